// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <ostream>

// How failed tests print Qt's texts; googletest looks beside the type, which is the global namespace.

inline void PrintTo(const QString& text, std::ostream* out)
{
  *out << '"' << text.toStdString() << '"';
}

inline void PrintTo(const QStringList& texts, std::ostream* out)
{
  for (const QString& text : texts) *out << "\n    \"" << text.toStdString() << '"';
}
