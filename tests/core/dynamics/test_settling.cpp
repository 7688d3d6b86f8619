// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The last part of the way to rest is taken in one go, where it is known how long it is.
#include "core/dynamics/rest/settling.h"
#include "tests/core/dynamics/skip_nets.h"
#include "tests/support/physics.h"

#include <cmath>
#include <limits>
#include <utility>

namespace esm::test {
namespace {

/// A node of 2 kg that swings at 20/s along x about 1 m from a fixed one.
struct Oscillator {
  static constexpr double kMass = 2.0, kRate = 20.0;
  System system;
  MotionState motion;
  Settling settling;
  StepReport report;

  Oscillator(double displacement, double speed)
  {
    SpringNet net = chain(2);
    net.fixed[0] = 1;
    net.mass.setConstant(kMass);
    net.stiffness[0] = kMass * kRate * kRate;
    system = System(net, {});
    motion.x.assign(2, Lanes{0, 0, 0, 0});
    motion.v = motion.x;
    motion.x[1] = Lanes{1.0 + displacement, 0, 0, 0};
    motion.v[1] = Lanes{speed, 0, 0, 0};
    system.enter(motion, true);
  }
  double glance(double mostSquare) { return settling.glance(system, motion, {mostSquare, 0.0, 0.0}, report); }
  double settle(double mostSquare, double since = 0.0)
  {
    return settling.settle(system, motion, {mostSquare, since, 0.0}, report);
  }
};

/// 300 links of 1e8 N/m that hang on one end, too long a way for gradients.
struct LongChain {
  SpringNet net = chain(300);
  System system;
  MotionState motion;
  Settling settling;
  StepReport report;

