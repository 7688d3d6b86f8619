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
class RuleTableModel;
class RuleTextPage;

/// The dock "Fuzzy Rules": the rule base as table and as text, both live, and below what is missing in it for
/// the current inputs.
class RulesPanel : public QWidget {
  Q_OBJECT
public:
  /// @param evaluation not owned, outlives this; one for all fuzzy panels of a document.
  explicit RulesPanel(FuzzyEvaluation* evaluation, QWidget* parent = nullptr);

  RuleTableModel* tableModel() const { return m_model; }
  RuleTextPage* textPage() const { return m_textPage; }
  void showRule(int rule); ///< opens the table at a rule

protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  QWidget* createTablePage();
  QAction* createAction(const QString& name, const QKeySequence& keys);
  void connectActions();
  void retranslate();
  void showProblems();
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
  QLabel* m_problems;
  QAction *m_add, *m_duplicate, *m_remove, *m_up, *m_down, *m_switch;
};

} // namespace esm
