// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The same bits: again, after reset(), with another number of threads, and in a second simulation that was
// begun in the middle of the first one's run.
#include "bench/scenes.h"
#include "core/base/hash.h"
#include "tests/support/physics.h"

namespace esm::test {
namespace {

/// The local and quasi-static ones take long for their steps; that far the bits are as good as further on.
constexpr std::int64_t kMostSteps = 200;

std::uint64_t hashOf(const Simulation& simulation, std::uint64_t seed)
{
  const NetState& state = simulation.state();
  const auto bytes = [](const Eigen::Matrix3Xd& m) {
    return sizeof(double) * static_cast<std::size_t>(m.size());
  };
  seed = hashBytes(state.position.data(), bytes(state.position), seed);
  seed = hashBytes(state.velocity.data(), bytes(state.velocity), seed);
  const double sums[] = {simulation.externalWork(), simulation.dissipatedEnergy(),
                         simulation.energies().total()};
  return hashBytes(sums, sizeof(sums), seed);
}

/// Of all frames: a hand comes, moves and goes, a slider moves in mid motion.
std::uint64_t play(Simulation& simulation, const SpringNet& net)
{
  std::uint64_t hash = 1;
  for (int frame = 0; frame < 4; ++frame) {
    ToolSpring tool{net.nodeCount() / 2, net.restPosition.col(net.nodeCount() / 2), {0, 0, 0}, 5.0, 0.01};
    tool.target.z() += 0.001 * frame;
    if (frame == 1 || frame == 2) simulation.setTools({&tool, 1});
    if (frame == 3) simulation.setTools({});
    simulation.advance(1.0 / 60.0, {.steps = kMostSteps});
    hash = hashOf(simulation, hash);
  }
  return hash;
}

std::vector<std::string> allSolvers()
{
  std::vector<std::string> names = {"auto"};
  for (const SolverInfo& info : solverNames()) names.push_back(info.name);
  return names;
}

} // namespace

class SameBits : public ::testing::TestWithParam<std::string> {};

TEST_P(SameBits, AgainResetThreadsAndInTheMiddle)
{
  const bool isCheap = GetParam() == "auto" || GetParam() == "leapfrog";
  for (const bench::Scene& scene :
       {bench::tube({0, 0.25, 0.0}), bench::uterus({0, isCheap ? 1.0 : 0.1, 0.0}), bench::smallSheet()}) {
    const std::string& name = scene.name;
    SolverSettings settings;
    settings.solver = GetParam();
    settings.tolerance = 1e-2;
    Simulation first = simulate(scene.net, scene.loads, settings);
    const std::uint64_t wanted = play(first, scene.net);
    settings.threads = 2;
    Simulation second = simulate(scene.net, scene.loads, settings);
    first.reset();
    first.setTools({});
    // Two in turns, one of them from a reset: nothing is shared between them.
    EXPECT_EQ(play(first, scene.net), wanted) << name << ": after reset()";
    EXPECT_EQ(play(second, scene.net), wanted) << name << ": with two threads";
    Simulation third = simulate(scene.net, scene.loads, settings),
               fourth = simulate(scene.net, scene.loads, settings);
    for (int frame = 0; frame < 3; ++frame) {
      third.advance(1.0 / 60.0, {.steps = kMostSteps});
      fourth.advance(1.0 / 60.0, {.steps = kMostSteps});
      ASSERT_EQ(hashOf(third, 1), hashOf(fourth, 1)) << name << ": in turns, frame " << frame;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Solvers, SameBits, ::testing::ValuesIn(allSolvers()));

} // namespace esm::test
