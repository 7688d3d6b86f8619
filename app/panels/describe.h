// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

namespace esm {

/// What a widget is called to those who cannot see it, and what it says under the mouse.
inline void describe(QWidget* widget, const QString& name, const QString& help)
{
  widget->setAccessibleName(name);
  widget->setToolTip(help);
}

/// Both in the same words.
inline void describe(QWidget* widget, const QString& text)
{
  describe(widget, text, text);
}

} // namespace esm
