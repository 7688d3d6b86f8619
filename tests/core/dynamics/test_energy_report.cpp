// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Where the energy of a motion has gone: what the method loses is known by itself, and nothing is left over.
#include "core/dynamics/simulation.h"
#include "tests/support/extreme_nets.h"
#include "tests/support/methods.h"
#include "tests/support/nets.h"
#include "tests/support/one_mass.h"
#include "tests/support/physics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace esm::test {
namespace {

struct Story {
  SpringNet net;
  Loads loads;
};

/// A net that falls, swings and is pushed, of any law, with damping or without.
Story storyOf(std::uint32_t seed)
{
  constexpr SpringLaw laws[] = {SpringLaw::Linear, SpringLaw::Cubic, SpringLaw::Exponential};
  Story story{randomNet(seed, static_cast<Index>(8 + seed % 13), laws[seed % 3]), {}};
  SpringNet& net = story.net;
  if (seed % 4 == 0) net.viscosity *= 0.0;
  if (seed % 5 == 0) net.massDamping = Eigen::ArrayXd::Constant(net.nodeCount(), 0.5);
  if (seed % 2 == 0) net.fixed[0] = 1;
  if (seed % 3 == 0) addAnchor(net, 3, {0.2, 0.1, 0.9}, 40.0, 0.5);
  if (seed % 7 != 0) story.loads.gravity = {0, 0, -9.81};
  story.loads.forces.push_back(
    {{2, 5},
     {{0.05, 0.2, 0.2, 0.25}, (Eigen::Matrix3Xd(3, 4) << 0, 3, 0, 0, 0, 0, -2, 0, 0, 1, 0, 1).finished()}});
  if (seed % 4 == 1)
    story.loads.motions.push_back(
      {{1, 4},
       {{0.0, 0.1, 0.2}, (Eigen::Matrix3Xd(3, 3) << 0, 0, 0.1, 0, 0.1, 0.1, 0, 0, 0).finished()},
       0.3});
  return story;
}

EnergyReport reportOf(const Story& story, const std::string& solver, double tolerance)
{
  SolverSettings settings;
  settings.solver = solver;
  settings.tolerance = tolerance;
  settings.duration = 0.5;
  Simulation simulation = simulate(story.net, story.loads, settings);
  advanceWell(simulation, settings.duration);
  return simulation.energyReport();
}

// The residual is judged as `esm simulate` does, which calls a run beyond it not good. Where nodes of a wild
// net pass through each other, the quadrature may give up: in one run of a hundred.
TEST(EnergyReport, LeavesNothingOverInRandomNets)
{
  int over = 0;
  for (std::uint32_t seed = 1; seed <= 60; ++seed)
    for (const double tolerance : {1e-1, 1e-3, 1e-5}) {
      const EnergyReport report = reportOf(storyOf(seed), "auto", tolerance);
      over += report.isKept(tolerance) ? 0 : 1;
      EXPECT_TRUE(report.isKept(10.0 * tolerance))
        << seed << ' ' << tolerance << ": " << report.residual() << " of " << report.largestTerm();
    }
  EXPECT_LE(over, 2) << "of 180";
}

TEST(EnergyReport, LeavesNothingOverWithAnyMethod)
{
  for (const std::string& solver : methodsBut({"wavefront", "relax"}))
    for (std::uint32_t seed = 101; seed <= 104; ++seed) {
      const EnergyReport report = reportOf(storyOf(seed), solver, 1e-3);
      EXPECT_TRUE(report.isKept(1e-3))
        << solver << ' ' << seed << ": " << report.residual() << " of " << report.largestTerm();
    }
}

/// Three nodes in a row, the first held, the others led: along a corner, or away within a millisecond, or through
/// the first one.
Story ledAllOver(SpringLaw law, double viscosity, const VectorCurve& way)
{
  Story story{chain(3, 0.1, 300.0), {}};
  for (SpringLaw& one : story.net.law) one = law;
  story.net.lawParameter.setConstant(law == SpringLaw::Linear ? 0.0 : 20.0);
  story.net.viscosity.setConstant(viscosity);
  story.net.fixed[0] = 1;
  story.loads.motions.push_back({{1, 2}, way, {}});
  return story;
}

// Where every node is held or led all steps end at the same places, so no distance of ends tells how coarse they are.
// Nothing can be lost there: what the supports have done is what the springs hold, and the heat. Without dampers that
// is a closed form, to rounding of the sums; with one it is as exact as the tolerance asks.
TEST(EnergyReport, WorkOfANetThatIsLedAllOverIsWhatTheSpringsHoldAndTheHeat)
{
  const VectorCurve corner{{0.0, 0.05, 0.4},
                           (Eigen::Matrix3Xd(3, 3) << 0, 0, 0.08, 0, 0.02, 0, 0, 0, 0).finished()};
  const VectorCurve jump{{0.0, 0.1, 0.101},
                         (Eigen::Matrix3Xd(3, 3) << 0, 0, 0.03, 0, 0, 0, 0, 0, 0).finished()};
  const VectorCurve through{{0.0, 0.3}, (Eigen::Matrix3Xd(3, 2) << 0, -0.25, 0, 0, 0, 0).finished()};
  for (const char* solver : {"auto", "leapfrog", "implicit", "rk4"})
    for (const SpringLaw law : {SpringLaw::Linear, SpringLaw::Exponential})
      for (const VectorCurve* way : {&corner, &jump, &through})
        for (const double viscosity : {0.0, 0.5})
          for (const double tolerance : {1e-1, 1e-4}) {
            const EnergyReport report = reportOf(ledAllOver(law, viscosity, *way), solver, tolerance);
            const double stored = report.atEnd.total() - report.atStart.total();
            const double least = 1e-9 * report.largestTerm(); // of 450 J in between
            EXPECT_NEAR(report.work, stored + report.heat, least) << solver << ' ' << tolerance;
            EXPECT_EQ(report.loss, 0.0) << solver << ' ' << tolerance;
            EXPECT_TRUE(report.isKept(tolerance)) << solver << ' ' << tolerance;
          }
  // The rates of both springs are constant where they are led straight: heat is c v^2 t.
  const VectorCurve straight{{0.0, 0.5}, (Eigen::Matrix3Xd(3, 2) << 0, 0.1, 0, 0, 0, 0).finished()};
  const EnergyReport report = reportOf(ledAllOver(SpringLaw::Linear, 0.5, straight), "auto", 1e-3);
  EXPECT_NEAR(report.heat, 0.5 * 0.2 * 0.2 * 0.5, 1e-3 * report.largestTerm());
}

// Descent on nets of any kind: what it books is its own balance, so nothing but rounding is left over, also
// where it ends before its goal and free bodies get their momentum back. Forces of 1e9 N on flying bodies leave
// eps times what they turn over.
TEST(EnergyReport, DescentBooksWhatItRestoresToFreeBodies)
{
  int restored = 0;
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const ExtremeCase story = extremeCase(seed);
    SolverSettings settings;
    settings.solver = "descent";
    Simulation simulation = simulate(story.net, story.loads, settings);
    StepReport sum;
    for (int frame = 1; frame <= 12 && sum.good(); ++frame)
      sum.add(simulation.advance(frame / 60.0 - simulation.state().time));
    const EnergyReport report = simulation.energyReport();
    EXPECT_LE(std::abs(report.residual()), 1e-7 * report.largestTerm()) << seed;
    restored += std::abs(report.restored) > 1e-3 * report.largestTerm() ? 1 : 0;
  }
  EXPECT_GT(restored, 0) << "none of the nets asks the question";
}

