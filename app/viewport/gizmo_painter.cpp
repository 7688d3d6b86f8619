// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/gizmo_painter.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

#include <cmath>
#include <numbers>

namespace esm {

namespace {

using HandleKind = GizmoHandle::Kind;

const QColor kAccent(0xf2, 0x6b, 0x21); // as the wire of the chosen region

QPointF toQt(const Eigen::Vector2d& pixel)
{
  return {pixel.x(), pixel.y()};
}

QString millimetres(double metres)
{
  return QLocale().toString(1000.0 * metres, 'f', 1);
}

QString axisName(int axis)
{
  return QStringLiteral("xyz").mid(axis, 1);
}

QString nameOf(const GizmoHandle& handle)
{
  switch (handle.kind) {
  case HandleKind::Move:
    return QStringLiteral("move");
  case HandleKind::Falloff:
    return QStringLiteral("falloff");
  case HandleKind::Slide:
    return QStringLiteral("slide ") + axisName(handle.axis);
  case HandleKind::Turn:
    return QStringLiteral("turn ") + axisName(handle.axis);
  case HandleKind::Stretch:
    return QStringLiteral("stretch ") + axisName(handle.axis) + QLatin1Char(handle.side > 0 ? '+' : '-');
  case HandleKind::None:
    break;
  }
  return {};
}

} // namespace

GizmoPainter::GizmoPainter(QPainter& painter, const QPalette& palette, const Camera& camera)
  : m_painter(painter),
    m_camera(camera),
    m_dark(palette.color(QPalette::Window).lightness() < 128),
    m_rim(m_dark ? QColor(0x12, 0x14, 0x16, 210) : QColor(255, 255, 255, 230))
{}

QColor GizmoPainter::colourOf(const GizmoHandle& handle) const
{
  if (handle.kind == HandleKind::Move || handle.kind == HandleKind::Falloff)
    return m_dark ? kAccent.lighter(125) : kAccent;
  const QColor axes[] = {QColor(0xd6, 0x45, 0x41), QColor(0x3f, 0x8f, 0x2f), QColor(0x2f, 0x6f, 0xd0)};
  const QColor colour = axes[handle.axis];
  return m_dark ? colour.lighter(150) : colour;
}

void GizmoPainter::drawHandles(const GizmoShape& shape, const GizmoHandle& lit)
{
  const GizmoLayout layout = layoutGizmo(m_camera, shape);
  m_painter.save();
  for (const bool front : {false, true})
    for (const auto& ring : layout.rings) drawRing(ring, front, ring.handle == lit);
  for (const auto& arrow : layout.arrows) drawArrow(arrow, arrow.handle == lit);
  for (auto spot = layout.spots.rbegin(); spot != layout.spots.rend(); ++spot) // the preferred ones on top
    drawSpot(*spot, spot->handle == lit);
  m_painter.restore();
}

void GizmoPainter::drawRing(const GizmoLayout::Ring& ring, bool front, bool lit)
{
  QPainterPath path;
  for (std::size_t i = 0; i + 1 < ring.pixels.size(); ++i) {
    const Eigen::Vector2d &a = ring.pixels[i], &b = ring.pixels[i + 1];
    if (ring.front[i] != front || !a.allFinite() || !b.allFinite()) continue;
    if (path.isEmpty() || path.currentPosition() != toQt(a)) path.moveTo(toQt(a));
    path.lineTo(toQt(b));
  }
  QColor colour = colourOf(ring.handle);
  if (!front) colour.setAlphaF(lit ? 0.6f : 0.3f);
  const double width = lit ? 3.6 : 1.8;
  m_painter.setBrush(Qt::NoBrush);
  if (front) m_painter.strokePath(path, QPen(m_rim, width + 2.4, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
  m_painter.strokePath(path, QPen(colour, width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
}

void GizmoPainter::drawArrow(const GizmoLayout::Arrow& arrow, bool lit)
{
  const QPointF from = toQt(arrow.from), to = toQt(arrow.to);
  const QPointF unit = (to - from) / std::hypot((to - from).x(), (to - from).y());
  if (!std::isfinite(unit.x()) || !std::isfinite(from.x())) return;
  const QPointF side(-unit.y(), unit.x()), neck = to - 12.0 * unit;
  const QPolygonF tip({to, neck + 6.0 * side, neck - 6.0 * side});
  const QColor colour = colourOf(arrow.handle);
  const double width = lit ? 4.5 : 2.8;
  for (const auto& [ink, wider] : {std::pair(m_rim, 2.8), std::pair(colour, 0.0)}) {
    m_painter.setPen(QPen(ink, width + wider, Qt::SolidLine, Qt::RoundCap));
    m_painter.drawLine(from, neck);
    m_painter.setPen(QPen(ink, wider + (lit ? 2.0 : 0.5), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.setBrush(ink);
    m_painter.drawPolygon(tip);
  }
}

/// Squares stretch, the diamond is the falloff, the circle the centre.
void GizmoPainter::drawSpot(const GizmoLayout::Spot& spot, bool lit)
{
  const QPointF at = toQt(spot.pixel);
  if (!std::isfinite(at.x()) || !std::isfinite(at.y())) return;
  const double half = lit ? 7.0 : 5.0;
  QPainterPath path;
  if (spot.handle.kind == HandleKind::Stretch)
    path.addRect(QRectF(at - QPointF(half, half), at + QPointF(half, half)));
  else if (spot.handle.kind == HandleKind::Falloff)
    path.addPolygon(QPolygonF({at + QPointF(0, -1.4 * half), at + QPointF(1.4 * half, 0),
                               at + QPointF(0, 1.4 * half), at + QPointF(-1.4 * half, 0)}));
  else
    path.addEllipse(at, half + 1.0, half + 1.0);
  path.closeSubpath();
  m_painter.strokePath(path, QPen(m_rim, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  m_painter.fillPath(path, colourOf(spot.handle));
}

void GizmoPainter::drawLock(const Ellipsoid& ellipsoid)
{
  const QPointF at = toQt(m_camera.project(ellipsoid.centre).pixel);
  if (!std::isfinite(at.x()) || !std::isfinite(at.y())) return;
  QPainterPath shackle, body;
  shackle.moveTo(at + QPointF(-6, 0));
  shackle.lineTo(at + QPointF(-6, -5));
  shackle.arcTo(QRectF(at + QPointF(-6, -11), QSizeF(12, 12)), 180.0, -180.0);
  shackle.lineTo(at + QPointF(6, 0));
  body.addRoundedRect(QRectF(at + QPointF(-10, -1), QSizeF(20, 15)), 2.5, 2.5);
  const QColor colour = m_dark ? kAccent.lighter(125) : kAccent;
  m_painter.setBrush(Qt::NoBrush);
  m_painter.strokePath(shackle, QPen(m_rim, 6.0));
  m_painter.strokePath(body, QPen(m_rim, 3.0));
  m_painter.strokePath(shackle, QPen(colour, 3.0));
  m_painter.fillPath(body, colour);
}

QString GizmoPainter::help(const GizmoHandle& handle)
{
  switch (handle.kind) {
  case HandleKind::Move:
    return tr("Move the region in the plane of the screen");
  case HandleKind::Slide:
    return tr("Move the region along its axis %1").arg(axisName(handle.axis));
  case HandleKind::Turn:
    return tr("Turn the region about its axis %1").arg(axisName(handle.axis));
  case HandleKind::Stretch:
    return tr("Change the semi-axis %1; with Shift all of them").arg(axisName(handle.axis));
  case HandleKind::Falloff:
    return tr("Change the falloff: from here the weight falls");
  case HandleKind::None:
    break;
  }
  return tr("Region: drag a handle to move, turn or resize it; beside them, dragging turns the view");
}

QString GizmoPainter::readout(const GizmoDrag& drag)
{
  const Ellipsoid& now = drag.shape().ellipsoid;
  switch (drag.handle().kind) {
  case HandleKind::Move:
  case HandleKind::Slide:
    return tr("Centre %1 · %2 · %3 mm, moved by %4 mm; Esc takes it back")
      .arg(millimetres(now.centre.x()), millimetres(now.centre.y()), millimetres(now.centre.z()),
           millimetres((now.centre - drag.start().ellipsoid.centre).norm()));
  case HandleKind::Turn:
    return tr("Turned by %1° about the axis %2; Esc takes it back")
      .arg(QLocale().toString(180.0 / std::numbers::pi * drag.angle(), 'f', 1), axisName(drag.handle().axis));
  case HandleKind::Stretch:
    return tr("Semi-axes %1 · %2 · %3 mm; Esc takes it back")
      .arg(millimetres(now.semiAxes.x()), millimetres(now.semiAxes.y()), millimetres(now.semiAxes.z()));
  case HandleKind::Falloff:
    return tr("Falloff %1 %; Esc takes it back")
      .arg(QLocale().toString(100.0 * drag.shape().falloff, 'f', 0));
  case HandleKind::None:
    break;
  }
  return {};
}

QMap<QString, QPointF> gizmoPlaces(const GizmoLayout& layout)
{
  QMap<QString, QPointF> places;
  const auto add = [&](const GizmoHandle& handle, const Eigen::Vector2d& pixel) {
    const bool taken = !pixel.allFinite() || places.contains(nameOf(handle));
    if (!taken && handleAt(layout, pixel) == handle) places.insert(nameOf(handle), toQt(pixel));
  };
  for (const auto& spot : layout.spots) add(spot.handle, spot.pixel);
  for (const auto& arrow : layout.arrows) add(arrow.handle, 0.5 * (arrow.from + arrow.to));
  for (const auto& ring : layout.rings)
    for (std::size_t i = 0; i < ring.pixels.size(); ++i)
      if (ring.front[i]) add(ring.handle, ring.pixels[i]);
  return places;
}

} // namespace esm
