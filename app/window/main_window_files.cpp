// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The part of MainWindow that deals with files, and with what must not get lost.
#include "app/dialogs/import_dialog.h"
#include "app/document/other_version.h"
#include "app/document/recovery.h"
#include "app/import/changed_files_bar.h"
#include "app/sample_files.h"
#include "app/text/error_text.h"
#include "app/window/main_window.h"
#include "app/window/window_actions.h"
#include "core/base/machine_memory.h"
#include "core/project/export.h"
#include "meshimport/import_endings.h"

#include <QAction>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QStatusBar>
#include <QVBoxLayout>

#include <algorithm>

namespace esm {

namespace {

/// One entry for all that can be imported, one for each kind of it.
QString meshFilter()
{
  const auto entry = [](const QString& what, const QStringList& endings) {
    QStringList patterns;
    for (const QString& ending : endings) patterns << QStringLiteral("*.") + ending;
    return QStringLiteral("%1 (%2)").arg(what, patterns.join(QLatin1Char(' ')));
  };
  QStringList own, foreign;
  for (const std::string_view ending : ownEndings())
    own << QString::fromUtf8(ending.data(), static_cast<qsizetype>(ending.size()));
  for (const std::string_view ending : foreignEndings())
    foreign << QString::fromUtf8(ending.data(), static_cast<qsizetype>(ending.size()));
  return entry(MainWindow::tr("Meshes"), own + foreign) + QStringLiteral(";;") +
         entry(MainWindow::tr("Meshes with a reader of their own"), own) + QStringLiteral(";;") +
         entry(MainWindow::tr("Foreign formats"), foreign);
}

} // namespace

void MainWindow::connectFileActions()
{
  const auto on = [this](QAction* action, auto slot) { connect(action, &QAction::triggered, this, slot); };
  on(m_actions->newProject, [this] { newProject(); });
  on(m_actions->open, [this] { chooseAndOpen(); });
  on(m_actions->save, [this] { saveProject(); });
  on(m_actions->saveAs, [this] { saveProjectAs(); });
  on(m_actions->import, [this] { chooseAndImport(); });
  on(m_actions->exportShape, [this] { exportShape(); });
  on(m_actions->picture, [this] { savePicture(); });
  on(m_actions->rename, [this] { renameProject(); });
  on(m_actions->quit, [this] { close(); });
}

/// The preview with a bar above it that says when a file of the model has changed.
void MainWindow::watchFiles()
{
  auto* middle = new QWidget(this);
  auto* layout = new QVBoxLayout(middle);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  m_changedFiles = new ChangedFilesBar(m_document, middle);
  layout->addWidget(m_changedFiles);
  layout->addWidget(m_view, 1);
  setCentralWidget(middle);
  connect(m_changedFiles, &ChangedFilesBar::updated, this,
          [this](const QString& summary) { statusBar()->showMessage(summary, 15000); });
  connect(m_changedFiles, &ChangedFilesBar::failed, this,
          [this](const Error& error) { showError(tr("Update the model"), error); });
}

void MainWindow::showError(const QString& title, const Error& error)
{
  QMessageBox box(QMessageBox::Warning, title, errorLead(error.code), QMessageBox::Ok, this);
  box.setObjectName(QStringLiteral("dlgError"));
  box.setInformativeText(errorDetail(error));
  box.exec();
}

// === Opening

void MainWindow::newProject()
{
  if (!mayDropChanges()) return;
  Project project;
  project.tissue = defaultTissue();
  m_controller->setPlaying(false);
  m_document->start(std::move(project), QString());
}

bool MainWindow::openPath(const QString& path)
{
  if (!isProjectFile(path)) {
    importPaths({path});
    return true;
  }
  if (!mayDropChanges()) return false;
  if (auto opened = m_document->open(path); !opened) {
    showError(tr("Open project"), opened.error());
    return false;
  }
  rememberFile(path);
  sayOpened(QFileInfo(path).fileName());
  return true;
}

/// Whoever opens a project to pull at it learns why nothing moves.
void MainWindow::sayOpened(const QString& name)
{
  statusBar()->showMessage(m_controller->isPlaying()
                             ? tr("Opened %1").arg(name)
                             : tr("Opened %1. The simulation is paused: the space key plays it.").arg(name),
                           15000);
}

bool MainWindow::openSample()
{
  const QStringList samples = sampleFiles();
  if (!samples.isEmpty()) return playSample(samples.front());
  statusBar()->showMessage(tr("The samples were not found beside the program; is it installed whole?"),
                           15000);
  return false;
}

bool MainWindow::playSample(const QString& path)
{
  if (!mayDropChanges()) return false;
  auto sample = projectFromFile(path);
  if (!sample) {
    showError(tr("Open sample"), sample.error());
    return false;
  }
  sample->name = sampleTitle(path).toStdString();
  m_document->start(std::move(sample).value(), QString()); // saving asks for a place of its own
  m_controller->setPlaying(true);
  return true;
}

void MainWindow::chooseAndOpen()
{
  const QString folder = QFileInfo(m_document->path()).absolutePath();
  const QString path = QFileDialog::getOpenFileName(
    this, tr("Open project"), m_document->path().isEmpty() ? QString() : folder,
    tr("Projects (*.esm *.esmb)") + QStringLiteral(";;") + tr("Plain nets (*.json *.xsp)") +
      QStringLiteral(";;") + tr("All files (*)"));
  if (!path.isEmpty()) openPath(path);
}

void MainWindow::chooseAndImport()
{
  const QString folder = QSettings().value(QStringLiteral("importFolder")).toString();
  const QStringList paths = QFileDialog::getOpenFileNames(
    this, tr("Import meshes"), folder, meshFilter() + QStringLiteral(";;") + tr("All files (*)"));
  if (paths.isEmpty()) return;
  QSettings().setValue(QStringLiteral("importFolder"), QFileInfo(paths.front()).absolutePath());
  importPaths(paths);
}

void MainWindow::importPaths(const QStringList& paths)
{
  const bool empty = m_document->project().net.nodeCount() == 0;
  const struct GiveBack { // after the dialog, with its mesh and previews, is gone
    ~GiveBack() { giveBackFreeMemory(); }
  } afterwards;
  ImportDialog dialog(paths, m_jobs, empty, m_document->project().tissue, this);
  if (dialog.exec() != QDialog::Accepted) return;
  const bool replace = dialog.replaces();
  if (auto imported = m_document->importModel(dialog.takeModel(), replace); !imported)
    showError(tr("Import meshes"), imported.error());
  else
    sayOpened(QFileInfo(paths.front()).fileName());
}

// === Dropping files

namespace {

/// The files that a drag carries; none if one of them is no file, or a project comes with others.
QStringList draggedFiles(const QMimeData* data)
{
  QStringList paths;
  for (const QUrl& url : data->urls()) {
    if (!url.isLocalFile()) return {};
    paths.append(url.toLocalFile());
  }
  const auto isProject = [](const QString& path) { return isProjectFile(path); };
  return paths.size() > 1 && std::any_of(paths.begin(), paths.end(), isProject) ? QStringList() : paths;
}

} // namespace

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
  const QStringList paths = draggedFiles(event->mimeData());
  if (paths.isEmpty()) return;
  event->acceptProposedAction();
  m_dropHint->setText(isProjectFile(paths.front())
                        ? tr("Drop to open the project")
                        : tr("Drop to import %n file(s)", nullptr, static_cast<int>(paths.size())));
  m_dropHint->setGeometry(rect().adjusted(60, 60, -60, -60));
  m_dropHint->show();
  m_dropHint->raise();
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*)
{
  m_dropHint->hide();
}

