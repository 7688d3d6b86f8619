// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>
#include <QString>

#include <optional>

namespace esm {

enum class Theme { System, Light, Dark };

std::optional<Theme> themeFromName(const QString& name); ///< "system", "light", "dark"
QString themeName(Theme theme);

/// Fusion style with the palette of the theme. All painting of ours takes its colours from the palette.
void applyTheme(Theme theme);
QPalette themePalette(Theme theme);

bool isDark(const QPalette& palette);

/// Signal colours that stand out from either background. Meaning is always said in words as well.
struct SignalColours {
  QColor good, warning, bad, force, device;
};
SignalColours signalColours(const QPalette& palette);

} // namespace esm
