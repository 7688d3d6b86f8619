// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/terms/membership_plot.h"

#include "core/fuzzy/axis.h"
#include "fuzzyeditor/fuzzy_evaluation.h"
#include "fuzzyeditor/panel_colors.h"
#include "fuzzyeditor/rules/rule_display.h"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace esm {
namespace {

constexpr int kSamples = 160; ///< of a bent curve; a straight one is drawn by its corners

/// Steps 1, 2 or 5 times a power of ten that divide `span` into about `count` parts.
double niceStep(double span, int count)
{
  const double raw = span / std::max(count, 1);
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (raw <= factor * power) return factor * power;
  return 10.0 * power;
}

} // namespace

MembershipPlot::MembershipPlot(FuzzyEvaluation* evaluation, QWidget* parent)
  : QWidget(parent), m_evaluation(evaluation)
{
  setObjectName("mfPlot");
  const auto refresh = [this] {
    layOut();
    describe();
    update();
  };
  connect(evaluation, &FuzzyEvaluation::changed, this, refresh);
  connect(evaluation->document(), &FuzzyDocument::ruleBaseChanged, this, [this] { layOut(); });
  connect(evaluation->document(), &FuzzyDocument::ruleLanguageChanged, this, refresh);
  MembershipPlot::describe();
}

const fuzzy::Variable* MembershipPlot::variable() const
{
  const fuzzy::RuleBase& rules = m_evaluation->document()->ruleBase();
  const std::vector<fuzzy::Variable>& list = m_output ? rules.outputs : rules.inputs;
  const auto index = static_cast<std::size_t>(m_index);
  return m_index >= 0 && index < list.size() ? &list[index] : nullptr;
}

void MembershipPlot::setVariable(bool output, int index)
{
  m_output = output;
  m_index = index;
  layOut();
  describe();
  update();
}

void MembershipPlot::describe()
{
  const fuzzy::Variable* v = variable();
  if (!v) {
    setAccessibleName(tr("Plot of a variable's words"));
    setAccessibleDescription(QString());
    return;
  }
  const Language language = m_evaluation->document()->ruleLanguage();
  QStringList terms;
  for (const fuzzy::Term& term : v->terms) terms << toQt(term.name.in(language));
  setAccessibleName(tr("Plot of the words for %1").arg(RuleDisplay::title(*v, language)));
  setAccessibleDescription(tr("The words are: %1.").arg(terms.join(QStringLiteral(", "))));
}

void MembershipPlot::layOut()
{
  const fuzzy::Variable* v = variable();
  const fuzzy::Axis axis = v ? fuzzy::axisOf(*v) : fuzzy::Axis{};
  m_low = axis.low;
  m_high = axis.high;
  const int line = fontMetrics().height();
  const int left = fontMetrics().horizontalAdvance(QStringLiteral("0.5")) + 12;
  m_area = QRectF(rect()).adjusted(left, 2 * line + 6, -14, -2 * line - 6);
}

void MembershipPlot::resizeEvent(QResizeEvent* event)
{
  QWidget::resizeEvent(event);
  layOut();
}

QPointF MembershipPlot::toPixel(double axis, double mu) const
{
  const double share = std::clamp((axis - m_low) / (m_high - m_low), 0.0, 1.0);
  return {m_area.left() + share * m_area.width(), m_area.bottom() - mu * m_area.height()};
}

double MembershipPlot::toAxis(double pixel) const
{
  return m_low + (pixel - m_area.left()) / m_area.width() * (m_high - m_low);
}

QPolygonF MembershipPlot::termCurve(const fuzzy::Term& term) const
{
  std::vector<double> places{m_low, m_high};
  if (term.shape == fuzzy::Shape::Gaussian) {
    for (int i = 1; i < kSamples; ++i) places.push_back(m_low + (m_high - m_low) * i / kSamples);
    places.push_back(term.parameters.front());
  } else {
    for (const double corner : term.parameters)
      if (corner > m_low && corner < m_high) { // both sides of a corner, for an upright flank
        const double beside = (m_high - m_low) * 1e-9;
        places.insert(places.end(), {corner - beside, corner, corner + beside});
      }
  }
  std::sort(places.begin(), places.end());
  QPolygonF curve;
  for (const double x : places) curve << toPixel(x, fuzzy::membership(term, x));
  return curve;
}

void MembershipPlot::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  const fuzzy::Variable* v = variable();
  if (!v || v->terms.empty()) return;
  painter.setRenderHint(QPainter::Antialiasing);
  if (!canPaint()) return;
  paintAxes(painter, *v);
  paintBehind(painter, *v);
  if (m_output) paintOutput(painter, *v);
  paintTerms(painter, *v);
  if (!m_output)
    paintInput(painter, *v);
  else if (const auto& outputs = m_evaluation->inference().outputs;
           static_cast<std::size_t>(m_index) < outputs.size())
    paintValueLine(painter, *v, outputs[static_cast<std::size_t>(m_index)].value);
  paintBefore(painter, *v);
}

