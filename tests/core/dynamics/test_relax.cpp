// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Relaxation leads to states of balance, in one step, and its books of work and heat agree.
#include "core/dynamics/methods/integrator.h"
#include "tests/support/nets.h"
#include "tests/support/physics.h"

#include <gtest/gtest.h>

namespace esm::test {
namespace {

/// A net with the relaxation, without the step driver.
class Relaxation {
public:
  explicit Relaxation(const SpringNet& net, const Loads& loads = {})
    : m_system(net, loads), m_relax(makeIntegrator("relax"))
  {
    state = startOf(net);
    m_system.enter(state, true);
    m_relax->prepare(m_system);
    m_relax->setSolveTolerance(1e-11, false);
  }
  StepResult step(double h) { return m_relax->step(m_system, state, h, state.time + h, report); }
  System& system() { return m_system; }
  Integrator& method() { return *m_relax; }

  double energy() const
  {
    return m_system.kineticEnergy(state.v) + m_system.elasticEnergy(state.x) +
           m_system.forces().gravityEnergy(state.x.data());
  }
  /// Largest force on a free node at rest [N].
  double unbalance()
  {
    NodeArray x = state.x, v = state.v, force = state.v;
    m_system.evaluate(state.time, x, v, force);
    double largest = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i)
      if (m_system.isFree(i)) largest = std::max(largest, std::sqrt(dot(force[i], force[i])));
    return largest;
  }

  MotionState state;
  StepReport report;

private:
  System m_system;
  std::unique_ptr<Integrator> m_relax;
};

VectorCurve constant(const Eigen::Vector3d& value)
{
  VectorCurve curve;
  curve.time = {0.0};
  curve.value = value;
  return curve;
}

SpringNet sheetHeldAtTwoSides()
{
  SpringNet net = sheet(8, 0.01, 100.0);
  net.mass.setConstant(1e-3);
  net.restLength *= 0.9;
  for (Index i = 0; i < 8; ++i) net.fixed[static_cast<std::size_t>(i)] = 1;
  for (Index i = 56; i < 64; ++i) net.fixed[static_cast<std::size_t>(i)] = 1;
  return net;
}

} // namespace

// A chain hanging from one end: spring s carries the weight of the nodes below it, so its length is
// L + (n - 1 - s) m g / k. One step gets there, from lying on its side.
TEST(Relax, HangingChainHasItsClosedFormInOneStep)
{
  const double k = 50.0, g = 9.81;
  SpringNet net = chain(12, 0.1, k);
  net.mass.setConstant(0.02);
  net.fixed[0] = 1;
  Loads loads;
  loads.gravity = {0, 0, -g};
  Relaxation relaxation(net, loads);
  ASSERT_EQ(relaxation.step(1.0 / 60.0), StepResult::Done);
  double depth = 0.0;
  for (std::size_t i = 1; i < 12; ++i) {
    depth += 0.1 + static_cast<double>(12 - i) * 0.02 * g / k;
    EXPECT_NEAR(relaxation.state.x[i][2], -depth, 1e-9) << "node " << i;
    EXPECT_NEAR(relaxation.state.x[i][0], 0.0, 1e-8) << "node " << i;
  }
}

