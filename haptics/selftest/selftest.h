// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace esm {

/// One promise of the haptic loop with the figure that was measured for it.
struct SelftestRow {
  std::string id;   ///< "A4", as in docs/HAPTIC_SAFETY.md
  std::string what; ///< in words (English)
  double figure = 0.0, least = 0.0, most = 0.0;
  std::string unit;
  bool good() const noexcept { return figure >= least && figure <= most; } ///< NaN is not
};

/// Plays devices, hands and tissues on a virtual clock, about a second of processor time each: nothing
/// depends on how fast this computer is, equal builds give equal figures, no device is needed. What measures
/// the computer itself is the jitter of `esm haptics run`.
std::vector<SelftestRow> selftestKinematics(); ///< A1 - A3
std::vector<SelftestRow> selftestWalls();      ///< A4, A5
std::vector<SelftestRow> selftestEnergy();     ///< A6
std::vector<SelftestRow> selftestTissue();     ///< A7, A8
std::vector<SelftestRow> selftestLimits();     ///< A9

std::vector<SelftestRow> runSelftest(); ///< all of them, in this order

} // namespace esm
