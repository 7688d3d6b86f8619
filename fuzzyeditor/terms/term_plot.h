// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fuzzy/term_editing.h"
#include "fuzzyeditor/plot_access.h"
#include "fuzzyeditor/terms/membership_plot.h"

#include <optional>

namespace esm {

class TermEdits;

/// The plot of a variable's terms as an editor. Feet, peaks, shoulders and whole curves are dragged; behind
/// the curves stands, pale, how they were when the document was last saved.
///
///     mouse            drag a point or a curve, Esc takes the drag back
///     Tab, Shift+Tab   from point to point, behind the last one to the next widget
///     arrows           move the point by 1/100 of the range; Shift: by 10 such steps, Ctrl: the curve
///     Home, End        to the limits of the point
///     Delete           removes the term
///
/// Screen readers see every point as a slider, "soft: left foot", whose value they can set.
class TermPlot : public MembershipPlot, public PointedPlot {
  Q_OBJECT
public:
  /// @param evaluation, edits not owned, outlive this.
  TermPlot(FuzzyEvaluation* evaluation, TermEdits* edits, QWidget* parent = nullptr);

  int pointCount() const override;
  PlotPoint point(int index) const override;
  void setPoint(int index, double value) override;
  QPointF pixelOf(int term, fuzzy::Handle handle) const;

  /// "left foot": what a handle of a term is called.
  static QString handleName(const fuzzy::Term& term, fuzzy::Handle handle);

protected:
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool focusNextPrevChild(bool next) override;

  void describe() override;
  void paintBehind(QPainter& painter, const fuzzy::Variable& variable) const override;
  void paintBefore(QPainter& painter, const fuzzy::Variable& variable) const override;
  int chosenTerm() const override;

private:
  struct Grip {
    int term = -1;
    fuzzy::Handle handle = fuzzy::Handle::Curve;
    bool operator==(const Grip&) const = default;
  };
  std::vector<Grip> grips() const; ///< without curves; by term from left to right
  std::optional<Grip> gripAt(const QPointF& pixel) const;
  int focusIndex() const; ///< into grips(), -1 if there are none
  void setFocusGrip(const Grip& grip);
  void stepBy(const Grip& grip, double steps);
  void showHover(const std::optional<Grip>& grip);
  QString readout(const Grip& grip) const;
  void refresh();
  void paintReadout(QPainter& painter, const Grip& grip) const;

  TermEdits* m_edits;
  Grip m_focus;
  std::optional<Grip> m_held, m_hovered;
  double m_offset = 0.0; ///< [pixel] from mouse to handle, so that grasping moves nothing
};

} // namespace esm
