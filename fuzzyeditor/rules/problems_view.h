// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fuzzyeditor/rules/problem_finder.h"

#include <QAbstractListModel>
#include <QLocale>
#include <QWidget>

class QLabel;
class QListView;

namespace esm {

class BadgeLabel;

/// Findings as sentences in the user's language: "Gap: No rule speaks of stiffness where hardness is about
/// 0.42." They are made when the findings come, so that they stay true to the rules that were looked at; the
/// first kMostShown of them, since nobody reads more and a list of thousands would hold up the window.
class ProblemsModel : public QAbstractListModel {
  Q_OBJECT
public:
  ProblemsModel(FuzzyDocument* document, ProblemFinder* finder, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  static constexpr int kMostShown = 100;
  const fuzzy::RuleFinding& finding(int row) const { return m_findings[static_cast<std::size_t>(row)]; }
  void retranslate(const QLocale& locale);

private:
  void follow();
  QString sentence(const fuzzy::RuleFinding& finding) const;
  QString placeText(const fuzzy::RuleFinding& finding) const;
  QString activationText(const fuzzy::RuleFinding& finding) const;

  FuzzyDocument* m_document;
  ProblemFinder* m_finder;
  QLocale m_locale;
  std::vector<fuzzy::RuleFinding> m_findings;
  QStringList m_sentences;
};

/// The list "Problems" with its count, hidden while there are none: then noneLabel() says so in a word,
/// wherever the owner has put it. A double click or Return goes to the spot: sets the inputs (one undo step)
/// or asks for the rules or the variable to be shown.
class ProblemsView : public QWidget {
  Q_OBJECT
public:
  explicit ProblemsView(FuzzyDocument* document, QWidget* parent = nullptr);

  ProblemFinder* finder() const { return m_finder; }
  ProblemsModel* model() const { return m_model; }
  QLabel* noneLabel() const { return m_none; }
  /// The list is of the rules in force; while the text has mistakes, none in it does not mean none at all.
  void setTextHasMistakes(bool has);

signals:
  void rulesRequested(int rule, int otherRule); ///< the other may be -1
  void variableRequested(bool isOutput, int variable);

protected:
  void changeEvent(QEvent* event) override;

private:
  void activate(const QModelIndex& index);
  void showCount();
  void retranslate();

  FuzzyDocument* m_document;
  ProblemFinder* m_finder;
  ProblemsModel* m_model;
  QLabel* m_title;
  BadgeLabel* m_count;
  QListView* m_list;
  QLabel* m_none;
  bool m_textHasMistakes = false;
};

} // namespace esm
