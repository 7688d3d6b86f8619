// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/support/force_harness.h"
#include "tests/support/nets.h"

#include <random>
#include <tuple>

namespace esm::test {
namespace {

/// One spring from the origin to (length, 0, 0), rest length 2 m, k = 3 N/m.
SpringNet oneSpring(SpringLaw law, double parameter, double length, double c = 0.0)
{
  SpringNet net = chain(2, length, 3.0);
  net.restLength[0] = 2.0;
  net.law[0] = law;
  net.lawParameter[0] = parameter;
  net.viscosity[0] = c;
  return net;
}

/// Force on the left end, along the spring.
double pull(const SpringNet& net)
{
  const ForceHarness harness(net);
  NodeArray x(2), v(2, Lanes{0, 0, 0, 0});
  copyNodes(net.restPosition, x);
  if (net.initialVelocity.cols() > 0) copyNodes(net.initialVelocity, v);
  const NodeArray force = harness.forces(x, v);
  EXPECT_EQ(force[0][0], -force[1][0]);
  EXPECT_EQ(force[0][1], 0.0);
  return force[0][0];
}

} // namespace

// By hand: L = 2, length 2.5, so e = 0.5 and e/L = 0.25.
TEST(ForceLaws, HandComputedCases)
{
  EXPECT_DOUBLE_EQ(pull(oneSpring(SpringLaw::Linear, 0.0, 2.5)), 1.5);
  EXPECT_DOUBLE_EQ(pull(oneSpring(SpringLaw::Linear, 0.0, 1.5)), -1.5);
  EXPECT_DOUBLE_EQ(pull(oneSpring(SpringLaw::Cubic, 4.0, 2.5)), 1.5 * (1.0 + 4.0 / 16.0));
  EXPECT_DOUBLE_EQ(pull(oneSpring(SpringLaw::Exponential, 4.0, 2.5)), 1.5 * (std::exp(1.0) - 1.0));
  EXPECT_NEAR(pull(oneSpring(SpringLaw::Exponential, 4.0, 1.5)), 1.5 * (std::exp(-1.0) - 1.0), 1e-15);
  EXPECT_DOUBLE_EQ(pull(oneSpring(SpringLaw::Exponential, 0.0, 2.5)), 1.5) << "b = 0 is the linear law";

  // g runs through (0, 0), (0.2, 0.1), (0.3, 0.5): at 0.25 it is 0.3; beyond the ends the slopes 0.5 and 4 go
  // on.
  SpringNet table = oneSpring(SpringLaw::Table, 0.0, 2.5);
  table.tables = {{{0.0, 0.2, 0.3}, {0.0, 0.1, 0.5}}};
  EXPECT_NEAR(pull(table), 3.0 * 2.0 * 0.3, 1e-14);
  table.restPosition(0, 1) = 2.8;
  EXPECT_NEAR(pull(table), 3.0 * 2.0 * 0.9, 1e-14);
  table.restPosition(0, 1) = 1.8;
  EXPECT_NEAR(pull(table), 3.0 * 2.0 * -0.05, 1e-14);
}

// c = 0.5 N s/m, the ends part with 2 m/s along the spring and slide across it, which costs nothing.
TEST(ForceLaws, DamperFeelsOnlyTheRateOfLength)
{
  SpringNet net = oneSpring(SpringLaw::Linear, 0.0, 2.5, 0.5);
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, 2);
  net.initialVelocity.col(1) << 2.0, 7.0, -3.0;
  EXPECT_DOUBLE_EQ(pull(net), 1.5 + 1.0);
}

// While shorter than its rest length a tension-only spring is a slack thread: it neither pushes nor brakes.
TEST(ForceLaws, TensionOnlySpringIsSlackWhenShort)
{
  SpringNet net = oneSpring(SpringLaw::Linear, 0.0, 1.5, 0.5);
  net.tensionOnly[0] = 1;
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, 2);
  net.initialVelocity(0, 1) = 2.0;
  EXPECT_EQ(pull(net), 0.0);
  net.restPosition(0, 1) = 2.5;
  EXPECT_DOUBLE_EQ(pull(net), 1.5 + 1.0);
}

// Every law, with and without tension-only: the rest lengths are +-30 %, so both branches occur.
class EveryLaw : public ::testing::TestWithParam<std::tuple<SpringLaw, bool>> {};
INSTANTIATE_TEST_SUITE_P(Laws, EveryLaw,
                         ::testing::Combine(::testing::Values(SpringLaw::Linear, SpringLaw::Cubic,
                                                              SpringLaw::Exponential, SpringLaw::Table),
                                            ::testing::Bool()));

