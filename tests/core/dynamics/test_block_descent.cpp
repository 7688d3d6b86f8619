// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The step that keeps time under a hand: its matrix, its laws, and that `auto` takes it when the clock asks.
#include "core/base/text_number.h"
#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/methods/step_gradients.h"
#include "core/dynamics/system/implicit_matrix.h"
#include "tests/core/dynamics/skip_nets.h"
#include "tests/support/stress_run.h"

#include <algorithm>
#include <cmath>

namespace esm::test {
namespace {

constexpr double kFrameTime = 1.0 / 60.0;

/// Springs of a law, some slack, some pressed, some without dampers, all in motion.
SpringNet livelyNet(SpringLaw law)
{
  SpringNet net = randomNet(7, 60, law);
  net.initialVelocity = Eigen::Matrix3Xd::Random(3, net.nodeCount());
  for (Index s = 0; s < net.springCount(); ++s) {
    if (s % 3 == 0) net.tensionOnly[static_cast<std::size_t>(s)] = 1;
    if (s % 4 == 0) net.viscosity[s] = 0.0;
  }
  net.fixed[0] = net.fixed[5] = 1;
  for (Index i = 10; i < 20; ++i) addAnchor(net, i, net.restPosition.col(i), 3.0, 0.2);
  return net;
}

NodeArray scatteredOver(std::size_t count)
{
  NodeArray values(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i);
    values[i] = Lanes{std::sin(1.0 + 2.0 * t), std::cos(3.0 * t), std::sin(0.7 * t), 0.0};
  }
  return values;
}

double distance(const NodeArray& a, const NodeArray& b)
{
  double square = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) square += dot(a[i] - b[i], a[i] - b[i]);
  return std::sqrt(square);
}

/// A bedded sheet of 900 nodes, so stiff that plain steps cost some times the effort, its rim fixed.
SpringNet stiffSheet()
{
  SpringNet net = sheet(30, 2e-3, 4e3);
  net.mass.setConstant(1e-5);
  net.viscosity.setConstant(0.05);
  const Eigen::Matrix3Xd points = net.restPosition;
  for (Index i = 0; i < net.nodeCount(); ++i) {
    const Index row = i / 30, column = i % 30;
    net.fixed[static_cast<std::size_t>(i)] = row == 0 || row == 29 || column == 0 || column == 29;
    addAnchor(net, i, points.col(i), 0.5, 0.005);
  }
  return net;
}

ToolSpring handAt(const SpringNet& net, double height)
{
  ToolSpring hand;
  hand.node = 15 * 30 + 15;
  hand.target = net.restPosition.col(hand.node) + Eigen::Vector3d(0, 0, height);
  hand.stiffness = 2e3;
  return hand;
}

SolverSettings onTheClock()
{
  SolverSettings settings;
  settings.tolerance = 1e-2;
  settings.effort = 2e5;
  settings.workLimit = 0.0;
  settings.keepsTime = true;
  return settings;
}

} // namespace

// The rows that a pass over springs fills are what each spring says of itself. Rounding: a few sums.
TEST(BlockDescent, TangentsAreThoseOfTheSprings)
{
  for (const SpringLaw law : {SpringLaw::Linear, SpringLaw::Cubic, SpringLaw::Exponential}) {
    const SpringNet net = livelyNet(law);
    const System system(net, {});
    const MotionState motion = startOf(net);
    const ForceModel& forces = system.forces();
    std::vector<SpringTangent> tangents;
    system.forces().springTangents(motion.x.data(), motion.v.data(), tangents);
    const double h = 0.01;
    SpringMatrix passed, told;
    passed.prepare(forces);
    passed.assignTangents(forces, motion.x.data(), motion.v.data(), {h, h * h});
    told.prepare(forces);
    told.assign(forces, [&](std::size_t s) {
      const SpringTangent& tangent = tangents[s];
      return SpringMatrix::Block{tangent.direction,
                                 h * h * std::max(tangent.axial, 0.0) + h * tangent.viscous,
                                 h * h * std::max(tangent.lateral, 0.0)};
    });
    const NodeArray z = scatteredOver(motion.x.size());
    NodeArray one(z.size(), Lanes{0, 0, 0, 0}), other = one;
    passed.addProduct(forces, z.data(), one.data());
    told.addProduct(forces, z.data(), other.data());
    EXPECT_LT(distance(one, other), 1e-13 * std::sqrt(sumOfSquares(other))) << static_cast<int>(law);
    EXPECT_GT(sumOfSquares(other), 0.0);
  }
}