void MainWindow::dropEvent(QDropEvent* event)
{
  m_dropHint->hide();
  const QStringList paths = draggedFiles(event->mimeData());
  if (paths.isEmpty()) return;
  event->acceptProposedAction();
  // The drag's source waits for this event: dialogs come after it.
  QMetaObject::invokeMethod(
    this,
    [this, paths] {
      if (paths.size() == 1)
        openPath(paths.front());
      else
        importPaths(paths);
    },
    Qt::QueuedConnection);
}

// === Saving

/// What is being typed in a field counts as entered: nobody leaves a field before closing or saving.
void MainWindow::commitTyped()
{
  if (const QPointer<QWidget> field = focusWidget()) {
    field->clearFocus();
    if (field && field->isVisible()) field->setFocus();
  }
  emit m_document->ruleTextWanted();
}

bool MainWindow::saveProject()
{
  commitTyped();
  if (m_document->path().isEmpty()) return saveProjectAs();
  if (!m_document->fileChangedOnDisk()) {
    if (!m_document->fileHoldsAnotherModel()) return writeProject(m_document->path());
    const OtherVersion answer = askAboutOtherModel();
    if (answer == OtherVersion::SaveElsewhere) return saveProjectAs();
    return answer == OtherVersion::Overwrite && writeProject(m_document->path());
  }
  const QString kept = nameForOtherVersion(m_document->path());
  switch (askAboutOtherVersion(kept)) {
  case OtherVersion::Overwrite:
    return writeProject(m_document->path(), kept);
  case OtherVersion::SaveElsewhere:
    return saveProjectAs();
  case OtherVersion::Keep:
    break;
  }
  return false;
}

