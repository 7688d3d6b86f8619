// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>
#include <QString>

class QWidget;

namespace esm {

/// One movable point of a plot, as screen readers tell it: a slider with a name and a value.
struct PlotPoint {
  QString name;                                           ///< "soft: left foot"
  QString valueText;                                      ///< with unit
  double value = 0, least = 0, greatest = 1, step = 0.01; ///< as displayed
  QRect place;                                            ///< in the plot
  bool focused = false;
};

/// A plot whose points stand in the accessibility tree below it. GUI thread.
class PointedPlot {
public:
  virtual ~PointedPlot() = default;
  virtual int pointCount() const = 0;
  virtual PlotPoint point(int index) const = 0;
  virtual void setPoint(int index, double value) = 0; ///< nearest place that is possible
};

/// Makes Qt ask here for every widget that is a PointedPlot. Call it before the first one is shown; calls
/// after the first do nothing.
void installPlotAccess();
/// Tells screen readers that a point has another value, or has the keyboard now.
void announcePlotPoint(QWidget* plot, int index, bool focus);

} // namespace esm
