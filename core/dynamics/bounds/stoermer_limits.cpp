// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/bounds/stoermer_limits.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

/// Of one mode without a correction: h g + bend h^2 w^2 <= reach is within one per cent of the region's edge.
constexpr double kReach = 0.415, kBend = 0.21;

/// Of one mode with a correction: fast ones must be damped either little or well.
bool isStableCorrected(double swing, double leastDamping, double damping) noexcept
{
  constexpr double kFastest = 1.4; // hardly damped
  constexpr double kGap = 0.95;    // where the gap between little and well begins
  if (swing > kFastest || damping > 2.56 - 0.24 * swing) return false;
  return swing <= kGap || damping <= 1.5 * (kFastest - swing) || leastDamping >= 1.12 + 1.6 * (swing - 1.0);
}

} // namespace

StoermerLimits::StoermerLimits(const FastestMode& mode) noexcept
{
  constexpr int kSamples = 16;    ///< of the frequencies
  constexpr double kFiner = 1.01; ///< from a step to the next
  if (!(mode.stiffness > 0.0) && !(mode.damping > 0.0)) return;
  // The positive root, in the form that bears no stiffness.
  alone = 2.0 * kReach /
          (mode.damping + std::sqrt(mode.damping * mode.damping + 4.0 * kReach * kBend * mode.stiffness));
  const auto isStable = [&](double h) {
    for (int i = 1; i <= kSamples; ++i) {
      const double w = std::sqrt(mode.stiffness) * i / kSamples;
      const double owed = mode.leastDamping * std::max(w * w - mode.undamped, 0.0);
      if (!isStableCorrected(h * w, h * std::min(owed, mode.damping), h * mode.damping)) return false;
    }
    return true;
  };
  corrected = 0.9 * alone; // at most six times shorter than what it comes to
  while (isStable(kFiner * corrected)) corrected *= kFiner;
}

} // namespace esm
