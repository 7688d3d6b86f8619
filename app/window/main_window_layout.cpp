// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The part of MainWindow that remembers: recent files, size and place of window and panels.
#include "app/sample_files.h"
#include "app/window/main_window.h"
#include "app/window/screen_room.h"
#include "app/window/window_actions.h"

#include <QAction>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>

namespace esm {

namespace {

constexpr int kLayoutVersion = 1; // of the docks: a saved layout of another version is ignored
constexpr int kRecentFiles = 8;

} // namespace

void MainWindow::rememberFile(const QString& path)
{
  QSettings settings;
  QStringList files = settings.value(QStringLiteral("recentFiles")).toStringList();
  const QString absolute = QFileInfo(path).absoluteFilePath();
  files.removeAll(absolute);
  files.prepend(absolute);
  settings.setValue(QStringLiteral("recentFiles"), QStringList(files.mid(0, kRecentFiles)));
  fillRecentMenu();
}

void MainWindow::fillRecentMenu()
{
  QMenu* menu = m_actions->recentMenu;
  menu->clear();
  for (const QString& file : QSettings().value(QStringLiteral("recentFiles")).toStringList()) {
    QAction* action = menu->addAction(QFileInfo(file).fileName(), this, [this, file] { openPath(file); });
    action->setStatusTip(file);
    action->setEnabled(QFileInfo::exists(file));
  }
  menu->addSeparator();
  menu->addAction(tr("Clear list"), this, [this] {
    QSettings().remove(QStringLiteral("recentFiles"));
    fillRecentMenu();
  });
  menu->setEnabled(menu->actions().size() > 2);
}

void MainWindow::fillSampleMenu()
{
  QMenu* menu = m_actions->sampleMenu;
  menu->clear();
  for (const QString& file : sampleFiles()) {
    QAction* action = menu->addAction(sampleTitle(file));
    connect(action, &QAction::triggered, this, [this, file] { playSample(file); });
  }
  menu->setEnabled(!menu->isEmpty());
}

void MainWindow::saveLayout()
{
  QSettings settings;
  settings.setValue(QStringLiteral("geometry"), saveGeometry());
  settings.setValue(QStringLiteral("layout"), saveState(kLayoutVersion));
}

void MainWindow::restoreLayout()
{
  const QSettings settings;
  restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray());
  putOnScreen(this); // the layout below is for the size that comes of it
  restoreState(settings.value(QStringLiteral("layout")).toByteArray(), kLayoutVersion);
  if (minimumSizeHint().height() > height()) applyDefaultLayout(); // it was stored on a higher screen
}

} // namespace esm
