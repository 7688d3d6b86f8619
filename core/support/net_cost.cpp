// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/support/net_cost.h"

#include "core/dynamics/simulation.h"

#include <cmath>

namespace esm {

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
