// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/number_spin_box.h"

#include <QLineEdit>
#include <QWheelEvent>

namespace esm {
namespace {

/// The number that people meant, read with either decimal mark.
double readNumber(QString text, const QString& suffix, bool* ok)
{
  if (!suffix.isEmpty() && text.endsWith(suffix)) text.chop(suffix.size());
  text = text.trimmed().replace(',', '.').replace(QChar(0x2212), '-');
  QLocale plain = QLocale::c();
  plain.setNumberOptions(QLocale::RejectGroupSeparator);
  return plain.toDouble(text, ok);
}

} // namespace

NumberSpinBox::NumberSpinBox(QWidget* parent) : QDoubleSpinBox(parent)
{
  setDecimals(3);
  setKeyboardTracking(false); // a half-typed number is none
  setFocusPolicy(Qt::StrongFocus);
  setAlignment(Qt::AlignRight);
}

void NumberSpinBox::setNamesForAccess(const QString& name)
{
  setAccessibleName(name);
  lineEdit()->setAccessibleName(name);
}

QString NumberSpinBox::textFromValue(double value) const
{
  QLocale plain = locale();
  plain.setNumberOptions(QLocale::OmitGroupSeparator);
  QString text = plain.toString(value, 'f', decimals());
  const qsizetype mark = text.indexOf(plain.decimalPoint());
  while (mark >= 0 && text.endsWith(plain.zeroDigit()) && text.size() - mark > 3) text.chop(1);
  return text;
}

double NumberSpinBox::valueFromText(const QString& text) const
{
  bool ok = false;
  const double number = readNumber(text, suffix(), &ok);
  return ok ? number : value();
}

QValidator::State NumberSpinBox::validate(QString& text, int&) const
{
  bool ok = false;
  const double number = readNumber(text, suffix(), &ok);
  if (ok)
    return number >= minimum() && number <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
  QString rest = text;
  if (!suffix().isEmpty() && rest.endsWith(suffix())) rest.chop(suffix().size());
  rest = rest.trimmed();
  const bool start =
    rest.isEmpty() || rest == "-" || rest == "," || rest == "." || rest == "-," || rest == "-.";
  return start ? QValidator::Intermediate : QValidator::Invalid;
}

void NumberSpinBox::stepBy(int steps)
{
  emit aboutToStep();
  QDoubleSpinBox::stepBy(steps);
}

void NumberSpinBox::wheelEvent(QWheelEvent* event)
{
  if (hasFocus())
    QDoubleSpinBox::wheelEvent(event);
  else
    event->ignore();
}

} // namespace esm