bool MainWindow::saveProjectAs()
{
  commitTyped();
  const QString start =
    m_document->path().isEmpty() ? m_document->displayName() + QStringLiteral(".esm") : m_document->path();
  QString path = QFileDialog::getSaveFileName(this, tr("Save project"), start,
                                              tr("Projects (*.esm)") + QStringLiteral(";;") +
                                                tr("Compact projects (*.esmb)"));
  if (path.isEmpty()) return false;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".esm");
  const bool losesOther = QFileInfo(path).size() > 0 && m_document->isForeign(path); // the dialog has asked
  return writeProject(path, losesOther ? nameForOtherVersion(path) : QString());
}

/// @param kept the name that what stands there gets first; empty: it is this project's own
bool MainWindow::writeProject(const QString& path, const QString& kept)
{
  if (!kept.isEmpty())
    if (auto other = keepOtherVersion(path, kept); !other) {
      showError(tr("Save project"), other.error());
      return false;
    }
  m_document->setView(m_view->viewSettings());
  if (auto saved = m_document->saveAs(path); !saved) {
    showError(tr("Save project"), saved.error());
    return false;
  }
  tellSaved(kept);
  return true;
}

void MainWindow::tellSaved(const QString& kept)
{
  const QString name = QFileInfo(m_document->path()).fileName();
  QString said = m_document->ruleDraft().isEmpty() ? tr("Saved %1").arg(name)
                                                   : tr("Saved %1, but for a rule with a mistake.").arg(name);
  if (!kept.isEmpty())
    said = tr("%1. The version that was there stays as “%2”.")
             .arg(said.endsWith(QLatin1Char('.')) ? said.chopped(1) : said, QFileInfo(kept).fileName());
  statusBar()->showMessage(said, kept.isEmpty() && m_document->ruleDraft().isEmpty() ? 4000 : 12000);
  rememberFile(m_document->path());
}

/// What becomes of a version of the project's file that somebody else has written. @param kept the name that it
/// gets if it is overwritten.
MainWindow::OtherVersion MainWindow::askAboutOtherVersion(const QString& kept)
{
  return askBeforeOverwriting("dlgOtherVersion",
                              tr("“%1” was changed by someone else since it was opened here."),
                              tr("Overwriting replaces that version by yours; it stays beside it as “%1”.")
                                .arg(QFileInfo(kept).fileName()));
}

/// What becomes of the project's file when its model was replaced by another.
MainWindow::OtherVersion MainWindow::askAboutOtherModel()
{
  return askBeforeOverwriting(
    "dlgOtherModel", tr("“%1” holds another model, which was replaced here."),
    tr("Overwriting puts the new model in its place; under another name, both stay."));
}

