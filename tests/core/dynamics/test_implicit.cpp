// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// What the implicit methods share: their matrix, the life of a factor; and the linearised Euler method.
#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/system/implicit_matrix.h"
#include "tests/support/nets.h"
#include "tests/support/physics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace esm::test {
namespace {

struct Motion {
  System system;
  std::unique_ptr<Integrator> method;
  MotionState state;
  StepReport report;
};

Motion begin(const SpringNet& net, const Loads& loads, std::unique_ptr<Integrator> method, double tolerance)
{
  Motion motion{System(net, loads), std::move(method), startOf(net), {}};
  motion.system.enter(motion.state, true);
  motion.method->prepare(motion.system);
  motion.method->setSolveTolerance(tolerance, false);
  return motion;
}

StepResult go(Motion& motion, double h, int steps)
{
  for (int i = 0; i < steps; ++i)
    if (const StepResult result =
          motion.method->step(motion.system, motion.state, h, motion.state.time + h, motion.report);
        result != StepResult::Done)
      return result;
  return StepResult::Done;
}

double fallEnergy(const Motion& motion)
{
  return motion.system.kineticEnergy(motion.state.v) +
         motion.system.forces().gravityEnergy(motion.state.x.data());
}

SpringNet hungSheet(double stiffer)
{
  SpringNet net = sheet(10, 0.01, 200.0 * stiffer);
  net.mass.setConstant(3e-5);
  net.viscosity.setConstant(0.02);
  for (Index i = 0; i < 10; ++i) net.fixed[static_cast<std::size_t>(i)] = 1;
  return net;
}

/// Held and stretched on all sides, so that it swings calmly; hungSheet() falls, folds and whips.
SpringNet framedSheet()
{
  SpringNet net = hungSheet(1.0);
  net.restLength *= 0.9;
  for (Index i = 0; i < 10; ++i)
    for (const Index rim : {90 + i, 10 * i, 10 * i + 9}) net.fixed[static_cast<std::size_t>(rim)] = 1;
  return net;
}

Loads weight()
{
  Loads loads;
  loads.gravity = {0, -9.81, 1.0};
  return loads;
}

} // namespace

// A mass on a spring swings as a cosine. What TR-BDF2 says that a step has erred in place is what it is off
// by, but for the error of its companion, which is smaller by h w (tolerance: twice that). Steps add up, and
// are forgotten once they have been told.
TEST(Implicit, StepsTellWhatTheyErr)
{
  SpringNet net = chain(2);
  net.fixed[0] = 1;
  net.mass.setConstant(0.5);
  net.stiffness.setConstant(200.0); // w = 20 / s
  net.viscosity.setZero();
  net.restPosition(0, 1) = 1.1;
  net.restLength.setConstant(1.0);
  for (const double angle : {0.02, 0.05}) {
    Motion motion = begin(net, {}, makeIntegrator("implicit"), 1e-15);
    ASSERT_EQ(go(motion, angle / 20.0, 10), StepResult::Done);
    const double sum = motion.method->takeLocalError();
    const double x = motion.state.x[1][0] - 1.0, v = motion.state.v[1][0];
    ASSERT_EQ(go(motion, angle / 20.0, 1), StepResult::Done);
    const double off =
      std::abs(motion.state.x[1][0] - 1.0 - x * std::cos(angle) - v / 20.0 * std::sin(angle));
    const double told = motion.method->takeLocalError();
    EXPECT_NEAR(told, off, 2.0 * angle * off);
    double sines = 0.0; // what a step errs is in proportion to the speed
    for (int step = 0; step < 10; ++step) sines += std::sin((step + 0.5) * angle);
    sines /= std::sin(10.5 * angle);
    EXPECT_NEAR(sum, told * sines, 2.0 * angle * sum);
    EXPECT_EQ(motion.method->takeLocalError(), 0.0);
  }
}

// factor() and solve() undo multiply(), nodes that are held take no part; the same after a held node has been
// released and another one been held.
TEST(ImplicitMatrix, SolveUndoesMultiply)
{
  SpringNet net = randomNet(9, 40);
  addAnchor(net, 5, {1, 2, 3}, 30.0, 0.4);
  net.massDamping = Eigen::ArrayXd::Constant(40, 0.3);
  net.fixed[7] = 1;
  Loads loads;
  PrescribedMotion early, late;
  early.nodes = {11};
  late.nodes = {20};
  for (PrescribedMotion* motion : {&early, &late}) {
    motion->displacement.time = {0.0};
    motion->displacement.value = Eigen::Vector3d::Zero();
  }
  early.release = 0.5;
  loads.motions = {early, late};
  System system(net, loads);
  MotionState state;
  state.x.resize(40);
  copyNodes(net.restPosition, state.x);
  state.v.assign(40, Lanes{0.1, 0, -0.2, 0});
  system.enter(state, true);
  ImplicitMatrix matrix;
  matrix.prepare(system);
  for (const std::size_t freeNodes : {37u, 38u}) {
    ASSERT_EQ(matrix.freeCount(), freeNodes);
    ASSERT_TRUE(matrix.factor(system, state.x, state.v, ImplicitMatrix::Shares::ofStep(0.02), false));
    NodeArray vector(40), product(40);
    for (std::size_t i = 0; i < 40; ++i)
      vector[i] =
        system.isFree(i) ? Lanes{1.0 + static_cast<double>(i % 5), -2.0, 0.5, 0} : Lanes{0, 0, 0, 0};
    matrix.multiply(vector, product);
    EXPECT_EQ(dot(product[7], product[7]), 0.0);
    matrix.solve(product);
    for (std::size_t i = 0; i < 40; ++i)
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(product[i][axis], vector[i][axis], 1e-11) << "node " << i;
    state.time = 0.5;
    system.enter(state, false);
    matrix.constraintsChanged(system);
  }
}