// Conjugate gradients that are let run find what the factor of the same matrix finds: 1e-6 for an energy that
// is left of 1e-14.
TEST(BlockDescent, GradientsSolveTheMatrixOfTheStep)
{
  for (const SpringLaw law : {SpringLaw::Linear, SpringLaw::Cubic, SpringLaw::Exponential}) {
    const SpringNet net = livelyNet(law);
    System system(net, {});
    const MotionState motion = startOf(net);
    ToolSpring tool;
    tool.node = 30;
    tool.stiffness = 50.0;
    tool.viscosity = 1.0;
    system.setTools({&tool, 1}, motion.x, motion.time);
    const double h = 0.05;
    ImplicitMatrix factored;
    factored.prepare(system);
    ASSERT_TRUE(factored.factor(system, motion.x, motion.v, ImplicitMatrix::Shares::ofStep(h), true));
    StepGradients gradients;
    gradients.prepare(system);
    ASSERT_TRUE(gradients.set(system, motion.x, motion.v, h));
    NodeArray exact = scatteredOver(motion.x.size()), found = exact;
    const NodeArray first = scatteredOver(motion.x.size());
    factored.solve(exact);
    gradients.solve(system, found, &first, 1e-14, 1000);
    EXPECT_LT(distance(found, exact), 1e-6 * std::sqrt(sumOfSquares(exact))) << static_cast<int>(law);
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(found[5][axis], 0.0) << "a held node";
  }
}

// Whatever the net, a step of a frame gains nothing but rounding.
TEST(BlockDescent, GainsNoEnergyAtAll)
{
  SolverSettings settings = fixedSteps("block-descent", kFrameTime);
  settings.workLimit = 0.0;
  const StressSummary summary = sweepStress(0, 1000, settings, 1e-12, 1.0);
  EXPECT_EQ(summary.cases, 1000);
}

// Half the step, half the error.
TEST(BlockDescent, IsOfFirstOrder)
{
  for (const SpringLaw law : {SpringLaw::Linear, SpringLaw::Exponential}) {
    SpringNet net = randomNet(21, 10, law);
    net.initialVelocity = Eigen::Matrix3Xd::Zero(3, 10);
    net.initialVelocity(0, 3) = 1.0;
    net.fixed[0] = 1;
    const auto endOf = [&](const std::string& solver, double step) {
      Simulation simulation = simulate(net, {}, fixedSteps(solver, step));
      advanceWell(simulation, 0.25);
      return simulation.state().position;
    };
    const Eigen::Matrix3Xd exact = endOf("rk4", 1e-4);
    const double coarse = (endOf("block-descent", 1e-3) - exact).norm();
    const double fine = (endOf("block-descent", 5e-4) - exact).norm();
    EXPECT_NEAR(std::log2(coarse / fine), 1.0, 0.25) << static_cast<int>(law);
  }
}

// A free body that is thrown: its centre of mass goes along the parabola, to 1e-9 of the way.
TEST(BlockDescent, AFreeBodyFallsAsItMust)
{
  SpringNet net = randomNet(3, 40);
  net.initialVelocity = Eigen::Matrix3Xd::Random(3, net.nodeCount());
  Loads loads;
  loads.gravity = {0, 0, -9.81};
  const double mass = net.mass.sum(), time = 0.5;
  const Eigen::Vector3d begin = net.restPosition * net.mass.matrix() / mass;
  const Eigen::Vector3d velocity = net.initialVelocity * net.mass.matrix() / mass;
  Simulation simulation = simulate(net, loads, fixedSteps("block-descent", kFrameTime));
  advanceWell(simulation, time);
  const Eigen::Vector3d way = velocity * time + 0.5 * time * time * loads.gravity;
  const Eigen::Vector3d end = simulation.state().position * net.mass.matrix() / mass;
  EXPECT_LT((end - begin - way).norm(), 1e-9 * way.norm());
  const Eigen::Vector3d momentum = mass * (velocity + time * loads.gravity);
  EXPECT_LT((simulation.momentum() - momentum).norm(), 1e-9 * momentum.norm());
}

