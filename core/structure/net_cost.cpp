// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/structure/net_cost.h"

#include "core/dynamics/simulation.h"

#include <cmath>

namespace esm {

MemoryCost predictMemory(const SpringNet& net) noexcept
{
  // What the programs take without a net, and for each part of one; see the test that runs them.
  constexpr double kProgram = 10e6, kWindow = 150e6;
  constexpr double kNode = 950.0, kSpring = 465.0;
  constexpr double kShownNode = 500.0, kShownSpring = 220.0, kShownTriangle = 60.0;
  const double nodes = net.nodeCount(), springs = net.springCount(), triangles = net.triangleCount();
  const double engine = kNode * nodes + kSpring * springs;
  const double shown = kShownNode * nodes + kShownSpring * springs + kShownTriangle * triangles;
  return {static_cast<std::uint64_t>(kProgram + engine),
          static_cast<std::uint64_t>(kWindow + engine + shown)};
}

NetCost predictCost(const SpringNet& net)
{
  NetCost cost{net.nodeCount(), net.springCount()};
  if (net.springCount() == 0) return cost;
  cost.shortest = net.restLength.minCoeff();
  if (!(net.stiffness.maxCoeff() > 0.0)) return cost;
  const auto simulation = Simulation::create(net, {}, {});
  if (!simulation) return cost;
  const double step = simulation->stableStep();
  if (!(std::isfinite(step) && step > 0.0)) return cost;
  cost.step = step;
  cost.work = static_cast<double>(net.springCount()) / step;
  return cost;
}

} // namespace esm