void MembershipPlot::paintAxes(QPainter& painter, const fuzzy::Variable& v) const
{
  const QColor grid = panel_colors::faint(palette()), ink = panel_colors::quiet(palette());
  const int line = fontMetrics().height();
  for (const double mu : {0.0, 0.5, 1.0}) {
    const QPointF at = toPixel(m_low, mu);
    painter.setPen(QPen(grid, 1, mu == 0.0 ? Qt::SolidLine : Qt::DotLine));
    painter.drawLine(at, toPixel(m_high, mu));
    painter.setPen(ink);
    painter.drawText(QRectF(0, at.y() - line / 2.0, m_area.left() - 6, line),
                     Qt::AlignRight | Qt::AlignVCenter, locale().toString(mu, 'g', 2));
  }
  const DisplayUnit unit = RuleDisplay::displayUnit(v.unit);
  const int room =
    std::max(2, static_cast<int>(m_area.width()) / (6 * fontMetrics().averageCharWidth() + 24));
  const double shift = v.logarithmic ? std::log10(unit.factor) : 0.0; // ticks at round numbers as displayed
  const double scale = v.logarithmic ? 1.0 : unit.factor;
  const double low = (m_low - shift) / scale, high = (m_high - shift) / scale;
  const double step = v.logarithmic ? std::max(1.0, niceStep(high - low, room)) : niceStep(high - low, room);
  const double slack = 1e-9 * (high - low);
  for (double tick = std::ceil((low - slack) / step) * step; tick <= high + slack; tick += step) {
    const QPointF at = toPixel(tick * scale + shift, 0);
    painter.setPen(QPen(grid, 1));
    painter.drawLine(at, at + QPointF(0, 4));
    const double shown = v.logarithmic ? std::pow(10.0, tick) : std::abs(tick) < slack ? 0.0 : tick;
    painter.setPen(ink);
    QLocale plain = locale();
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    const QString text = plain.toString(shown, 'g', 6);
    const double wide = fontMetrics().horizontalAdvance(text);
    const double start = std::min(at.x() - wide / 2, width() - wide - 3.0);
    painter.drawText(QRectF(start, at.y() + 4, wide + 2, line), Qt::AlignLeft, text);
  }
  QString title = RuleDisplay::title(v, m_evaluation->document()->ruleLanguage());
  if (!unit.symbol.isEmpty()) title += QStringLiteral(" [%1]").arg(unit.symbol);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(QRectF(m_area.left(), height() - line - 3, m_area.width(), line), Qt::AlignCenter, title);
}

void MembershipPlot::paintCurve(QPainter& painter, const fuzzy::Term& term) const
{
  const QPolygonF curve = termCurve(term);
  for (qsizetype k = 1; k < curve.size(); ++k) // along the axis there is nothing to see
    if (curve[k - 1].y() < m_area.bottom() - 1e-6 || curve[k].y() < m_area.bottom() - 1e-6)
      painter.drawLine(curve[k - 1], curve[k]);
}

void MembershipPlot::paintTerms(QPainter& painter, const fuzzy::Variable& v) const
{
  std::vector<std::pair<double, int>> peaks;
  for (int i = 0; i < static_cast<int>(v.terms.size()); ++i) {
    const fuzzy::Term& term = v.terms[static_cast<std::size_t>(i)];
    painter.setPen(
      QPen(panel_colors::curve(palette(), i), i == chosenTerm() ? 3 : 2, Qt::SolidLine, Qt::RoundCap));
    paintCurve(painter, term);
    const QPolygonF curve = termCurve(term);
    const auto higher = [](const QPointF& a, const QPointF& b) { return a.y() > b.y() + 1e-6; };
    const auto first = std::max_element(curve.begin(), curve.end(), higher);
    auto last = first;
    while (std::next(last) != curve.end() && std::next(last)->y() <= first->y() + 1e-6) ++last;
    peaks.emplace_back((first->x() + last->x()) / 2, i);
  }
  std::sort(peaks.begin(), peaks.end());
  paintWords(painter, v, peaks);
}

/// Words above their peaks, side by side: crowded ones are pushed to the right, and back where that leaves
/// the plot; what has no room is cut short. @param peaks places [pixel] and terms, from the left.
void MembershipPlot::paintWords(QPainter& painter, const fuzzy::Variable& v,
                                const std::vector<std::pair<double, int>>& peaks) const
{
  constexpr double kGap = 8.0, kLeastGap = 4.0, kMargin = 3.0;
  const Language language = m_evaluation->document()->ruleLanguage();
  const QFontMetricsF metrics(font());
  const int line = fontMetrics().height();
  QStringList names;
  std::vector<double> start(peaks.size()), wide(peaks.size());
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    names << toQt(v.terms[static_cast<std::size_t>(peaks[i].second)].name.in(language));
    wide[i] = metrics.horizontalAdvance(names.back());
  }
  const double all = std::accumulate(wide.begin(), wide.end(), 0.0), room = width() - 2.0 * kMargin;
  const double gaps = std::max(static_cast<double>(peaks.size()) - 1.0, 1.0);
  const double gap = std::clamp((room - all) / gaps, kLeastGap, kGap);
  if (const double share = (room - gaps * gap) / all; share < 1.0)
    for (std::size_t i = 0; i < peaks.size(); ++i) {
      QString& name = names[static_cast<qsizetype>(i)];
      name = metrics.elidedText(name, Qt::ElideRight, share * wide[i]);
      wide[i] *= share;
    }
  double free = m_area.left();
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    start[i] = std::max(free, peaks[i].first - wide[i] / 2);
    free = start[i] + wide[i] + gap;
  }
  double end = width() - kMargin;
  for (std::size_t i = peaks.size(); i-- > 0;) {
    start[i] = std::min(start[i], end - wide[i]);
    end = start[i] - gap;
    painter.setPen(panel_colors::curve(palette(), peaks[i].second));
    painter.drawText(QRectF(start[i], m_area.top() - line - 2, wide[i] + 2, line), Qt::AlignLeft,
                     names[static_cast<qsizetype>(i)]);
  }
}

