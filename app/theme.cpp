// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/theme.h"

#include <QApplication>
#include <QStyle>
#include <QStyleFactory>

namespace esm {

namespace {

QPalette paletteOf(const QColor& window, const QColor& base, const QColor& text, const QColor& button,
                   const QColor& highlight, const QColor& link, const QColor& faint)
{
  QPalette palette(text, button, button.lighter(130), button.darker(160), button.darker(120), text, Qt::white,
                   base, window);
  palette.setColor(QPalette::AlternateBase,
                   window.lightnessF() < 0.5F ? base.lighter(125) : base.darker(103));
  palette.setColor(QPalette::Highlight, highlight);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, link);
  palette.setColor(QPalette::ToolTipBase, base);
  palette.setColor(QPalette::ToolTipText, text);
  palette.setColor(QPalette::PlaceholderText, faint);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, faint);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, faint);
  return palette;
}

/// What the platform offered before any theme of ours was set.
const QPalette& systemPalette()
{
  static const QPalette palette = QApplication::palette();
  return palette;
}

} // namespace

std::optional<Theme> themeFromName(const QString& name)
{
  for (const Theme theme : {Theme::System, Theme::Light, Theme::Dark})
    if (name == themeName(theme)) return theme;
  return std::nullopt;
}

QString themeName(Theme theme)
{
  switch (theme) {
  case Theme::Light:
    return QStringLiteral("light");
  case Theme::Dark:
    return QStringLiteral("dark");
  case Theme::System:
    break;
  }
  return QStringLiteral("system");
}

QPalette themePalette(Theme theme)
{
  if (theme == Theme::Light)
    return paletteOf(QColor(0xf2f3f5), QColor(0xffffff), QColor(0x1d2126), QColor(0xe6e8eb), QColor(0x2367b0),
                     QColor(0x1b5fa8), QColor(0x7a818a));
  if (theme == Theme::Dark)
    return paletteOf(QColor(0x25282d), QColor(0x1b1d21), QColor(0xe4e6ea), QColor(0x33373e), QColor(0x3a78c2),
                     QColor(0x7db4f2), QColor(0x868d97));
  return systemPalette();
}

void applyTheme(Theme theme)
{
  systemPalette(); // keep it before it is gone
  if (QApplication::style()->objectName() != QLatin1String("fusion"))
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  QApplication::setPalette(themePalette(theme));
}

bool isDark(const QPalette& palette)
{
  return palette.color(QPalette::Window).lightnessF() < palette.color(QPalette::WindowText).lightnessF();
}

SignalColours signalColours(const QPalette& palette)
{
  if (isDark(palette))
    return {QColor(0x5fbf77), QColor(0xe0a93f), QColor(0xf0706a), QColor(0xf2a65a), QColor(0x6fb1f0)};
  return {QColor(0x2c8a45), QColor(0xa86a00), QColor(0xc22f2a), QColor(0xb8560b), QColor(0x1b5fa8)};
}

} // namespace esm
