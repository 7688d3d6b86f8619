// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/loads.h"

#include <vector>

namespace esm {

/// Which nodes the loads keep in motion: those under a force or a prescribed position that changes between
/// now and the next event, and those for which something changes at that event. A load that holds its value
/// keeps nobody awake.
class LoadWatch {
public:
  /// Looks at the time from t on. @param nextEvent  infinity if there is none.
  void enter(const Loads& loads, double t, double nextEvent);

  const std::vector<Index>& moving() const noexcept { return m_moving; }
  const std::vector<Index>& atEvent() const noexcept { return m_atEvent; }

private:
  std::vector<Index> m_moving, m_atEvent;
};

} // namespace esm