// The matrix is the derivative of the residual M v - s F(x0 + s v, v): differences of forces agree. The shear
// of dampers is left out of the comparison by a net at rest, where it vanishes.
TEST(ImplicitMatrix, IsTheDerivativeOfTheResidual)
{
  for (const SpringLaw law : {SpringLaw::Linear, SpringLaw::Cubic, SpringLaw::Exponential}) {
    const SpringNet net = randomNet(3, 20, law);
    System system(net, {});
    MotionState state = startOf(net);
    system.enter(state, true);
    ImplicitMatrix matrix;
    matrix.prepare(system);
    const double s = 0.1, change = 1e-6;
    ASSERT_TRUE(matrix.factor(system, state.x, state.v, ImplicitMatrix::Shares::ofStep(s), false));
    NodeArray direction(20), product(20), plus(20), minus(20);
    for (std::size_t i = 0; i < 20; ++i) direction[i] = Lanes{1, static_cast<double>(i % 3) - 1.0, 0.5, 0};
    matrix.multiply(direction, product);
    for (const double sign : {1.0, -1.0}) {
      NodeArray x = state.x, v = state.v;
      for (std::size_t i = 0; i < 20; ++i) {
        v[i] += direction[i] * (sign * change);
        x[i] += v[i] * s;
      }
      system.evaluate(0.0, x, v, sign > 0 ? plus : minus);
    }
    double scale = 0.0;
    for (const Lanes& value : product) scale = std::max(scale, std::sqrt(dot(value, value)));
    for (std::size_t i = 0; i < 20; ++i) {
      const Lanes slope = direction[i] * system.mass()[i] - (plus[i] - minus[i]) * (0.5 * s / change);
      // Central differences of an O(1) force: truncation 1e-12, rounding 1e-16/1e-6.
      for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(product[i][axis], slope[axis], 1e-7 * scale);
    }
  }
}

// A calm swing: one factor serves for many steps, and a stage needs hardly more than two solutions.
TEST(Implicit, OneFactorServesManySteps)
{
  Motion motion = begin(framedSheet(), weight(), makeIntegrator("implicit"), 1e-8);
  ASSERT_EQ(go(motion, 1e-3, 400), StepResult::Done);
  EXPECT_LT(motion.report.factorizations, 40);
  EXPECT_LT(motion.report.newtonIterations, 400 * 2 * 3);
  EXPECT_GT(motion.report.factorizations, 0);
}

// The tolerance of the stages bounds what old factors and extrapolated guesses may add: against stages solved
// to rounding the end differs by less than the sum of what every stage was granted.
TEST(Implicit, StageToleranceBoundsTheDifference)
{
  Motion exact = begin(framedSheet(), weight(), makeIntegrator("implicit"), 1e-14);
  ASSERT_EQ(go(exact, 2e-3, 100), StepResult::Done);
  for (const double tolerance : {1e-6, 1e-8}) {
    Motion motion = begin(framedSheet(), weight(), makeIntegrator("implicit"), tolerance);
    ASSERT_EQ(go(motion, 2e-3, 100), StepResult::Done);
    double sum = 0.0;
    for (std::size_t i = 0; i < motion.state.x.size(); ++i) {
      const Lanes away = motion.state.x[i] - exact.state.x[i];
      sum += dot(away, away);
    }
    EXPECT_LT(std::sqrt(sum / 100.0), 200 * tolerance);
  }
}

// Steps of a sixtieth of a second, from tissue to a million times stiffer: the net moves no faster than its
// fall allows (springs may overshoot: a turn is a straight line to one linear system), no step fails, none
// takes more than one factor.
TEST(LinearizedEuler, IsBoundedAtFrameStepsWhateverTheStiffness)
{
  for (const double stiffer : {1.0, 1e2, 1e4, 1e6}) {
    Motion motion = begin(hungSheet(stiffer), weight(), makeIntegrator("lie"), 0.0);
    const double start = fallEnergy(motion);
    for (int frame = 0; frame < 120; ++frame) {
      ASSERT_EQ(go(motion, 1.0 / 60.0, 1), StepResult::Done) << stiffer;
      ASSERT_LT(fallEnergy(motion), start * (1.0 + 1e-9)) << stiffer << " frame " << frame;
    }
    EXPECT_LE(motion.report.factorizations, 120);
    for (const Lanes& x : motion.state.x) EXPECT_LT(std::sqrt(dot(x, x)), 0.5);
  }
}

// First order: halving the step halves the error of an oscillator, x = cos(w t) about its rest length.
TEST(LinearizedEuler, IsOfFirstOrder)
{
  SpringNet net = chain(2, 1.0, 40.0);
  net.restPosition(0, 1) = 1.1;
  net.restLength[0] = 1.0;
  net.fixed[0] = 1;
  const double w = std::sqrt(40.0), time = 0.5, exact = 1.0 + 0.1 * std::cos(w * time);
  double errors[2] = {};
  for (const int steps : {1000, 2000}) {
    Motion motion = begin(net, {}, makeIntegrator("lie"), 0.0);
    ASSERT_EQ(go(motion, time / steps, steps), StepResult::Done);
    errors[steps == 1000 ? 0 : 1] = std::abs(motion.state.x[1][0] - exact);
  }
  EXPECT_NEAR(errors[0] / errors[1], 2.0, 0.05);
}

} // namespace esm::test
