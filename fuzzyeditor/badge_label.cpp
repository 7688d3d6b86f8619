// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/badge_label.h"

#include "fuzzyeditor/panel_colors.h"

#include <QEvent>
#include <QGuiApplication>
#include <QPainter>

namespace esm {

BadgeLabel::BadgeLabel(QWidget* parent) : QLabel(parent)
{
  setWordWrap(true);
  setTextFormat(Qt::PlainText);
  setContentsMargins(26, 4, 8, 4);
  takeColors();
  hide();
}

void BadgeLabel::takeColors()
{
  const QColor text = panel_colors::badgeText(QGuiApplication::palette());
  if (palette().color(QPalette::WindowText) == text) return;
  QPalette colors;
  colors.setColor(QPalette::WindowText, text);
  setPalette(colors);
}

void BadgeLabel::changeEvent(QEvent* event)
{
  QLabel::changeEvent(event);
  if (event->type() == QEvent::ApplicationPaletteChange || event->type() == QEvent::PaletteChange)
    takeColors();
}

void BadgeLabel::paintEvent(QPaintEvent* event)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(panel_colors::badge(QGuiApplication::palette()));
  painter.drawRoundedRect(rect(), 4, 4);

  // A triangle with an exclamation mark: fonts without the sign would show a box.
  const QPointF centre(14, 4 + fontMetrics().height() / 2.0);
  const QPolygonF triangle{centre + QPointF(-7, 6), centre + QPointF(7, 6), centre + QPointF(0, -6.5)};
  const QColor ink = palette().color(QPalette::WindowText);
  painter.setPen(QPen(ink, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPolygon(triangle);
  painter.drawLine(centre + QPointF(0, -2), centre + QPointF(0, 1.5));
  painter.drawPoint(centre + QPointF(0, 4));
  painter.end();
  QLabel::paintEvent(event);
}

} // namespace esm
