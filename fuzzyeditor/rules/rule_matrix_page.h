// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>
#include <QWidget>

class QAction;
class QComboBox;
class QLabel;
class QTableView;

namespace esm {

class FuzzyEvaluation;
class RuleMatrixModel;

/// Paints a cell of the rule matrix (hatched where no rule speaks, tinted by how strongly its rules fire now)
/// and edits it with a list of the output's words.
class RuleMatrixDelegate : public QStyledItemDelegate {
  Q_OBJECT
public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;
};

/// The rules about two chosen inputs as a grid: see RuleMatrixModel. Return, F2 or a double click chooses a
/// cell's word, Delete takes the rules of the selected cells away.
class RuleMatrixPage : public QWidget {
  Q_OBJECT
public:
  explicit RuleMatrixPage(FuzzyEvaluation* evaluation, QWidget* parent = nullptr);

  RuleMatrixModel* model() const { return m_model; }

protected:
  void changeEvent(QEvent* event) override;

private:
  void fillChoices();
  void takeChoice(const QComboBox* changed);
  void retranslate();

  FuzzyEvaluation* m_evaluation;
  RuleMatrixModel* m_model;
  QTableView* m_table;
  QLabel *m_rowsLabel, *m_columnsLabel, *m_outputLabel;
  QComboBox *m_rows, *m_columns, *m_output;
  QAction* m_clear;
  QLabel* m_note;
};

} // namespace esm
