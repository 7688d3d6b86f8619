// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/overlay.h"

#include "app/viewport/gizmo_painter.h"
#include "app/viewport/grip_painter.h"
#include "core/base/colour_map.h"

#include <QLinearGradient>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double kMargin = 14.0; ///< from the border of the picture [pixels]
/// Of the legend [pixels].
constexpr double kPlatePadding = 10.0, kBarWidth = 16.0, kBarToNumber = 12.0, kLeastBarHeight = 50.0;
const QColor kAccent(0xf2, 0x6b, 0x21);

double legendBarHeight(double pictureHeight)
{
  return std::min(220.0, pictureHeight - 150.0);
}

/// Of a number beside the legend's bar: what it takes at least, whatever the values are.
double usualNumber(const QFontMetricsF& metrics)
{
  return metrics.horizontalAdvance(QStringLiteral("0.000"));
}

/// @param number  width of the widest [pixels]
double legendWidth(const QString& title, double number, const QFontMetricsF& metrics)
{
  return std::max(metrics.horizontalAdvance(title), kBarWidth + kBarToNumber + number) + 2.0 * kPlatePadding;
}

QPointF toQt(const Eigen::Vector2d& pixel)
{
  return {pixel.x(), pixel.y()};
}

QColor faded(QColor colour, double alpha)
{
  colour.setAlphaF(static_cast<float>(alpha));
  return colour;
}

