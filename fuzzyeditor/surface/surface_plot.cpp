// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/surface/surface_plot.h"

#include "core/fuzzy/axis.h"
#include "core/fuzzy/term_editing.h"
#include "fuzzyeditor/fuzzy_evaluation.h"
#include "fuzzyeditor/rules/rule_display.h"
#include "fuzzyeditor/surface/surface_source.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double kSteps = 100.0; ///< of the arrow keys, over the range

} // namespace

SurfacePlot::SurfacePlot(SurfaceSource* source, QWidget* parent) : QWidget(parent), m_source(source)
{
  setObjectName("surfacePlot");
  installPlotAccess();
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  connect(source, &SurfaceSource::changed, this, &SurfacePlot::refresh);
  connect(source->evaluation()->document(), &FuzzyDocument::ruleLanguageChanged, this, &SurfacePlot::refresh);
  refresh();
}

void SurfacePlot::refresh()
{
  if (!isVisible()) return; // it comes again when it is shown
  setAccessibleName(tr("Map of a result over two inputs"));
  setAccessibleDescription(sentence());
  if (hasFocus())
    for (int i = 0; i < pointCount(); ++i) announcePlotPoint(this, i, false);
  update();
}

bool SurfacePlot::canShow() const
{
  return m_source->surface() != nullptr && m_source->evaluation()->document()->inputs().size() ==
                                             m_source->evaluation()->document()->ruleBase().inputs.size();
}

// === Places

double SurfacePlot::axisOfInput(int index) const
{
  const fuzzy::Variable& v = index == 0 ? *m_source->inputX() : *m_source->inputY();
  const int input = index == 0 ? m_source->question().x : m_source->question().y;
  const fuzzy::InputValue& value =
    m_source->evaluation()->document()->inputs()[static_cast<std::size_t>(input)];
  if (const double* number = std::get_if<double>(&value)) return fuzzy::toAxis(v, *number);
  const fuzzy::Axis axis = fuzzy::axisOf(v); // a word stands where it fits best
  for (const fuzzy::Term& term : v.terms)
    if (term.id == std::get<fuzzy::Word>(value).term)
      return std::clamp(fuzzy::placeOf(term, fuzzy::Handle::Curve), axis.low, axis.high);
  return fuzzy::toAxis(v, v.defaultValue);
}

QPointF SurfacePlot::cross() const
{
  const auto share = [](const fuzzy::Variable& v, double place) {
    const fuzzy::Axis axis = fuzzy::axisOf(v);
    return (place - axis.low) / (axis.high - axis.low);
  };
  const QRectF map = area();
  return {map.left() + share(*m_source->inputX(), axisOfInput(0)) * map.width(),
          map.bottom() - share(*m_source->inputY(), axisOfInput(1)) * map.height()};
}

void SurfacePlot::moveTo(double x, double y, int gesture)
{
  FuzzyDocument* document = m_source->evaluation()->document();
  const fuzzy::Variable &vx = *m_source->inputX(), &vy = *m_source->inputY();
  std::vector<fuzzy::InputValue> inputs = document->inputs();
  // An axis that does not move keeps its value, which may be a word.
  if (x != axisOfInput(0)) inputs[static_cast<std::size_t>(m_source->question().x)] = fuzzy::fromAxis(vx, x);
  if (y != axisOfInput(1)) inputs[static_cast<std::size_t>(m_source->question().y)] = fuzzy::fromAxis(vy, y);
  document->setInputs(std::move(inputs), tr("Change inputs on the surface"), gesture);
}

void SurfacePlot::moveToPixel(const QPointF& pixel)
{
  const QRectF map = area();
  const auto place = [](const fuzzy::Variable& v, double share) {
    const fuzzy::Axis axis = fuzzy::axisOf(v);
    return axis.low + std::clamp(share, 0.0, 1.0) * (axis.high - axis.low);
  };
  moveTo(place(*m_source->inputX(), (pixel.x() - map.left()) / map.width()),
         place(*m_source->inputY(), (map.bottom() - pixel.y()) / map.height()), m_gesture);
}

void SurfacePlot::step(double x, double y)
{
  const auto moved = [](const fuzzy::Variable& v, double place, double steps) {
    const fuzzy::Axis axis = fuzzy::axisOf(v);
    return std::clamp(place + steps * (axis.high - axis.low) / kSteps, axis.low, axis.high);
  };
  moveTo(moved(*m_source->inputX(), axisOfInput(0), x), moved(*m_source->inputY(), axisOfInput(1), y),
         m_keys.press());
}

// === In words

QString SurfacePlot::quantityOf(int index) const
{
  const fuzzy::Variable& v = index == 0 ? *m_source->inputX() : *m_source->inputY();
  return RuleDisplay::quantity(fuzzy::fromAxis(v, axisOfInput(index)), v.unit, locale());
}

QString SurfacePlot::sentence() const
{
  if (!canShow()) return tr("There is no result or there are no two inputs to show.");
  const Language language = m_source->evaluation()->document()->ruleLanguage();
  const fuzzy::Variable& output = *m_source->output();
  const auto& outputs = m_source->evaluation()->inference().outputs;
  const auto index = static_cast<std::size_t>(m_source->question().output);
  QString result =
    index < outputs.size() ? RuleDisplay::quantity(outputs[index].value, output.unit, locale()) : QString();
  if (index < outputs.size() && !outputs[index].fromRules) result += tr(" (no rule)");
  return tr("%1 %2, %3 %4: %5 %6")
    .arg(RuleDisplay::title(*m_source->inputX(), language), quantityOf(0),
         RuleDisplay::name(*m_source->inputY(), language), quantityOf(1), RuleDisplay::name(output, language),
         result);
}

int SurfacePlot::pointCount() const
{
  return canShow() ? 2 : 0;
}

