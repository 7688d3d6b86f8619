// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/force_display.h"

#include "app/theme.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace esm {

namespace {
/// The next of 0.1, 0.2, 0.5, 1, 2, 5, ... [N] above a force.
double rimFor(double force)
{
  double rim = 0.1;
  for (const double factor : {2.0, 2.5, 2.0, 2.0, 2.5, 2.0, 2.0, 2.5, 2.0})
    if (rim < force) rim *= factor;
  return rim;
}

} // namespace

ForceDial::ForceDial(QWidget* parent) : QWidget(parent)
{
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  setSizePolicy(policy);
}

void ForceDial::setForce(const Eigen::Vector3d& force)
{
  m_force = force;
  const double needed = rimFor(force.norm());
  if (needed > m_rim || force.norm() < 0.15 * m_rim) m_rim = needed; // no flicker between two scales
  update();
}

void ForceDial::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  constexpr int kBar = 14, kLabel = 16; // [pixel] kept for the bar at the right and the number below
  const double radius = 0.5 * std::min(width() - kBar, height() - kLabel) - 4.0;
  const QPointF centre(0.5 * (width() - kBar), 0.5 * (height() - kLabel));
  QColor faint = palette().color(QPalette::WindowText);
  faint.setAlphaF(0.3F);

  painter.setPen(QPen(faint, 1.0));
  painter.setBrush(palette().base());
  painter.drawEllipse(centre, radius, radius);
  painter.drawEllipse(centre, 0.5 * radius, 0.5 * radius);
  painter.drawLine(centre - QPointF(radius, 0), centre + QPointF(radius, 0));
  painter.drawLine(centre - QPointF(0, radius), centre + QPointF(0, radius));
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.8);
  painter.setFont(small);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(QRectF(centre.x() + radius - 14, centre.y() - 14, 12, 12), Qt::AlignCenter,
                   QStringLiteral("x"));
  painter.drawText(QRectF(centre.x() + 2, centre.y() - radius + 1, 12, 12), Qt::AlignCenter,
                   QStringLiteral("z"));

  painter.drawText(QRectF(0, centre.y() + radius + 2, width() - kBar, kLabel),
                   Qt::AlignHCenter | Qt::AlignTop,
                   QStringLiteral("%1 N").arg(QLocale().toString(m_rim, 'g', 2)));

  const QColor colour = signalColours(palette()).force;
  const double share = std::clamp(m_force.y() / m_rim, -1.0, 1.0);
  const QRectF bar(width() - 10, centre.y() - radius, 6, 2 * radius);
  painter.setPen(QPen(faint, 1.0));
  painter.setBrush(palette().base());
  painter.drawRect(bar);
  painter.fillRect(QRectF(bar.left() + 1, centre.y(), 4, -share * radius).normalized(), colour);
  painter.drawLine(QPointF(bar.left() - 2, centre.y()), QPointF(bar.right() + 2, centre.y()));

  QPointF arrow(m_force.x() / m_rim * radius, -m_force.z() / m_rim * radius);
  const double length = std::hypot(arrow.x(), arrow.y());
  if (length > radius) arrow *= radius / length;
  if (length < 2.0) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(centre, 2.5, 2.5);
    return;
  }
  const QPointF direction = arrow / std::hypot(arrow.x(), arrow.y()), side(-direction.y(), direction.x());
  const QPointF tip = centre + arrow;
  const double head = std::min(9.0, std::hypot(arrow.x(), arrow.y()));
  painter.setPen(QPen(colour, 3.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(centre, tip - direction * head * 0.8);
  QPainterPath path(tip);
  path.lineTo(tip - direction * head + side * head * 0.55);
  path.lineTo(tip - direction * head - side * head * 0.55);
  path.closeSubpath();
  painter.fillPath(path, colour);
}

} // namespace esm
