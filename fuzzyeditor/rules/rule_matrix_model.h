// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fuzzyeditor/fuzzy_evaluation.h"
#include "fuzzyeditor/rules/rule_display.h"

#include <QAbstractTableModel>

#include <string>
#include <vector>

namespace esm {

/// The rules about two inputs as a grid: rows and columns are the words of the inputs, a cell says what is
/// concluded on one output where both words hold.
///
/// A cell's *own* rules have exactly the condition "row input IS row word AND column input IS column word";
/// these are edited here. Other rules that speak of the two inputs alone *cover* the cells where their
/// condition holds ("wall IS solid" covers a whole row) and are shown in parentheses. Rules about any other
/// input are not shown; unshownRules() counts them. Edits go to the document and come back by its signal.
class RuleMatrixModel : public QAbstractTableModel {
  Q_OBJECT
public:
  enum Role {
    ChoicesRole = Qt::UserRole, ///< QStringList: the output's words, for an editor
    OwnDegreeRole,              ///< double: of the strongest of the cell's own rules at the present inputs
    CoverDegreeRole,            ///< double: of the strongest rule that covers the cell
    HasOwnRole,                 ///< bool
    IsEmptyRole                 ///< bool: no rule at all
  };

  explicit RuleMatrixModel(FuzzyEvaluation* evaluation, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  /// EditRole: index of the word that the first own rule concludes, -1 without one.
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

  /// One undo step: each cell gets one own rule that concludes the output's word number `term`, or none
  /// (-1). The first own rule is changed, further ones lose what they say about this output.
  void setCells(const QModelIndexList& cells, int term);

  // === What is shown, as places in the rule base; -1: there are not two inputs and an output
  void setAxes(int rowInput, int columnInput, int output);
  int rowInput() const { return m_row; }
  int columnInput() const { return m_column; }
  int output() const { return m_output; }
  int unshownRules() const; ///< about this output, but also about other inputs
  void retranslate();       ///< language of the rules or locale of the window
  void setLocale(const QLocale& locale);

signals:
  void axesChanged(); ///< also by a rule base that lost or gained inputs

private:
  struct Entry {
    int rule = -1;
    bool own = false;
  };
  struct Ids {
    std::string row, column, output;
  };
  using Cells = std::vector<std::vector<Entry>>; ///< row by row

  const fuzzy::RuleBase& rules() const { return m_document->ruleBase(); }
  const fuzzy::Variable& variable(int input) const { return rules().inputs[static_cast<std::size_t>(input)]; }
  bool hasAxes() const { return m_output >= 0; }
  void followDocument();
  void chooseAxes();
  void findPlaces();
  void announce();
  const Cells& cells() const;
  void sortIn(int rule, Cells& cells) const;
  const std::vector<Entry>& entries(const QModelIndex& index) const;
  bool isOwn(const fuzzy::Rule& rule, int row, int column) const;
  QString entryText(const Entry& entry) const;
  QString accessibleText(const QModelIndex& index) const;
  double degree(const QModelIndex& index, bool own) const;
  fuzzy::Rule newRule(int row, int column, int term) const;

  FuzzyEvaluation* m_evaluation;
  FuzzyDocument* m_document;
  QLocale m_locale;
  Ids m_ids;
  int m_row = -1, m_column = -1, m_output = -1;
  int m_rows = 0, m_columns = 0; ///< as last told to the view
  mutable bool m_stale = true;
  mutable Cells m_cells;
  mutable int m_unshown = 0;
};

} // namespace esm
