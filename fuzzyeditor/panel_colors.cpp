// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/panel_colors.h"

#include <array>

namespace esm::panel_colors {

bool isDark(const QPalette& palette)
{
  return palette.color(QPalette::Base).lightness() < palette.color(QPalette::Text).lightness();
}

QColor mix(const QColor& a, const QColor& b, double shareOfB)
{
  const auto blend = [&](float x, float y) { return static_cast<float>(x + (y - x) * shareOfB); };
  return QColor::fromRgbF(blend(a.redF(), b.redF()), blend(a.greenF(), b.greenF()),
                          blend(a.blueF(), b.blueF()));
}

QColor faint(const QPalette& palette)
{
  return mix(palette.color(QPalette::Base), palette.color(QPalette::Text), 0.25);
}

QColor quiet(const QPalette& palette)
{
  return mix(palette.color(QPalette::Base), palette.color(QPalette::Text), 0.68);
}

QColor off(const QPalette& palette)
{
  return mix(palette.color(QPalette::Base), palette.color(QPalette::Text), 0.55);
}

QColor bar(const QPalette& palette)
{
  return isDark(palette) ? QColor(0x2b, 0x62, 0x8f) : QColor(0x9c, 0xcb, 0xf0);
}

QColor mistake(const QPalette& palette)
{
  return isDark(palette) ? QColor(0xff, 0x8a, 0x80) : QColor(0xb7, 0x1c, 0x1c);
}

QColor keyword(const QPalette& palette)
{
  return isDark(palette) ? QColor(0x82, 0xb6, 0xff) : QColor(0x1a, 0x4f, 0xa3);
}

QColor hedge(const QPalette& palette)
{
  return isDark(palette) ? QColor(0xd7, 0xa6, 0xff) : QColor(0x7a, 0x2e, 0xa8);
}

QColor variable(const QPalette& palette)
{
  return isDark(palette) ? QColor(0x7e, 0xd8, 0xb4) : QColor(0x00, 0x66, 0x4b);
}

QColor term(const QPalette& palette)
{
  return isDark(palette) ? QColor(0xff, 0xc0, 0x7a) : QColor(0x9a, 0x45, 0x00);
}

QColor badge(const QPalette& palette)
{
  return isDark(palette) ? QColor(0x5c, 0x4a, 0x10) : QColor(0xff, 0xec, 0xa8);
}

QColor badgeText(const QPalette& palette)
{
  return isDark(palette) ? QColor(0xff, 0xe9, 0xa6) : QColor(0x4d, 0x38, 0x00);
}

QColor curve(const QPalette& palette, int number)
{
  // Okabe & Ito's palette, distinguishable with colour vision deficiencies; darkened for white ground.
  static const std::array<QColor, 6> onDark{QColor(0x56, 0xb4, 0xe9), QColor(0xe6, 0x9f, 0x00),
                                            QColor(0x2f, 0xc4, 0x9a), QColor(0xe8, 0x8f, 0xbf),
                                            QColor(0xf0, 0xe4, 0x42), QColor(0xf0, 0x7c, 0x3c)};
  static const std::array<QColor, 6> onLight{QColor(0x00, 0x62, 0x9e), QColor(0xa8, 0x62, 0x00),
                                             QColor(0x00, 0x75, 0x57), QColor(0xa6, 0x3d, 0x78),
                                             QColor(0x7d, 0x70, 0x00), QColor(0xb8, 0x45, 0x00)};
  const auto index = static_cast<std::size_t>(number) % onDark.size();
  return isDark(palette) ? onDark[index] : onLight[index];
}

} // namespace esm::panel_colors
