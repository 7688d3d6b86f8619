// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/terms/term_plot.h"

#include "fuzzyeditor/fuzzy_evaluation.h"
#include "fuzzyeditor/rules/rule_display.h"
#include "fuzzyeditor/terms/term_edits.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double kReach = 9.0;      ///< [pixel] from which a point is grasped
constexpr double kCurveReach = 5.0; ///< [pixel] from which a curve is grasped
constexpr double kKeySteps = 100.0; ///< of the arrow keys, over the range

double distanceToSegment(const QPointF& p, const QPointF& a, const QPointF& b)
{
  const QPointF along = b - a, to = p - a;
  const double squared = QPointF::dotProduct(along, along);
  const double share = squared > 0 ? std::clamp(QPointF::dotProduct(to, along) / squared, 0.0, 1.0) : 0.0;
  const QPointF off = to - share * along;
  return std::hypot(off.x(), off.y());
}

} // namespace

TermPlot::TermPlot(FuzzyEvaluation* evaluation, TermEdits* edits, QWidget* parent)
  : MembershipPlot(evaluation, parent), m_edits(edits)
{
  installPlotAccess();
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  connect(edits, &TermEdits::changed, this, &TermPlot::refresh);
  refresh();
  TermPlot::describe();
}

void TermPlot::refresh()
{
  const std::vector<Grip> all = grips();
  if (std::find(all.begin(), all.end(), m_focus) == all.end()) {
    const auto near =
      std::find_if(all.begin(), all.end(), [&](const Grip& grip) { return grip.term == m_edits->term(); });
    m_focus = near != all.end() ? *near : all.empty() ? Grip{} : all.front();
  }
  if (m_held && !m_edits->isDragging()) m_held.reset();
  if (hasFocus() && focusIndex() >= 0) announcePlotPoint(this, focusIndex(), false);
  update();
}

int TermPlot::chosenTerm() const
{
  return m_edits->term();
}

void TermPlot::describe()
{
  MembershipPlot::describe();
  setAccessibleDescription(
    accessibleDescription() + QLatin1Char(' ') +
    tr("Tab goes from point to point, arrows move it, with Ctrl the whole curve, Delete removes the word."));
}

// === Points

std::vector<TermPlot::Grip> TermPlot::grips() const
{
  std::vector<Grip> all;
  const fuzzy::Variable* v = m_edits->variable();
  if (!v) return all;
  for (const int term : fuzzy::orderOfCores(*v))
    for (const fuzzy::Handle handle : fuzzy::handlesOf(v->terms[static_cast<std::size_t>(term)]))
      all.push_back({term, handle});
  return all;
}

