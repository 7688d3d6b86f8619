// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The part of SurfacePlot that paints.
#include "core/base/colour_map.h"
#include "core/fuzzy/axis.h"
#include "core/fuzzy/term_editing.h"
#include "fuzzyeditor/fuzzy_evaluation.h"
#include "fuzzyeditor/panel_colors.h"
#include "fuzzyeditor/rules/rule_display.h"
#include "fuzzyeditor/surface/surface_plot.h"
#include "fuzzyeditor/surface/surface_source.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr int kLegendWidth = 74; ///< [pixel] bar, gap and numbers
constexpr int kMostContours = 10;

QColor colourAt(double share)
{
  const Rgb colour = viridis(share);
  return QColor::fromRgbF(colour[0], colour[1], colour[2]);
}

/// Ink that can be read on the map's colour.
QColor inkOn(double share)
{
  return share < 0.6 ? QColor(0xff, 0xff, 0xff) : QColor(0x10, 0x10, 0x10);
}

} // namespace

double SurfacePlot::Scale::shareOf(double axis) const
{
  return greatest > least ? (axis - least) / (greatest - least) : 0.5;
}

/// Room for the words of the upright axis, at most a quarter of the plot.
int SurfacePlot::wordWidth() const
{
  int widest = 0;
  const Language language = m_source->evaluation()->document()->ruleLanguage();
  if (const fuzzy::Variable* y = m_source->inputY())
    for (const fuzzy::Term& term : y->terms)
      widest = std::max(widest, fontMetrics().horizontalAdvance(toQt(term.name.in(language))));
  return std::min(widest + 6, width() / 4);
}

QRectF SurfacePlot::area() const
{
  const int line = fontMetrics().height();
  return QRectF(rect()).adjusted(wordWidth() + line + 8, line + 8, -kLegendWidth - 8, -2 * line - 10);
}

QPointF SurfacePlot::pixelOf(double column, double row) const
{
  const QRectF map = area();
  const fuzzy::ControlSurface& surface = *m_source->surface();
  return {map.left() + column / static_cast<double>(surface.columns() - 1) * map.width(),
          map.bottom() - row / static_cast<double>(surface.rows() - 1) * map.height()};
}

/// Colours span what the rules give, on the output's own scale.
SurfacePlot::Scale SurfacePlot::scale(const fuzzy::ControlSurface& surface) const
{
  Scale colours{HUGE_VAL, -HUGE_VAL};
  for (std::size_t i = 0; i < surface.value.size(); ++i) {
    if (!surface.fired[i]) continue;
    const double place = fuzzy::toAxis(*m_source->output(), surface.value[i]);
    colours.least = std::min(colours.least, place);
    colours.greatest = std::max(colours.greatest, place);
  }
  if (colours.least > colours.greatest) { // no rule fires anywhere
    const fuzzy::Axis axis = fuzzy::axisOf(*m_source->output());
    colours = {axis.low, axis.high};
  }
  return colours;
}

void SurfacePlot::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  painter.setRenderHint(QPainter::Antialiasing);
  const int line = fontMetrics().height();
  QFont bold = font();
  bold.setWeight(QFont::DemiBold);
  painter.setFont(bold);
  painter.setPen(palette().color(QPalette::Text));
  const QString heading = QFontMetrics(bold).elidedText(sentence(), Qt::ElideRight, width() - 8);
  painter.drawText(QRectF(4, 3, width() - 8, line), Qt::AlignCenter, heading);
  painter.setFont(font());
  if (!canShow() || area().width() < 30 || area().height() < 30) return;
  const fuzzy::ControlSurface& surface = *m_source->surface();
  const Scale colours = scale(surface);
  paintMap(painter, surface, colours);
  paintContours(painter, surface, colours);
  paintAxes(painter);
  paintLegend(painter, colours);
  paintCross(painter);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(hasFocus() ? QPen(palette().color(QPalette::Highlight), 2)
                            : QPen(panel_colors::faint(palette()), 1));
  painter.drawRect(area());
}