// Who keeps time gets the first picture after a step's work, not after checks and retries, and is told that it
// is rough. Thirty passes for a step leave room for twice as many iterations as it takes.
TEST(BlockDescent, KeepsTimeFromTheFirstFrameOn)
{
  const SpringNet net = stiffSheet();
  Simulation simulation = simulate(net, {}, onTheClock());
  for (int frame = 1; frame <= 10; ++frame) {
    const ToolSpring hand = handAt(net, 2e-4 * frame);
    simulation.setTools({&hand, 1});
    const StepReport report = simulation.advance(kFrameTime);
    ASSERT_TRUE(report.good()) << simulation.why();
    EXPECT_EQ(simulation.solverName(), "block-descent");
    EXPECT_TRUE(report.rough);
    EXPECT_LT(report.springsEvaluated, 30 * net.springCount()) << "frame " << frame;
  }
  EXPECT_NE(simulation.why().find("to keep time"), std::string::npos) << simulation.why();
  ASSERT_TRUE(simulation.setAccuracy(1e-2, 1e9)); // time enough
  const ToolSpring away = handAt(net, 4e-3);
  simulation.setTools({&away, 1});
  ASSERT_TRUE(simulation.advance(kFrameTime).good());
  EXPECT_NE(simulation.solverName(), "block-descent");
}

// Blocks need no bound of stable steps, and what a hand does to it stays unknown while they go. Whoever comes after them
// keeps to what is stable now: the springs have stiffened since anybody looked.
TEST(BlockDescent, PlainStepsThatFollowKnowWhatIsStable)
{
  SpringNet net = stiffSheet();
  for (SpringLaw& law : net.law) law = SpringLaw::Exponential;
  net.lawParameter.setConstant(8.0);
  SolverSettings settings = onTheClock();
  settings.tolerance = 0.3;
  settings.effort = 2e3; // far from what plain steps cost
  Simulation simulation = simulate(net, {}, settings);
  const double atRest = simulation.stableStep();
  for (int frame = 1; frame <= 3; ++frame) {
    ToolSpring hand = handAt(net, 4e-3 * frame);
    hand.targetVelocity = Eigen::Vector3d(0, 0, 4e-3 / kFrameTime);
    simulation.setTools({&hand, 1});
    ASSERT_TRUE(simulation.advance(kFrameTime).good()) << simulation.why();
    ASSERT_EQ(simulation.solverName(), "block-descent");
  }
  ASSERT_LT(simulation.stableStep(), 0.8 * atRest) << "or the test tells nothing";
  simulation.setTools({});
  ASSERT_TRUE(simulation.setAccuracy(0.3, 1e9)); // time enough
  const StepReport report = simulation.advance(kFrameTime / 8.0);
  ASSERT_TRUE(report.good()) << simulation.why();
  ASSERT_NE(simulation.solverName(), "block-descent");
  EXPECT_LE(report.smallestStep, simulation.stableStep()) << "as the springs are, a moment later";
}

