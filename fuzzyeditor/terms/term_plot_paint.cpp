// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The part of TermPlot that paints.
#include "fuzzyeditor/panel_colors.h"
#include "fuzzyeditor/terms/term_edits.h"
#include "fuzzyeditor/terms/term_plot.h"

#include <QPainter>

#include <algorithm>

namespace esm {

void TermPlot::paintBehind(QPainter& painter, const fuzzy::Variable& v) const
{
  const fuzzy::Variable* saved = m_edits->savedVariable();
  if (!saved) return;
  for (const fuzzy::Term& before : saved->terms) {
    const auto now = std::find_if(v.terms.begin(), v.terms.end(),
                                  [&](const fuzzy::Term& term) { return term.id == before.id; });
    if (now == v.terms.end() || (now->shape == before.shape && now->parameters == before.parameters))
      continue;
    const QColor pale =
      panel_colors::mix(palette().color(QPalette::Base),
                        panel_colors::curve(palette(), static_cast<int>(now - v.terms.begin())), 0.45);
    painter.setPen(QPen(pale, 1));
    paintCurve(painter, before);
  }
}

void TermPlot::paintBefore(QPainter& painter, const fuzzy::Variable& v) const
{
  const auto paint = [&](const Grip& grip) {
    const QPointF at = pixelOf(grip.term, grip.handle);
    const bool chosen = grip.term == m_edits->term();
    const double place = fuzzy::placeOf(v.terms[static_cast<std::size_t>(grip.term)], grip.handle);
    const fuzzy::Axis axis = fuzzy::axisOf(v);
    const QColor colour = panel_colors::curve(palette(), grip.term);
    const bool outside = place < axis.low || place > axis.high; // drawn at the edge, hollow
    painter.setPen(QPen(chosen ? palette().color(QPalette::Base) : colour, 1.2));
    painter.setBrush(outside ? palette().color(QPalette::Base) : colour);
    if (outside) painter.setPen(QPen(colour, 1.5));
    const double size = chosen ? 4.5 : 2.5;
    painter.drawEllipse(at, size, size);
  };
  for (const bool chosen : {false, true}) // the chosen term's points lie on top
    for (const Grip& grip : grips())
      if ((grip.term == m_edits->term()) == chosen) paint(grip);
  painter.setBrush(Qt::NoBrush);
  if (hasFocus() && focusIndex() >= 0) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    painter.drawEllipse(pixelOf(m_focus.term, m_focus.handle), 8, 8);
  }
  if (m_held)
    paintReadout(painter, *m_held);
  else if (m_hovered && m_hovered->term < static_cast<int>(v.terms.size()))
    paintReadout(painter, *m_hovered);
  else if (hasFocus() && focusIndex() >= 0)
    paintReadout(painter, m_focus);
}

/// The value beside the point, on a ground of its own.
void TermPlot::paintReadout(QPainter& painter, const Grip& grip) const
{
  const QString text = readout(grip);
  const QPointF at = pixelOf(grip.term, grip.handle);
  const QSizeF size(fontMetrics().horizontalAdvance(text) + 10, fontMetrics().height() + 4);
  const double x = std::clamp(at.x() - size.width() / 2, 2.0, std::max(2.0, width() - size.width() - 2.0));
  const double above = at.y() - size.height() - 11;
  const QRectF box(QPointF(x, above > area().top() - 4 ? above : at.y() + 11), size);
  painter.setPen(QPen(panel_colors::curve(palette(), grip.term), 1));
  painter.setBrush(palette().color(QPalette::ToolTipBase));
  painter.drawRoundedRect(box, 3, 3);
  painter.setPen(palette().color(QPalette::ToolTipText));
  painter.drawText(box, Qt::AlignCenter, text);
  painter.setBrush(Qt::NoBrush);
}

} // namespace esm
