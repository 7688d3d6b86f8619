// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/main_window.h"

#include <QElapsedTimer>
#include <QTimer>

namespace esm {

/// The run behind --screenshot: plays, takes hold of the node in the middle of the picture, pulls it to and
/// fro, and saves the window as a picture. Ends the program with 0, or 1 with a reason on stderr.
class ScriptedRun : public QObject {
  Q_OBJECT
public:
  ScriptedRun(MainWindow* window, const QString& picture, double seconds);

private:
  void tick();
  void takeHold();
  void finish();

  MainWindow* m_window;
  QString m_picture;
  double m_seconds;
  QElapsedTimer m_clock;
  QTimer m_timer;
  Eigen::Vector3d m_start = Eigen::Vector3d::Zero(); ///< where the node was taken [m]
  Eigen::Vector3d m_reach = Eigen::Vector3d::Zero(); ///< how far it is pulled [m]
};

} // namespace esm
