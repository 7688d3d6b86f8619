// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/types.h"

#include <Eigen/Core>

#include <cmath>
#include <random>

namespace esm::test {

/// Draws from raw bits only, so that every standard library draws the same.
class Dice {
public:
  explicit Dice(std::uint32_t seed) : m_random(seed) {}
  double uniform(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(m_random()) / 4294967296.0);
  }
  double decades(double low, double high) { return std::pow(10.0, uniform(low, high)); }
  Index below(Index count) { return static_cast<Index>(m_random() % static_cast<std::uint32_t>(count)); }
  bool oneIn(Index count) { return below(count) == 0; }
  Eigen::Vector3d vector(double size)
  {
    const double x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
    return {x, y, z};
  }

private:
  std::mt19937 m_random;
};

} // namespace esm::test