/// A line from a to b with a filled head, and around both a rim of that colour; nothing if a and b coincide.
void drawArrow(QPainter& painter, const QPointF& a, const QPointF& b, const QColor& colour, double width,
               const QColor& rim = Qt::transparent)
{
  const QPointF along = b - a;
  const double length = std::hypot(along.x(), along.y());
  if (length < 1.0) return;
  const QPointF unit = along / length, side(-unit.y(), unit.x());
  const double head = std::min(4.5 * width, 0.6 * length);
  const QPointF neck = b - head * unit;
  const QPolygonF tip({b, neck + 0.45 * head * side, neck - 0.45 * head * side});
  if (rim.alpha() > 0) {
    painter.setPen(QPen(rim, width + 3.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(a, neck);
    painter.setPen(QPen(rim, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(rim);
    painter.drawPolygon(tip);
  }
  painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(a, neck);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawPolygon(tip);
}

} // namespace

LegendText legendText(const SceneModel& model)
{
  switch (model.colouring()) {
  case Colouring::Stiffness:
    return {QCoreApplication::translate("esm::Overlay", "Stiffness [N/m]"), 1.0};
  case Colouring::Strain:
    return {QCoreApplication::translate("esm::Overlay", "Strain [%]"), 100.0};
  case Colouring::Force:
    return {QCoreApplication::translate("esm::Overlay", "Force [mN]"), 1000.0};
  case Colouring::RegionWeight: {
    const Region* region = model.chosenRegion();
    if (region == nullptr)
      return {QCoreApplication::translate("esm::Overlay", "Weight: choose a region"), 100.0};
    constexpr int kLongest = 24; // letters of a name
    QString name = QString::fromStdString(region->name);
    if (name.size() > kLongest) name = name.left(kLongest - 1) + QChar(0x2026);
    return {QCoreApplication::translate("esm::Overlay", "Weight of %1 [%]").arg(name), 100.0};
  }
  case Colouring::None:
    break;
  }
  return {};
}

double legendRoom(const SceneModel& model, const QFontMetricsF& metrics)
{
  if (model.net() == nullptr || model.colouring() == Colouring::None) return 0.0;
  if (legendBarHeight(model.camera.height()) < kLeastBarHeight) return 0.0;
  return legendWidth(legendText(model).title, usualNumber(metrics), metrics) + 2.0 * kMargin;
}

QString legendNumber(double value)
{
  const QLocale locale;
  const double size = std::abs(value);
  if (size != 0.0 && (size < 1e-4 || size >= 1e7)) return locale.toString(value, 'g', 3);
  int decimals = 0;
  for (double rest = size; decimals < 6 && std::abs(rest - std::round(rest)) > 1e-6 * std::max(rest, 1.0);
       rest *= 10.0)
    ++decimals;
  return locale.toString(value, 'f', decimals);
}

Overlay::Overlay(QPainter& painter, const QPalette& palette, const SceneModel& model,
                 const OverlayState& state)
  : m_painter(painter),
    m_palette(palette),
    m_model(model),
    m_state(state),
    m_width(model.camera.width()),
    m_height(model.camera.height())
{}

void Overlay::draw()
{
  m_painter.setRenderHint(QPainter::Antialiasing);
  if (m_model.net()) {
    drawRegion();
    drawMarks();
    drawInstrument();
    drawPull();
    drawSelectionBox();
    if (m_model.colouring() != Colouring::None) drawLegend();
    drawScaleBar();
  } else {
    drawEmpty();
  }
  drawAxes();
  drawHint();
  if (m_state.keyboardFocus) {
    m_painter.setPen(QPen(m_palette.color(QPalette::Highlight), 2.0));
    m_painter.setBrush(Qt::NoBrush);
    m_painter.drawRect(QRectF(1.0, 1.0, m_width - 2.0, m_height - 2.0));
  }
}

void Overlay::panel(const QRectF& rect)
{
  m_painter.setPen(Qt::NoPen);
  m_painter.setBrush(faded(m_palette.color(QPalette::Base), 0.72));
  m_painter.drawRoundedRect(rect, 5.0, 5.0);
}

void Overlay::drawSelectedSpring()
{
  if (m_state.selectedSpring < 0 || !m_model.net() || m_state.selectedSpring >= m_model.net()->springCount())
    return;
  const auto ends = m_model.net()->ends.col(m_state.selectedSpring);
  const QPointF a = toQt(m_model.camera.project(m_model.position().col(ends[0])).pixel),
                b = toQt(m_model.camera.project(m_model.position().col(ends[1])).pixel);
  if (std::isnan(a.x()) || std::isnan(b.x())) return;
  m_painter.setPen(QPen(QColor(255, 255, 255, 200), 6.0, Qt::SolidLine, Qt::RoundCap));
  m_painter.drawLine(a, b);
  m_painter.setPen(QPen(m_palette.color(QPalette::Highlight), 3.0, Qt::SolidLine, Qt::RoundCap));
  m_painter.drawLine(a, b);
}

void Overlay::drawRing(Index node, double radius, const QColor& colour)
{
  if (node < 0 || node >= m_model.position().cols()) return;
  drawRingAt(m_model.position().col(node), radius, colour);
}

void Overlay::drawMarks()
{
  for (const auto& place : m_model.marks().colwise()) drawRingAt(place, 8.0, kAccent);
}

/// The workspace as a box in dashes; the instrument as a shaft with a ball at its tip, which stays outside
/// the tissue; and where the hand has gone further, a thin line to it.
void Overlay::drawInstrument()
{
  const Instrument& instrument = m_model.instrument();
  if (!instrument.visible) return;
  const Projector projector = m_model.camera.projector();
  const auto line = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const QPointF from = toQt(projector(a).pixel), to = toQt(projector(b).pixel);
    if (!std::isnan(from.x()) && !std::isnan(to.x())) m_painter.drawLine(from, to);
  };
  const QColor text = m_palette.color(QPalette::WindowText), base = m_palette.color(QPalette::Base);
  m_painter.setPen(QPen(faded(text, 0.45), 1.0, Qt::DashLine));
  const auto corner = [&](int i) {
    return instrument.workspace.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
  };
  for (int i = 0; i < 8; ++i)
    for (const int axis : {1, 2, 4})
      if ((i & axis) == 0) line(corner(i), corner(i | axis));

  const QPointF tip = toQt(projector(instrument.tip).pixel), hand = toQt(projector(instrument.hand).pixel);
  if (std::isnan(tip.x())) return;
  const double pixels = instrument.radius / m_model.camera.metresPerPixel(instrument.tip);
  const double radius = std::clamp(pixels, 3.0, 200.0);
  if (!std::isnan(hand.x()) && (instrument.hand - instrument.tip).norm() > 1e-4) {
    m_painter.setPen(QPen(faded(text, 0.7), 1.0, Qt::DotLine));
    m_painter.drawLine(tip, hand);
    m_painter.setBrush(Qt::NoBrush);
    m_painter.drawEllipse(hand, radius, radius);
  }
  const QColor metal = instrument.touches ? kAccent : text;
  const Eigen::Vector3d shaft(0.0, 0.0, 20.0 * instrument.radius); // it comes from above, as through a trocar
  for (const auto& [colour, width] : {std::pair(base, 6.0), std::pair(metal, 3.0)}) {
    m_painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
    line(instrument.tip, instrument.tip + shaft);
  }
  m_painter.setPen(QPen(base, 2.0));
  m_painter.setBrush(metal);
  m_painter.drawEllipse(tip, radius, radius);
}

void Overlay::drawRingAt(const Eigen::Vector3d& place, double radius, const QColor& colour)
{
  const QPointF at = toQt(m_model.camera.project(place).pixel);
  if (std::isnan(at.x())) return;
  m_painter.setBrush(Qt::NoBrush);
  m_painter.setPen(QPen(QColor(255, 255, 255, 200), 4.0));
  m_painter.drawEllipse(at, radius, radius);
  m_painter.setPen(QPen(colour, 2.0));
  m_painter.drawEllipse(at, radius, radius);
}

void Overlay::drawRegion()
{
  const Region* region = m_model.chosenRegion();
  if (m_state.tool != Tool::Region || region == nullptr || !region->visible) return;
  GizmoPainter painter(m_painter, m_palette, m_model.camera);
  if (region->locked)
    painter.drawLock(region->ellipsoid);
  else
    painter.drawHandles({region->ellipsoid, region->falloff}, m_state.handle);
}

void Overlay::drawSelectionBox()
{
  if (!m_state.selectionBox) return;
  const QColor colour = m_palette.color(QPalette::Highlight);
  m_painter.setPen(QPen(colour, 1.5));
  m_painter.setBrush(faded(colour, 0.15));
  m_painter.drawRect(QRectF(toQt(m_state.selectionBox->min()), toQt(m_state.selectionBox->max())));
}

void Overlay::drawPull()
{
  drawRing(m_state.selected, 7.0, m_palette.color(QPalette::Highlight));
  drawSelectedSpring();
  GripPainter grip(m_painter, m_model, kAccent);
  if (m_state.tool == Tool::Pull && m_state.hovered != kNoIndex) grip.drawRim(m_state.hovered);
  drawRing(m_state.hovered, 5.0, kAccent);
  const Index grabbed = m_state.pulled != kNoIndex ? m_state.pulled : m_model.grabbedNode();
  if (grabbed < 0 || grabbed >= m_model.position().cols()) return;
  if (m_state.pulled != kNoIndex) { // the rubber band between node and hand
    const QPointF node = toQt(m_model.camera.project(m_model.position().col(grabbed)).pixel);
    const QPointF hand = toQt(m_model.camera.project(m_state.pullTarget).pixel);
    m_painter.setPen(QPen(faded(m_palette.color(QPalette::WindowText), 0.7), 1.5, Qt::DashLine));
    m_painter.drawLine(node, hand);
  }
  grip.drawHeld();
  grip.drawRim(grabbed);
  drawRing(grabbed, 5.0, kAccent);
  drawForce(grabbed);
}

void Overlay::drawForce(Index node)
{
  const double force = m_state.toolForce.norm();
  if (!(force > 1e-4) || !std::isfinite(force)) return;
  // The length grows with the force but never leaves the picture: 100 pixels at 0.5 N, at most 180.
  const double pixels = 160.0 * force / (force + 0.5) + 20.0;
  const Camera& camera = m_model.camera;
  const Eigen::Vector3d from = m_model.position().col(node);
  const Eigen::Vector3d to = from + pixels * camera.metresPerPixel(from) / force * m_state.toolForce;
  const QPointF a = toQt(camera.project(from).pixel), b = toQt(camera.project(to).pixel);
  if (std::isnan(a.x()) || std::isnan(b.x())) return;
  drawArrow(m_painter, a, b, kAccent, 3.0, Qt::white);

  const QString text = tr("%1 N").arg(QLocale().toString(force, 'f', force < 1.0 ? 3 : 2));
  const QFontMetricsF metrics(m_painter.font());
  QRectF box(0.0, 0.0, metrics.horizontalAdvance(text) + 12.0, metrics.height() + 4.0);
  box.moveCenter(b + QPointF(0.0, b.y() < a.y() ? -16.0 : 16.0));
  panel(box);
  m_painter.setPen(m_palette.color(QPalette::WindowText));
  m_painter.drawText(box, Qt::AlignCenter, text);
}

void Overlay::drawLegend()
{
  const LegendText text = legendText(m_model);
  const ValueRange range = m_model.valueRange();
  const ValueRange shown{range.low * text.perSi, range.high * text.perSi, range.logarithmic};
  const double barHeight = legendBarHeight(m_height);
  if (barHeight < kLeastBarHeight) return;

  const QFontMetricsF metrics(m_painter.font());
  const std::vector<double> ticks = legendTicks(shown, std::max(3, static_cast<int>(barHeight / 45.0)));
  double widest = usualNumber(metrics);
  for (const double tick : ticks) widest = std::max(widest, metrics.horizontalAdvance(legendNumber(tick)));
  const double plateWidth = legendWidth(text.title, widest, metrics);
  const QRectF plate(m_width - kMargin - plateWidth, kMargin, plateWidth,
                     barHeight + metrics.height() + 32.0);
  panel(plate);

  m_painter.setPen(m_palette.color(QPalette::WindowText));
  m_painter.drawText(QPointF(plate.left() + kPlatePadding, plate.top() + 8.0 + metrics.ascent()), text.title);
  const QRectF bar(plate.left() + kPlatePadding, plate.top() + metrics.height() + 20.0, kBarWidth, barHeight);
  QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
  for (int i = 0; i <= 17; ++i) {
    const Rgb c = viridis(i / 17.0);
    gradient.setColorAt(i / 17.0, QColor::fromRgbF(c[0], c[1], c[2]));
  }
  m_painter.setBrush(gradient);
  m_painter.setPen(QPen(faded(m_palette.color(QPalette::WindowText), 0.35), 1.0));
  m_painter.drawRect(bar);
  for (const double tick : ticks) {
    const double y = bar.bottom() - shown.share(tick) * bar.height();
    m_painter.setPen(QPen(m_palette.color(QPalette::WindowText), 1.0));
    m_painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 5.0, y));
    m_painter.drawText(QPointF(bar.right() + 9.0, y + metrics.ascent() / 2.0 - 1.0), legendNumber(tick));
  }
}