  explicit LongChain(double stretch)
  {
    net.fixed.front() = 1;
    net.stiffness.setConstant(1e8);
    system = System(net, {});
    motion = startOf(net);
    stretchBy(stretch);
    system.enter(motion, true);
    settling.countWork(1'000'000'000);
  }
  void stretchBy(double by)
  {
    for (std::size_t i = 0; i < motion.x.size(); ++i) motion.x[i][0] = static_cast<double>(i) * (1.0 + by);
  }
};

} // namespace

// An oscillator gets A = sqrt(x^2 + v^2/w^2) far, and misses A^2/2 in the mean; at its turning point it might
// as well creep, and counts in full. The inertia over ten seconds makes 2.5e-5 of it.
TEST(Settling, KnowsHowFarAnOscillatorGets)
{
  const double cases[][2] = {
    {1e-3, 0.0}, {0.0, 0.02}, {1e-3, -0.02}}; // stretched: a pressed spring would give way sidewards
  for (const auto& [displacement, speed] : cases) {
    Oscillator oscillator(displacement, speed);
    const MotionState before = oscillator.motion;
    const double way = std::pow(displacement, 2), swing = std::pow(speed / Oscillator::kRate, 2);
    const double square = std::max(way, 0.5 * (way + swing));
    // One node, one iteration: here the bound is what it bounds.
    EXPECT_NEAR(oscillator.glance(1e-6), square / 1e-6, 1e-4 * square / 1e-6);
    EXPECT_NEAR(oscillator.settle(1e-9), square / 1e-9, 1e-4 * square / 1e-9);
    EXPECT_EQ(toVector(oscillator.motion.x[1]), toVector(before.x[1])); // too far: nothing is done
    EXPECT_EQ(toVector(oscillator.motion.v[1]), toVector(before.v[1]));
    EXPECT_EQ(oscillator.motion.heat, 0.0);
  }
}

// A pressed spring gives way sidewards, whether the node moves there or not yet: nothing tells how far. What
// one look has met is forgotten in the next.
TEST(Settling, KnowsNoEndWhereANetGivesWay)
{
  Oscillator oscillator(-0.1, 0.0);
  oscillator.motion.v[1] = Lanes{0, 0.02, 0, 0};
  EXPECT_TRUE(std::isinf(oscillator.glance(1e-6)));
  oscillator.motion.x[1] = Lanes{1, 0, 0, 0};
  oscillator.motion.v[1] = Lanes{0, 0, 0, 0};
  EXPECT_EQ(oscillator.glance(1e-6), 0.0);
}

// What it had is heat: m v^2/2 + k x^2/2, to the same 2.5e-5.
TEST(Settling, TurnsTheEnergyThatIsLeftIntoHeat)
{
  Oscillator oscillator(1e-3, 0.02);
  EXPECT_LE(oscillator.settle(1e-5), 1.0);
  EXPECT_NEAR(oscillator.motion.x[1][0], 1.0, 1e-7);
  EXPECT_EQ(oscillator.motion.v[1][0], 0.0);
  const double energy = 0.5 * Oscillator::kMass * (0.02 * 0.02 + std::pow(Oscillator::kRate * 1e-3, 2));
  EXPECT_NEAR(oscillator.motion.heat, energy, 1e-4 * energy);
  EXPECT_EQ(oscillator.motion.work, 0.0);
  EXPECT_GT(oscillator.report.springsEvaluated, 0);
}

// What is missed after a motion of length T fades as A exp(-t/tau): its mean square over all the time up to
// then is never more than what may be missed for good, and never far below.
TEST(Settling, MissesNoMoreInTheMeanThanForGood)
{
  const double tau = 0.3;
  for (const double length : {0.0, 0.1, 0.3, 1.0}) {
    const double square = SettlingBudget{1.0, length, tau}.squareAt(tau);
    double worst = 0.0;
    for (double s = 1e-4; s < 20.0 * tau; s += 1e-3)
      worst = std::max(worst, square * tau / 2.0 * -std::expm1(-2.0 * s / tau) / (length + s));
    EXPECT_LE(worst, 1.0) << length;
    EXPECT_GE(worst, 0.6) << length;
  }
  EXPECT_DOUBLE_EQ((SettlingBudget{1.0, 1e6, tau}.squareAt(tau)), 16.0); // the eye sees the jump
}

// An oscillator reaches its goal in 1/w: a motion of four times that may miss nine times the square, and one
// that has just begun no more than it would for good; half of 1e-4 is missed in the mean.
TEST(Settling, LongMotionMayMissMore)
{
  const double length = 4.0 / Oscillator::kRate, square = 1e-6;
  for (const auto& [since, gain] : {std::pair{0.0, 1.0}, std::pair{length, 9.0}}) {
    Oscillator oscillator(0.0, 1e-2 * Oscillator::kRate);
    EXPECT_NEAR(oscillator.settle(square, since), 0.5e-4 / square / gain, 0.5e-2 / square / gain) << since;
  }
}

// A column under pressure stands in balance, and falls at a breath: that is no rest. Nor is the drift of what
// nothing holds.
TEST(Settling, LeavesUnstableBalanceAndDriftAlone)
{
  SpringNet column = chain(3);
  column.fixed[0] = column.fixed[2] = 1;
  column.restLength.setConstant(1.2);
  SpringNet drifting = chain(3);
  for (const bool drifts : {false, true}) {
    System system(drifts ? drifting : column, {});
    MotionState motion;
    motion.x = {Lanes{0, 0, 0, 0}, Lanes{1, 0, 0, 0}, Lanes{2, 0, 0, 0}};
    motion.v.assign(3, Lanes{0, drifts ? 1e-4 : 0.0, 0, 0});
    system.enter(motion, true);
    Settling settling;
    StepReport report;
    EXPECT_GT(settling.settle(system, motion, {1e-8}, report), 1.0);
    EXPECT_EQ(motion.v[1][1], drifts ? 1e-4 : 0.0);
  }
}

// A net that is slow enough to try but has too far to go is seen to be so at a glance: forces are asked for
// once, where a try looks at them at the goal, too.
TEST(Settling, SeesAtAGlanceThatItIsTooEarly)
{
  Oscillator oscillator(1e-3, 0.0);
  oscillator.settling.countWork(1'000'000);
  const auto tryWith = [&](double square) {
    return oscillator.settling.settleIfDue(oscillator.system, oscillator.motion, {square, 0.0, 0.0}, 1e6,
                                           oscillator.report);
  };
  EXPECT_FALSE(tryWith(0.5e-6));
  EXPECT_EQ(oscillator.report.springsEvaluated, 1);
  oscillator.settling.countWork(1'000'000);
  EXPECT_TRUE(tryWith(2e-6));
  EXPECT_EQ(oscillator.report.springsEvaluated, 4);
}

// Amplitudes that are ten times too large take fading times ln 10 to come down. Until near then nobody looks
// again, however slow the net is for the moment: a swing is so at each turn.
TEST(Settling, WaitsForWhatHasToFade)
{
  Oscillator oscillator(1e-3, 0.0);
  const auto looksAt = [&](double time) {
    oscillator.settling.countWork(1'000'000);
    oscillator.motion.time = time;
    const std::int64_t before = oscillator.report.springsEvaluated;
    oscillator.settling.settleIfDue(oscillator.system, oscillator.motion, {1e-8, 0.0, 1.0}, 1e6,
                                    oscillator.report);
    return oscillator.report.springsEvaluated > before;
  };
  EXPECT_TRUE(looksAt(1.0));
  EXPECT_FALSE(looksAt(1.5));
  EXPECT_FALSE(looksAt(1.0 + 0.39 * std::log(10.0)));
  EXPECT_TRUE(looksAt(1.0 + 0.41 * std::log(10.0)));
}

// What seems never to fade may be damped a moment later, by another slider: nobody waits for good.
TEST(Settling, LooksAgainAfterSomeTimeWhateverItHasSeen)
{
  Oscillator oscillator(1e-3, 0.0);
  int found = 0;
  for (int look = 0; look < 100; ++look) {
    oscillator.settling.countWork(1'000'000);
    const std::int64_t before = oscillator.report.springsEvaluated;
    oscillator.settling.settleIfDue(oscillator.system, oscillator.motion,
                                    {1e-8, 0.0, std::numeric_limits<double>::infinity()}, 1e6,
                                    oscillator.report);
    found += oscillator.report.springsEvaluated > before ? 1 : 0;
  }
  EXPECT_EQ(found, 4); // once, and after each 32 looks
}

// A weight on a spring, 0.02 rad aside: the first of Newton's steps is along the tangent of the circle and
// stretches the spring, which then pulls harder than what is left of the weight did before. The goal is known
// all the same: straight down, the spring longer by m g/k.
TEST(Settling, GoesOnToTheGoalWhereTheFirstStepStretchesSprings)
{
  constexpr double kMass = 2.0, kGravity = 10.0, kStiffness = 3000.0, kAngle = 0.02;
  constexpr double kLength = 1.0 + kMass * kGravity / kStiffness;
  SpringNet net = chain(2);
  net.fixed[0] = 1;
  net.mass.setConstant(kMass);
  net.stiffness[0] = kStiffness;
  Loads loads;
  loads.gravity = {0.0, 0.0, -kGravity};
  System system(net, loads);
  MotionState motion;
  motion.x = {Lanes{0, 0, 0, 0}, Lanes{kLength * std::sin(kAngle), 0, -kLength * std::cos(kAngle), 0}};
  motion.v.assign(2, Lanes{0, 0, 0, 0});
  system.enter(motion, true);
  Settling settling;
  StepReport report;
  const double share = settling.settle(system, motion, {1e-3, 0.0, 0.0}, report);
  // The stretch by L a^2/2 is taken back along the first direction, a aside of where it pulls now.
  const double aside = 0.5 * kStiffness * kLength * std::pow(kAngle, 3) / (kMass * kGravity / kLength);
  EXPECT_NEAR(motion.x[1][0], 0.0, 1.1 * aside);
  EXPECT_NEAR(motion.x[1][2], -kLength, 1.1 * aside * kAngle);
  EXPECT_NEAR(share, std::pow(kLength * kAngle, 2) / 1e-3, 2.2 * aside / (kLength * kAngle) * share);
  // m g times the height that it has lost; nothing else changes in the first order.
  const double energy = kMass * kGravity * kLength * (1.0 - std::cos(kAngle));
  EXPECT_NEAR(motion.heat, energy, 1e-2 * energy);
}

// One node among a hundred that stands as far off as all of them may together is seen, and goes on.
TEST(Settling, LetsASingleSpotSwingOn)
{
  SpringNet net;
  for (int i = 0; i < 100; ++i) addAnchor(net, addNode(net, {0.01 * i, 0, 0}), {0.01 * i, 0, 0}, 400.0);
  System system(net, {});
  MotionState motion = startOf(net);
  motion.x[50][1] += 1e-3;
  system.enter(motion, true);
  Settling settling;
  StepReport report;
  EXPECT_NEAR(settling.settle(system, motion, {1e-6}, report), 100.0 / 25.0, 1e-3);
  EXPECT_EQ(motion.x[50][1], 1e-3);
  motion.x[50][1] = 0.0;
  for (Lanes& x : motion.x) x[1] += 1e-4; // the same sum, but of all
  EXPECT_NEAR(settling.settle(system, motion, {1e-6}, report), 1.0, 1e-3);
}

// Where the equilibrium is known a look takes a force pass; a factor is made once, and looks need not wait
// for what has to fade.
TEST(Settling, LooksAtAKnownEquilibriumForNextToNothing)
{
  LongChain net(3e-6);
  const double square = 1e-12 * 300.0 * 300.0 * 300.0 / 3.0; // of a stretch by 1e-6, about
  const auto look = [&] {
    return net.settling.settleIfDue(net.system, net.motion, {square, 0.0, 1.0}, 1e12, net.report);
  };
  EXPECT_FALSE(look());
  const std::int64_t factors = net.report.factorizations;
  EXPECT_GT(factors, 0);
  for (const double by : {2e-6, 1.1e-6}) {
    net.stretchBy(by);
    const std::int64_t before = net.report.springsEvaluated;
    EXPECT_FALSE(look());
    EXPECT_EQ(net.report.springsEvaluated, before + 299) << by;
  }
  net.stretchBy(0.9e-6);
  net.settling.countWork(1'000'000);
  EXPECT_TRUE(look());
  EXPECT_EQ(net.report.factorizations, factors);
}

// A node between links that are too long stands above or below their line, below it deeper by its weight;
// struts across hold it in the plane. Whoever knows the upper place and is below by now has not the energy to
// go back.
TEST(Settling, GoesToNoEquilibriumThatIsOutOfReach)
{
  SpringNet net = chain(3);
  net.fixed[0] = net.fixed[2] = 1;
  net.restLength.setConstant(1.2);
  for (const double side : {-1.0, 1.0}) addSpring(net, 1, addNode(net, {1, 0, side}), 1.0);
  net.fixed[3] = net.fixed[4] = 1;
  Loads loads;
  loads.gravity = {0.0, -0.01, 0.0};
  System system(net, loads);
  MotionState motion = startOf(net);
  motion.x[1][1] = 0.5;
  system.enter(motion, true);
  Settling settling;
  StepReport report;
  EXPECT_LE(settling.settle(system, motion, {1.0}, report), 1.0);
  const double above = motion.x[1][1];
  EXPECT_GT(above, 0.3);
  motion.x[1][1] = -above;
  const double missed = settling.settle(system, motion, {10.0}, report);
  EXPECT_TRUE(std::isinf(missed)) << missed;
  EXPECT_EQ(motion.x[1][1], -above);
  EXPECT_LE(settling.settle(system, motion, {10.0}, report), 1.0); // from here
  EXPECT_LT(motion.x[1][1], -above);
}

// A net that errs by as much as it may miss misses that in addition.
TEST(Settling, CountsWhatTheNetErrsAlready)
{
  for (const double erring : {0.0, 0.6}) {
    Oscillator oscillator(0.0, 1e-3 * Oscillator::kRate); // misses half of 1e-6
    const double share = oscillator.settling.settle(oscillator.system, oscillator.motion,
                                                    {1e-6, 0.0, 0.0, 0.0, erring * 1e-6}, oscillator.report);
    EXPECT_NEAR(share, 0.5 + erring, 1e-3);
    EXPECT_EQ(oscillator.motion.v[1][0] == 0.0, erring == 0.0);
  }
}

// What its kinetic energy says of the time in which a net fades is too short where it creeps: all that its
// springs hold has to pass the dampers, in 4 E/P with the margin for slow modes.
TEST(Settling, AsksHowLongTheDampersNeedForAllOfTheEnergy)
{
  const double away = 1e-3, energy = Oscillator::kMass * std::pow(Oscillator::kRate * away, 2);
  const double since = 1.0, fading = 0.1;
  for (const double tau : {0.05, 0.2, 0.8}) {
    Oscillator oscillator(away, Oscillator::kRate * away);
    const double square = 1e-7;
    const double share =
      oscillator.settling.settle(oscillator.system, oscillator.motion,
                                 {square, since, fading, 4.0 * energy / tau, 0.0}, oscillator.report);
    const double gain = std::min(1.0 + 2.0 * since / std::max(tau, fading), 16.0);
    EXPECT_NEAR(share, away * away / square / gain, 1e-3 * share) << tau;
  }
}

// What pulls at the end of a long chain passes through one link per iteration: too slow, so that a factor
// takes the net to its goal.
TEST(Settling, TakesAFactorWhereGradientsAreSlow)
{
  LongChain net(1e-6);
  EXPECT_TRUE(net.settling.settleIfDue(net.system, net.motion, {1.0, 0.0, 0.0}, 1e12, net.report));
  EXPECT_EQ(net.report.factorizations, 1);
  EXPECT_NEAR(net.motion.x[299][0], net.net.restPosition(0, 299), 1e-2 * 299e-6);
}

// Nets that are too large for a factor are taken to rest as well: a sheet of 12,100 nodes that swings as a
// whole, known in closed form, since all nodes move alike.
TEST(Settling, EndsTheMotionOfALargeNet)
{
  SpringNet net = beddedSheet(110);
  System system(net, {});
  MotionState motion = startOf(net);
  for (Lanes& x : motion.x) x[0] += 1e-6;
  system.enter(motion, true);
  Settling settling;
  settling.countWork(1'000'000'000);
  StepReport report;
  const double square = 1e-12 * static_cast<double>(motion.x.size());
  EXPECT_FALSE(settling.settleIfDue(system, motion, {0.9 * square, 0.0, 0.0}, 1e12, report));
  settling.forget();
  settling.countWork(1'000'000'000);
  motion.time = 10.0;
  EXPECT_TRUE(settling.settleIfDue(system, motion, {1.1 * square, 0.0, 0.0}, 1e12, report));
  EXPECT_EQ(report.factorizations, 0);
  EXPECT_NEAR(motion.x[50][0], net.restPosition(0, 50), 1e-2 * 1e-6);
  const double energy = 0.5 * 5.0 * square;
  EXPECT_NEAR(motion.heat, energy, 1e-3 * energy);
}

} // namespace esm::test
