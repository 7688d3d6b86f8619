// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/falloff_curve.h"

#include "fuzzyeditor/panel_colors.h"

#include <QPainter>
#include <QPainterPath>

namespace esm {

namespace {

constexpr double kFarthest = 1.3; ///< radius at the right border

} // namespace

FalloffCurve::FalloffCurve(QWidget* parent) : QWidget(parent)
{
  setMinimumSize(60, 36);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void FalloffCurve::show(const Region& region)
{
  const Curve curve{region.profile, region.falloff, region.insideOut};
  if (m_curve == curve) return;
  m_curve = curve;
  update();
}

void FalloffCurve::clear()
{
  m_curve.reset();
  update();
}

void FalloffCurve::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.setPen(panel_colors::faint(palette()));
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawRect(frame);
  if (!m_curve) return;

  const QRectF plot = frame.adjusted(3.0, 5.0, -3.0, -4.0);
  const auto at = [&](double radius, double weight) {
    return QPointF(plot.left() + radius / kFarthest * plot.width(), plot.bottom() - weight * plot.height());
  };
  painter.drawLine(at(1.0, -0.1), at(1.0, 1.1));
  QPainterPath line;
  const int steps = std::max(2, static_cast<int>(plot.width()));
  for (int i = 0; i <= steps; ++i) {
    const double radius = kFarthest * i / steps;
    const double inside = profileWeight(m_curve->profile, radius, m_curve->falloff);
    const QPointF point = at(radius, m_curve->insideOut ? 1.0 - inside : inside);
    i == 0 ? line.moveTo(point) : line.lineTo(point);
  }
  QPainterPath area = line;
  area.lineTo(plot.bottomRight());
  area.lineTo(plot.bottomLeft());
  area.closeSubpath();
  QColor ground = panel_colors::curve(palette(), 0);
  painter.strokePath(line, QPen(ground, 2.0));
  ground.setAlphaF(0.18f);
  painter.fillPath(area, ground);
}

} // namespace esm
