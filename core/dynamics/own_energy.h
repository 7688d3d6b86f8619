// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/system.h"

#include <algorithm>

namespace esm {

/// Of the nodes that nobody holds or moves [J]: what supports carry is theirs.
inline double freeKinetic(const System& system, const NodeArray& v) noexcept
{
  double energy = 0.0;
  for (std::size_t i = 0; i < v.size(); ++i)
    if (system.isFree(i)) energy += 0.5 * system.mass()[i] * dot(v[i], v[i]);
  return energy;
}

/// That a net has by itself and could lose [J].
inline double ownEnergy(const System& system, const MotionState& state) noexcept
{
  return freeKinetic(system, state.v) + std::max(system.elasticEnergy(state.x), 0.0);
}

} // namespace esm