void Overlay::drawAxes()
{
  const QPointF origin(kMargin + 34.0, m_height - kMargin - 62.0);
  struct Axis {
    Eigen::Vector3d direction;
    const char* name;
    QColor colour;
  };
  Axis axes[] = {{Eigen::Vector3d::UnitX(), "x", QColor(0xd6, 0x45, 0x41)},
                 {Eigen::Vector3d::UnitY(), "y", QColor(0x4c, 0x9a, 0x3b)},
                 {Eigen::Vector3d::UnitZ(), "z", QColor(0x3a, 0x7b, 0xd5)}};
  const Eigen::Vector3d back = m_model.camera.backward();
  std::sort(std::begin(axes), std::end(axes),
            [&](const Axis& a, const Axis& b) { return a.direction.dot(back) < b.direction.dot(back); });
  QFont font = m_painter.font();
  font.setBold(true);
  m_painter.save();
  m_painter.setFont(font);
  for (const Axis& axis : axes) {
    const QPointF along(axis.direction.dot(m_model.camera.right()), -axis.direction.dot(m_model.camera.up()));
    const QColor colour =
      m_palette.color(QPalette::Window).lightness() < 128 ? axis.colour.lighter(135) : axis.colour;
    drawArrow(m_painter, origin, origin + 26.0 * along, colour, 2.0);
    m_painter.setPen(colour);
    QRectF label(0.0, 0.0, 14.0, 14.0);
    label.moveCenter(origin + 34.0 * along);
    m_painter.drawText(label, Qt::AlignCenter, QString::fromLatin1(axis.name));
  }
  m_painter.restore();
}

