// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>

namespace esm {

/// Number of a new gesture (FuzzyDocument). Gestures are numbered through the whole program: two panels must
/// never share one. GUI thread.
int nextGesture();

/// Key presses soon after each other are one gesture; a longer pause begins a new one.
class KeyRun {
public:
  bool goesOn() const; ///< the next press belongs to the present run
  int press();         ///< notes a press. @return the number of its run
  void end() { m_sinceLast.invalidate(); }

private:
  QElapsedTimer m_sinceLast;
  int m_gesture = 0;
};

} // namespace esm
