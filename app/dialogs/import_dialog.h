// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/import/import_preview.h"
#include "app/jobs/job.h"

#include <QDialog>
#include <QTimer>

#include <memory>
#include <optional>

class QComboBox;
class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;
class QRadioButton;
class QScrollArea;
class QTableWidget;

namespace esm {

class DefectList;
class RecipeForm;
class SceneView;

/// Shows what mesh files would become before they become the model: the net as it would be, its size, what is
/// wrong with the mesh and where, what it will cost. Every choice makes the net anew off the GUI thread, so
/// what is taken is what was seen. Leaving the dialog stops all work at once and changes nothing.
class ImportDialog : public QDialog {
  Q_OBJECT
public:
  /// @param paths one or more, joined to one model. @param jobs outlives the dialog.
  /// @param modelIsEmpty then there is nothing to add to. @param tissue of the document.
  ImportDialog(const QStringList& paths, JobRunner* jobs, bool modelIsEmpty, TissueModel tissue,
               QWidget* parent = nullptr);
  ~ImportDialog() override;

  /// What of the former organ's tissue the new one gets: its regions lie where that one was.
  enum class Keeps { BaseTissue, BaseTissueAndRegions, Nothing };

  bool replaces() const;
  IncomingModel takeModel(); ///< after accept(), once

  const SceneView* view() const noexcept { return m_view; }

  void accept() override;

protected:
  void changeEvent(QEvent* event) override;

private:
  void buildWidgets(bool modelIsEmpty);
  QWidget* buildLeft(bool modelIsEmpty);
  QWidget* buildRight();
  void readFiles();
  void makeNet();
  void takeSource(MeshSource source);
  void showPreview(ImportPreview preview);
  void showFailure(const Error& error);
  void showReport();
  static QString textOf(const QualityFinding& finding, const QualityReport& report);
  void showSize();
  void addRow(const QString& what, const QString& before, const QString& after, bool bad);
  void setBusy(bool busy);
  TissueModel wantedTissue() const;
  void askForNet();
  bool unitIsMeant();
  void resetRemembered();
  void retranslate();
  ImportRecipe recipe() const;
  QString format() const;

  QStringList m_paths;
  JobRunner* m_jobs;
  TissueModel m_tissue, m_askedTissue;        ///< the document's; that the net is made with
  std::shared_ptr<const MeshSource> m_source; ///< null: not read yet
  std::optional<ImportPreview> m_preview;     ///< of the present choices, or empty
  std::uint64_t m_generation = 0;             ///< of nets in the view
  bool m_remembered = false;
  double m_extent = 0.0, m_metres = 0.0; ///< the largest of the box, in the file's unit and in the scene
  QTimer m_settle;                       ///< a value that is being typed or dragged waits for the next
  QTimer m_progressTimer;

  QScrollArea* m_left = nullptr;
  RecipeForm* m_form = nullptr;
  SceneView* m_view = nullptr;
  QTableWidget* m_report = nullptr;
  DefectList* m_defects = nullptr;
  QListWidget* m_notes = nullptr;
  QLabel *m_size = nullptr, *m_prediction = nullptr, *m_message = nullptr, *m_rememberedNote = nullptr;
  QRadioButton *m_replace = nullptr, *m_add = nullptr;
  QLabel* m_keepsText = nullptr;
  QComboBox* m_keeps = nullptr; ///< rows as Keeps
  QProgressBar* m_progress = nullptr;
  QPushButton *m_ok = nullptr, *m_cancel = nullptr, *m_reset = nullptr;
};

/// The unit in which the box would have the size of an organ: extents up to 2 count as metres.
LengthUnit guessedUnit(double largestExtent);

} // namespace esm
