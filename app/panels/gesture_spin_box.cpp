// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/gesture_spin_box.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>

namespace esm {

GestureSpinBox::GestureSpinBox(QWidget* parent) : DecimalSpinBox(parent)
{
  setKeyboardTracking(false);
  setFocusPolicy(Qt::StrongFocus);
  connect(this, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    if (!m_showing) emit edited(value, m_gesture);
  });
}

void GestureSpinBox::display(double value)
{
  // Qt draws the field, and with it the whole window, even for the number that it shows already.
  const bool isShown = std::abs(value - this->value()) < 0.5 * std::pow(10.0, -decimals());
  if (isShown && cleanText() == textFromValue(this->value())) return;
  m_showing = true;
  setValue(value);
  m_showing = false;
}

void GestureSpinBox::mousePressEvent(QMouseEvent* event)
{
  beginGesture();
  DecimalSpinBox::mousePressEvent(event);
}

void GestureSpinBox::keyPressEvent(QKeyEvent* event)
{
  if (!event->isAutoRepeat()) beginGesture();
  DecimalSpinBox::keyPressEvent(event);
}

void GestureSpinBox::wheelEvent(QWheelEvent* event)
{
  if (!hasFocus()) {
    event->ignore();
    return;
  }
  constexpr qint64 kPause = 700; // [ms] without rolling ends the gesture
  if (!m_lastWheel.isValid() || m_lastWheel.elapsed() > kPause) beginGesture();
  m_lastWheel.start();
  DecimalSpinBox::wheelEvent(event);
}

void GestureSpinBox::focusInEvent(QFocusEvent* event)
{
  beginGesture();
  DecimalSpinBox::focusInEvent(event);
}

void GestureSpinBox::beginGesture()
{
  m_gesture = newGesture();
}

int GestureSpinBox::newGesture()
{
  static int last = 0;
  return ++last;
}

} // namespace esm
