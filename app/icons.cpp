// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/icons.h"

#include "app/theme.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

namespace esm {

namespace {

/// A drawing on a field of 24 x 24: lines of width 1.8, and areas that are filled.
struct Drawing {
  QPainterPath lines, areas;
};

void polyline(QPainterPath& path, std::initializer_list<QPointF> points)
{
  const auto* point = points.begin();
  path.moveTo(*point);
  while (++point != points.end()) path.lineTo(*point);
}

void polygon(QPainterPath& path, std::initializer_list<QPointF> points)
{
  polyline(path, points);
  path.closeSubpath();
}

void arrowHead(QPainterPath& path, const QPointF& tip, const QPointF& direction, double size = 4.0)
{
  const QPointF side(-direction.y(), direction.x());
  const QPointF back = tip - direction * size;
  polygon(path, {tip, back + side * (size * 0.75), back - side * (size * 0.75)});
}

Drawing fileDrawing(Symbol symbol)
{
  Drawing d;
  switch (symbol) {
  case Symbol::New:
    polygon(d.lines, {{6, 3}, {14, 3}, {18.5, 7.5}, {18.5, 21}, {6, 21}});
    polyline(d.lines, {{14, 3}, {14, 7.5}, {18.5, 7.5}});
    break;
  case Symbol::Open:
    polyline(d.lines, {{4, 19}, {4, 5.5}, {9.5, 5.5}, {11.5, 8}, {19, 8}, {19, 11}});
    polygon(d.lines, {{4, 19}, {7, 11}, {22, 11}, {19, 19}});
    break;
  case Symbol::Save:
    polygon(d.lines, {{4, 4}, {17, 4}, {20, 7}, {20, 20}, {4, 20}});
    polyline(d.lines, {{8, 4}, {8, 9}, {15, 9}, {15, 4}});
    polyline(d.lines, {{7.5, 20}, {7.5, 13.5}, {16.5, 13.5}, {16.5, 20}});
    break;
  case Symbol::Import: // a mesh that arrives
    polyline(d.lines, {{12, 2.5}, {12, 11}});
    arrowHead(d.areas, {12, 14.5}, {0, 1}, 5);
    polyline(d.lines, {{7, 8.5}, {3.5, 15.5}, {7.5, 21}, {16.5, 21}, {20.5, 15.5}, {17, 8.5}});
    polyline(d.lines, {{3.5, 15.5}, {8.5, 16.5}, {7.5, 21}});
    polyline(d.lines, {{20.5, 15.5}, {15.5, 16.5}, {16.5, 21}});
    break;
  case Symbol::Undo:
  case Symbol::Redo:
    d.lines.moveTo(6, 9.5);
    d.lines.lineTo(14, 9.5);
    d.lines.cubicTo({21, 9.5}, {21, 19}, {14, 19});
    d.lines.lineTo(9, 19);
    arrowHead(d.areas, {3, 9.5}, {-1, 0}, 6);
    if (symbol == Symbol::Redo) {
      const QTransform mirror = QTransform::fromTranslate(24, 0).scale(-1, 1);
      d = {mirror.map(d.lines), mirror.map(d.areas)};
    }
    break;
  case Symbol::Copy:
    d.lines.addRoundedRect(8.5, 8.5, 11.5, 11.5, 1.5, 1.5);
    polyline(d.lines, {{5.5, 15.5}, {4, 15.5}, {4, 4}, {15.5, 4}, {15.5, 5.5}});
    break;
  default:
    break;
  }
  return d;
}

Drawing runDrawing(Symbol symbol)
{
  Drawing d;
  switch (symbol) {
  case Symbol::Play:
    polygon(d.areas, {{7, 4}, {20, 12}, {7, 20}});
    break;
  case Symbol::Pause:
    d.areas.addRect(6.5, 4.5, 4, 15);
    d.areas.addRect(13.5, 4.5, 4, 15);
    break;
  case Symbol::Step:
    polygon(d.areas, {{5, 4.5}, {15, 12}, {5, 19.5}});
    d.areas.addRect(16.5, 4.5, 3, 15);
    break;
  case Symbol::Reset:
    d.areas.addRect(4.5, 4.5, 3, 15);
    polygon(d.areas, {{19.5, 4.5}, {9.5, 12}, {19.5, 19.5}});
    break;
  case Symbol::Stop:
    polygon(d.areas, {{8, 2}, {16, 2}, {22, 8}, {22, 16}, {16, 22}, {8, 22}, {2, 16}, {2, 8}});
    break;
  case Symbol::Up:
    polyline(d.lines, {{5, 15}, {12, 8}, {19, 15}});
    break;
  case Symbol::Down:
    polyline(d.lines, {{5, 9}, {12, 16}, {19, 9}});
    break;
  case Symbol::Plus:
    polyline(d.lines, {{12, 5}, {12, 19}});
    polyline(d.lines, {{5, 12}, {19, 12}});
    break;
  case Symbol::Minus:
    polyline(d.lines, {{5, 12}, {19, 12}});
    break;
  case Symbol::Fit:
    for (const double x : {4.0, 20.0})
      for (const double y : {4.0, 20.0})
        polyline(d.lines, {{x, y < 12 ? 9.0 : 15.0}, {x, y}, {x < 12 ? 9.0 : 15.0, y}});
    d.areas.addEllipse(QPointF(12, 12), 3, 3);
    break;
  default:
    break;
  }
  return d;
}

Drawing toolDrawing(Symbol symbol)
{
  Drawing d;
  switch (symbol) {
  case Symbol::Camera: // orbit
    d.areas.addEllipse(QPointF(12, 12), 3.2, 3.2);
    d.lines.moveTo(20.5, 9.5);
    d.lines.cubicTo({17, 4.5}, {7, 4.5}, {3.5, 9.5});
    d.lines.moveTo(3.5, 14.5);
    d.lines.cubicTo({7, 19.5}, {17, 19.5}, {20.5, 14.5});
    arrowHead(d.areas, {2.5, 13}, {-0.55, 0.83}, 4.5);
    arrowHead(d.areas, {21.5, 11}, {0.55, -0.83}, 4.5);
    break;
  case Symbol::Pull: // a surface drawn up to a point
    d.lines.moveTo(2.5, 20);
    d.lines.cubicTo({9, 20}, {10, 12}, {12, 12});
    d.lines.cubicTo({14, 12}, {15, 20}, {21.5, 20});
    polyline(d.lines, {{12, 12}, {12, 7}});
    arrowHead(d.areas, {12, 2}, {0, -1}, 6);
    break;
  case Symbol::Select:
    polygon(d.areas, {{6, 3}, {6, 18.5}, {10, 15}, {12.6, 21}, {15.4, 19.8}, {12.8, 14}, {18, 13.6}});
    break;
  case Symbol::Region: // an ellipsoid with handles
    d.lines.addEllipse(QPointF(12, 12), 9, 6.5);
    for (const QPointF& handle : {QPointF(3, 12), QPointF(21, 12), QPointF(12, 5.5), QPointF(12, 18.5)})
      d.areas.addRect(handle.x() - 2.2, handle.y() - 2.2, 4.4, 4.4);
    d.areas.addEllipse(QPointF(12, 12), 1.8, 1.8);
    break;
  case Symbol::FromSelection: // an ellipsoid around points
    d.lines.addEllipse(QPointF(12, 12), 9.5, 7);
    for (const QPointF& node : {QPointF(8, 10.5), QPointF(12.5, 15), QPointF(15.5, 9.5)})
      d.areas.addEllipse(node, 1.9, 1.9);
    break;
  case Symbol::Eye:
  case Symbol::EyeShut:
    d.lines.moveTo(2.5, 12);
    d.lines.cubicTo({7, 4.5}, {17, 4.5}, {21.5, 12});
    d.lines.cubicTo({17, 19.5}, {7, 19.5}, {2.5, 12});
    d.areas.addEllipse(QPointF(12, 12), 3.2, 3.2);
    if (symbol == Symbol::EyeShut) polyline(d.lines, {{4.5, 20}, {19.5, 4}});
    break;
  case Symbol::Lock:
  case Symbol::LockOpen:
    d.areas.addRoundedRect(5, 11, 14, 10, 1.5, 1.5);
    polyline(d.lines, {{8, 11}, {8, 7.5}});
    d.lines.cubicTo({8, 2}, {16, 2}, {16, 7.5});
    if (symbol == Symbol::Lock) d.lines.lineTo(16, 11);
    break;
  case Symbol::Arm: // lightning: force on
    polygon(d.areas, {{13.5, 2}, {5, 13.5}, {11, 13.5}, {9.5, 22}, {19, 9.5}, {12.5, 9.5}});
    break;
  case Symbol::Program: // a spring net
    polygon(d.lines, {{12, 3}, {21, 10}, {17.5, 20.5}, {6.5, 20.5}, {3, 10}});
    polyline(d.lines, {{12, 3}, {12, 12}, {21, 10}});
    polyline(d.lines, {{17.5, 20.5}, {12, 12}, {6.5, 20.5}});
    polyline(d.lines, {{12, 12}, {3, 10}});
    for (const QPointF& node : {QPointF(12, 3), QPointF(21, 10), QPointF(17.5, 20.5), QPointF(6.5, 20.5),
                                QPointF(3, 10), QPointF(12, 12)})
      d.areas.addEllipse(node, 2.2, 2.2);
    break;
  default:
    break;
  }
  return d;
}

Drawing drawingOf(Symbol symbol)
{
  for (const Drawing& drawing : {fileDrawing(symbol), runDrawing(symbol), toolDrawing(symbol)})
    if (!drawing.lines.isEmpty() || !drawing.areas.isEmpty()) return drawing;
  return {};
}

class SymbolEngine : public QIconEngine {
public:
  explicit SymbolEngine(Symbol symbol) : m_symbol(symbol) {}
  QIconEngine* clone() const override { return new SymbolEngine(m_symbol); }

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
  {
    const QPalette palette = QGuiApplication::palette();
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    QColor colour =
      palette.color(group, mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::ButtonText);
    if (m_symbol == Symbol::Stop && mode != QIcon::Disabled) colour = signalColours(palette).bad;
    if (m_symbol == Symbol::Program) colour = signalColours(palette).device;

    const Drawing drawing = drawingOf(m_symbol);
    const double scale = std::min(rect.width(), rect.height()) / 24.0;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(rect.center() + QPointF(0.5, 0.5));
    painter->scale(scale, scale);
    painter->translate(-12, -12);
    painter->strokePath(drawing.lines, QPen(colour, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter->fillPath(drawing.areas, colour);
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
  {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return pixmap;
  }

private:
  Symbol m_symbol;
};

} // namespace

QIcon icon(Symbol symbol)
{
  return QIcon(new SymbolEngine(symbol));
}

} // namespace esm