// Now and then a frame is done twice, so that its error can be told. Where the clock never leaves room for that, what it
// costs is for nothing: it is tried ever more seldom.
TEST(BlockDescent, ChecksThatFindNoRoomBecomeRare)
{
  const SpringNet net = stiffSheet();
  const auto checksOf = [&](int questions) { // that a frame is granted; tried, and brought to their end
    Simulation simulation = simulate(net, {}, onTheClock());
    int tried = 0, done = 0;
    for (int frame = 1; frame <= 200; ++frame) {
      ToolSpring hand = handAt(net, 4e-3 * std::sin(0.05 * frame));
      hand.targetVelocity = Eigen::Vector3d(0, 0, 4e-3 * 0.05 * std::cos(0.05 * frame) / kFrameTime);
      simulation.setTools({&hand, 1});
      int asked = 0;
      const StepReport report =
        simulation.advance(kFrameTime, {.isSpent = [&] { return ++asked > questions; }});
      EXPECT_TRUE(report.good() || report.interrupted) << simulation.why();
      tried += report.rejectedSteps > 0 ? 1 : 0;
      done += report.rejectedSteps > 0 && asked <= questions ? 1 : 0;
    }
    return std::pair(tried, done);
  };
  const auto [triedWithRoom, doneWithRoom] = checksOf(1'000'000);
  EXPECT_EQ(triedWithRoom, doneWithRoom);
  EXPECT_GT(triedWithRoom, 10);
  const auto [tried, done] = checksOf(30); // a frame asks some dozen
  EXPECT_EQ(done, 0) << "or the test tells nothing";
  EXPECT_GT(tried, 0);
  EXPECT_LT(tried, triedWithRoom / 2);
}

// While the part that moves grows, steps by blocks keep the bound that is known. The node that it names stays that node,
// though it has another place in another part: all that is said of it is of one node of the net.
TEST(BlockDescent, TheStiffestNodeIsTheSameInAnyPart)
{
  SpringNet net = sheet(160, 2e-3, 4e3);
  net.viscosity.setConstant(0.05);
  const Eigen::Matrix3Xd points = net.restPosition;
  for (Index i = 0; i < net.nodeCount(); ++i) {
    net.mass[i] = 1e-5 * (1.0 + 0.3 * std::sin(1.7 * i));
    addAnchor(net, i, points.col(i), 30.0, 0.3);
  }
  for (Index s = 0; s < net.springCount(); ++s) net.stiffness[s] *= 1.0 + 0.3 * std::sin(2.3 * s);
  SolverSettings settings = onTheClock();
  settings.effort *= 0.1;
  Simulation simulation = simulate(net, {}, settings);
  Index said = 0, awake = 0, changed = 0;
  for (int frame = 1; frame <= 25; ++frame) {
    ToolSpring hand;
    hand.node = (frame <= 12 ? 40 : 120) * 160 + 80;
    hand.target = net.restPosition.col(hand.node) + Eigen::Vector3d(0, 0, 2e-5 * frame);
    hand.stiffness = 200.0;
    simulation.setTools({&hand, 1});
    const StepReport report = simulation.advance(kFrameTime);
    ASSERT_TRUE(report.good()) << simulation.why();
    changed += report.nodesAwake != awake && simulation.solverName() != "leapfrog";
    awake = static_cast<Index>(report.nodesAwake);
    const std::string why = simulation.why(); // "... springs at node 31 (12.5 N/m on 0.001 kg) ..."
    const auto wordAfter = [&why](const std::string& words) {
      const std::size_t found = why.find(words);
      if (found == std::string::npos) return std::string();
      const std::size_t begin = found + words.size();
      return why.substr(begin, why.find(' ', begin) - begin);
    };
    const std::string name = wordAfter("springs at node ");
    if (name.empty()) continue;
    ++said;
    const Index node = static_cast<Index>(parseInteger(name).value_or(-1));
    ASSERT_TRUE(node >= 0 && node < net.nodeCount()) << why;
    EXPECT_EQ(wordAfter("N/m on "), formatDouble(net.mass[node], 3)) << why;
    double stiffness = node == hand.node ? 30.0 + hand.stiffness : 30.0;
    for (Index s = 0; s < net.springCount(); ++s)
      if (net.ends(0, s) == node || net.ends(1, s) == node) stiffness += net.stiffness[s];
    EXPECT_NEAR(parseDouble(wordAfter("springs at node " + name + " (")).value_or(0.0), stiffness,
                0.02 * stiffness)
      << why;
  }
  EXPECT_GT(said, 20);
  EXPECT_GT(changed, 1) << "or the test tells nothing";
}

