// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/trace_plots.h"

#include "app/theme.h"

#include <QEvent>
#include <QLocale>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include <algorithm>

namespace esm {

namespace {

constexpr int kEvery = 8; // 1000 ticks per second are more than the curve has pixels

/// The least range that is shown, so that noise does not fill the picture: [N], [mm], [mJ].
double leastSpan(TracePlot::Kind kind)
{
  switch (kind) {
  case TracePlot::Kind::Force:
    return 0.5;
  case TracePlot::Kind::Position:
    return 2.0;
  case TracePlot::Kind::Energy:
    break;
  }
  return 1.0;
}

const char* plotName(TracePlot::Kind kind)
{
  switch (kind) {
  case TracePlot::Kind::Force:
    return "forcePlot";
  case TracePlot::Kind::Position:
    return "positionPlot";
  case TracePlot::Kind::Energy:
    break;
  }
  return "energyPlot";
}

} // namespace

void applyPlotPalette(QCustomPlot* plot, const QWidget* around)
{
  const QPalette& palette = around->palette();
  const QColor text = palette.color(QPalette::WindowText);
  QColor faint = text;
  faint.setAlphaF(0.2F);
  plot->setBackground(palette.brush(QPalette::Base));
  QFont small = around->font();
  small.setPointSizeF(small.pointSizeF() * 0.85);
  for (QCPAxis* axis : {plot->xAxis, plot->yAxis}) {
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
  plot->legend->setBrush(Qt::NoBrush);
  plot->legend->setBorderPen(Qt::NoPen);
  plot->legend->setTextColor(text);
  plot->legend->setFont(small);
}

TracePlot::TracePlot(Kind kind, QWidget* parent)
  : QWidget(parent), m_kind(kind), m_plot(new QCustomPlot(this))
{
  m_plot->setObjectName(QLatin1String(plotName(kind)));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_plot);
  const int curves = kind == Kind::Force ? 2 : kind == Kind::Position ? 3 : 1;
  for (int i = 0; i < curves; ++i) m_plot->addGraph();
  m_plot->setMinimumSize(160, 90);
  m_plot->legend->setVisible(curves > 1);
  m_plot->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignTop | Qt::AlignLeft);
  m_plot->axisRect()->setMinimumMargins(QMargins(2, 4, 8, 2));
  applyPalette();
  retranslateUi();
}

void TracePlot::add(std::span<const TraceSample> ticks)
{
  for (const TraceSample& tick : ticks) {
    if (m_start < 0.0) m_start = tick.time;
    m_now = tick.time - m_start;
    if (++m_skipped < kEvery) continue;
    m_skipped = 0;
    addPoint(tick);
  }
}

void TracePlot::addPoint(const TraceSample& tick)
{
  switch (m_kind) {
  case Kind::Force:
    m_plot->graph(1)->addData(m_now, tick.force.norm());
    break;
  case Kind::Position:
    for (int axis = 0; axis < 3; ++axis) m_plot->graph(axis)->addData(m_now, 1e3 * tick.position[axis]);
    break;
  case Kind::Energy:
    m_plot->graph(0)->addData(m_now, 1e3 * tick.work);
    break;
  }
}

void TracePlot::addTissueForce(double newtons)
{
  if (m_kind == Kind::Force && m_now > 0.0) m_plot->graph(0)->addData(m_now, newtons);
}

void TracePlot::clear()
{
  for (int i = 0; i < m_plot->graphCount(); ++i) m_plot->graph(i)->data()->clear();
  m_start = -1.0;
  m_now = 0.0;
}

void TracePlot::redraw()
{
  double least = 1e300, most = -1e300;
  for (int i = 0; i < m_plot->graphCount(); ++i) {
    m_plot->graph(i)->data()->removeBefore(m_now - kShownSeconds - 0.5);
    for (const QCPGraphData& point : *m_plot->graph(i)->data()) {
      least = std::min(least, point.value);
      most = std::max(most, point.value);
    }
  }
  if (!isVisible()) return;
  const double span = leastSpan(m_kind);
  if (least > most) least = most = 0.0;
  if (m_kind == Kind::Force)
    m_plot->yAxis->setRange(0.0, 1.15 * std::max(most, span));
  else
    m_plot->yAxis->setRange(least - 0.1 * span, std::max(most, least + span) + 0.1 * span);
  m_plot->xAxis->setRange(std::max(0.0, m_now - kShownSeconds), std::max(kShownSeconds, m_now));
  m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void TracePlot::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::PaletteChange) applyPalette();
  if (event->type() == QEvent::LanguageChange) retranslateUi();
  QWidget::changeEvent(event);
}

