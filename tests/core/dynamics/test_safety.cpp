// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// No net may blow up, and what goes wrong is said.
#include "core/dynamics/planner/step_driver.h"
#include "tests/support/nets.h"
#include "tests/support/physics.h"

#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <random>

namespace esm::test {
namespace {

std::string errorOf(SpringNet net, Loads loads = {}, SolverSettings settings = {})
{
  const Result<Simulation> result = Simulation::create(std::move(net), std::move(loads), std::move(settings));
  return result ? std::string() : result.error().detail;
}

bool isFinite(const Simulation& simulation)
{
  return simulation.state().position.allFinite() && simulation.state().velocity.allFinite();
}

VectorCurve constant(const Eigen::Vector3d& value)
{
  VectorCurve curve;
  curve.time = {0.0};
  curve.value = value;
  return curve;
}

} // namespace

// Of several advances the smallest step is the smallest of all, not the last one's; none is no step.
TEST(StepReport, KeepsTheSmallestStep)
{
  StepReport sum, part;
  for (const double step : {0.002, 0.0, 0.001, 0.004}) {
    part.smallestStep = step;
    sum.add(part);
  }
  EXPECT_EQ(sum.smallestStep, 0.001);
}

TEST(Safety, CreateRefusesWhatCannotBe)
{
  const auto contains = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos ? ::testing::AssertionSuccess()
                                                : ::testing::AssertionFailure() << text;
  };
  SpringNet net = chain(3);
  EXPECT_EQ(errorOf(net), "");
  SpringNet negative = net;
  negative.stiffness[1] = -3.0;
  EXPECT_TRUE(contains(errorOf(negative), "-3"));
  Loads loads;
  loads.forces.push_back({{7}, constant({1, 0, 0})});
  EXPECT_TRUE(contains(errorOf(net, loads), "node 7"));
  loads.forces[0].nodes = {1};
  loads.forces[0].force.value(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(errorOf(net, loads), "nodal force 0"));
  loads.forces[0].force = {{1.0, 0.5}, Eigen::Matrix3Xd::Zero(3, 2)};
  EXPECT_TRUE(contains(errorOf(net, loads), "sort the times"));
  Loads twice;
  twice.motions = {{{1}, constant({0, 0, 0}), {}}, {{1}, constant({1, 0, 0}), {}}};
  EXPECT_TRUE(contains(errorOf(net, twice), "motions 0 and 1"));
  SolverSettings settings;
  settings.solver = "magic";
  EXPECT_TRUE(
    contains(errorOf(net, {}, settings), "auto, leapfrog, chebyshev, stoermer3, verlet, stoermer, rk4"));
  settings = {};
  settings.tolerance = 0.0;
  EXPECT_TRUE(contains(errorOf(net, {}, settings), "tolerance"));
}

// Random nets, from soft to a million times stiffer, some with light nodes, some with springs of zero length:
// two frames each. Never a number that is not finite, and mechanical energy does not grow beyond a tenth
// (undamped tumbling at the floor step gains a few percent).
TEST(Safety, RandomNetsStayFinite)
{
  const SpringLaw laws[] = {SpringLaw::Linear, SpringLaw::Cubic, SpringLaw::Exponential, SpringLaw::Table};
  int implicit = 0;
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    SpringNet net = randomNet(seed, 6 + static_cast<Index>(seed % 5), laws[seed % 4]);
    const double stiffer = std::pow(10.0, static_cast<double>(random() % 7));
    net.stiffness *= stiffer;
    net.viscosity *= random() % 2 ? stiffer : random() % 2 ? 1.0 : 0.0;
    if (random() % 3 == 0) net.mass[2] *= 1e-5;
    if (random() % 4 == 0) {
      net.restPosition.col(3) = net.restPosition.col(net.ends(1, 6)); // spring 6 is one of node 3's
      net.restLength[6] = std::max(net.restLength[6], 0.1);
    }
    if (random() % 4 == 0) net.tensionOnly.assign(net.tensionOnly.size(), 1);
    if (random() % 2 == 0) net.fixed[0] = 1;
    Loads loads;
    if (random() % 2 == 0) loads.gravity = {0, 0, -9.81};
    Simulation simulation = simulate(net, loads);
    const double before = simulation.energies().total();
    StepReport report;
    for (int frame = 0; frame < 2 && report.good(); ++frame)
      report.add(simulation.advance(1.0 / 60.0, {.steps = 1000}));
    implicit += simulation.solverName() == "implicit";
    ASSERT_TRUE(isFinite(simulation)) << "seed " << seed;
    ASSERT_TRUE(report.good() || report.stepLimit) << "seed " << seed << ": " << simulation.why();
    const double gained = simulation.energies().total() - before;
    EXPECT_LT(gained, 0.1 * (std::abs(before) + simulation.energies().kinetic)) << "seed " << seed;
  }
  EXPECT_GT(implicit, 0) << "the sweep must reach nets that are too stiff for explicit steps";
}

