// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/gesture.h"

namespace esm {

namespace {

constexpr qint64 kPause = 700; ///< [ms]

} // namespace

int nextGesture()
{
  static int last = 0;
  return ++last;
}

bool KeyRun::goesOn() const
{
  return m_sinceLast.isValid() && m_sinceLast.elapsed() <= kPause;
}

int KeyRun::press()
{
  if (!goesOn()) m_gesture = nextGesture();
  m_sinceLast.start();
  return m_gesture;
}

} // namespace esm