int TermPlot::focusIndex() const
{
  const std::vector<Grip> all = grips();
  const auto found = std::find(all.begin(), all.end(), m_focus);
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

void TermPlot::setFocusGrip(const Grip& grip)
{
  m_focus = grip;
  m_edits->chooseTerm(grip.term);
  if (hasFocus()) announcePlotPoint(this, focusIndex(), true);
  update();
}

QPointF TermPlot::pixelOf(int term, fuzzy::Handle handle) const
{
  const fuzzy::Variable* v = m_edits->variable();
  return toPixel(fuzzy::placeOf(v->terms[static_cast<std::size_t>(term)], handle), fuzzy::heightOf(handle));
}

/// The nearest point, where several lie together that of the chosen term; else the curve under the mouse.
std::optional<TermPlot::Grip> TermPlot::gripAt(const QPointF& pixel) const
{
  const fuzzy::Variable* v = m_edits->variable();
  if (!v || !canPaint()) return std::nullopt;
  std::optional<Grip> nearest;
  double least = kReach;
  for (const Grip& grip : grips()) {
    const QPointF away = pixelOf(grip.term, grip.handle) - pixel;
    const double distance = std::hypot(away.x(), away.y()) - (grip.term == m_edits->term() ? 1.0 : 0.0);
    if (distance >= least) continue;
    least = distance;
    nearest = grip;
  }
  if (nearest) return nearest;
  least = kCurveReach;
  for (std::size_t i = 0; i < v->terms.size(); ++i) {
    if (fuzzy::handlesOf(v->terms[i]).empty()) continue;
    const QPolygonF curve = termCurve(v->terms[i]);
    for (qsizetype k = 1; k < curve.size(); ++k) {
      const bool onAxis = curve[k - 1].y() > area().bottom() - 1 && curve[k].y() > area().bottom() - 1;
      const double distance = distanceToSegment(pixel, curve[k - 1], curve[k]);
      if (onAxis || distance >= least) continue;
      least = distance;
      nearest = Grip{static_cast<int>(i), fuzzy::Handle::Curve};
    }
  }
  return nearest;
}

QString TermPlot::handleName(const fuzzy::Term& term, fuzzy::Handle handle)
{
  const fuzzy::Form form = fuzzy::formOf(term);
  switch (handle) {
  case fuzzy::Handle::LeftFoot:
    return tr("left foot");
  case fuzzy::Handle::LeftShoulder:
    return form == fuzzy::Form::RightShoulder ? tr("shoulder") : tr("left shoulder");
  case fuzzy::Handle::Peak:
    return form == fuzzy::Form::LeftShoulder || form == fuzzy::Form::RightShoulder ? tr("shoulder")
                                                                                   : tr("peak");
  case fuzzy::Handle::RightShoulder:
    return form == fuzzy::Form::LeftShoulder ? tr("shoulder") : tr("right shoulder");
  case fuzzy::Handle::RightFoot:
    return tr("right foot");
  case fuzzy::Handle::LeftFlank:
    return tr("left flank");
  case fuzzy::Handle::RightFlank:
    return tr("right flank");
  case fuzzy::Handle::Curve:
    break;
  }
  return tr("whole curve");
}

int TermPlot::pointCount() const
{
  return static_cast<int>(grips().size());
}

PlotPoint TermPlot::point(int index) const
{
  const fuzzy::Variable& v = *m_edits->variable();
  const Grip grip = grips()[static_cast<std::size_t>(index)];
  const fuzzy::Term& term = v.terms[static_cast<std::size_t>(grip.term)];
  const double place = fuzzy::placeOf(term, grip.handle), unit = RuleDisplay::displayUnit(v.unit).factor;
  const auto shown = [&](double axis) { return (v.logarithmic ? std::pow(10.0, axis) : axis) / unit; };
  const fuzzy::Limits limits = m_edits->limits(grip.term, grip.handle);
  PlotPoint point;
  point.name = tr("%1: %2").arg(toQt(term.name.in(evaluation()->document()->ruleLanguage())),
                                handleName(term, grip.handle));
  point.valueText = readout(grip);
  point.value = shown(place);
  point.least = shown(std::min(place, limits.least));
  point.greatest = shown(std::max(place, limits.greatest));
  const fuzzy::Axis axis = fuzzy::axisOf(v);
  point.step = std::abs(shown(place + (axis.high - axis.low) / kKeySteps) - point.value);
  point.place = QRect(pixelOf(grip.term, grip.handle).toPoint() - QPoint(6, 6), QSize(13, 13));
  point.focused = hasFocus() && grip == m_focus;
  return point;
}

void TermPlot::setPoint(int index, double value)
{
  const fuzzy::Variable& v = *m_edits->variable();
  const Grip grip = grips()[static_cast<std::size_t>(index)];
  const double plain = value * RuleDisplay::displayUnit(v.unit).factor;
  if (v.logarithmic && !(plain > 0.0)) return;
  m_edits->chooseTerm(grip.term);
  m_edits->place(grip.term, grip.handle, v.logarithmic ? std::log10(plain) : plain);
}

/// "0.35", "12 kPa": where the point is.
QString TermPlot::readout(const Grip& grip) const
{
  const fuzzy::Variable& v = *m_edits->variable();
  const double place = fuzzy::placeOf(v.terms[static_cast<std::size_t>(grip.term)], grip.handle);
  return RuleDisplay::quantity(v.logarithmic ? std::pow(10.0, place) : place, v.unit, locale());
}

// === Mouse

void TermPlot::mousePressEvent(QMouseEvent* event)
{
  const std::optional<Grip> grip = gripAt(event->position());
  if (event->button() != Qt::LeftButton || !grip || m_held) return;
  m_edits->chooseTerm(grip->term);
  if (grip->handle != fuzzy::Handle::Curve) setFocusGrip(*grip);
  m_edits->beginDrag();
  m_held = grip;
  m_offset = pixelOf(grip->term, grip->handle).x() - event->position().x();
  setCursor(grip->handle == fuzzy::Handle::Curve ? Qt::ClosedHandCursor : Qt::SizeHorCursor);
  update();
}

void TermPlot::mouseMoveEvent(QMouseEvent* event)
{
  if (m_held)
    m_edits->drag(m_held->term, m_held->handle, toAxis(event->position().x() + m_offset));
  else
    showHover(gripAt(event->position()));
}

void TermPlot::mouseReleaseEvent(QMouseEvent* event)
{
  if (event->button() != Qt::LeftButton || !m_held) return;
  m_held.reset();
  m_edits->endDrag();
  showHover(gripAt(event->position()));
  update();
}

void TermPlot::leaveEvent(QEvent*)
{
  if (!m_held) showHover(std::nullopt);
}

void TermPlot::showHover(const std::optional<Grip>& grip)
{
  if (!grip)
    unsetCursor();
  else
    setCursor(grip->handle == fuzzy::Handle::Curve ? Qt::OpenHandCursor : Qt::SizeHorCursor);
  if (grip != m_hovered) update();
  m_hovered = grip;
}

// === Keys

bool TermPlot::event(QEvent* event)
{
  if (event->type() == QEvent::ShortcutOverride) { // keys of this plot go before those of the window
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool moves = key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Home ||
                       key == Qt::Key_End || key == Qt::Key_Delete;
    if (moves || (key == Qt::Key_Escape && m_held)) event->accept();
  }
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const std::optional<Grip> grip = gripAt(help->pos());
    if (!grip) {
      QToolTip::hideText();
      return true;
    }
    const fuzzy::Term& term = m_edits->variable()->terms[static_cast<std::size_t>(grip->term)];
    const QString name = toQt(term.name.in(evaluation()->document()->ruleLanguage()));
    QToolTip::showText(
      help->globalPos(),
      tr("%1: %2").arg(name, handleName(term, grip->handle)) + QStringLiteral("\n") + readout(*grip), this);
    return true;
  }
  return MembershipPlot::event(event);
}

