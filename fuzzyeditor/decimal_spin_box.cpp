// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/decimal_spin_box.h"

namespace esm {

/// Both marks of the number as the language has it; what stands around the number stays.
QString DecimalSpinBox::withOwnMark(QString text) const
{
  if (text == specialValueText()) return text;
  const qsizetype begin = text.startsWith(prefix()) ? prefix().size() : 0;
  const qsizetype end = text.size() - (text.endsWith(suffix()) ? suffix().size() : 0);
  const QString mark = locale().decimalPoint();
  for (qsizetype i = begin; i < end; ++i)
    if (text[i] == QLatin1Char('.') || text[i] == QLatin1Char(',')) text[i] = mark.front();
  return text;
}

double DecimalSpinBox::valueFromText(const QString& text) const
{
  return QDoubleSpinBox::valueFromText(withOwnMark(text));
}

QValidator::State DecimalSpinBox::validate(QString& text, int& position) const
{
  text = withOwnMark(text);
  return QDoubleSpinBox::validate(text, position);
}

} // namespace esm
