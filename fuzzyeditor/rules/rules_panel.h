// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <vector>

class QAction;
class QLabel;
class QTableView;
class QTabWidget;

namespace esm {

class FuzzyEvaluation;
class MistakeBar;
class ProblemsView;
class RuleMatrixPage;
class RuleTableModel;
class RuleTextPage;

/// The dock "Fuzzy Rules": the rule base as table, as text and as matrix of two inputs, all live; beside it
/// the list of its problems, below it what is missing for the current inputs.
class RulesPanel : public QWidget {
  Q_OBJECT
public:
  /// @param evaluation not owned, outlives this; one for all fuzzy panels of a document.
  explicit RulesPanel(FuzzyEvaluation* evaluation, QWidget* parent = nullptr);

  RuleTableModel* tableModel() const { return m_model; }
  RuleTextPage* textPage() const { return m_textPage; }
  RuleMatrixPage* matrixPage() const { return m_matrixPage; }
  ProblemsView* problemsView() const { return m_problemsView; }
  void showRule(int rule); ///< opens the table at a rule

signals:
  void variableRequested(bool isOutput, int variable); ///< a problem of its words wants to be looked at

protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  QWidget* createTablePage();
  QAction* createAction(const QString& name, const QKeySequence& keys);
  void connectActions();
  void retranslate();
  void showSilence();
  void showRules(int rule, int otherRule);
  void showTableMistake();
  void updateActions();
  std::vector<int> selectedRows() const;
  void selectRows(int first, int count);

  FuzzyEvaluation* m_evaluation;
  RuleTableModel* m_model;
  QTabWidget* m_tabs;
  QTableView* m_table = nullptr;
  MistakeBar* m_tableMistake = nullptr;
  RuleTextPage* m_textPage;
  RuleMatrixPage* m_matrixPage;
  ProblemsView* m_problemsView;
  QLabel* m_silence;
  QAction *m_add, *m_duplicate, *m_remove, *m_up, *m_down, *m_switch;
};

} // namespace esm
