// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/loads.h"
#include "core/net/spring_net.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace esm::test {

/// A net that no modeller would want, with a story of what happens to it. Plain data.
struct StressCase {
  SpringNet net;
  Loads loads;
  int frames = 4; ///< of 1/60 s
  /// Before frame `frame`: other tools, other parameters, or both.
  struct Change {
    int frame = 0;
    std::optional<std::vector<ToolSpring>> tools;
    std::optional<SpringNet> net;
  };
  std::vector<Change> changes;
};

/// The case of this seed; equal seeds give equal cases. Drawn are
///
///     shape        heap, chain, star, tube or block of 5 to 60 nodes, 1 mm to 1 m apart, perhaps in two
///     pieces stiffness    1 to 1000 N/m, x 1 to 1e9, for the whole net or spring by spring mass         1e-9
///     to 1e3 kg, one for all or node by node viscosity    none, in proportion to the stiffness, or huge (up
///     to 1e6 N s/m); mass damping up to 1e4/s springs      of all laws, tension-only, of rest length zero,
///     of length zero, without stiffness, pre-stretched held         fixed nodes, anchors loads gravity,
///     forces up to 1e6 N with corners and jumps, prescribed motions with jumps and releases changes tools
///     that come, move and go; springs cut under load (stiffness and viscosity 0); sudden
///                  other stiffness, viscosity, mass, laws
StressCase stressCase(std::uint32_t seed);

} // namespace esm::test
