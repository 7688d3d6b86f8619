// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The part of MainWindow that speaks: languages, colours, titles, hints, help.
#include "app/window/main_window.h"

#include "app/window/status_strip.h"
#include "app/window/window_actions.h"
#include "core/base/version.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QEvent>
#include <QFileInfo>
#include <QMessageBox>

namespace esm {

void MainWindow::setTheme(Theme theme)
{
  applyTheme(theme);
  for (QAction* action : m_actions->theme->actions())
    if (action->data().toString() == themeName(theme)) action->setChecked(true);
}

void MainWindow::setLanguage(Language language)
{
  m_language->set(language);
  m_document->setRuleLanguage(language);
  retranslateUi();
}

void MainWindow::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::LanguageChange) retranslateUi();
  QMainWindow::changeEvent(event);
}

void MainWindow::retranslateUi()
{
  if (m_dockHaptics == nullptr) return; // still being built
  m_actions->retranslate();
  m_status->retranslate();
  m_status->setLanguage(languageCode(m_language->language()));
  m_dockRegions->setWindowTitle(tr("Regions"));
  m_dockTissue->setWindowTitle(tr("Tissue"));
  m_dockInputs->setWindowTitle(tr("Fuzzy Input"));
  m_dockMf->setWindowTitle(tr("Terms"));
  m_dockSurface->setWindowTitle(tr("Surface"));
  m_dockWhy->setWindowTitle(tr("Why?"));
  m_dockRules->setWindowTitle(tr("Fuzzy Rules"));
  m_dockHaptics->setWindowTitle(tr("Haptics"));
  for (QDockWidget* dock : findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly)) {
    dock->setAccessibleName(dock->windowTitle());
    dock->toggleViewAction()->setObjectName(QStringLiteral("act_") + dock->objectName());
  }
  for (QAction* action : m_actions->language->actions())
    action->setChecked(action->data().toString() == languageCode(m_language->language()));
  fillRecentMenu();
  fillSampleMenu();
  refreshToolHint();
  refreshTitle();
  retranslateUndo();
}

void MainWindow::retranslateUndo()
{
  const QUndoStack* undo = m_document->undoStack();
  const auto show = [](QAction* action, bool possible, const QString& text) {
    action->setEnabled(possible);
    action->setText(text);
    action->setToolTip(QStringLiteral("%1 (%2)").arg(QString(text).remove(QLatin1Char('&')),
                                                     action->shortcut().toString(QKeySequence::NativeText)));
  };
  show(m_actions->undo, undo->canUndo(),
       undo->canUndo() ? tr("&Undo: %1").arg(undo->undoText()) : tr("&Undo"));
  show(m_actions->redo, undo->canRedo(),
       undo->canRedo() ? tr("&Redo: %1").arg(undo->redoText()) : tr("&Redo"));
  const std::string& solver = m_document->project().simulation.solver.solver;
  for (QAction* action : m_actions->solver->actions())
    action->setChecked(action->data().toString().toStdString() == solver);
}

void MainWindow::refreshToolHint()
{
  switch (m_view->tool()) {
  case Tool::Camera:
    m_status->setTool(tr("Camera: drag turns, wheel zooms"));
    break;
  case Tool::Pull:
    m_status->setTool(tr("Pull: drag the tissue (Esc lets go)"));
    break;
  case Tool::Select:
    m_status->setTool(tr("Select: click a node to see why it is as it is"));
    break;
  case Tool::Region:
    m_status->setTool(tr("Region: drag its handles (Esc takes a drag back)"));
    break;
  }
}

void MainWindow::showKeys()
{
  QMessageBox box(QMessageBox::NoIcon, tr("Keys"), QString(), QMessageBox::Ok, this);
  box.setObjectName(QStringLiteral("dlgKeys"));
  QString rows;
  for (const QAction* action : findChildren<QAction*>(Qt::FindDirectChildrenOnly))
    if (!action->shortcut().isEmpty())
      rows +=
        QStringLiteral("<tr><td style='padding-right:16px'><b>%1</b></td><td>%2</td></tr>")
          .arg(action->shortcut().toString(QKeySequence::NativeText),
               (action->statusTip().isEmpty() ? action->text().remove(QLatin1Char('&')) : action->statusTip())
                 .toHtmlEscaped());
  box.setText(
    QStringLiteral("<table>%1</table><p>%2</p>")
      .arg(
        rows,
        tr("In the preview: F fits, 1, 3 and 7 look from front, right and top, arrows turn, + and - zoom.")));
  box.exec();
}

void MainWindow::showAbout()
{
  QMessageBox::about(
    this, tr("About the Elastodynamic Shape Modeler"),
    tr("<h3>Elastodynamic Shape Modeler %1</h3><p>Meshes become spring-mass nets, words and rules give them "
       "their tissue, and their force can be felt.</p><p>Licence: GPL-3.0-or-later (core libraries: MIT)</p>")
      .arg(QLatin1String(version())));
}

void MainWindow::refreshTitle()
{
  // What "Save" would overwrite is in the title, whatever the project is called.
  const QFileInfo file(m_document->path());
  QString name = m_document->displayName();
  if (!m_document->path().isEmpty())
    name = name == file.completeBaseName() ? file.fileName()
                                           : QStringLiteral("%1 (%2)").arg(name, file.fileName());
  name.replace(QLatin1String("[*]"), QLatin1String("[*][*]")); // Qt's way of writing it
  setWindowTitle(tr("%1[*] – Elastodynamic Shape Modeler").arg(name));
  setWindowModified(m_document->isModified());
}

} // namespace esm