// Steps under a work limit share it: the last one, too, has its part, and the run arrives. Thirty passes are less than
// the four would take.
TEST(BlockDescent, EveryStepHasItsShareOfTheWork)
{
  const SpringNet net = livelyNet(SpringLaw::Exponential);
  System system(net, {});
  MotionState motion = startOf(net);
  const std::unique_ptr<Integrator> blocks = makeIntegrator("block-descent");
  blocks->prepare(system);
  const double limit = 30.0 * static_cast<double>(system.forces().activeSprings());
  system.workLimit = limit;
  StepReport report;
  EXPECT_EQ(blocks->run(system, motion, 4 * kFrameTime, 4, report), StepResult::Done);
  EXPECT_EQ(report.steps, 4);
  EXPECT_EQ(motion.time, 4 * kFrameTime);
  EXPECT_EQ(system.workLimit, limit);
}

// Where nothing pulls there is nowhere to go, and no way there to be searched for: what a hand that takes hold of a net
// at rest asks for in its first frame.
TEST(BlockDescent, AStepOfANetAtRestCostsALook)
{
  const SpringNet net = stiffSheet();
  System system(net, {});
  MotionState motion = startOf(net);
  const std::unique_ptr<Integrator> blocks = makeIntegrator("block-descent");
  blocks->prepare(system);
  StepReport report;
  EXPECT_EQ(blocks->step(system, motion, kFrameTime, kFrameTime, report), StepResult::Done);
  EXPECT_EQ(motion.time, kFrameTime);
  EXPECT_EQ(distance(motion.x, startOf(net).x), 0.0);
  EXPECT_EQ(system.springsEvaluated, system.forces().activeSprings());
  EXPECT_EQ(system.solverWork, 0.0);
  EXPECT_EQ(blocks->takeLocalError(), 0.0);
  EXPECT_FALSE(report.rough);
}

// Springs that stiffen: within the passes that a frame has for an organ of 10,000 nodes, the step comes near the least of
// its potential, which `descent` finds with a factor for each iteration.
TEST(BlockDescent, FollowsSpringsThatStiffen)
{
  SpringNet net = stiffSheet();
  for (SpringLaw& law : net.law) law = SpringLaw::Exponential;
  net.lawParameter.setConstant(8.0);
  const auto stepOf = [&](const char* name, double passes) {
    System system(net, {});
    MotionState motion = startOf(net);
    const ToolSpring hand = handAt(net, 4e-3);
    system.setTools({&hand, 1}, motion.x, motion.time);
    const std::unique_ptr<Integrator> method = makeIntegrator(name);
    method->prepare(system);
    system.workLimit = passes * static_cast<double>(system.forces().activeSprings());
    StepReport report;
    EXPECT_EQ(method->step(system, motion, kFrameTime, kFrameTime, report), StepResult::Done);
    return motion.x;
  };
  const NodeArray start = startOf(net).x, least = stepOf("descent", 1e9);
  const double error = distance(stepOf("block-descent", 65.0), least) / distance(least, start);
  EXPECT_LT(error, 0.3) << "0.22; thirty directions an iteration leave 0.97";
}

// And what it shows is near: a hand that lifts the middle in a third of a second, against a fine run. The
// steps of a frame themselves err some per cent.
TEST(BlockDescent, FollowsTheHandWithinSomePerCent)
{
  const SpringNet net = stiffSheet();
  SolverSettings fine;
  fine.tolerance = 1e-2;
  Simulation quick = simulate(net, {}, onTheClock()), exact = simulate(net, {}, fine);
  double error = 0.0, way = 0.0;
  for (int frame = 1; frame <= 30; ++frame) {
    const ToolSpring hand = handAt(net, 5e-3 * std::min(frame / 20.0, 1.0));
    for (Simulation* simulation : {&quick, &exact}) {
      simulation->setTools({&hand, 1});
      ASSERT_TRUE(simulation->advance(kFrameTime).good()) << simulation->why();
    }
    error += (quick.state().position - exact.state().position).squaredNorm();
    way += (exact.state().position - net.restPosition).squaredNorm();
  }
  EXPECT_LT(std::sqrt(error / way), 0.1);
}

} // namespace esm::test