/// A filled set under an outline that runs from left to right.
void MembershipPlot::paintSet(QPainter& painter, QPolygonF outline) const
{
  if (outline.isEmpty()) return;
  QColor fill = palette().color(QPalette::Highlight);
  const QPolygonF top = outline;
  outline << QPointF(top.last().x(), m_area.bottom()) << QPointF(top.first().x(), m_area.bottom());
  fill.setAlpha(70);
  painter.setPen(Qt::NoPen);
  painter.setBrush(fill);
  painter.drawPolygon(outline);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1.2));
  painter.drawPolyline(top);
}

void MembershipPlot::paintInput(QPainter& painter, const fuzzy::Variable& v) const
{
  const std::vector<fuzzy::InputValue>& inputs = m_evaluation->document()->inputs();
  if (static_cast<std::size_t>(m_index) >= inputs.size()) return;
  const fuzzy::InputValue& input = inputs[static_cast<std::size_t>(m_index)];
  if (const auto* word = std::get_if<fuzzy::Word>(&input)) {
    for (const fuzzy::Term& term : v.terms) {
      if (term.id != word->term) continue;
      QPolygonF outline;
      for (int i = 0; i <= kSamples; ++i) {
        const double x = m_low + (m_high - m_low) * i / kSamples;
        outline << toPixel(x, fuzzy::applyHedges(word->hedges, fuzzy::membership(term, x)));
      }
      paintSet(painter, outline);
      const Language language = m_evaluation->document()->ruleLanguage();
      paintHeading(painter, m_area.center().x(), toQt(fuzzy::formatInput(input, v, language)));
    }
    return;
  }
  const double plain = std::clamp(std::get<double>(input), v.minimum, v.maximum);
  paintValueLine(painter, v, plain);
  for (std::size_t i = 0; i < v.terms.size(); ++i) {
    const double mu = fuzzy::membership(v.terms[i], fuzzy::toAxis(v, plain));
    if (mu <= 0) continue;
    painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
    painter.setBrush(panel_colors::curve(palette(), static_cast<int>(i)));
    painter.drawEllipse(toPixel(fuzzy::toAxis(v, plain), mu), 4.5, 4.5);
  }
}

void MembershipPlot::paintOutput(QPainter& painter, const fuzzy::Variable& v) const
{
  const fuzzy::Inference& inference = m_evaluation->inference();
  const auto index = static_cast<std::size_t>(m_index);
  if (index >= inference.outputs.size() || !inference.outputs[index].fromRules) return;
  QPolygonF outline;
  for (const auto& [x, mu] :
       fuzzy::aggregatedSet(m_evaluation->document()->ruleBase(), inference, m_index, 2 * kSamples + 1))
    outline << toPixel(v.logarithmic ? std::log10(x) : x, mu);
  paintSet(painter, outline);
}

/// Where the variable is now, with its number above the words.
void MembershipPlot::paintValueLine(QPainter& painter, const fuzzy::Variable& v, double plain) const
{
  if (!std::isfinite(plain)) return;
  const double x = toPixel(fuzzy::toAxis(v, plain), 0).x();
  const QColor ink = palette().color(QPalette::Text);
  painter.setPen(QPen(ink, 1.4, Qt::DashLine));
  painter.drawLine(QPointF(x, m_area.bottom()), QPointF(x, m_area.top()));
  paintHeading(painter, x, RuleDisplay::quantity(plain, v.unit, locale()));
}

/// The present value above the words, at its place.
void MembershipPlot::paintHeading(QPainter& painter, double x, const QString& text) const
{
  QFont bold = font();
  bold.setWeight(QFont::DemiBold);
  painter.setFont(bold);
  painter.setPen(palette().color(QPalette::Text));
  const double width = QFontMetricsF(bold).horizontalAdvance(text) + 4;
  const double start = std::clamp(x - width / 2, 2.0, std::max(2.0, this->width() - width - 2.0));
  painter.drawText(QRectF(start, 2, width, fontMetrics().height()), Qt::AlignCenter, text);
  painter.setFont(font());
}

void MembershipPlot::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) describe();
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange ||
      event->type() == QEvent::PaletteChange)
    update();
}

} // namespace esm
