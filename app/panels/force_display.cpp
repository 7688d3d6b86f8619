// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/force_display.h"

#include "app/theme.h"

#include <QEvent>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include <algorithm>

namespace esm {

namespace {
constexpr double kShownSeconds = 4.0;

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

ForceCurve::ForceCurve(QWidget* parent) : QWidget(parent), m_plot(new QCustomPlot(this))
{
  m_plot->setObjectName(QStringLiteral("forcePlot"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_plot);
  m_plot->addGraph();
  m_plot->addGraph();
  m_plot->setMinimumSize(160, 90);
  m_plot->legend->setVisible(true);
  m_plot->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignTop | Qt::AlignLeft);
  m_plot->axisRect()->setMinimumMargins(QMargins(2, 4, 8, 2));
  applyPalette();
  retranslateUi();
}

void ForceCurve::addTissueForce(double time, double newtons)
{
  m_now = std::max(m_now, time);
  m_plot->graph(0)->addData(time, newtons);
}

void ForceCurve::addDeviceForce(double time, double newtons)
{
  m_now = std::max(m_now, time);
  m_plot->graph(1)->addData(time, newtons);
}

void ForceCurve::clear()
{
  for (int i = 0; i < 2; ++i) m_plot->graph(i)->data()->clear();
  m_now = 0.0;
}

void ForceCurve::redraw()
{
  for (int i = 0; i < 2; ++i) m_plot->graph(i)->data()->removeBefore(m_now - kShownSeconds - 0.5);
  if (!isVisible()) return;
  double top = 0.5; // [N]: so that noise does not fill the picture
  for (int i = 0; i < 2; ++i)
    for (const QCPGraphData& point : *m_plot->graph(i)->data()) top = std::max(top, point.value);
  m_plot->xAxis->setRange(std::max(0.0, m_now - kShownSeconds), std::max(kShownSeconds, m_now));
  m_plot->yAxis->setRange(0.0, 1.15 * top);
  m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void ForceCurve::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::PaletteChange) applyPalette();
  if (event->type() == QEvent::LanguageChange) retranslateUi();
  QWidget::changeEvent(event);
}

void ForceCurve::applyPalette()
{
  const QColor text = palette().color(QPalette::WindowText);
  QColor faint = text;
  faint.setAlphaF(0.2F);
  m_plot->setBackground(palette().brush(QPalette::Base));
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.85);
  for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis}) {
    axis->setBasePen(QPen(text));
    axis->setTickPen(QPen(text));
    axis->setSubTickPen(QPen(faint));
    axis->setTickLabelColor(text);
    axis->setLabelColor(text);
    axis->setTickLabelFont(small);
    axis->setLabelFont(small);
    axis->grid()->setPen(QPen(faint, 1, Qt::DotLine));
    axis->grid()->setZeroLinePen(Qt::NoPen);
    axis->ticker()->setTickCount(4);
  }
  m_plot->legend->setBrush(Qt::NoBrush);
  m_plot->legend->setBorderPen(Qt::NoPen);
  m_plot->legend->setTextColor(text);
  m_plot->legend->setFont(small);
  const SignalColours colours = signalColours(palette());
  m_plot->graph(0)->setPen(QPen(colours.force, 1.6));
  m_plot->graph(1)->setPen(QPen(colours.device, 1.6, Qt::DashLine));
  m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void ForceCurve::retranslateUi()
{
  m_plot->setLocale(QLocale());
  m_plot->graph(0)->setName(tr("tissue"));
  m_plot->graph(1)->setName(tr("device"));
  m_plot->xAxis->setLabel(tr("time [s]"));
  m_plot->yAxis->setLabel(tr("force [N]"));
  m_plot->setAccessibleName(tr("Force over the last four seconds"));
  m_plot->replot(QCustomPlot::rpQueuedReplot);
}

} // namespace esm
