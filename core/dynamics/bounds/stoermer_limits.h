// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/bounds/step_bound.h"

#include <limits>

namespace esm {

/// The largest steps [s] of Stoermer's method such that this one and all smaller ones are stable, for a net
/// within the bounds. For one mode, h w and h g tell: the roots of the recurrence were found for both, and
/// the regions in which none is larger than 1 are what the constants describe.
struct StoermerLimits {
  static constexpr std::size_t kDepth = 4;    ///< forces that a step reads
  static constexpr double kCarry = 2.0 / 3.0; ///< of what was foretold wrongly, without a correction

  StoermerLimits() = default;
  explicit StoermerLimits(const FastestMode& mode) noexcept;

  double alone = std::numeric_limits<double>::infinity();     ///< with foretold velocities
  double corrected = std::numeric_limits<double>::infinity(); ///< with corrected ones
};

} // namespace esm
