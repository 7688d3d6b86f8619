// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/main_window.h"

#include <QTimer>

namespace esm {

/// Diagnostic behind --dump-state: writes what the window shows as one JSON object, twice a second, all or
/// nothing. Journeys with real mouse and keys read it to find widgets (places on the screen) and to assert:
///
///   title modified path language nodes springs playing time undoCount undoIndex inputs ruleCount regions
///   target selectedNode selectedSpring why clipboard
///   toolForce stability solver message meanStiffness device pullPoint springPoint
///   points { plot: [name, x, y, value] of its movable points }
///   widgets { objectName: [x, y, width, height] of those that can be seen; tab i of a tab widget: name + i }
///   texts { objectName: what a label or text editor says }, items { objectName: rows of a list or table }
///   dialog (its object name)
class StateDump : public QObject {
  Q_OBJECT
public:
  StateDump(MainWindow* window, const QString& file);

private:
  void write();
  MainWindow* m_window;
  QString m_file;
  QTimer m_timer;
};

} // namespace esm
