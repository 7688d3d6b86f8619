// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/node_array.h"

#include <array>

namespace esm {

/// Guesses of a velocity from velocities and accelerations at two earlier instants, of rising order: the last
/// velocity; along its acceleration; with the change of acceleration; the cubic through all four. Which one
/// is nearest depends on how lively the net is in a step; the one that was nearest last time is taken.
class StageGuess {
public:
  /// Weights of v0, a0, v1, a1 at `ahead` after the second instant, which is `gap` after the first [s]. In
  /// the first step after a blow only the velocity is to be trusted.
  void set(double gap, double ahead, bool isFirst) noexcept
  {
    const double u = gap > 0.0 ? ahead / gap : 0.0, p = 1.0 + u; // place on the cubic, 1 = second instant
    m_weights[0] = {0, 0, 1, 0};
    m_weights[1] = {0, 0, 1, ahead};
    m_weights[2] = {0, -0.5 * u * ahead, 1, ahead + 0.5 * u * ahead};
    m_weights[3] = {(2 * p - 3) * p * p + 1, gap * p * u * u, (3 - 2 * p) * p * p, gap * p * p * u};
    m_known = isFirst ? 1 : kGuesses;
    if (isFirst) m_best = 0;
  }

  void make(const NodeArray& v0, const NodeArray& a0, const NodeArray& v1, const NodeArray& a1,
            NodeArray& v) const noexcept;

  /// After the stage is solved. The arrays are those of make().
  void judge(const NodeArray& v0, const NodeArray& a0, const NodeArray& v1, const NodeArray& a1,
             const NodeArray& v) noexcept;

private:
  static constexpr std::size_t kGuesses = 4;

  std::array<std::array<double, 4>, kGuesses> m_weights{};
  std::size_t m_known = 2, m_best = 1;
};

} // namespace esm