/// One pixel for each grid place, blown up smoothly; hatched where no rule fires.
void SurfacePlot::paintMap(QPainter& painter, const fuzzy::ControlSurface& surface,
                           const Scale& colours) const
{
  const auto columns = static_cast<int>(surface.columns()), rows = static_cast<int>(surface.rows());
  QImage image(columns, rows, QImage::Format_RGB32);
  QPainterPath empty;
  const QSizeF cell(area().width() / (columns - 1), area().height() / (rows - 1));
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const auto r = static_cast<std::size_t>(row), c = static_cast<std::size_t>(column);
      const double share = colours.shareOf(fuzzy::toAxis(*m_source->output(), surface.at(r, c)));
      image.setPixelColor(column, rows - 1 - row, colourAt(share));
      if (surface.firedAt(r, c)) continue;
      const QPointF at = pixelOf(column, row);
      empty.addRect(
        QRectF(at.x() - cell.width() / 2, at.y() - cell.height() / 2, cell.width(), cell.height()));
    }
  painter.save();
  painter.setClipRect(area());
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(
    area().adjusted(-cell.width() / 2, -cell.height() / 2, cell.width() / 2, cell.height() / 2), image);
  painter.setRenderHint(QPainter::Antialiasing, false); // no seams between neighbouring rectangles
  empty.setFillRule(Qt::WindingFill);
  painter.fillPath(empty, palette().color(QPalette::Base));
  painter.fillPath(empty, QBrush(panel_colors::quiet(palette()), Qt::BDiagPattern));
  painter.restore();
}

