// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace esm {

/// A warning on coloured ground with a sign in front of it, so that the colour is not the only message.
/// Hidden until shown.
class BadgeLabel : public QLabel {
  Q_OBJECT
public:
  explicit BadgeLabel(QWidget* parent = nullptr);

protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void takeColors();
};

} // namespace esm
