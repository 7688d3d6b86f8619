// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/jobs/job.h"
#include "meshimport/mesh_importer.h"

#include <QDialog>

#include <optional>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;
class QRadioButton;
class QTableWidget;

namespace esm {

/// Shows what is in a mesh file before it becomes the model: counts, defects, size in mm, the net that will
/// come of it. Reading and net building run off the GUI thread; leaving the dialog drops their result.
class ImportDialog : public QDialog {
  Q_OBJECT
public:
  /// @param jobs outlives the dialog. @param modelIsEmpty then there is nothing to add to.
  ImportDialog(const QString& path, JobRunner* jobs, bool modelIsEmpty, QWidget* parent = nullptr);
  ~ImportDialog() override;

  bool replaces() const;
  IncomingModel takeModel(); ///< after accept(), once

  void accept() override; ///< builds the net first

private:
  void buildWidgets(bool modelIsEmpty);
  void readFile();
  void showReport();
  void showFailure(const Error& error);
  void refreshSize();
  void setReady(bool ready);
  LengthUnit unit() const;
  UpAxis upAxis() const;
  void addLine(const QString& what, const QString& value, bool bad = false);

  QString m_path;
  JobRunner* m_jobs;
  std::optional<ImportedMesh> m_mesh;
  std::optional<SpringNet> m_net;

  QComboBox *m_unit = nullptr, *m_up = nullptr;
  QCheckBox* m_weld = nullptr;
  QDoubleSpinBox* m_tolerance = nullptr;
  QTableWidget* m_report = nullptr;
  QListWidget* m_notes = nullptr;
  QLabel *m_size = nullptr, *m_prediction = nullptr, *m_message = nullptr;
  QRadioButton *m_replace = nullptr, *m_add = nullptr;
  QProgressBar* m_progress = nullptr;
  QPushButton* m_ok = nullptr;
};

/// The unit in which the box would have the size of an organ: extents up to 2 count as metres.
LengthUnit guessedUnit(double largestExtent);

} // namespace esm
