// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

/// Colours that Qt's palette has no role for, taken from its lightness so that they hold on light and dark.
namespace esm::panel_colors {

bool isDark(const QPalette& palette);

QColor mix(const QColor& a, const QColor& b, double shareOfB);
QColor faint(const QPalette& palette);             ///< frames, grid lines
QColor quiet(const QPalette& palette);             ///< text of less weight, still well readable
QColor off(const QPalette& palette);               ///< text of what is switched off, but still to be read
QColor bar(const QPalette& palette);               ///< filling of a degree bar, text stays readable on it
QColor mistake(const QPalette& palette);           ///< wave lines, messages of mistakes
QColor keyword(const QPalette& palette);           ///< IF THEN ...
QColor hedge(const QPalette& palette);             ///< very, somewhat
QColor variable(const QPalette& palette);          ///< names of variables
QColor term(const QPalette& palette);              ///< names of terms
QColor badge(const QPalette& palette);             ///< ground of a warning badge
QColor badgeText(const QPalette& palette);         ///< text on it
QColor curve(const QPalette& palette, int number); ///< of distinct curves, told apart also in grey by labels

} // namespace esm::panel_colors