PlotPoint SurfacePlot::point(int index) const
{
  const fuzzy::Variable& v = index == 0 ? *m_source->inputX() : *m_source->inputY();
  const double unit = RuleDisplay::displayUnit(v.unit).factor, place = axisOfInput(index);
  const fuzzy::Axis axis = fuzzy::axisOf(v);
  PlotPoint point;
  point.name = RuleDisplay::title(v, m_source->evaluation()->document()->ruleLanguage());
  point.valueText = sentence();
  point.value = fuzzy::fromAxis(v, place) / unit;
  point.least = v.minimum / unit;
  point.greatest = v.maximum / unit;
  const double next = std::min(place + (axis.high - axis.low) / kSteps, axis.high);
  point.step = std::max(fuzzy::fromAxis(v, next) / unit - point.value, (point.greatest - point.least) / 1e6);
  const QPoint at = cross().toPoint();
  const QRect map = area().toRect();
  point.place = index == 0 ? QRect(at.x() - 4, map.top(), 9, map.height())
                           : QRect(map.left(), at.y() - 4, map.width(), 9);
  point.focused = hasFocus() && index == 0;
  return point;
}

void SurfacePlot::setPoint(int index, double value)
{
  const fuzzy::Variable& v = index == 0 ? *m_source->inputX() : *m_source->inputY();
  const double place = fuzzy::toAxis(v, value * RuleDisplay::displayUnit(v.unit).factor);
  moveTo(index == 0 ? place : axisOfInput(0), index == 1 ? place : axisOfInput(1), 0);
}

// === Mouse and keys

void SurfacePlot::mousePressEvent(QMouseEvent* event)
{
  if (event->button() != Qt::LeftButton || !canShow() || m_dragging) return;
  if (!area().adjusted(-4, -4, 4, 4).contains(event->position())) return;
  m_dragging = true;
  m_gesture = nextGesture();
  m_start = m_source->evaluation()->document()->inputs();
  moveToPixel(event->position());
}

void SurfacePlot::mouseMoveEvent(QMouseEvent* event)
{
  if (m_dragging && canShow()) moveToPixel(event->position());
}

void SurfacePlot::mouseReleaseEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton) m_dragging = false;
}

void SurfacePlot::keyPressEvent(QKeyEvent* event)
{
  if (event->key() == Qt::Key_Escape && m_dragging) {
    m_dragging = false;
    m_source->evaluation()->document()->setInputs(m_start, tr("Change inputs on the surface"), m_gesture);
    return;
  }
  if (!canShow() || m_dragging) {
    event->ignore();
    return;
  }
  const double size = event->modifiers() & Qt::ShiftModifier ? 10.0 : 1.0;
  switch (event->key()) {
  case Qt::Key_Left:
    return step(-size, 0);
  case Qt::Key_Right:
    return step(size, 0);
  case Qt::Key_Down:
    return step(0, -size);
  case Qt::Key_Up:
    return step(0, size);
  case Qt::Key_Home:
    return step(-kSteps, 0);
  case Qt::Key_End:
    return step(kSteps, 0);
  case Qt::Key_PageDown:
    return step(0, -kSteps);
  case Qt::Key_PageUp:
    return step(0, kSteps);
  default:
    event->ignore();
  }
}

bool SurfacePlot::event(QEvent* event)
{
  if (event->type() == QEvent::Show)
    QMetaObject::invokeMethod(this, &SurfacePlot::refresh, Qt::QueuedConnection);
  if (event->type() == QEvent::ShortcutOverride) { // keys of this plot go before those of the window
    static const int keys[] = {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up,     Qt::Key_Down,
                               Qt::Key_Home, Qt::Key_End,   Qt::Key_PageUp, Qt::Key_PageDown};
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (std::find(std::begin(keys), std::end(keys), key) != std::end(keys) ||
        (key == Qt::Key_Escape && m_dragging))
      event->accept();
  }
  if (event->type() == QEvent::ToolTip && canShow()) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const fuzzy::ControlSurface& surface = *m_source->surface();
    const QRectF map = area();
    const auto nearest = [](double share, std::size_t count) {
      return static_cast<std::size_t>(
        std::lround(std::clamp(share, 0.0, 1.0) * static_cast<double>(count - 1)));
    };
    const std::size_t column = nearest((help->pos().x() - map.left()) / map.width(), surface.columns());
    const std::size_t row = nearest((map.bottom() - help->pos().y()) / map.height(), surface.rows());
    const fuzzy::Variable &x = *m_source->inputX(), &y = *m_source->inputY(), &z = *m_source->output();
    const Language language = m_source->evaluation()->document()->ruleLanguage();
    const auto said = [&](const fuzzy::Variable& v, double value) {
      return RuleDisplay::title(v, language) + QLatin1Char(' ') +
             RuleDisplay::quantity(value, v.unit, locale());
    };
    const QString last =
      surface.firedAt(row, column) ? said(z, surface.at(row, column)) : tr("No rule fires here.");
    if (map.contains(help->pos()))
      QToolTip::showText(help->globalPos(),
                         said(x, surface.x[column]) + '\n' + said(y, surface.y[row]) + '\n' + last, this);
    else
      QToolTip::hideText();
    return true;
  }
  return QWidget::event(event);
}

void SurfacePlot::focusInEvent(QFocusEvent* event)
{
  QWidget::focusInEvent(event);
  if (pointCount() > 0) announcePlotPoint(this, 0, true);
  update();
}

void SurfacePlot::focusOutEvent(QFocusEvent* event)
{
  QWidget::focusOutEvent(event);
  m_dragging = false;
  update();
}

void SurfacePlot::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange ||
      event->type() == QEvent::PaletteChange)
    refresh();
}

} // namespace esm
