// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fuzzy/control_surface.h"
#include "fuzzyeditor/gesture.h"
#include "fuzzyeditor/plot_access.h"

#include <QImage>
#include <QWidget>

#include <optional>
#include <vector>

namespace esm {

class SurfaceSource;

/// One output over two inputs as a map: colours of equal steps, lines of equal value with their numbers,
/// words along the axes, hatching where no rule fires. A cross marks the present inputs; dragging it sets
/// both, as one undo step.
///
///     mouse          press or drag anywhere, Esc takes the drag back
///     arrows         move the cross by 1/100 of the range, with Shift by 10 such steps
///     Home, End      to the ends of the lower axis; Page Up, Page Down of the upright one
///
/// Screen readers see both inputs as sliders; their value says what the rules make of it.
class SurfacePlot : public QWidget, public PointedPlot {
  Q_OBJECT
public:
  /// @param source not owned, outlives this.
  explicit SurfacePlot(SurfaceSource* source, QWidget* parent = nullptr);

  int pointCount() const override;
  PlotPoint point(int index) const override;
  void setPoint(int index, double value) override;

  QRectF area() const;   ///< of the map
  QPointF cross() const; ///< where the present inputs are, in the plot
  QSize sizeHint() const override { return {360, 260}; }
  QSize minimumSizeHint() const override { return {200, 150}; }

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

private:
  /// Least and greatest of the colours, on the output's axis.
  struct Scale {
    double least = 0.0, greatest = 1.0;
    double shareOf(double axis) const;
  };
  bool canShow() const;
  int wordWidth() const;
  void refresh();
  QString sentence() const; ///< "Hardness 0.68, elasticity 0.20: stiffness 33 kPa"
  QString quantityOf(int index) const;
  double axisOfInput(int index) const;          ///< 0: x, 1: y; place on its axis
  void moveTo(double x, double y, int gesture); ///< places on the axes
  void moveToPixel(const QPointF& pixel);
  void step(double x, double y);
  QPointF pixelOf(double column, double row) const; ///< grid units

  Scale scale(const fuzzy::ControlSurface& surface) const;
  void paintMap(QPainter& painter, const fuzzy::ControlSurface& surface, const Scale& colours) const;
  void paintContours(QPainter& painter, const fuzzy::ControlSurface& surface, const Scale& colours) const;
  void paintAxes(QPainter& painter) const;
  void paintLegend(QPainter& painter, const Scale& colours) const;
  void paintCross(QPainter& painter) const;

  SurfaceSource* m_source;
  bool m_dragging = false;
  int m_gesture = 0;                      ///< of the drag
  std::vector<fuzzy::InputValue> m_start; ///< inputs at the beginning of the drag
  KeyRun m_keys;
};

} // namespace esm