// A chain a million times stiffer than tissue: auto goes implicit, says why, and stays bounded at a few steps
// per frame.
TEST(Safety, HugeStiffnessEndsUpImplicitAndBounded)
{
  SpringNet net = sheet(6, 0.01, 200.0e6);
  net.viscosity.setConstant(0.02e6);
  net.mass.setConstant(3e-5);
  net.fixed[0] = net.fixed[5] = 1;
  Loads loads;
  loads.gravity = {0, -9.81, 0};
  Simulation simulation = simulate(net, loads);
  EXPECT_EQ(simulation.solverName(), "implicit");
  EXPECT_NE(simulation.why().find("the engine went implicit"), std::string::npos) << simulation.why();
  EXPECT_NE(simulation.why().find("node " + std::to_string(simulation.stiffestNode())), std::string::npos)
    << simulation.why();
  const StepReport report = simulation.advance(0.5);
  EXPECT_TRUE(report.good()) << simulation.why();
  EXPECT_LT(report.steps, 20000);
  EXPECT_LT((simulation.state().position - net.restPosition).colwise().norm().maxCoeff(), 0.1);
}

// The largest stable step is a promise: just below it a long run stays bounded, at twice it the run explodes.
TEST(Safety, StableStepSeparatesStableFromUnstable)
{
  SpringNet net = sheet(6, 0.01, 200.0);
  net.mass.setConstant(3e-5);
  net.viscosity.setConstant(0.01);
  net.fixed[0] = net.fixed[5] = 1;
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, 36);
  net.initialVelocity(0, 20) = 0.1;
  const double stable = simulate(net).stableStep();
  Simulation calm = simulate(net, {}, fixedSteps("verlet", 0.95 * stable));
  EXPECT_TRUE(calm.advance(0.3).good());
  EXPECT_LT((calm.state().position - net.restPosition).colwise().norm().maxCoeff(), 0.1);
  Simulation wild = simulate(net, {}, fixedSteps("verlet", 2.0 * stable));
  const StepReport report = wild.advance(0.3);
  EXPECT_TRUE(report.nonFinite || wild.energies().kinetic > 1e6);
  EXPECT_TRUE(isFinite(wild));
}

// A coarse step leaves an oscillator with some per cent more energy than it had, or less, by its phase. When
// only a part of the net goes on, with a ten-thousandth of that energy, no step of its own can take that
// back: for ever smaller ones were tried.
TEST(Safety, APartDoesNotAnswerForWhatAnotherHasGained)
{
  const auto oscillators = [](std::initializer_list<double> displacements) {
    SpringNet net;
    for (const double displacement : displacements) {
      const double x = net.nodeCount();
      addAnchor(net, addNode(net, {x + displacement, 0, 0}), {x, 0, 0}, 400.0);
    }
    net.mass.setConstant(1.0);
    return net;
  };
  SolverSettings settings;
  settings.tolerance = 0.3;
  settings.effort = 1e13;
  for (int phase = 0; phase < 16; ++phase) {
    const double angle = std::numbers::pi / 8.0 * phase, strong = std::cos(angle), weak = 1e-2 * strong;
    SpringNet both = oscillators({strong, weak}), one = oscillators({weak});
    one.restPosition(0, 0) += 1.0;
    one.anchors.point(0, 0) += 1.0;
    System whole(both, {}), part(one, {});
    MotionState motion = startOf(both), rest = startOf(one);
    motion.v[0] = Lanes{20.0 * std::sin(angle), 0, 0, 0};
    motion.v[1] = motion.v[0] * 1e-2;
    whole.enter(motion, true);
    StepDriver driver(settings);
    driver.begin(whole, motion);
    ASSERT_TRUE(driver.advance(whole, motion, 1.0 / 60.0, 0).good());
    rest.x[0] = motion.x[1];
    rest.v[0] = motion.v[1];
    rest.time = motion.time;
    part.enter(rest, true);
    driver.partChanged(part, rest, {{1}, {Lanes{1, 0, 0, 0}}, 2, 0.0});
    const StepReport report = driver.advance(part, rest, 1.0 / 60.0, 10000);
    EXPECT_TRUE(report.good()) << phase;
    EXPECT_LT(report.steps, 100) << phase;
  }
}

