// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

#include <algorithm>
#include <cstdint>

namespace esm {

/// The two ends of an edge as one number: the same whichever way it runs, another for every other pair.
/// @pre neither is negative
inline std::uint64_t pairKey(Index a, Index b) noexcept
{
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint64_t>(std::max(a, b));
}

} // namespace esm