// Errors of order two and more fall at least with the tolerance, so what is lost does; 3 leaves room for the
// steps, which are not exactly in proportion.
TEST(EnergyReport, LossFallsWithTheTolerance)
{
  const std::pair<std::string, std::vector<std::uint32_t>> runs[] = {{"implicit", {12, 25, 38}},
                                                                     {"leapfrog", {25, 38}}};
  for (const auto& [solver, seeds] : runs)
    for (const std::uint32_t seed : seeds) {
      double last = 0.0;
      for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
        const double lost = std::abs(reportOf(storyOf(seed), solver, tolerance).loss);
        if (last > 0.0) {
          EXPECT_LE(lost, last / 3.0) << solver << ' ' << seed << ' ' << tolerance;
        }
        last = lost;
      }
      EXPECT_GT(last, 0.0);
    }
}

/// Of 20 nodes, hung up by an anchor at one end and let go where it lies level: dampers turn as it falls.
Story hangingChain()
{
  Story story{chain(20, 0.05, 200.0), {}};
  story.net.mass.setConstant(0.01);
  story.net.viscosity.setConstant(0.05);
  addAnchor(story.net, 0, story.net.restPosition.col(0), 400.0, 0.05);
  story.loads.gravity = {0, 0, -9.81};
  return story;
}