// Between two supports at the same height, with stiff springs: horizontal pull H and the weight carried add
// up in each spring, so its direction has slope V_s / H and its length L + sqrt(H^2 + V_s^2) / k. H is found
// here by bisection on the span; the relaxed chain must have those positions.
TEST(Relax, ChainBetweenTwoSupportsHasTheFunicularShape)
{
  const int springs = 10;
  const double k = 200.0, weight = 0.05 * 9.81, span = 0.8;
  SpringNet net = chain(springs + 1, 0.08, k);
  net.restLength.setConstant(0.1);
  net.mass.setConstant(0.05);
  net.fixed[0] = net.fixed[springs] = 1;
  Loads loads;
  loads.gravity = {0, 0, -9.81};
  const auto springVector = [&](double pull, int s) {
    const double carried =
      weight * (0.5 * (springs - 1) - s); // the vertical force, positive downwards from node 0
    const double tension = std::hypot(pull, carried), length = 0.1 + tension / k;
    return Eigen::Vector2d(length * pull / tension, -length * carried / tension);
  };
  double low = 1e-6, high = 100.0;
  for (int i = 0; i < 200; ++i) {
    const double pull = 0.5 * (low + high);
    double reach = 0.0;
    for (int s = 0; s < springs; ++s) reach += springVector(pull, s).x();
    (reach < span ? low : high) = pull;
  }
  Relaxation relaxation(net, loads);
  ASSERT_EQ(relaxation.step(1.0), StepResult::Done);
  Eigen::Vector2d place(0, 0);
  for (int s = 0; s < springs; ++s) {
    place += springVector(low, s);
    const Eigen::Vector3d found = toVector(relaxation.state.x[static_cast<std::size_t>(s + 1)]);
    EXPECT_NEAR(found.x(), place.x(), 1e-8) << "node " << s + 1;
    EXPECT_NEAR(found.z(), place.y(), 1e-8) << "node " << s + 1;
  }
}

// Two ways to the same rest: one step of relaxation, and seconds of motion with strong mass damping, every
// law.
TEST(Relax, MinimumAgreesWithALongDampedRun)
{
  for (const SpringLaw law : {SpringLaw::Linear, SpringLaw::Cubic, SpringLaw::Exponential}) {
    SpringNet net = sheetHeldAtTwoSides();
    net.law.assign(net.law.size(), law);
    net.lawParameter.setConstant(2.0);
    Loads loads;
    loads.gravity = {0, 0, -9.81};
    loads.forces.push_back({{27, 28}, constant({0.02, 0.0, 0.1})});
    Relaxation relaxation(net, loads);
    ASSERT_EQ(relaxation.step(0.1), StepResult::Done);
    net.massDamping = Eigen::ArrayXd::Constant(net.nodeCount(), 60.0);
    Simulation simulation = simulate(net, loads);
    advanceWell(simulation, 4.0);
    double away = 0.0;
    for (Index i = 0; i < net.nodeCount(); ++i)
      away = std::max(
        away, (simulation.state().position.col(i) - toVector(relaxation.state.x[static_cast<std::size_t>(i)]))
                .norm());
    EXPECT_LT(away, 1e-7) << "law " << static_cast<int>(law); // displacements are some millimetres
    EXPECT_LT(relaxation.unbalance(), 1e-8);
  }
}

// Nothing moves afterwards, and kinetic energy is in the heat.
TEST(Relax, MotionEndsAsHeat)
{
  SpringNet net = sheetHeldAtTwoSides();
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, net.nodeCount());
  net.initialVelocity(2, 30) = 2.0;
  Relaxation relaxation(net);
  const double before = relaxation.energy();
  ASSERT_EQ(relaxation.step(0.1), StepResult::Done);
  for (const Lanes& v : relaxation.state.v) EXPECT_EQ(dot(v, v), 0.0);
  EXPECT_EQ(relaxation.state.work, 0.0);
  EXPECT_NEAR(relaxation.state.heat, before - relaxation.energy(), 1e-12 * before);
  EXPECT_GE(relaxation.state.heat, 0.5 * 1e-3 * 4.0 * (1 - 1e-12)) << "the kinetic energy at least";
}

