// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

namespace esm {

/// A spin box for people on both sides of the decimal mark: takes "0,7" and "0.7" whatever the locale, never
/// reads either as a group separator ("62,5" is not 625), shows the locale's mark and at least two decimals.
class NumberSpinBox : public QDoubleSpinBox {
  Q_OBJECT
public:
  explicit NumberSpinBox(QWidget* parent = nullptr);

  /// Accessible name of the box and of the line edit inside it.
  void setNamesForAccess(const QString& name);

  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;

signals:
  /// An arrow key, button or wheel is about to change the value; typed values come without it.
  void aboutToStep();

protected:
  void stepBy(int steps) override;
  void wheelEvent(QWheelEvent* event) override; ///< only with focus, so scrolling a panel changes nothing
};

} // namespace esm
