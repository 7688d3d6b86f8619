// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/viewport/region_gizmo.h"

#include <QColor>
#include <QCoreApplication>
#include <QMap>
#include <QPointF>

class QPainter;
class QPalette;

namespace esm {

/// Draws the handles of a region over the 3D picture, and says what they do. Every line has a rim of the
/// other lightness, so that it can be read on the organ's colours, on light and on dark.
class GizmoPainter {
  Q_DECLARE_TR_FUNCTIONS(esm::GizmoPainter)
public:
  /// All are borrowed for the painter's life.
  GizmoPainter(QPainter& painter, const QPalette& palette, const Camera& camera);

  /// @param lit the handle under the mouse, or None.
  void drawHandles(const GizmoShape& shape, const GizmoHandle& lit);
  void drawLock(const Ellipsoid& ellipsoid); ///< a padlock instead of handles

  static QString help(const GizmoHandle& handle); ///< what the handle does; of None: the tool
  static QString readout(const GizmoDrag& drag);  ///< its numbers now, with units

private:
  QColor colourOf(const GizmoHandle& handle) const;
  void drawRing(const GizmoLayout::Ring& ring, bool front, bool lit);
  void drawArrow(const GizmoLayout::Arrow& arrow, bool lit);
  void drawSpot(const GizmoLayout::Spot& spot, bool lit);

  QPainter& m_painter;
  const Camera& m_camera;
  bool m_dark;
  QColor m_rim;
};

/// A pixel of each handle, by name: see SceneView::gizmoHandles().
QMap<QString, QPointF> gizmoPlaces(const GizmoLayout& layout);

} // namespace esm