/// @param text with a place for the file's name.
MainWindow::OtherVersion MainWindow::askBeforeOverwriting(const char* dialog, const QString& text,
                                                          const QString& what)
{
  QMessageBox box(QMessageBox::Warning, tr("Save project"),
                  text.arg(QFileInfo(m_document->path()).fileName()), QMessageBox::Cancel, this);
  box.setObjectName(QLatin1String(dialog));
  box.setInformativeText(what);
  QPushButton* overwrite = box.addButton(tr("&Overwrite"), QMessageBox::DestructiveRole);
  QPushButton* elsewhere = box.addButton(tr("Save &as…"), QMessageBox::AcceptRole);
  overwrite->setObjectName(QStringLiteral("otherVersionOverwrite"));
  elsewhere->setObjectName(QStringLiteral("otherVersionSaveAs"));
  box.setDefaultButton(elsewhere);
  box.exec();
  if (box.clickedButton() == overwrite) return OtherVersion::Overwrite;
  return box.clickedButton() == elsewhere ? OtherVersion::SaveElsewhere : OtherVersion::Keep;
}

bool MainWindow::mayDropChanges()
{
  commitTyped();
  if (!m_document->isModified()) return true;
  QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                  tr("“%1” has changes that are not saved.").arg(m_document->displayName()),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setObjectName(QStringLiteral("dlgUnsaved"));
  box.setInformativeText(m_document->ruleDraft().isEmpty()
                           ? tr("Save them?")
                           : tr("A rule has a mistake. Saving leaves it out, and it will be lost."));
  box.setDefaultButton(QMessageBox::Save);
  box.button(QMessageBox::Save)->setObjectName(QStringLiteral("unsavedSave"));
  const int answer = box.exec();
  if (answer == QMessageBox::Save) return saveProject();
  return answer == QMessageBox::Discard;
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  m_controller->disarm(); // nobody feels a window that asks whether to save
  if (!mayDropChanges()) {
    event->ignore();
    return;
  }
  if (m_recovery != nullptr) m_recovery->letGo();
  m_controller->stop();
  saveLayout();
  event->accept();
}

void MainWindow::exportShape()
{
  const SimSnapshot& snapshot = m_controller->snapshot();
  const auto net = m_document->net();
  if (net->nodeCount() == 0 || !m_controller->snapshotIsCurrent()) {
    statusBar()->showMessage(tr("There is no model to export."), 6000);
    return;
  }
  const QString path =
    QFileDialog::getSaveFileName(this, tr("Export shape"), m_document->displayName() + QStringLiteral(".obj"),
                                 tr("OBJ with springs (*.obj);;PLY (*.ply);;STL (*.stl);;glTF binary "
                                    "(*.glb);;glTF text (*.gltf);;VTK (*.vtu);;Tables (*.csv);;SOFA scene "
                                    "(*.scn);;Masses and springs, Xsp 3.0 (*.xsp)"));
  if (path.isEmpty()) return;
  const Eigen::Matrix3Xd position = snapshot.position; // the snapshot may move on
  Frame frame;
  frame.net = net.get();
  frame.position = &position;
  frame.tension = snapshot.tension.size() == net->springCount() ? &snapshot.tension : nullptr;
  frame.time = snapshot.time;
  frame.loads = &m_document->project().loads;
  if (auto written = exportFrame(frame, path.toStdString()); !written)
    return showError(tr("Export shape"), written.error());
  const QString name = QFileInfo(path).fileName();
  QStringList lost;
  for (const std::string& what : lostInExport(frame, path.toStdString()))
    lost << QString::fromStdString(what);
  if (lost.isEmpty())
    statusBar()->showMessage(tr("Exported %1").arg(name), 4000);
  else
    statusBar()->showMessage(
      tr("Exported %1. It does not hold: %2").arg(name, lost.join(QStringLiteral("; "))), 15000);
}

void MainWindow::savePicture()
{
  const QImage picture = m_view->picture();
  const QString path = QFileDialog::getSaveFileName(this, tr("Picture of the preview"),
                                                    m_document->displayName() + QStringLiteral(".png"),
                                                    tr("Pictures (*.png *.jpg)"));
  if (path.isEmpty()) return;
  if (!picture.save(path))
    showError(tr("Picture of the preview"), {ErrorCode::FileUnwritable, path.toStdString()});
}

void MainWindow::renameProject()
{
  bool accepted = false;
  const QString name = QInputDialog::getText(this, tr("Rename project"), tr("Name"), QLineEdit::Normal,
                                             m_document->displayName(), &accepted);
  if (accepted && !name.trimmed().isEmpty()) m_document->rename(name.trimmed());
}

} // namespace esm
