// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QWidget>

class QPushButton;
class QTableView;

namespace esm {

class SurfaceSource;

/// The control surface as rows of three columns: both inputs and the result, in display units. Places where
/// no rule fires show no result.
class SurfaceTableModel : public QAbstractTableModel {
  Q_OBJECT
public:
  /// @param source not owned, outlives this.
  explicit SurfaceTableModel(SurfaceSource* source, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : 3; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  /// Header and rows for other programs: commas, decimal points whatever the language, an empty field where
  /// no rule fires. @param rows empty: all
  QString csv(const QList<int>& rows) const;
  void reload(); ///< asks the source again

private:
  QString title(int column) const;
  double value(int row, int column) const; ///< NaN where no rule fires
  SurfaceSource* m_source;
  int m_rows = 0;
};

/// The table with a button that copies it; Ctrl+C copies the chosen rows. Filled only while it is visible.
class SurfaceTable : public QWidget {
  Q_OBJECT
public:
  explicit SurfaceTable(SurfaceSource* source, QWidget* parent = nullptr);

protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  void retranslate();
  void copy(bool chosenOnly);
  SurfaceTableModel* m_model;
  QTableView* m_view;
  QPushButton* m_copy;
};

} // namespace esm