TEST_P(EveryLaw, PassesTheFiveChecksAndItsTangentsAreDerivatives)
{
  SpringNet net = randomNet(7, 14, std::get<0>(GetParam()));
  for (auto& flag : net.tensionOnly) flag = std::get<1>(GetParam());
  std::mt19937 random(3);
  net.initialVelocity.resize(3, net.nodeCount());
  for (double& v : net.initialVelocity.reshaped()) v = static_cast<double>(random() % 2001) / 1000.0 - 1.0;
  ForceHarness(net).expectAll();
}

TEST(ForceLaws, AnchorsAndMassDampingTooAreGradientsAndTakeEnergy)
{
  SpringNet net = randomNet(9, 8);
  for (Index i = 0; i < 8; i += 2) addAnchor(net, i, {0.1 * i, 0.0, 1.0}, 5.0 + i, 0.3);
  net.massDamping = Eigen::ArrayXd::LinSpaced(8, 0.0, 2.0);
  net.initialVelocity = Eigen::Matrix3Xd::Ones(3, 8);
  const ForceHarness harness(net);
  harness.expectMinusGradientOfEnergy();
  harness.expectDampingTakesEnergy();
  harness.expectTangentsAreDerivatives();
}

// The exponential of 1e6 m of stretch would overflow; the tangent goes on instead, so the force is large but
// a number, and the step control can answer.
TEST(ForceLaws, ExponentialLawDoesNotOverflow)
{
  const double force = pull(oneSpring(SpringLaw::Exponential, 50.0, 1e6));
  EXPECT_TRUE(std::isfinite(force));
  EXPECT_GT(force, 1e40);
  EXPECT_TRUE(std::isfinite(pull(oneSpring(SpringLaw::Exponential, -50.0, 1e6))));
}

// Against the C library, within 4 units in the last place: over the whole range, and closely where the small
// exponents end and where the first power of two begins.
TEST(ForceLaws, ExponentialLawIsExactToRounding)
{
  const auto compare = [](double s) {
    const double length = 2.0 + s / 100.0 * 2.0;
    if (length <= 0.0) return;
    const double expected = 3.0 * 2.0 / 100.0 * std::expm1(100.0 * (length - 2.0) / 2.0);
    EXPECT_NEAR(pull(oneSpring(SpringLaw::Exponential, 100.0, length)), expected,
                4 * 2.3e-16 * std::abs(expected))
      << s;
  };
  for (double s = -60.0; s < 60.0; s += 0.37) compare(s);
  for (double s = -0.4; s < 0.4; s += 0.0013) compare(s);
}

// Fifteen springs that share no node. Where one needs a power of two, others of its step go the longer way
// with it, and must not feel that.
TEST(ForceLaws, ExponentialSpringsDoNotFeelHowFarOthersAreStretched)
{
  constexpr Index kSprings = 15;
  SpringNet net = chain(2 * kSprings, 2.0, 3.0);
  for (Index s = 0; s < net.springCount(); ++s) {
    if (s % 2 == 1) net.stiffness[s] = 0.0; // no spring between two pairs
    net.law[static_cast<std::size_t>(s)] = SpringLaw::Exponential;
    net.lawParameter[s] = 4.0;
    net.restLength[s] = 1.85 + 0.01 * static_cast<double>(s);
  }
  const ForceHarness harness(net);
  NodeArray x(2 * kSprings), v(2 * kSprings, Lanes{0, 0, 0, 0});
  copyNodes(net.restPosition, x);
  const NodeArray alone = harness.forces(x, v);
  for (std::size_t far = 0; far < kSprings; ++far) {
    NodeArray stretched = x;
    stretched[2 * far + 1][1] = 3.0;
    const NodeArray force = harness.forces(stretched, v);
    EXPECT_GT(force[2 * far][0], alone[2 * far][0]);
    for (std::size_t i = 0; i < force.size(); ++i)
      if (i / 2 != far) {
        EXPECT_EQ(toVector(force[i]), toVector(alone[i])) << i << " of " << far;
      }
  }
}

