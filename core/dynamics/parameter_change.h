// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/energy_report.h"
#include "core/net/parameter_patch.h"

#include <cstdint>
#include <vector>

namespace esm {

/// What other parameters mean for a net in motion.
struct ParameterChange {
  bool everything = false;   ///< all nodes are touched; `nodes` is empty then
  bool otherFixed = false;   ///< other nodes are fixed
  bool otherAnchors = false; ///< other nodes have anchors
  /// Rising: those with another mass or damping, or with a spring or anchor that has other numbers.
  std::vector<Index> nodes;
  std::vector<Index> springs;   ///< rising: those of a patch, whose numbers were others
  Energies energies;            ///< that it adds to the net [J]
  std::int64_t springsSeen = 0; ///< that were looked at for all of this: the work

  bool isNone() const noexcept { return !everything && nodes.empty(); }
};

/// By looking at all nodes and springs. @pre the same topology.
ParameterChange changeBetween(const SpringNet& before, const SpringNet& now);
/// By looking at what the patch names, before it is applied. @pre checkPatch()
ParameterChange changeBy(const ParameterPatch& patch, const SpringNet& net);

} // namespace esm
