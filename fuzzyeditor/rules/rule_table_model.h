// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fuzzyeditor/fuzzy_evaluation.h"
#include "fuzzyeditor/rules/rule_display.h"

#include <QAbstractTableModel>

#include <functional>
#include <optional>
#include <vector>

namespace esm {

/// The rules as a table: on, IF, THEN, weight, degree, note. It keeps a copy of the rules as last shown, only
/// to tell the view which rows changed; every edit goes to the document and comes back by its signal.
///
/// A text that is no rule changes nothing, but it is not thrown away either: it stays in its cell as a
/// mistake, shown with its wave line, until it is mended, replaced or its rule changes otherwise.
class RuleTableModel : public QAbstractTableModel {
  Q_OBJECT
public:
  enum Column { On, Condition, Conclusion, Weight, Degree, Note, kColumnCount };
  enum Role { DegreeRole = Qt::UserRole, MistakeRangeRole }; ///< double; QPoint(start, length) or nothing

  /// A cell's text that is no rule.
  struct Mistake {
    int row = -1;
    Column column = Condition;
    QString text;
    TextRange range; ///< of the offending word in text
    fuzzy::RuleTextError error;
    QString word; ///< empty: something is missing
  };

  explicit RuleTableModel(FuzzyEvaluation* evaluation, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

  Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QModelIndexList& indexes) const override;
  bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                    const QModelIndex& parent) override;

  // === Edits of whole rules; each one undo step ===
  /// A rule that says what holds now (the words that fit the current inputs and results best), below `row`.
  /// @return its row, -1 if the rule base has no variable to speak of.
  int addRule(int row);
  int duplicateRules(const std::vector<int>& rows); ///< below the last of them; the first copy's row
  void removeRules(const std::vector<int>& rows);
  /// Moves the rows, in their order, before `target`. @return the row of the first of them.
  int moveRules(const std::vector<int>& rows, int target);
  void setRulesEnabled(const std::vector<int>& rows, bool enabled);

  const std::optional<Mistake>& mistake() const { return m_mistake; }
  QString mistakeSentence() const; ///< in the language of now
  void cureMistake();              ///< replaces the offending word by the suggestion
  void discardMistake();
  void retranslate();                    ///< the language of the window changed
  void setLocale(const QLocale& locale); ///< number format of the window

signals:
  void mistakeChanged();

private:
  struct Reading {
    std::optional<Mistake> mistake;
    fuzzy::Rule rule;     ///< without a mistake
    bool isWhole = false; ///< the text is a whole rule, not a part
  };

  void followDocument();
  void restoreMistake();
  void tellMistake();
  Reading read(int row, Column column, const QString& text) const;
  void forgetTexts();
  bool setRuleText(int row, Column column, const QString& text);
  void setMistake(std::optional<Mistake> mistake);
  void push(std::vector<fuzzy::Rule> rules, const QString& undoText);
  bool editRule(int row, const QString& undoText, const std::function<void(fuzzy::Rule&)>& change);
  const RuleParts& parts(int row) const;
  QVariant displayData(int row, Column column) const;

  FuzzyEvaluation* m_evaluation;
  FuzzyDocument* m_document;
  QLocale m_locale;
  std::vector<fuzzy::Rule> m_rules;
  mutable std::vector<std::optional<RuleParts>> m_parts; ///< texts, made when a row is first shown
  std::optional<Mistake> m_mistake;
  bool m_restoring = false; ///< the document's draft holds a mistake that is still to be shown
};

} // namespace esm