void Overlay::drawScaleBar()
{
  const double perPixel = 1000.0 * m_model.camera.metresPerPixel(m_model.camera.target()); // [mm]
  const double length = niceFloor(110.0 * perPixel);
  if (!(length > 0.0)) return;
  const double pixels = length / perPixel;
  const QPointF left(kMargin + 84.0, m_height - kMargin - 42.0), right = left + QPointF(pixels, 0.0);
  const QColor colour = m_palette.color(QPalette::WindowText);
  m_painter.setPen(QPen(colour, 2.0, Qt::SolidLine, Qt::FlatCap));
  m_painter.drawLine(left, right);
  for (const QPointF& end : {left, right})
    m_painter.drawLine(end - QPointF(0.0, 4.0), end + QPointF(0.0, 4.0));
  m_painter.drawText(QRectF(left.x() - 40.0, left.y() - 24.0, pixels + 80.0, 20.0), Qt::AlignCenter,
                     tr("%1 mm").arg(legendNumber(length)));
}

QString Overlay::hint() const
{
  switch (m_state.tool) {
  case Tool::Camera:
    return tr("Camera: drag to turn, right button to move, wheel to zoom, F to fit");
  case Tool::Pull:
    return m_state.pulled != kNoIndex
             ? tr("Pull: release or Esc lets go")
             : tr("Pull: drag a point of the organ; beside it, dragging turns the view");
  case Tool::Select:
    if (!m_model.selection().empty())
      return tr("Select: %n node(s); Shift adds, Ctrl takes away, Esc clears", nullptr,
                static_cast<int>(m_model.selection().size()));
    return tr("Select: click a point of the organ, or drag a box around what can be seen");
  case Tool::Region:
    if (m_state.drag != nullptr) return GizmoPainter::readout(*m_state.drag);
    if (m_model.chosenRegion() == nullptr) return tr("Region: choose or add one in the dock Regions");
    if (m_model.chosenRegion()->locked) return tr("Region: locked");
    if (!m_model.chosenRegion()->visible) return tr("Region: hidden");
    return GizmoPainter::help(m_state.handle);
  }
  return {};
}

void Overlay::drawHint()
{
  QString hint = this->hint();
  const QFontMetricsF metrics(m_painter.font());
  hint = metrics.elidedText(hint, Qt::ElideRight, m_width - 2.0 * kMargin - 20.0);
  const QRectF box(kMargin, m_height - kMargin - metrics.height() - 6.0,
                   metrics.horizontalAdvance(hint) + 20.0, metrics.height() + 8.0);
  panel(box);
  m_painter.setPen(m_palette.color(QPalette::WindowText));
  m_painter.drawText(box, Qt::AlignCenter, hint);
}

void Overlay::drawEmpty()
{
  m_painter.setPen(faded(m_palette.color(QPalette::WindowText), 0.75));
  m_painter.drawText(QRectF(0.0, 0.0, m_width, m_height), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Nothing to show yet: import a mesh or open a project."));
}

} // namespace esm