void TracePlot::applyPalette()
{
  applyPlotPalette(m_plot, this);
  const SignalColours colours = signalColours(palette());
  if (m_kind == Kind::Force) {
    m_plot->graph(0)->setPen(QPen(colours.force, 1.6));
    m_plot->graph(1)->setPen(QPen(colours.device, 1.6, Qt::DashLine));
  } else if (m_kind == Kind::Position) {
    m_plot->graph(0)->setPen(QPen(colours.bad, 1.6));
    m_plot->graph(1)->setPen(QPen(colours.good, 1.6, Qt::DashLine));
    m_plot->graph(2)->setPen(QPen(colours.device, 1.6, Qt::DotLine));
  } else {
    m_plot->graph(0)->setPen(QPen(colours.force, 1.6));
  }
  m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void TracePlot::retranslateUi()
{
  m_plot->setLocale(QLocale());
  m_plot->xAxis->setLabel(tr("time [s]"));
  switch (m_kind) {
  case Kind::Force:
    m_plot->graph(0)->setName(tr("tissue"));
    m_plot->graph(1)->setName(tr("device"));
    m_plot->yAxis->setLabel(tr("force [N]"));
    m_plot->setAccessibleName(tr("Force over the last four seconds"));
    break;
  case Kind::Position:
    for (int axis = 0; axis < 3; ++axis) m_plot->graph(axis)->setName(QStringLiteral("xyz").mid(axis, 1));
    m_plot->yAxis->setLabel(tr("position [mm]"));
    m_plot->setAccessibleName(tr("Position of the hand over the last four seconds"));
    break;
  case Kind::Energy:
    m_plot->yAxis->setLabel(tr("work on the hand [mJ]"));
    m_plot->setAccessibleName(tr("Work done on the hand since the device was connected"));
    break;
  }
  m_plot->replot(QCustomPlot::rpQueuedReplot);
}

// === Jitter

JitterPlot::JitterPlot(QWidget* parent) : QWidget(parent), m_plot(new QCustomPlot(this))
{
  m_plot->setObjectName(QStringLiteral("jitterPlot"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_plot);
  m_bars = new QCPBars(m_plot->xAxis, m_plot->yAxis);
  m_bars->setWidthType(QCPBars::wtAxisRectRatio);
  m_bars->setWidth(1.0 / static_cast<double>(JitterCounts::kBins) * 0.9);
  m_plot->setMinimumSize(160, 90);
  m_plot->xAxis->setScaleType(QCPAxis::stLogarithmic);
  m_plot->xAxis->setTicker(QSharedPointer<QCPAxisTickerLog>(new QCPAxisTickerLog));
  m_plot->xAxis->setRange(1e-3, 100.0);
  m_plot->yAxis->setScaleType(QCPAxis::stLogarithmic);
  m_plot->yAxis->setTicker(QSharedPointer<QCPAxisTickerLog>(new QCPAxisTickerLog));
  for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis}) {
    axis->setNumberFormat(QStringLiteral("g"));
    axis->setNumberPrecision(6);
  }
  m_bars->setBaseValue(0.5); // one tick is seen as a bar
  m_plot->axisRect()->setMinimumMargins(QMargins(2, 4, 8, 2));
  applyPalette();
  retranslateUi();
}

void JitterPlot::show(const JitterCounts& counts)
{
  if (!isVisible()) return;
  QVector<double> lateness, ticks;
  double most = 10.0;
  for (std::size_t bin = 0; bin < JitterCounts::kBins; ++bin) {
    if (counts.count[bin] == 0) continue;
    lateness.append(1e3 * std::min(JitterCounts::upperEdge(bin), 0.1));
    ticks.append(static_cast<double>(counts.count[bin]));
    most = std::max(most, ticks.back());
  }
  m_bars->setData(lateness, ticks, true);
  m_plot->yAxis->setRange(0.5, 2.0 * most);
  m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void JitterPlot::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::PaletteChange) applyPalette();
  if (event->type() == QEvent::LanguageChange) retranslateUi();
  QWidget::changeEvent(event);
}

void JitterPlot::applyPalette()
{
  applyPlotPalette(m_plot, this);
  const QColor colour = signalColours(palette()).device;
  m_bars->setPen(QPen(colour));
  m_bars->setBrush(colour);
  m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void JitterPlot::retranslateUi()
{
  m_plot->setLocale(QLocale());
  m_plot->xAxis->setLabel(tr("lateness [ms]"));
  m_plot->yAxis->setLabel(tr("ticks"));
  m_plot->setAccessibleName(tr("How late the ticks of the force loop began"));
  m_plot->replot(QCustomPlot::rpQueuedReplot);
}

} // namespace esm