void SurfacePlot::paintContours(QPainter& painter, const fuzzy::ControlSurface& surface,
                                const Scale& colours) const
{
  const fuzzy::Variable& output = *m_source->output();
  const double unit = RuleDisplay::displayUnit(output.unit).factor;
  std::vector<QRectF> taken;
  QFont small = font();
  small.setPointSizeF(0.9 * small.pointSizeF());
  painter.setFont(small);
  const QFontMetricsF metrics(small);
  for (const double level :
       fuzzy::contourLevels(fuzzy::fromAxis(output, colours.least), fuzzy::fromAxis(output, colours.greatest),
                            output.logarithmic, kMostContours)) {
    const QColor ink = inkOn(colours.shareOf(fuzzy::toAxis(output, level)));
    const QString text = RuleDisplay::number(level / unit, locale(), 2);
    for (const fuzzy::ContourLine& contour : fuzzy::contourLines(surface, output, level)) {
      QPolygonF line;
      for (const auto& [column, row] : contour) line << pixelOf(column, row);
      painter.setPen(QPen(ink, 1));
      painter.drawPolyline(line);
      const QSizeF size(metrics.horizontalAdvance(text) + 4, metrics.height());
      for (const double share : {0.5, 0.3, 0.7, 0.15, 0.85}) { // where there is room
        const QPointF at = line[static_cast<qsizetype>(share * static_cast<double>(line.size() - 1))];
        const QRectF box(at.x() - size.width() / 2, at.y() - size.height() / 2, size.width(), size.height());
        if (!area().contains(box) || std::any_of(taken.begin(), taken.end(),
                                                 [&](const QRectF& other) { return other.intersects(box); }))
          continue;
        taken.push_back(box.adjusted(-12, -4, 12, 4));
        QPainterPath letters;
        letters.addText(QPointF(box.left() + 2, box.bottom() - metrics.descent()), small, text);
        painter.strokePath(letters, QPen(colourAt(colours.shareOf(fuzzy::toAxis(output, level))), 4,
                                         Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.fillPath(letters, ink);
        break;
      }
    }
  }
  painter.setFont(font());
}

/// Words where they are most true, the ends of the range as numbers beside the variable's name.
void SurfacePlot::paintAxes(QPainter& painter) const
{
  const Language language = m_source->evaluation()->document()->ruleLanguage();
  const QRectF map = area();
  const int line = fontMetrics().height();
  const auto paintTitle = [&](const fuzzy::Variable& v, const QRectF& box) {
    const DisplayUnit unit = RuleDisplay::displayUnit(v.unit);
    const auto number = [&](double plain) {
      return plain == 0.0 ? QStringLiteral("0") : locale().toString(plain / unit.factor, 'g', 3);
    };
    QString title = RuleDisplay::title(v, language);
    if (!unit.symbol.isEmpty()) title += QStringLiteral(" [%1]").arg(unit.symbol);
    painter.setPen(panel_colors::quiet(palette()));
    painter.drawText(box, Qt::AlignLeft | Qt::AlignVCenter, number(v.minimum));
    painter.drawText(box, Qt::AlignRight | Qt::AlignVCenter, number(v.maximum));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(box, Qt::AlignCenter,
                     fontMetrics().elidedText(title, Qt::ElideRight, static_cast<int>(box.width()) - 40));
  };
  paintTitle(*m_source->inputX(), QRectF(map.left(), map.bottom() + line + 7, map.width(), line));
  painter.save();
  painter.translate(4, map.bottom());
  painter.rotate(-90);
  paintTitle(*m_source->inputY(), QRectF(0, 0, map.height(), line));
  painter.restore();

  double free = 0; // up to where the axis is taken
  const auto share = [](const fuzzy::Variable& v, const fuzzy::Term& term) {
    const fuzzy::Axis axis = fuzzy::axisOf(v);
    return (std::clamp(fuzzy::placeOf(term, fuzzy::Handle::Curve), axis.low, axis.high) - axis.low) /
           (axis.high - axis.low);
  };
  const fuzzy::Variable &x = *m_source->inputX(), &y = *m_source->inputY();
  painter.setPen(palette().color(QPalette::Text));
  for (const int index : fuzzy::orderOfCores(x)) {
    const fuzzy::Term& term = x.terms[static_cast<std::size_t>(index)];
    const double at = map.left() + share(x, term) * map.width();
    painter.drawLine(QPointF(at, map.bottom()), QPointF(at, map.bottom() + 4));
    const QString name = toQt(term.name.in(language));
    const double wide = fontMetrics().horizontalAdvance(name);
    const double start = std::clamp(at - wide / 2, 2.0, std::max(2.0, width() - wide - 2.0));
    if (start < free) continue;
    painter.drawText(QRectF(start, map.bottom() + 5, wide + 2, line), Qt::AlignLeft, name);
    free = start + wide + 8;
  }
  double roof = height();
  for (const int index : fuzzy::orderOfCores(y)) {
    const fuzzy::Term& term = y.terms[static_cast<std::size_t>(index)];
    const double at = map.bottom() - share(y, term) * map.height();
    painter.drawLine(QPointF(map.left() - 4, at), QPointF(map.left(), at));
    if (at + line / 2.0 > roof) continue;
    const QString name =
      fontMetrics().elidedText(toQt(term.name.in(language)), Qt::ElideRight, wordWidth() - 4);
    painter.drawText(QRectF(line + 6, at - line / 2.0, wordWidth() - 4, line),
                     Qt::AlignRight | Qt::AlignVCenter, name);
    roof = at - line / 2.0;
  }
}

void SurfacePlot::paintLegend(QPainter& painter, const Scale& colours) const
{
  const fuzzy::Variable& output = *m_source->output();
  const QRectF map = area();
  const QRectF bar(map.right() + 10, map.top(), 12, map.height());
  for (int i = 0; i < static_cast<int>(bar.height()); ++i)
    painter.fillRect(QRectF(bar.left(), bar.bottom() - i - 1, bar.width(), 1.5), colourAt(i / bar.height()));
  const DisplayUnit unit = RuleDisplay::displayUnit(output.unit);
  const int line = fontMetrics().height();
  const auto number = [&](double axis, double y) {
    painter.drawText(QRectF(bar.right() + 5, y - line / 2.0, kLegendWidth - 20, line),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     RuleDisplay::number(fuzzy::fromAxis(output, axis) / unit.factor, locale(), 2));
  };
  painter.setPen(palette().color(QPalette::Text));
  number(colours.greatest, bar.top() + line / 2.0);
  number(colours.least, bar.bottom() - line / 2.0);
  if (bar.height() > 4 * line)
    number(colours.least + 0.5 * (colours.greatest - colours.least), bar.center().y());
  painter.drawText(QRectF(bar.left(), bar.bottom() + line + 7, kLegendWidth, line), Qt::AlignLeft,
                   unit.symbol);
}

/// Light on dark and dark on light at once, so that it stands out on every colour.
void SurfacePlot::paintCross(QPainter& painter) const
{
  const QPointF at = cross();
  const QRectF map = area();
  for (const QPen& pen : {QPen(QColor(0, 0, 0, 190), 3), QPen(Qt::white, 1.2)}) {
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawLine(QPointF(map.left(), at.y()), QPointF(at.x() - 6, at.y()));
    painter.drawLine(QPointF(at.x() + 6, at.y()), QPointF(map.right(), at.y()));
    painter.drawLine(QPointF(at.x(), map.top()), QPointF(at.x(), at.y() - 6));
    painter.drawLine(QPointF(at.x(), at.y() + 6), QPointF(at.x(), map.bottom()));
    painter.drawEllipse(at, 6, 6);
  }
}

} // namespace esm
