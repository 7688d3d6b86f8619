// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/loads.h"
#include "core/net/spring_net.h"

#include <cstdint>

namespace esm::test {

/// A net and loads that a file may hold and no tissue is like.
struct ExtremeCase {
  SpringNet net;
  Loads loads;
};

/// The case of this seed; equal seeds give equal cases. Drawn are the shape (two nodes, star, chain, cloud,
/// tube, sheet or single nodes, in one to three separate parts), stiffness 1e-6 to 1e12 N/m and viscosity
/// 1e-9 to 1e6 N s/m for all or spring by spring, masses of 1e-12 to 1e6 kg for all or node by node, all
/// laws, lengths that do not fit, lengths and distances of zero; some are held or anchored, most fly; speeds
/// up to 1e6 m/s, weight, wind on all nodes, forces up to 1e9 N with corners and jumps, and nodes that are
/// moved, in no time too, and let go.
ExtremeCase extremeCase(std::uint32_t seed);

/// Another kind: one to three bodies that are rows, rings, lattices (flat ones, too) or clusters of nodes 1e-14
/// to 1e-2 of the size apart, each with masses and stiffness spread over up to six decades about its own, some
/// joined by a spring or two of 1e-6 to 1e12 N/m, some up to 1e5 of their size from the origin; they fly, spin
/// and tremble, and are pulled by forces that all but cancel out.
ExtremeCase unevenCase(std::uint32_t seed);

} // namespace esm::test
