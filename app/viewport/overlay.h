// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/viewport/region_gizmo.h"
#include "app/viewport/scene_model.h"

#include <QCoreApplication>

class QFontMetricsF;
class QPainter;
class QPalette;

namespace esm {

/// What the overlay shows beside the model.
struct OverlayState {
  Tool tool = Tool::Camera;
  Index hovered = kNoIndex, selected = kNoIndex, selectedSpring = kNoIndex, pulled = kNoIndex;
  Eigen::Vector3d pullTarget = Eigen::Vector3d::Zero(); ///< [m]
  Eigen::Vector3d toolForce = Eigen::Vector3d::Zero();  ///< [N]
  GizmoHandle handle;                                   ///< under the mouse or dragged
  const GizmoDrag* drag = nullptr;                      ///< of the gizmo, while it goes on; borrowed
  std::optional<Eigen::AlignedBox2d> selectionBox;
  bool keyboardFocus = false;
};

/// The flat things over the 3D picture: legend, axes, scale bar, hint line, rings around nodes, force arrow,
/// the gizmo of the chosen region.
/// Texts are translated and numbers written in the user's locale. Draws within the camera's width and height.
class Overlay {
  Q_DECLARE_TR_FUNCTIONS(esm::Overlay)
public:
  /// The painter is borrowed for the call; the model and the state too.
  Overlay(QPainter& painter, const QPalette& palette, const SceneModel& model, const OverlayState& state);
  void draw();

private:
  void drawPull();
  void drawRegion();
  void drawSelectionBox();
  QString hint() const;
  void drawForce(Index node);
  void drawSelectedSpring();
  void drawMarks();
  void drawInstrument();
  void drawRing(Index node, double radius, const QColor& colour);
  void drawRingAt(const Eigen::Vector3d& place, double radius, const QColor& colour);
  void drawLegend();
  void drawAxes();
  void drawScaleBar();
  void drawHint();
  void drawEmpty();
  void panel(const QRectF& rect); ///< a quiet plate behind text

  QPainter& m_painter;
  const QPalette& m_palette;
  const SceneModel& m_model;
  const OverlayState& m_state;
  double m_width, m_height; ///< [logical pixels]
};

/// Title and unit of a legend, and the factor from SI to that unit.
struct LegendText {
  QString title;
  double perSi = 1.0;
};
LegendText legendText(const SceneModel& model);

/// How much of the picture's right edge the legend takes [logical pixels]; 0 while there is none. It depends
/// on the title and the font, not on the numbers: these may follow the motion.
double legendRoom(const SceneModel& model, const QFontMetricsF& metrics);

/// A number for a legend: as short as its neighbours need, never in exponent form within [1e-4, 1e7).
QString legendNumber(double value);

} // namespace esm