// A support that leads a node away, in steps: what its work does not store is heat, never negative, and less
// the finer the steps; the store is the same.
TEST(Relax, WorkIsStoredOrHeatAndFineStepsLoseLess)
{
  SpringNet net = sheetHeldAtTwoSides();
  Loads loads;
  loads.gravity = {0, 0, -9.81};
  PrescribedMotion pull;
  pull.nodes = {27};
  pull.displacement.time = {0.0, 1.0};
  pull.displacement.value = Eigen::Matrix3Xd::Zero(3, 2);
  pull.displacement.value(2, 1) = 0.02;
  loads.motions.push_back(pull);
  double heats[2] = {}, stored[2] = {};
  for (const int steps : {32, 512}) {
    Relaxation relaxation(net, loads);
    ASSERT_EQ(relaxation.step(1e-9), StepResult::Done); // settled under its weight
    const double begin = relaxation.energy(), heat = relaxation.state.heat, work = relaxation.state.work;
    double last = heat;
    for (int i = 0; i < steps; ++i) {
      ASSERT_EQ(relaxation.step((1.0 - 1e-9) / steps), StepResult::Done);
      EXPECT_GE(relaxation.state.heat, last - 1e-15);
      last = relaxation.state.heat;
    }
    const std::size_t which = steps == 32 ? 0 : 1;
    stored[which] = relaxation.energy() - begin;
    heats[which] = last - heat;
    EXPECT_NEAR(relaxation.state.work - work, stored[which] + heats[which], 1e-12);
    EXPECT_NEAR(relaxation.state.x[27][2], 0.02, 1e-12);
  }
  EXPECT_NEAR(stored[0], stored[1], 1e-9 * stored[1]);
  EXPECT_GT(heats[1], 0.0);
  EXPECT_NEAR(heats[0] / heats[1], 16.0, 2.0) << "heat per step goes with the square of the step";
}

// A pressed straight column is in balance, but not at rest for long: the minimum is beside it, and lower.
TEST(Relax, PressedColumnBuckles)
{
  SpringNet net = chain(5, 0.09, 100.0);
  net.restLength.setConstant(0.1);
  net.fixed[0] = net.fixed[4] = 1;
  for (Index i = 1; i < 4; ++i) addAnchor(net, i, net.restPosition.col(i), 1.0);
  Relaxation relaxation(net);
  const double straight = relaxation.energy();
  ASSERT_EQ(relaxation.step(0.1), StepResult::Done);
  EXPECT_LT(relaxation.energy(), 0.9 * straight);
  EXPECT_LT(relaxation.unbalance(), 1e-8);
}

// A tool pulls, a node is released, a slack thread hangs: balance each time.
TEST(Relax, FollowsToolsReleasesAndSlackThreads)
{
  SpringNet net = sheetHeldAtTwoSides();
  const Index hanger = addNode(net, net.restPosition.col(27) + Eigen::Vector3d(0, 0, -0.01));
  net.mass[hanger] = 1e-3;
  const Index thread = addSpring(net, 27, hanger, 500.0);
  net.tensionOnly[static_cast<std::size_t>(thread)] = 1;
  net.restLength[thread] = 0.03;
  Loads loads;
  loads.gravity = {0, 0, -9.81};
  PrescribedMotion hold;
  hold.nodes = {35};
  hold.displacement = constant({0, 0, 0.01});
  hold.release = 0.5;
  loads.motions.push_back(hold);
  Relaxation relaxation(net, loads);
  ASSERT_EQ(relaxation.step(0.5), StepResult::Done);
  EXPECT_LT(relaxation.unbalance(), 1e-8);
  EXPECT_NEAR(relaxation.state.x[27][2] - relaxation.state.x[static_cast<std::size_t>(hanger)][2],
              0.03 + 1e-3 * 9.81 / 500.0, 1e-9);
  ASSERT_TRUE(relaxation.system().enter(relaxation.state, false));
  relaxation.method().constraintsChanged(relaxation.system());
  const ToolSpring tool{
    20, toVector(relaxation.state.x[20]) + Eigen::Vector3d(0, 0, 0.02), {0, 0, 0}, 80.0, 0.0};
  relaxation.system().setTools({&tool, 1}, relaxation.state.x, relaxation.state.time);
  relaxation.method().prepare(relaxation.system());
  ASSERT_EQ(relaxation.step(0.5), StepResult::Done);
  EXPECT_LT(relaxation.unbalance(), 1e-8);
}

// Weight without support has no minimum: that is said, and the state stays.
TEST(Relax, FallingNetIsRefused)
{
  SpringNet net = chain(3);
  Loads loads;
  loads.gravity = {0, 0, -9.81};
  Relaxation relaxation(net, loads);
  const NodeArray before = relaxation.state.x;
  EXPECT_NE(relaxation.step(0.1), StepResult::Done);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(relaxation.state.x[i][2], before[i][2]);
  EXPECT_EQ(relaxation.state.time, 0.0);
}

} // namespace esm::test
