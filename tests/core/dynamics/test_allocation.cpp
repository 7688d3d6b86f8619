// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

#include "tests/support/allocation_counter.h"
#include "tests/support/methods.h"
#include "tests/support/nets.h"
#include "tests/support/physics.h"

namespace esm::test {

// After the first frame (buffers and the step bound are made then) explicit frames do not allocate, checks of
// the accuracy included.
TEST(Allocation, ExplicitFramesDoNotAllocate)
{
  for (const std::string& solver : explicitMethods()) {
    SpringNet net = randomNet(3, 20, SpringLaw::Exponential);
    net.fixed[0] = 1;
    Loads loads;
    loads.gravity = {0, 0, -9.81};
    SolverSettings settings;
    settings.solver = solver;
    Simulation simulation = simulate(net, loads, settings);
    const ToolSpring tool{4, {1, 1, 1}, {0, 0, 0}, 20.0, 0.1};
    simulation.setTools({&tool, 1});
    simulation.advance(1.0 / 60.0);
    const std::uint64_t before = allocationsOfThisThread();
    for (int frame = 0; frame < 30; ++frame) {
      simulation.setTools({&tool, 1});
      simulation.advance(1.0 / 60.0);
    }
    EXPECT_EQ(allocationsOfThisThread() - before, 0u) << solver;
  }
}

} // namespace esm::test
