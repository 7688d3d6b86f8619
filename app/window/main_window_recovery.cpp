// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The part of MainWindow that brings back what a crash left.
#include "app/dialogs/recovery_dialog.h"
#include "app/document/recovery.h"
#include "app/text/error_text.h"
#include "app/window/main_window.h"
#include "app/window/window_actions.h"

#include <QAction>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>

namespace esm {

namespace {

bool isDiscardMeant(const FoundJournal& journal, QWidget* parent)
{
  QMessageBox box(QMessageBox::Question, RecoveryDialog::tr("Recover unsaved work"),
                  RecoveryDialog::tr("Discard “%1”? It cannot be brought back.").arg(journalName(journal)),
                  QMessageBox::Discard | QMessageBox::Cancel, parent);
  box.setObjectName(QStringLiteral("dlgDiscard"));
  box.setDefaultButton(QMessageBox::Cancel);
  return box.exec() == QMessageBox::Discard;
}

} // namespace

void MainWindow::keepJournal(const std::filesystem::path& folder)
{
  m_recovery = new Recovery(m_document, folder, this);
  m_recovery->setPictureSource([this] { return m_view->picture(); });
  connect(m_recovery, &Recovery::failed, this, [this](const Error& error) {
    statusBar()->showMessage(tr("Unsaved work is not kept for the case of a crash. %1 %2")
                               .arg(errorLead(error.code), errorDetail(error)),
                             20000);
  });
  connect(m_actions->recover, &QAction::triggered, this, [this] { offerRecovery(true); });
  m_actions->recover->setVisible(true);
}

/// Journals that cannot be read are kept out of the way and told once; those of a later program wait for it.
void MainWindow::tellUnreadable(std::vector<FoundJournal>& found)
{
  for (FoundJournal& journal : found) {
    if (!journal.fault || journal.postponed) continue;
    const Error fault = *journal.fault;
    if (fault.code == ErrorCode::NewerVersion)
      postponeJournal(journal);
    else
      setJournalAside(journal);
    showError(tr("Recover unsaved work"), fault);
  }
  std::erase_if(found, [](const FoundJournal& journal) { return journal.fault.has_value(); });
}

bool MainWindow::offerRecovery(bool asked)
{
  if (m_recovery == nullptr) return false;
  std::vector<FoundJournal> found = m_recovery->find();
  tellUnreadable(found);
  if (!asked) std::erase_if(found, [](const FoundJournal& journal) { return journal.postponed; });
  if (found.empty() && asked) statusBar()->showMessage(tr("There is nothing to recover."), 6000);
  while (!found.empty()) {
    RecoveryDialog dialog(found, this);
    dialog.exec();
    const int chosen = dialog.chosen();
    if (dialog.answer() == RecoveryDialog::Later || chosen < 0) {
      for (const FoundJournal& journal : found) postponeJournal(journal);
      return false;
    }
    FoundJournal& journal = found[static_cast<std::size_t>(chosen)];
    if (dialog.answer() == RecoveryDialog::Discard ? !isDiscardMeant(journal, this) : !mayDropChanges())
      continue;
    if (dialog.answer() == RecoveryDialog::Discard)
      discardJournal(journal);
    else if (recover(std::move(journal)))
      return true;
    found.erase(found.begin() + chosen);
  }
  return false;
}

/// Nobody loses one for the other: the work is here, and the project that was asked for gets a window of its own.
/// Where the work is a later state of that very project there is nothing else to open.
void MainWindow::begin(const QString& named, const std::function<bool(const QString& path)>& anotherWindow)
{
  const bool recovered = offerRecovery(false);
  if (!recovered) {
    if (named.isEmpty())
      openSample();
    else
      openPath(named);
    return;
  }
  const QFileInfo file(named);
  if (named.isEmpty() || (!m_document->path().isEmpty() && QFileInfo(m_document->path()) == file)) return;
  if (anotherWindow(file.absoluteFilePath())) {
    statusBar()->showMessage((statusBar()->currentMessage() + QLatin1Char(' ') +
                              tr("“%1” opens in a window of its own.").arg(file.fileName()))
                               .trimmed()); // stays: that window may cover this one
    return;
  }
  QMessageBox box(QMessageBox::Information, tr("Open project"),
                  tr("“%1” is not open: this window shows the recovered work.").arg(file.fileName()),
                  QMessageBox::Close, this);
  box.setObjectName(QStringLiteral("dlgNamedLater"));
  box.setInformativeText(
    tr("Another window could not be started. Opening it here asks first whether to save."));
  QPushButton* open = box.addButton(tr("&Open here"), QMessageBox::AcceptRole);
  open->setObjectName(QStringLiteral("namedOpenHere"));
  box.setDefaultButton(QMessageBox::Close);
  box.exec();
  if (box.clickedButton() == open) openPath(named);
}

bool MainWindow::recover(FoundJournal&& journal)
{
  const bool neverSaved = journal.path.empty();
  m_controller->setPlaying(false);
  Result<RecoveredWork> work = m_recovery->recover(std::move(journal));
  if (!work) {
    setJournalAside(journal); // not moved from: it could not be read
    showError(tr("Recover unsaved work"), work.error());
    return false;
  }
  const QString steps = stepsText(work->steps, neverSaved, !work->draft.isEmpty());
  statusBar()->showMessage(tr("Recovered: %1. Nothing of it is saved yet.").arg(steps), 20000);
  QStringList told;
  if (work->fileChanged)
    told
      << tr("The file has changed since, or is gone: %1. What was recovered does not replace it; saving asks "
            "for a place.")
           .arg(QString::fromStdString(work->path));
  if (work->isCutShort)
    told << tr(
      "The end of what was kept is damaged; recovered is what came before. The damaged lines are left "
      "beside the other journals.");
  if (told.isEmpty()) return true;
  QMessageBox box(QMessageBox::Information, tr("Recover unsaved work"), told.join(QLatin1Char('\n')),
                  QMessageBox::Ok, this);
  box.setObjectName(QStringLiteral("dlgRecovered"));
  box.exec();
  return true;
}

} // namespace esm