/// Held at one end, pushed aside at the other for a tenth of a second.
Story pushedTube()
{
  constexpr Index kAround = 6, kRings = 6;
  constexpr double kRadius = 0.02, kApart = 0.02;
  SpringNet net;
  for (Index ring = 0; ring < kRings; ++ring)
    for (Index i = 0; i < kAround; ++i) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / kAround;
      addNode(net, {ring * kApart, kRadius * std::cos(angle), kRadius * std::sin(angle)});
    }
  for (Index ring = 0; ring < kRings; ++ring)
    for (Index i = 0; i < kAround; ++i) {
      const Index node = ring * kAround + i, next = ring * kAround + (i + 1) % kAround;
      addSpring(net, node, next, 60.0, 0.02);
      if (ring + 1 == kRings) continue;
      addSpring(net, node, node + kAround, 60.0, 0.02);
      addSpring(net, node, next + kAround, 60.0, 0.02);
      addSpring(net, next, node + kAround, 60.0, 0.02);
    }
  net.mass.setConstant(2e-3);
  for (Index i = 0; i < kAround; ++i) net.fixed[static_cast<std::size_t>(i)] = 1;
  NodalForce push;
  for (Index i = 0; i < kAround; ++i) push.nodes.push_back(net.nodeCount() - 1 - i);
  push.force = {{0.0, 0.1, 0.1}, (Eigen::Matrix3Xd(3, 3) << 0, 0, 0, 0, 0, 0, 0.02, 0.02, 0).finished()};
  return {net, {Eigen::Vector3d::Zero(), {push}, {}}};
}

/// That nothing holds: it flies, turns and shakes.
Story flyingBody()
{
  Story story{relaxed(11, 16), {}};
  SpringNet& net = story.net;
  net.initialVelocity.resize(3, net.nodeCount());
  for (Index i = 0; i < net.nodeCount(); ++i) {
    const Eigen::Vector3d place = net.restPosition.col(i);
    net.initialVelocity.col(i) =
      Eigen::Vector3d(1.0, 0.0, 2.0) + Eigen::Vector3d(0.0, 3.0, 1.0).cross(place) +
      0.3 * Eigen::Vector3d(std::sin(7.0 * place.z()), 0.0, std::sin(9.0 * place.x()));
  }
  story.loads.gravity = {0, 0, -9.81};
  return story;
}

