// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fuzzyeditor/decimal_spin_box.h"

#include <QElapsedTimer>

namespace esm {

inline constexpr double kMillimetresPerMetre = 1000.0; ///< fields show lengths in mm

/// A number field that numbers its gestures: holding an arrow button or key, or rolling the wheel, is one
/// gesture; each typed value is one of its own. Edits of one gesture become one undo step.
/// The wheel works only in the focused field, so that scrolling a panel changes nothing by accident.
class GestureSpinBox : public DecimalSpinBox {
  Q_OBJECT
public:
  explicit GestureSpinBox(QWidget* parent = nullptr);

  /// Shows a value of the document without announcing it.
  void display(double value);

  /// A number for a gesture of one's own; shared by all, so that no two gestures have the same one.
  static int newGesture();

signals:
  void edited(double value, int gesture);

protected:
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;

private:
  void beginGesture();
  int m_gesture = 0;
  bool m_showing = false;
  QElapsedTimer m_lastWheel;
};

} // namespace esm
