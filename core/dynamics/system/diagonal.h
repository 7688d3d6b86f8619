// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/node_array.h"

#include <algorithm>

namespace esm {

/// Of the box around the nodes, its diagonal's square [m^2]; 0 without nodes.
inline double squareOfDiagonal(const NodeArray& x) noexcept
{
  if (x.empty()) return 0.0;
  Lanes low = x[0], high = x[0];
  for (const Lanes& position : x)
    for (int lane = 0; lane < 3; ++lane) {
      low[lane] = std::min(low[lane], position[lane]);
      high[lane] = std::max(high[lane], position[lane]);
    }
  return dot(high - low, high - low);
}

} // namespace esm
