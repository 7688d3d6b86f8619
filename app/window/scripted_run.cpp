// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/scripted_run.h"

#include "app/window/window_actions.h"
#include "core/geometry/extent.h"

#include <QAction>
#include <QCoreApplication>
#include <QPainter>
#include <QPixmap>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace esm {

ScriptedRun::ScriptedRun(MainWindow* window, const QString& picture, double seconds)
  : QObject(window), m_window(window), m_picture(picture), m_seconds(seconds)
{
  connect(&m_timer, &QTimer::timeout, this, &ScriptedRun::tick);
  m_timer.start(16);
  m_clock.start();
  m_window->actions()->toolPull->trigger();
  m_window->controller()->setPlaying(true);
}

void ScriptedRun::tick()
{
  const double now = 1e-3 * static_cast<double>(m_clock.elapsed());
  constexpr double kSettle = 0.3; // [s] until the first frames are there
  constexpr double kRise = 0.7;   // [s] a hand does not jump
  SimulationController* run = m_window->controller();
  if (now > kSettle && !run->isPulling() && run->snapshotIsCurrent()) takeHold();
  if (run->isPulling()) {
    const double sway = 0.85 + 0.15 * std::cos(2.0 * std::numbers::pi * 0.8 * (now - m_seconds));
    const double ramp = std::clamp((now - kSettle) / kRise, 0.0, 1.0);
    run->movePull(m_start + ramp * sway * m_reach); // at its farthest when the picture is taken
  }
  if (now >= m_seconds) finish();
}

/// The front-most node near the middle of the picture; without OpenGL the highest one.
void ScriptedRun::takeHold()
{
  const Eigen::Matrix3Xd& nodes = m_window->controller()->snapshot().position;
  if (nodes.cols() == 0) return;
  SceneView* view = m_window->sceneView();
  Index node = kNoIndex;
  for (int ring = 0; ring < 40 && node == kNoIndex; ++ring)
    node = view->nodeAt(QPointF(0.5 * view->width(), 0.5 * view->height() - 6.0 * ring));
  if (node == kNoIndex) nodes.row(2).maxCoeff(&node);
  const double size = extentOf(nodes);
  const Eigen::Vector3d middle = nodes.rowwise().mean();
  m_start = nodes.col(node);
  m_reach = 0.09 * size * ((m_start - middle).normalized() + Eigen::Vector3d(0, 0, 0.4));
  m_window->selectNode(node);
  m_window->controller()->startPull(node, m_start);
}

void ScriptedRun::finish()
{
  m_timer.stop();
  QPixmap picture = m_window->grab(); // without the preview's overlays
  SceneView* view = m_window->sceneView();
  if (view->hasOpenGl()) QPainter(&picture).drawImage(view->mapTo(m_window, QPoint(0, 0)), view->picture());
  const bool saved = picture.save(m_picture);
  if (!saved) std::fprintf(stderr, "esm-modeler: %s: the picture cannot be written\n", qPrintable(m_picture));
  QCoreApplication::exit(saved ? 0 : 1);
}

} // namespace esm
