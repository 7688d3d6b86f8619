// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

namespace esm {

/// A number field that takes either decimal mark, typed or pasted, whatever the language. One of Qt's own
/// drops the mark that is not its language's, and "0.5" becomes 5.
class DecimalSpinBox : public QDoubleSpinBox {
  Q_OBJECT
public:
  using QDoubleSpinBox::QDoubleSpinBox;

  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;

private:
  QString withOwnMark(QString text) const;
};

} // namespace esm