// Springs are sorted by their tables where these are few. Against each spring alone, whose table is the only
// one that matters, within the rounding of sums in another order.
TEST(ForceLaws, SpringsOfSeveralTablesFollowTheirOwn)
{
  const SpringNet net = randomNet(5, 30, SpringLaw::Table);
  const auto count = static_cast<std::size_t>(net.nodeCount());
  NodeArray x(count), v(count, Lanes{0, 0, 0, 0}), sum = v;
  copyNodes(net.restPosition, x);
  for (Index s = 0; s < net.springCount(); ++s) {
    SpringNet alone = net;
    alone.stiffness.setZero();
    alone.viscosity.setZero();
    alone.stiffness[s] = net.stiffness[s];
    alone.tables = {net.tables[static_cast<std::size_t>(net.lawParameter[s])]};
    alone.lawParameter.setZero();
    const NodeArray force = ForceHarness(alone).forces(x, v);
    for (std::size_t i = 0; i < count; ++i) sum[i] += force[i];
  }
  SpringNet many = net;
  for (int copy = 0; copy < 20; ++copy) many.tables.insert(many.tables.end(), {net.tables[0], net.tables[1]});
  for (const SpringNet& each : {net, many}) {
    const ForceHarness harness(each);
    const NodeArray force = harness.forces(x, v);
    for (std::size_t i = 0; i < count; ++i)
      EXPECT_LE((toVector(force[i]) - toVector(sum[i])).norm(), 1e-14 * harness.largest(sum)) << i;
  }
}

// As if they were not there, up to rounding of another order of sums.
TEST(ForceLaws, ZeroLengthSpringsGiveNoForce)
{
  SpringNet net = randomNet(1, 6);
  net.restPosition.col(net.ends(0, 4)) = net.restPosition.col(net.ends(1, 4));
  net.initialVelocity = Eigen::Matrix3Xd::Random(3, 6);
  const ForceModel model(net, Eigen::Vector3d::Zero());
  NodeArray x(6), v(6), force(6);
  copyNodes(net.restPosition, x);
  copyNodes(net.initialVelocity, v);
  const double heat = model.computeForces(x.data(), v.data(), force.data());
  SpringNet without = net;
  for (Index s = 0; s < net.springCount(); ++s)
    if (net.restPosition.col(net.ends(0, s)) == net.restPosition.col(net.ends(1, s)))
      without.stiffness[s] = without.viscosity[s] = 0.0;
  const ForceModel other(without, Eigen::Vector3d::Zero());
  ASSERT_LT(other.activeSprings(), model.activeSprings());
  NodeArray expected(6);
  EXPECT_NEAR(other.computeForces(x.data(), v.data(), expected.data()), heat, 1e-13 * heat);
  for (std::size_t i = 0; i < 6; ++i) {
    const Lanes away = force[i] - expected[i];
    EXPECT_LE(dot(away, away), 1e-26 * dot(expected[i], expected[i])) << i;
  }
}

// Of late velocities the heat is that of their places, for as many passes as are asked for.
TEST(ForceLaws, HeatOfLateVelocitiesIsThatOfTheirPlaces)
{
  constexpr double kLate = 0.02, kPasses = 8.0;
  for (const SpringLaw law :
       {SpringLaw::Linear, SpringLaw::Cubic, SpringLaw::Exponential, SpringLaw::Table}) {
    SpringNet net = randomNet(3, 20, law);
    net.initialVelocity = Eigen::Matrix3Xd::Random(3, 20);
    const ForceModel model(net, Eigen::Vector3d::Zero());
    NodeArray x(20), v(20), force(20), damper(model.damperSize());
    copyNodes(net.initialVelocity, v);
    copyNodes(net.restPosition - kLate * net.initialVelocity, x);
    const double then = model.computeForces(x.data(), v.data(), force.data(), damper.data());
    copyNodes(net.restPosition, x);
    const double now = model.computeForces(x.data(), v.data(), force.data(), damper.data());
    const auto found = [&](double passes) {
      return model.computeForces(x.data(), v.data(), force.data(), damper.data(), nullptr, {},
                                 {kLate, passes});
    };
    EXPECT_GT(std::abs(then - now), 1e-3 * now) << "it makes no difference";
    EXPECT_NEAR(found(1.0), then, 1e-12 * then); // rounding
    EXPECT_NEAR(found(kPasses), now + kPasses * (then - now), 1e-11 * then);
  }
}

// Rule 1 of the house: springs without stiffness and viscosity are not even looked at.
TEST(ForceLaws, IdleSpringsCostNothing)
{
  SpringNet net = chain(11);
  net.stiffness.tail(4).setZero();
  EXPECT_EQ(ForceModel(net, Eigen::Vector3d::Zero()).activeSprings(), 6);
}

} // namespace esm::test