void TermPlot::stepBy(const Grip& grip, double steps)
{
  const fuzzy::Variable& v = *m_edits->variable();
  const fuzzy::Axis axis = fuzzy::axisOf(v);
  const double place = fuzzy::placeOf(v.terms[static_cast<std::size_t>(grip.term)], grip.handle);
  m_edits->step(grip.term, grip.handle, place + steps * (axis.high - axis.low) / kKeySteps);
}

void TermPlot::keyPressEvent(QKeyEvent* event)
{
  if (event->key() == Qt::Key_Escape && m_held) {
    m_held.reset();
    m_edits->cancelDrag();
    unsetCursor();
    return;
  }
  if (focusIndex() < 0 || m_held) {
    event->ignore();
    return;
  }
  const Grip grip =
    event->modifiers() & Qt::ControlModifier ? Grip{m_focus.term, fuzzy::Handle::Curve} : m_focus;
  const double size = event->modifiers() & Qt::ShiftModifier ? 10.0 : 1.0;
  switch (event->key()) {
  case Qt::Key_Left:
    stepBy(grip, -size);
    break;
  case Qt::Key_Right:
    stepBy(grip, size);
    break;
  case Qt::Key_Home:
    m_edits->step(grip.term, grip.handle, m_edits->limits(grip.term, grip.handle).least);
    break;
  case Qt::Key_End:
    m_edits->step(grip.term, grip.handle, m_edits->limits(grip.term, grip.handle).greatest);
    break;
  case Qt::Key_Delete:
    m_edits->removeTerm(m_focus.term);
    break;
  default:
    event->ignore();
  }
}

bool TermPlot::focusNextPrevChild(bool next)
{
  const std::vector<Grip> all = grips();
  const int to = focusIndex() + (next ? 1 : -1);
  if (focusIndex() < 0 || to < 0 || to >= static_cast<int>(all.size()))
    return MembershipPlot::focusNextPrevChild(next);
  setFocusGrip(all[static_cast<std::size_t>(to)]);
  return true;
}

void TermPlot::focusInEvent(QFocusEvent* event)
{
  MembershipPlot::focusInEvent(event);
  const std::vector<Grip> all = grips();
  if (all.empty()) return;
  if (event->reason() == Qt::TabFocusReason) setFocusGrip(all.front());
  if (event->reason() == Qt::BacktabFocusReason) setFocusGrip(all.back());
}

/// A drag does not go on behind a dialog or another window.
void TermPlot::focusOutEvent(QFocusEvent* event)
{
  MembershipPlot::focusOutEvent(event);
  if (m_held) m_edits->endDrag();
  m_held.reset();
  update();
}

} // namespace esm
