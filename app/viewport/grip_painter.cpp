// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/grip_painter.h"

#include <QLineF>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace esm {

namespace {

QPointF onScreen(const Eigen::Vector2d& pixel)
{
  return {pixel.x(), pixel.y()};
}

QColor translucent(QColor colour, double alpha)
{
  colour.setAlphaF(static_cast<float>(alpha));
  return colour;
}

const QColor kHalo(255, 255, 255, 200); ///< keeps the rim apart from tissue of any colour

} // namespace

void GripPainter::drawHeld()
{
  constexpr int kLevels = 8;
  const std::vector<Index>& held = m_model.heldNodes();
  if (held.empty()) return;
  const double radius = 1.5 * m_model.grip().radius();
  const double cell = std::sqrt(std::numbers::pi * radius * radius / static_cast<double>(held.size()));
  const double pixels = cell / m_model.camera.metresPerPixel(m_model.position().col(held.front()));
  const double width = std::clamp(pixels, 2.5, 7.0);
  std::array<QPolygonF, kLevels> dots;
  const Projector projector = m_model.camera.projector();
  for (std::size_t i = 0; i < held.size(); ++i) {
    const QPointF at = onScreen(projector(m_model.position().col(held[i])).pixel);
    const auto level = static_cast<std::size_t>(m_model.grip().heldShares()[i] * (kLevels - 1) + 0.5);
    if (!std::isnan(at.x())) dots[std::min<std::size_t>(level, kLevels - 1)] << at;
  }
  for (std::size_t level = 0; level < kLevels; ++level) {
    if (dots[level].isEmpty()) continue;
    const double alpha = 0.06 + 0.5 * static_cast<double>(level) / (kLevels - 1);
    m_painter.setPen(QPen(translucent(m_accent, alpha), width, Qt::SolidLine, Qt::RoundCap));
    m_painter.drawPoints(dots[level]);
  }
}

/// Only the side of the surface that is seen.
void GripPainter::drawOutline(Index node, const GripMark::Outline& outline)
{
  const Eigen::Matrix3Xd& position = m_model.position();
  const Camera& camera = m_model.camera;
  const auto towardsEye = [&](const Eigen::Vector3d& normal, const Eigen::Vector3d& at) {
    return normal.dot(camera.orthographic() ? camera.backward() : Eigen::Vector3d(camera.eye() - at));
  };
  const bool outside = towardsEye(m_model.grip().normal(position, node), position.col(node)) >= 0.0;
  const auto placeOf = [&](const GripMark::Place& place) -> Eigen::Vector3d {
    return position.col(place.from) + place.share * (position.col(place.to) - position.col(place.from));
  };
  const Projector projector = camera.projector();
  QList<QLineF> lines;
  for (std::size_t i = 0; i + 1 < outline.size(); i += 2) {
    const auto corners = m_model.net()->triangles.col(outline[i].triangle);
    const Eigen::Vector3d a = position.col(corners[0]), ab = position.col(corners[1]) - a,
                          ac = position.col(corners[2]) - a;
    if ((towardsEye(ab.cross(ac), a) >= 0.0) != outside) continue;
    const QLineF line(onScreen(projector(placeOf(outline[i])).pixel),
                      onScreen(projector(placeOf(outline[i + 1])).pixel));
    if (!std::isnan(line.dx()) && !std::isnan(line.dy())) lines << line;
  }
  m_painter.setPen(QPen(kHalo, 4.0, Qt::SolidLine, Qt::FlatCap));
  m_painter.drawLines(lines);
  m_painter.setPen(QPen(m_accent, 2.0, Qt::SolidLine, Qt::RoundCap));
  m_painter.drawLines(lines);
}

void GripPainter::drawRim(Index node)
{
  const GripMark& grip = m_model.grip();
  const bool isHeld = grip.heldNode() == node;
  const GripMark::Outline outline = isHeld ? grip.heldOutline() : grip.outline(m_model.position(), node);
  if (!outline.empty()) return drawOutline(node, outline);
  const Eigen::Vector3d place = m_model.position().col(node);
  const QPointF at = onScreen(m_model.camera.project(place).pixel);
  const double radius = grip.radius() / m_model.camera.metresPerPixel(place);
  if (!(radius > 0.0) || std::isnan(at.x())) return;
  m_painter.setBrush(Qt::NoBrush);
  for (const QPen& pen : {QPen(kHalo, 4.0), QPen(m_accent, 2.0)}) {
    m_painter.setPen(pen);
    m_painter.drawEllipse(at, radius, radius);
  }
}

} // namespace esm