// Of every method that has a tolerance and order two or more, on nets that hang, are held and fly. A fifth of the
// tolerance's share of the largest term is a tenth of what an amplitude may err by: signs cancel there, and steps at
// their limit of stability are the same for two tolerances.
TEST(EnergyReport, LossFallsWithTheToleranceOfEveryMethod)
{
  const std::pair<const char*, Story> stories[] = {
    {"chain", hangingChain()}, {"tube", pushedTube()}, {"body", flyingBody()}};
  for (const std::string& solver : accurateMethods({"multirate"}))
    for (const auto& [name, story] : stories) {
      double last = 0.0;
      for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5}) {
        const EnergyReport report = reportOf(story, solver, tolerance);
        const double lost = std::abs(report.loss), small = 0.2 * tolerance * report.largestTerm();
        if (last > 0.0) {
          EXPECT_LE(lost, std::max(last / 3.0, small)) << solver << ' ' << name << ' ' << tolerance;
        }
        EXPECT_TRUE(report.isKept(tolerance)) << solver << ' ' << name << ' ' << tolerance;
        last = lost;
      }
    }
}

// Implicit Euler takes 1/(1 + h^2 w^2) of an oscillator's energy away in each step.
TEST(EnergyReport, LossOfImplicitEulerIsThatOfItsClosedForm)
{
  SpringNet net = chain(2, 1.0, 100.0);
  net.fixed[0] = 1;
  net.restPosition(0, 1) = 1.1;
  SolverSettings settings;
  settings.solver = "lie";
  settings.fixedStep = 0.01;
  Simulation simulation = simulate(net, {}, settings);
  const double energy = simulation.energies().total();
  advanceWell(simulation, 0.5);
  const EnergyReport report = simulation.energyReport();
  const double left = energy * std::pow(1.0 + 0.01 * 0.01 * 100.0, -50.0);
  EXPECT_NEAR(report.loss, energy - left, 1e-9 * energy); // the step is linear to rounding
  EXPECT_EQ(report.heat, 0.0);
  EXPECT_EQ(report.work, 0.0);
}

// What is not accounted for is found: here energy that nobody has put in.
TEST(EnergyReport, EnergyFromNowhereIsNotKept)
{
  EnergyReport report;
  report.atStart.elastic = 1.0;
  report.atEnd.kinetic = 1.0;
  EXPECT_TRUE(report.isKept(1e-6));
  report.atEnd.elastic = 2e-3;
  EXPECT_FALSE(report.isKept(1e-3));
  EXPECT_TRUE(report.isKept(1e-2));
  report.loss = -2e-3; // the method says that it adds
  EXPECT_NEAR(report.residual(), 0.0, 1e-15);
  EXPECT_FALSE(report.isKept(1e-4)) << "that it says so makes it no better";
  EXPECT_FALSE(report.isKept(1.5e-3));
  EXPECT_TRUE(report.isKept(2.5e-3));
}

// A node of 1.3e-7 kg and 6e5 m/s on an anchor of 7.5e5 N s/m has 2.3e4 J to lose. A method that books 1.3e14 J of
// heat and as much that it has added itself balances, and is wrong.
TEST(EnergyReport, HeatBeyondAllThatWasThereIsNotKept)
{
  EnergyReport report;
  report.atStart.kinetic = report.heat = 2.3e4;
  EXPECT_TRUE(report.isKept(1e-3));
  report.heat = 1.3e14;
  report.loss = report.atStart.kinetic - report.heat;
  EXPECT_LE(std::abs(report.residual()), 1e-3 * report.largestTerm());
  EXPECT_FALSE(report.isKept(1e-3));
}

// Nobody has worked, nothing has fallen, and there is more than before: no motion does that.
TEST(EnergyReport, WhatNobodyHasPutInIsNotKept)
{
  EnergyReport report;
  report.atStart.kinetic = 1.0;
  report.atEnd.kinetic = 1.0015;
  report.loss = -0.0015; // as the method's own quadrature finds it
  EXPECT_NEAR(report.residual(), 0.0, 1e-15);
  EXPECT_NEAR(report.appeared(), 0.0015, 1e-15);
  EXPECT_FALSE(report.isKept(1e-3));
  EXPECT_TRUE(report.isKept(2e-3));
  report.work = 0.001; // a load has
  report.loss = -0.0005;
  EXPECT_TRUE(report.isKept(1e-3));
}

} // namespace
} // namespace esm::test
