// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Whatever changes wakes whom it touches, and no answer of a simulation depends on who sleeps.
#include "core/dynamics/rest/active_region.h"
#include "core/dynamics/rest/rest_watch.h"
#include "tests/core/dynamics/skip_nets.h"

namespace esm::test {
namespace {

/// 3 x n: x, y, z of each column.
Eigen::Matrix3Xd columns(std::initializer_list<Eigen::Vector3d> values)
{
  Eigen::Matrix3Xd result(3, static_cast<Eigen::Index>(values.size()));
  Eigen::Index column = 0;
  for (const Eigen::Vector3d& value : values) result.col(column++) = value;
  return result;
}

} // namespace

// A force that begins late finds everybody asleep and wakes its node; held constant, it lets all sleep again.
TEST(SkipEvents, LateForceWakesItsNode)
{
  for (const Index side : {12, 60}) {
    const SpringNet net = beddedSheet(side);
    Loads loads;
    loads.forces.push_back(
      {{side * side / 2 + side / 2}, curve({0.105, 0.155}, columns({{0, 0, 0}, {0.002, 0, 0.005}}))});
    Simulation skipping = simulate(net, loads, settingsOf(1e-2, true));
    Simulation full = simulate(net, loads, fixedSteps("verlet", 1e-4));
    const Frames a = play(skipping, 60), b = play(full, 60);
    EXPECT_EQ(a.report[5].springsEvaluated, 0) << "before 0.1 s";
    EXPECT_GT(a.report[7].springsEvaluated, 0);
    EXPECT_EQ(a.report.back().springsEvaluated, 0) << "1 s, the force holds";
    EXPECT_LT(errorOf(a, b), 1e-2);
    EXPECT_NEAR(balance(skipping), 0.0, 0.02 * skipping.externalWork());
  }
}

// Prescribed nodes that stand still sleep with the others, also when displaced; jumps and releases wake them,
// and the work of the support is what the net takes up.
TEST(SkipEvents, JumpAndReleaseOfPrescribedNodes)
{
  const SpringNet net = beddedSheet(60);
  Loads loads;
  const Eigen::Vector3d up(0, 0, 1e-3);
  loads.motions.push_back({{1830, 1831, 1890, 1891}, curve({0.05, 0.05}, columns({{0, 0, 0}, up})), 0.75});
  Simulation skipping = simulate(net, loads, settingsOf(1e-2, true));
  Simulation full = simulate(net, loads, fixedSteps("verlet", 1e-4));
  const Frames a = play(skipping, 70), b = play(full, 70);
  EXPECT_LT(errorOf(a, b), 1e-2);
  EXPECT_EQ(a.report[1].springsEvaluated, 0);
  EXPECT_EQ(a.report[40].springsEvaluated, 0) << "held up, settled";
  EXPECT_EQ(a.position[41].col(1830), Eigen::Vector3d(net.restPosition.col(1830) + up));
  EXPECT_GT(a.report[46].springsEvaluated, 0) << "released";
  EXPECT_NEAR(skipping.externalWork(), full.externalWork(), 1e-2 * full.externalWork());
}

// A tool that glides over tissue leaves a trail that falls asleep behind it and wakes what lies ahead.
TEST(SkipEvents, GlidingToolIsFollowed)
{
  const SpringNet net = beddedSheet(80);
  Simulation skipping = simulate(net, {}, settingsOf(3e-2, true, "verlet"));
  Simulation full = simulate(net, {}, fixedSteps("verlet", 1e-4));
  Frames frames[2];
  std::int64_t most = 0;
  for (int run = 0; run < 2; ++run) {
    Simulation& simulation = run == 0 ? skipping : full;
    for (int frame = 0; frame < 50; ++frame) {
      const Index node = 80 * 40 + 15 + frame / 2;
      const ToolSpring tool = pull(net, node, {0, 1e-4, 4e-4}, 100.0);
      const Frames one = play(simulation, 1, {&tool, 1});
      frames[run].position.push_back(one.position[0]);
      frames[run].report.push_back(one.report[0]);
      if (run == 0) most = std::max(most, one.report[0].nodesAwake);
    }
  }
  EXPECT_LT(errorOf(frames[0], frames[1]), 3e-2);
  EXPECT_LT(most, 0.6 * net.nodeCount());
  EXPECT_EQ(frames[0].position[20].col(79), net.restPosition.col(79));
}

// Only those whose parameters change wake. Softening half of a stretched chain moves it; the same parameters
// again move nobody.
TEST(SkipEvents, NewParametersWakeWhomTheyTouch)
{
  SpringNet net = chain(2600, 1e-3, 100.0);
  net.mass.setConstant(1e-4);
  net.massDamping = Eigen::ArrayXd::Constant(net.nodeCount(), 200.0);
  net.restLength *= 0.9;
  net.fixed.front() = net.fixed.back() = 1;
  Simulation skipping = simulate(net, {}, settingsOf(1e-2, true));
  EXPECT_EQ(skipping.advance(0.1).springsEvaluated, 0) << "stretched, but in balance";
  ASSERT_TRUE(skipping.setParameters(net));
  EXPECT_EQ(skipping.advance(0.1).springsEvaluated, 0);
  SpringNet softer = net;
  softer.stiffness[1300] = 50.0;
  ASSERT_TRUE(skipping.setParameters(softer));
  Simulation full = simulate(net, {}, fixedSteps("verlet", 1e-4));
  ASSERT_TRUE(full.setParameters(softer));
  const Frames a = play(skipping, 12), b = play(full, 12);
  EXPECT_LT(errorOf(a, b), 1e-2);
  EXPECT_GT(a.report.back().nodesAwake, 0);
  EXPECT_LT(a.report.back().nodesAwake, net.nodeCount() / 2);
}

// What a sleeping net says about itself is what a net that never sleeps says.
TEST(SkipEvents, AnswersDoNotDependOnSleep)
{
  SpringNet net = beddedSheet(50);
  net.fixed[0] = 1;
  SolverSettings with = settingsOf(1e-3, true), without = settingsOf(1e-3, false);
  with.solver = without.solver = "verlet"; // the stable step is that of the method
  Simulation skipping = simulate(net, {}, with);
  Simulation full = simulate(net, {}, without);
  const ToolSpring tool = pull(net, 50 * 25 + 25, {5e-4, 0, 5e-4}, 20.0);
  play(skipping, 40, {&tool, 1});
  play(full, 40, {&tool, 1});
  EXPECT_EQ(skipping.advance(0.01).nodesAwake, 0);
  const StepReport report = full.advance(0.01);
  EXPECT_EQ(report.nodesAwake, net.nodeCount());
  Eigen::ArrayXd tension(net.springCount());
  skipping.springTensions(tension);
  EXPECT_DOUBLE_EQ(skipping.advance(0.01).largestForce, tension.abs().maxCoeff());
  EXPECT_NEAR(report.largestForce, tension.abs().maxCoeff(), 1e-2 * report.largestForce);
  EXPECT_NEAR(skipping.energies().elastic, full.energies().elastic, 1e-2 * full.energies().elastic);
  EXPECT_NEAR((skipping.toolForce(0) - full.toolForce(0)).norm(), 0.0, 1e-2 * full.toolForce(0).norm());
  EXPECT_NEAR((skipping.reaction(0) - full.reaction(0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(skipping.stableStep(), full.stableStep(), 0.02 * full.stableStep());
  EXPECT_NEAR(skipping.externalWork(), full.externalWork(), 1e-2 * full.externalWork());

  skipping.reset();
  EXPECT_EQ(skipping.state().position, net.restPosition);
  EXPECT_EQ(skipping.externalWork(), 0.0);
  EXPECT_EQ(skipping.dissipatedEnergy(), 0.0);
  EXPECT_EQ(skipping.advance(0.1).springsEvaluated, 0);
}

// While nodes sleep, the sentence about the stiffest node speaks of the net's own numbers.
TEST(SkipEvents, WhyNamesNodesOfTheWholeNet)
{
  SpringNet net = beddedSheet(60);
  net.mass[60 * 30 + 31] = 1e-6;
  Simulation simulation = simulate(net, {}, settingsOf(1e-2, true));
  const ToolSpring tool = pull(net, 60 * 30 + 30, {5e-4, 0, 5e-4}, 20.0);
  const Frames frames = play(simulation, 3, {&tool, 1});
  EXPECT_LT(frames.report.back().nodesAwake, net.nodeCount());
  EXPECT_NE(simulation.why().find("node 1831"), std::string::npos) << simulation.why();
  EXPECT_EQ(simulation.stiffestNode(), 1831);
}

// An undamped oscillation in step with the frames stands still at every look; it must not be taken for rest.
TEST(SkipEvents, OscillationInStepWithTheFramesStaysAwake)
{
  SpringNet net = chain(2, 1.0, 1.0);
  net.fixed[0] = 1;
  net.stiffness[0] = std::pow(2 * std::numbers::pi * 60.0, 2);
  net.restLength[0] = 0.9; // starts at the turning point
  Simulation simulation = simulate(net, {}, settingsOf(1e-2, true, "rk4"));
  const Frames frames = play(simulation, 100);
  EXPECT_GT(frames.report.back().springsEvaluated, 0);
}

// The work limit of one call is that of all stretches and repeats together.
TEST(SkipEvents, WorkLimitHolds)
{
  const SpringNet net = beddedSheet(60);
  Simulation simulation = simulate(net, {}, settingsOf(1e-3, true));
  const ToolSpring tool = pull(net, 60 * 30 + 30, {5e-4, 0, 5e-4}, 200.0);
  simulation.setTools({&tool, 1});
  const StepReport report = simulation.advance(0.1, {.steps = 50});
  EXPECT_TRUE(report.stepLimit);
  EXPECT_LE(report.steps, 50);
  EXPECT_NE(simulation.why().find("50"), std::string::npos) << simulation.why();
  EXPECT_TRUE(simulation.state().position.allFinite());
  EXPECT_TRUE(simulation.advance(0.05).good());
}

// Layers are counted in springs; fixed nodes stop them.
TEST(ActiveRegion, WakesByLayersAndKnowsItsDepth)
{
  SpringNet net = chain(20);
  net.fixed[14] = 1;
  ActiveRegion region(net);
  const Index seed = 10;
  EXPECT_EQ(region.wake({&seed, 1}, 2).size(), 5u);
  std::vector<std::uint8_t> fresh(20, 0);
  fresh[7] = 1;
  region.update(fresh);
  EXPECT_EQ(region.awake(), (std::vector<Index>{8, 9, 10, 11, 12}));
  EXPECT_EQ(region.rim(), (std::vector<Index>{7, 13}));
  EXPECT_EQ(region.radius(), 3);
  ASSERT_EQ(region.layers().size(), 5u);
  EXPECT_TRUE(region.layers()[0].nearFresh); // node 8
  EXPECT_FALSE(region.layers()[1].nearFresh);
  EXPECT_EQ(region.wake({&seed, 1}, 9).size(), 9 - 2 + 1u); // to node 1 on the left, to the fixed node
  region.update(std::vector<std::uint8_t>(20, 0));
  EXPECT_EQ(region.rim(), (std::vector<Index>{0, 14}));
  EXPECT_EQ(region.layers().back().node, 13); // a fixed node misses nothing: depth counts from node 0 only
  std::vector<std::uint8_t> calm(20, 1);
  calm[6] = 0;
  EXPECT_EQ(region.inside(calm, 3), (std::vector<Index>{1, 2, 10, 11, 12, 13}));
  EXPECT_EQ(region.inside(calm, 3, 6).size(), 6u);
  EXPECT_TRUE(region.inside(calm, 3, 7).empty()) << "fewer are not worth it";
  region.sleep(std::vector<Index>{12, 13});
  EXPECT_FALSE(region.isAwake(12));
  EXPECT_TRUE(region.isAwake(11));
}

// A slow sway has no speed at its turning point, a slow creep no acceleration: neither is calm.
TEST(RestWatch, SwayAndCreepAreNotRest)
{
  constexpr double kFrame = 1.0 / 60.0, kLimit = 1e-3;
  const std::vector<Index> nodes{0, 1, 2};
  RestWatch watch;
  watch.prepare(3);
  MotionState motion;
  motion.x.assign(3, Lanes{0, 0, 0, 0});
  motion.v = motion.x;
  watch.watch(nodes, motion);
  for (int frame = -12; frame <= 4; ++frame) {
    const double omega = 1.2, t = frame * kFrame; // [1/s]
    motion.time = (frame + 13) * kFrame;
    motion.x[0] = Lanes{0.1 * std::cos(omega * t), 0, 0, 0};
    motion.v[0] = Lanes{-0.1 * omega * std::sin(omega * t), 0, 0, 0}; // slow around the turning point
    motion.x[1] = Lanes{1e-3 * t, 0, 0, 0}; // a hundredth of the limit per frame, for ever
    motion.v[1] = Lanes{1e-3, 0, 0, 0};
    motion.x[2] = Lanes{0, 0, 1e-4, 0}; // at rest
    watch.look(nodes, motion, kLimit);
  }
  EXPECT_EQ(watch.calm(), (std::vector<std::uint8_t>{0, 0, 1}));
  EXPECT_EQ(watch.slow(), (std::vector<std::uint8_t>{1, 1, 1})); // with awake neighbours that is enough
}

// What stands still at every frame but is found moving between two is not at rest.
TEST(RestWatch, GlancesSeeWhatLooksMiss)
{
  const std::vector<Index> nodes{0, 1};
  RestWatch watch;
  watch.prepare(2);
  MotionState motion;
  motion.x.assign(2, Lanes{0, 0, 0, 0});
  motion.v = motion.x;
  watch.watch(nodes, motion);
  for (int frame = 1; frame <= 20; ++frame) {
    motion.v[0] = Lanes{1.0, 0, 0, 0};
    watch.glance(nodes, motion, 1e-3);
    motion.v[0] = Lanes{0, 0, 0, 0};
    motion.time = frame / 60.0;
    watch.look(nodes, motion, 1e-3);
  }
  EXPECT_EQ(watch.slow(), (std::vector<std::uint8_t>{0, 1}));
  EXPECT_EQ(watch.calm(), (std::vector<std::uint8_t>{0, 1}));
}

} // namespace esm::test