// With a hand-chosen step that is too large the numbers run away; the state stays finite, the report and the
// sentence say so and name a step that would do.
TEST(Safety, RunawayIsCaughtAndTheLastGoodStateKept)
{
  SpringNet net = chain(3, 1.0, 1e6);
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, 3);
  net.initialVelocity(0, 1) = 1.0;
  Simulation simulation = simulate(net, {}, fixedSteps("rk4", 0.1));
  const StepReport report = simulation.advance(100.0);
  EXPECT_TRUE(report.nonFinite);
  EXPECT_FALSE(report.good());
  EXPECT_TRUE(isFinite(simulation));
  EXPECT_NE(simulation.why().find("smaller fixed step"), std::string::npos) << simulation.why();
  EXPECT_LT(report.simulatedTime, 100.0);
}

// A force past all reason (1e300 N) and a tool at infinity's door: the engine says that it cannot, with the
// state of before.
TEST(Safety, AbsurdForceIsRefusedWithAFiniteState)
{
  for (const char* solver : {"auto", "verlet", "stoermer", "rk4", "implicit"}) {
    Loads loads;
    loads.forces.push_back({{1}, constant({1e305, 0, 0})});
    SolverSettings settings;
    settings.solver = solver;
    SpringNet net = chain(2, 1.0, 10.0);
    net.mass[1] = 1e-5;
    Simulation simulation = simulate(net, loads, settings);
    const StepReport report = simulation.advance(0.1, {.steps = 2000});
    EXPECT_FALSE(report.good()) << solver;
    EXPECT_TRUE(isFinite(simulation)) << solver;
    EXPECT_FALSE(simulation.why().empty());
  }
}

TEST(Safety, WorkLimitStopsAndGoesOnLater)
{
  SpringNet net = chain(4, 1.0, 1e4);
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, 4);
  net.initialVelocity(0, 1) = 1.0;
  Simulation simulation = simulate(net, {}, fixedSteps("verlet", 1e-3));
  const StepReport limited = simulation.advance(1.0, {.steps = 100});
  EXPECT_TRUE(limited.stepLimit);
  EXPECT_EQ(limited.steps, 100);
  EXPECT_NEAR(simulation.state().time, 0.1, 1e-12);
  EXPECT_TRUE(simulation.advance(0.1).good());
}

// A slider moved while the net swings: position, velocity and time stay, the new stiffness acts.
TEST(Safety, SetParametersKeepsTheMotion)
{
  SpringNet net = chain(3, 1.0, 10.0);
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, 3);
  net.initialVelocity(1, 1) = 1.0;
  SolverSettings settings;
  settings.solver = "verlet";
  Simulation simulation = simulate(net, {}, settings);
  advanceWell(simulation, 0.2);
  const NetState before = simulation.state();
  net.stiffness *= 100.0;
  net.law.assign(2, SpringLaw::Cubic);
  const double stable = simulation.stableStep();
  ASSERT_TRUE(simulation.setParameters(net));
  EXPECT_EQ(simulation.state().position, before.position);
  EXPECT_EQ(simulation.state().velocity, before.velocity);
  EXPECT_EQ(simulation.state().time, before.time);
  EXPECT_NEAR(simulation.stableStep(), stable / 10.0, 0.1 * stable / 10.0);
  EXPECT_FALSE(simulation.setParameters(chain(4)));
  net.stiffness[0] = -1.0;
  EXPECT_FALSE(simulation.setParameters(net));
  EXPECT_EQ(simulation.net().stiffness[0], 1000.0) << "the old parameters stay";
  advanceWell(simulation, 0.2);
}

TEST(Safety, ResetGoesBackToTheStart)
{
  SpringNet net = randomNet(5, 8);
  Simulation simulation = simulate(net);
  advanceWell(simulation, 0.1);
  const Eigen::Matrix3Xd first = simulation.state().position;
  const ToolSpring tool{2, {9, 9, 9}, {0, 0, 0}, 5.0, 0.0};
  simulation.setTools({&tool, 1});
  EXPECT_NEAR(simulation.toolForce(0).norm(), 5.0 * (tool.target - first.col(2)).norm(), 1e-12);
  advanceWell(simulation, 0.1);
  simulation.reset();
  EXPECT_EQ(simulation.state().time, 0.0);
  EXPECT_EQ(simulation.state().position, net.restPosition);
  EXPECT_EQ(simulation.externalWork(), 0.0);
  EXPECT_EQ(simulation.dissipatedEnergy(), 0.0);
  advanceWell(simulation, 0.1);
  EXPECT_EQ(simulation.state().position, first) << "the same run gives the same bits";
}

TEST(Safety, SolverNamesAreTheOnesThatCreateTakes)
{
  ASSERT_GE(solverNames().size(), 8u);
  for (const SolverInfo& info : solverNames()) {
    EXPECT_EQ(errorOf(chain(2), {}, fixedSteps(info.name, 0.0)), "");
    EXPECT_FALSE(info.description.empty());
  }
}

} // namespace esm::test
