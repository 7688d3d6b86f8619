// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/viewport/scene_model.h"

#include <QColor>

class QPainter;

namespace esm {

/// Draws over the picture what the pull tool would hold, or holds: the rim where it does so by half, and the held
/// nodes, the stronger the more wholly they are held. Borrows all for a repaint.
class GripPainter {
public:
  GripPainter(QPainter& painter, const SceneModel& model, const QColor& accent)
    : m_painter(painter), m_model(model), m_accent(accent)
  {}
  void drawHeld();
  void drawRim(Index node); ///< around it, whether it is held or not; a circle around nodes without triangles

private:
  void drawOutline(Index node, const GripMark::Outline& outline);

  QPainter& m_painter;
  const SceneModel& m_model;
  QColor m_accent;
};

} // namespace esm
