// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The smallest net: two masses and the spring between them, let go from 10 % of stretch.
#include "core/dynamics/simulation.h"
#include "core/net/net_builder.h"

#include <cmath>
#include <iostream>

int main()
{
  esm::SpringNet net;
  esm::resizeNet(net, 2, 1); // two free nodes of 1 kg, one linear spring
  net.restPosition.col(1) << 1.1, 0, 0;
  net.ends.col(0) << 0, 1;
  net.restLength[0] = 1.0;  // [m]
  net.stiffness[0] = 200.0; // [N/m]

  auto simulation = esm::Simulation::create(net, {}, {});
  if (!simulation) {
    std::cerr << simulation.error().detail << '\n';
    return 1;
  }
  // Both masses against each other: omega = sqrt(k (1/m + 1/m)) = 20 rad/s.
  for (int frame = 0; frame <= 10; ++frame) {
    const auto& state = simulation->state();
    const double length = (state.position.col(1) - state.position.col(0)).norm();
    const double exact = 1.0 + 0.1 * std::cos(20.0 * state.time);
    std::cout << "t " << state.time << " s   length " << length << " m   closed form " << exact << " m\n";
    if (std::abs(length - exact) > 1e-3) return 1;
    simulation->advance(0.05);
  }
}
