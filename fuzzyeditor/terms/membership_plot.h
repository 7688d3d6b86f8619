// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fuzzy/inference.h"

#include <QPolygonF>
#include <QWidget>

namespace esm {

class FuzzyEvaluation;

/// The terms of one variable over its range, with what is the case now: for an input its value and how far it
/// belongs to each term, for an output the set that the rules add up to and its centroid. Corners are drawn
/// where they are, not where a sample falls; a logarithmic variable has a logarithmic axis.
/// TermPlot lets people move them.
class MembershipPlot : public QWidget {
  Q_OBJECT
public:
  /// @param evaluation not owned, outlives this.
  explicit MembershipPlot(FuzzyEvaluation* evaluation, QWidget* parent = nullptr);

  void setVariable(bool output, int index);
  bool showsOutput() const { return m_output; }
  int variableIndex() const { return m_index; }
  QSize sizeHint() const override { return {360, 200}; }
  QSize minimumSizeHint() const override { return {200, 120}; }

protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

  const fuzzy::Variable* variable() const;
  FuzzyEvaluation* evaluation() const { return m_evaluation; }
  bool canPaint() const { return m_area.width() >= 40 && m_area.height() >= 20 && m_high > m_low; }
  const QRectF& area() const { return m_area; } ///< of the curves
  QPointF toPixel(double axis, double mu) const;
  double toAxis(double pixel) const; ///< of an x in the widget, not kept within the range
  /// Corners exactly, plus samples where the curve is bent; from the left to the right end of the axis.
  QPolygonF termCurve(const fuzzy::Term& term) const;
  void paintCurve(QPainter& painter, const fuzzy::Term& term) const;

  virtual void describe();                                             ///< in words, for screen readers
  virtual void paintBehind(QPainter&, const fuzzy::Variable&) const {} ///< between axes and curves
  virtual void paintBefore(QPainter&, const fuzzy::Variable&) const {} ///< over everything
  virtual int chosenTerm() const { return -1; }                        ///< drawn with more weight

private:
  void layOut();
  void paintAxes(QPainter& painter, const fuzzy::Variable& variable) const;
  void paintTerms(QPainter& painter, const fuzzy::Variable& variable) const;
  void paintWords(QPainter& painter, const fuzzy::Variable& variable,
                  const std::vector<std::pair<double, int>>& peaks) const;
  void paintInput(QPainter& painter, const fuzzy::Variable& variable) const;
  void paintOutput(QPainter& painter, const fuzzy::Variable& variable) const;
  void paintValueLine(QPainter& painter, const fuzzy::Variable& variable, double plain) const;
  void paintHeading(QPainter& painter, double x, const QString& text) const;
  void paintSet(QPainter& painter, QPolygonF outline) const;

  FuzzyEvaluation* m_evaluation;
  bool m_output = false;
  int m_index = 0;
  QRectF m_area;
  double m_low = 0, m_high = 1; ///< axis range
};

} // namespace esm
