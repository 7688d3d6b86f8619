// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/haptic_types.h"
#include "haptics/jitter_histogram.h"

#include <QWidget>

#include <span>

class QCPBars;
class QCustomPlot;

namespace esm {

/// The last seconds of a force loop, one kind of figure per plot, curves over the servo's clock.
class TracePlot : public QWidget {
  Q_OBJECT
public:
  enum class Kind {
    Force,    ///< what the tissue gives, what the device got [N]
    Position, ///< of the hand, x, y, z [mm]
    Energy    ///< work done on the hand [mJ]
  };
  static constexpr double kShownSeconds = 4.0;

  explicit TracePlot(Kind kind, QWidget* parent = nullptr);
  void add(std::span<const TraceSample> ticks);
  void addTissueForce(double newtons); ///< Kind::Force: at the newest tick
  void clear();
  void redraw(); ///< call at the rate of the screen at most; does nothing while hidden

protected:
  void changeEvent(QEvent* event) override;

private:
  void applyPalette();
  void retranslateUi();
  void addPoint(const TraceSample& tick);
  Kind m_kind;
  QCustomPlot* m_plot;
  double m_start = -1.0, m_now = 0.0; ///< first and newest time, servo clock [s]; before the first tick -1
  int m_skipped = 0;                  ///< ticks since the last that became a point
};

/// How late the ticks of the servo began: a bar per lateness, and the shares in words.
class JitterPlot : public QWidget {
  Q_OBJECT
public:
  explicit JitterPlot(QWidget* parent = nullptr);
  void show(const JitterCounts& counts); ///< does nothing while hidden
  using QWidget::show;

protected:
  void changeEvent(QEvent* event) override;

private:
  void applyPalette();
  void retranslateUi();
  QCustomPlot* m_plot;
  QCPBars* m_bars;
};

/// Axes, text and grid of a plot in the colours of the widget around it.
void applyPlotPalette(QCustomPlot* plot, const QWidget* around);

} // namespace esm
