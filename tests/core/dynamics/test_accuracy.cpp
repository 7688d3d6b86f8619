// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The tolerance means something: the measured error of a trajectory, in the metric of docs/FILE_FORMAT.md,
// stays below it. The reference is the bench's textbook Runge-Kutta program, which shares no code with the
// engine.
#include "bench/reference/plain_net.h"
#include "bench/scenes.h"
#include "bench/skip_scenes.h"
#include "core/dynamics/simulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace esm::test {
namespace {

struct Outcome {
  double error = 0.0;
  std::int64_t springs = 0; ///< evaluated
};

/// @param duration  that the solver is told [s]; 0 = none
Outcome outcomeOf(const bench::Scene& scene, const std::string& solver, double tolerance, int stepsPerFrame,
                  double duration)
{
  SolverSettings settings;
  settings.solver = solver;
  settings.tolerance = tolerance;
  settings.duration = duration;
  Outcome outcome;
  Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
  bench::PlainNet reference(scene.net, scene.loads);
  Eigen::Matrix3Xd start, x;
  reference.positions(start);
  double error = 0.0, displacement = 0.0;
  for (long frame = 1; frame <= scene.frames(); ++frame) {
    for (int step = 0; step < stepsPerFrame; ++step)
      reference.stepRungeKutta4(1.0 / bench::kFrameRate / stepsPerFrame);
    const StepReport report = simulation->advance(1.0 / bench::kFrameRate);
    EXPECT_TRUE(report.good()) << simulation->why();
    outcome.springs += report.springsEvaluated;
    reference.positions(x);
    error += (simulation->state().position - x).squaredNorm();
    displacement += (x - start).squaredNorm();
  }
  outcome.error = std::sqrt(error / displacement);
  return outcome;
}

/// Evaluated in the next frames.
double springsOver(Simulation& simulation, long frames)
{
  double springs = 0.0;
  for (long frame = 0; frame < frames; ++frame)
    springs += static_cast<double>(simulation.advance(1.0 / bench::kFrameRate).springsEvaluated);
  return springs;
}

double errorOf(const bench::Scene& scene, const std::string& solver, double tolerance, int stepsPerFrame)
{
  return outcomeOf(scene, solver, tolerance, stepsPerFrame, 0.0).error;
}

} // namespace

TEST(Accuracy, TrajectoryErrorStaysBelowTheTolerance)
{
  // A quarter of a second: the tube is pulled and released in it, the uterus pressed. The full length is the
  // bench's, a debug build takes minutes for it.
  for (bench::Scene scene : {bench::tube(), bench::uterus(), bench::smallSheet()}) {
    scene.duration = scene.name == "uterus" ? 0.05 : 0.25;
    for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4})
      EXPECT_LT(errorOf(scene, "auto", tolerance, 240), tolerance) << scene.name;
    EXPECT_LT(errorOf(scene, "leapfrog", 1e-2, 240), 1e-2) << scene.name;
    EXPECT_LT(errorOf(scene, "chebyshev", 1e-3, 240), 1e-3) << scene.name;
    EXPECT_LT(errorOf(scene, "stoermer3", 1e-4, 240), 1e-4) << scene.name;
  }
}

// Errors of a sheet live longer than the quarter of a second that is looked at, and a run of unknown length
// is taken to last two seconds: whoever knows its end may err more in each step.
TEST(Accuracy, AKnownEndTakesFewerStepsForTheSameTolerance)
{
  bench::Scene scene = bench::smallSheet();
  scene.duration = 0.25;
  const Outcome unknown = outcomeOf(scene, "verlet", 1e-5, 240, 0.0),
                known = outcomeOf(scene, "verlet", 1e-5, 240, scene.duration);
  EXPECT_LT(unknown.error, 1e-5);
  EXPECT_LT(known.error, 1e-5);
  EXPECT_LT(static_cast<double>(known.springs), 0.9 * static_cast<double>(unknown.springs));
}

// A run begins with the small steps that its first milliseconds ask for; `auto` goes over to a cheaper method
// as soon as one of those that it probes errs little enough, of which only what goes on to grow counts.
TEST(Accuracy, ACheaperMethodIsFoundBeforeTheMotionIsOver)
{
  const bench::Scene scene = bench::uterus();
  const Outcome one = outcomeOf(scene, "stoermer", 1e-4, 120, scene.duration),
                chosen = outcomeOf(scene, "auto", 1e-4, 120, scene.duration);
  EXPECT_LT(chosen.error, 1e-4);
  EXPECT_LT(static_cast<double>(chosen.springs), 0.9 * static_cast<double>(one.springs));
}

// Where checks are rare, a method whose probe has failed is not left out for several of them: by then the
// motion has faded, and it may do. Counted in checks alone the wait costs this tube a twentieth of its work.
TEST(Accuracy, AMethodThatFailedAProbeIsTriedAgainOnceTheMotionHasFaded)
{
  const bench::Scene scene = bench::tube();
  const auto springsOf = [&](const std::string& solver) {
    SolverSettings settings;
    settings.solver = solver;
    settings.tolerance = 2e-3;
    settings.duration = scene.duration;
    Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
    return springsOver(*simulation, scene.frames());
  };
  EXPECT_LT(springsOf("auto"), 0.91 * springsOf("chebyshev"));
}

// Ten frames at the limit of stability, which errs less than a tenth of what it may. If nobody knows that
// they are all, one of the second half is checked: half of it is then done once and once more with smaller
// steps.
TEST(Accuracy, NothingIsCheckedShortlyBeforeAKnownEnd)
{
  constexpr int kFrames = 10;
  const bench::Scene scene = bench::tube();
  const auto springsOfSecondHalf = [&](double duration) {
    SolverSettings settings;
    settings.solver = "verlet";
    settings.tolerance = 1e-1;
    settings.duration = duration;
    Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
    std::vector<std::int64_t> springs;
    for (int frame = 1; frame <= kFrames; ++frame)
      springs.push_back(simulation->advance(1.0 / bench::kFrameRate).springsEvaluated);
    springs.erase(springs.begin(), springs.begin() + kFrames / 2);
    std::sort(springs.begin(), springs.end());
    return springs;
  };
  const auto known = springsOfSecondHalf(kFrames / bench::kFrameRate), unknown = springsOfSecondHalf(0.0);
  EXPECT_LT(static_cast<double>(known.back()), 1.3 * static_cast<double>(known.front()));
  EXPECT_GT(static_cast<double>(unknown.back()), 1.5 * static_cast<double>(unknown.front()));
}

// What a tube errs while it is pulled is small but sits in its stiff patterns; once it is let go that becomes
// twenty times as large in its soft ones. Spent as any other error it ended at 3.2 times the tolerance.
TEST(Accuracy, ATubeThatIsLetGoKeepsTheToleranceToo)
{
  const bench::Scene scene = bench::tube({.seed = 128, .duration = 0.5});
  EXPECT_LT(outcomeOf(scene, "auto", 1e-4, 480, scene.duration).error, 1e-4);
  EXPECT_LT(errorOf(scene, "auto", 1e-4, 480), 1e-4);
}

// What addingUp() of the planner builds on: once a damped tube is let go, `chebyshev` is as far off within some
// frames as it will ever be, and that fades (measured: to 0.4 of the first frame's after a third of a second,
// with 25 steps a frame as with 36). `leapfrog`, which errs as much, goes on to err (to 2.0 of it): there the
// amplitudes are wrong, and errors add up. Fixed steps, as far below their limit as accuracy takes them.
TEST(Accuracy, WhatChebyshevErrsAfterAReleaseDoesNotAddUp)
{
  constexpr std::ptrdiff_t kRelease = 12, kEnd = 48; // frames
  const bench::Scene scene = bench::tube();
  /// Distances from the reference after each frame from the release on.
  const auto errorsOf = [&](const char* solver, int steps) {
    SolverSettings settings;
    settings.solver = solver;
    settings.fixedStep = 1.0 / bench::kFrameRate / steps;
    Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
    bench::PlainNet reference(scene.net, scene.loads);
    Eigen::Matrix3Xd x;
    std::vector<double> errors;
    for (std::ptrdiff_t frame = 1; frame <= kEnd; ++frame) {
      for (int step = 0; step < 240; ++step) reference.stepRungeKutta4(1.0 / bench::kFrameRate / 240);
      EXPECT_TRUE(simulation->advance(1.0 / bench::kFrameRate).good()) << simulation->why();
      reference.positions(x);
      if (frame > kRelease) errors.push_back((simulation->state().position - x).norm());
    }
    return errors;
  };
  const auto largest = [](const std::vector<double>& errors, std::ptrdiff_t first, std::ptrdiff_t last) {
    return *std::max_element(errors.begin() + first, errors.begin() + last);
  };
  const std::vector<double> offset = errorsOf("chebyshev", 36), adding = errorsOf("leapfrog", 70);
  EXPECT_LT(largest(offset, 3, kEnd - kRelease), 1.5 * largest(offset, 0, 3));
  EXPECT_LT(largest(offset, 23, 32), 0.6 * offset.front());
  EXPECT_GT(largest(adding, 23, 32), 1.2 * adding.front());
}

// A tube that swings in its first mode: there everything adds up. Counted as after a release, it ended at
// 1.47 times a tolerance of 1e-2.
TEST(Accuracy, ATubeThatSwingsInOneModeKeepsTheToleranceToo)
{
  bench::Scene scene = bench::tube({.seed = 2, .size = 0.5});
  scene.loads.motions.clear();
  scene.net.viscosity *= 0.6;
  const Eigen::Matrix3Xd& rest = scene.net.restPosition;
  const double begin = rest.row(0).minCoeff(), length = rest.row(0).maxCoeff() - begin;
  scene.net.initialVelocity = Eigen::Matrix3Xd::Zero(3, rest.cols());
  for (Index i = 0; i < scene.net.nodeCount(); ++i)
    scene.net.initialVelocity(1, i) = 0.3 * std::sin(std::numbers::pi * (rest(0, i) - begin) / length);
  for (const double tolerance : {1e-1, 1e-2})
    EXPECT_LT(outcomeOf(scene, "auto", tolerance, 240, scene.duration).error, tolerance) << tolerance;
}

// A blow's speed says little of how far it will throw: taken for 30 ms of displacement it let errors through
// that ended 12 % above a tolerance of 1e-3.
// (Organs of up to 1,500 nodes are at the edge: chance decides by which method they miss 1e-2, or keep it.)
TEST(Accuracy, AStruckOrganKeepsTheToleranceToo)
{
  const bench::SkipScene scene = bench::struckOrgan(1800, 0.3);
  for (const double tolerance : {1e-2, 1e-3})
    EXPECT_LT(errorOf(scene, "auto", tolerance, 400), tolerance) << tolerance;
}

// Wind blows a hardly damped sheet far out, falls, and leaves the errors: with all of each budget spent this
// one ended at 1.32 times the tolerance. (480 steps a frame are 9e-9 off, by halving them.)
TEST(Accuracy, ASheetThatTheWindHasLeftKeepsTheToleranceToo)
{
  const bench::Scene scene = bench::sheet({.seed = 3, .size = 0.1});
  EXPECT_LT(outcomeOf(scene, "auto", 1e-6, 480, scene.duration).error, 1e-6);
}

// Stiff nets that snap through multiply errors, which no check before sees. With steps of their own for each
// spring, for a twentieth less than plain ones cost, and with all of the budget spent this one ended at 13
// times the tolerance after a tenth of a second.
TEST(Accuracy, AStiffNetThatSnapsThroughKeepsTheToleranceToo)
{
  const bench::Scene scene = bench::stiff({.seed = 8, .size = 0.5, .duration = 0.1});
  EXPECT_LT(outcomeOf(scene, "auto", 1e-4, 10000, scene.duration).error, 1e-4);
}

// Nor does the snap find implicit steps at work, which err as much as they may, where explicit ones cost four
// times as much: left to them this one ended at 3.0 times the tolerance.
TEST(Accuracy, AStiffNetIsNotLeftToImplicitStepsAtASmallTolerance)
{
  const bench::Scene scene = bench::stiff({.seed = 4, .size = 0.5, .duration = 0.7});
  EXPECT_LT(outcomeOf(scene, "auto", 1e-3, 12000, scene.duration).error, 1e-3);
}

// A light part snaps through between two checks, in a net whose dampers take no more power then: nothing but
// what each step errs by itself tells of it. Without that this one ended at 2.5 times the tolerance.
TEST(Accuracy, ImplicitStepsSeeASnapBetweenTwoChecks)
{
  const bench::Scene scene = bench::stiff({.seed = 9, .size = 0.5, .duration = 0.4});
  EXPECT_LT(outcomeOf(scene, "implicit", 1e-3, 12000, scene.duration).error, 1e-3);
}

// Wind sets off waves in a sheet that hardly damps them, and implicit steps damp them away within a frame:
// both runs of a check do, only the energy that no damper has taken tells of it. Without that this one ended
// at 1.9 times the tolerance, and a larger one at nine times, in silence.
TEST(Accuracy, ImplicitStepsDoNotTakeAwayWaves)
{
  bench::Scene scene = bench::sheet({.size = 0.05, .duration = 6.0 / bench::kFrameRate});
  scene.net.stiffness *= 1000.0;
  EXPECT_LT(outcomeOf(scene, "auto", 1e-2, 4000, scene.duration).error, 1e-2);
}

// What a jerk costs decides nothing about the rest, unless it costs more than the rest: this tube was left to
// implicit steps when it was let go, for five times the force passes of `stoermer`.
TEST(Accuracy, AJerkDoesNotLeaveATubeToImplicitSteps)
{
  bench::Scene scene = bench::tube({.duration = 15.0 / bench::kFrameRate});
  scene.net.stiffness *= 1000.0;
  SolverSettings settings;
  settings.tolerance = 1e-2;
  settings.effort = 1e15;
  settings.duration = scene.duration;
  const auto springs = [&](const char* solver) {
    settings.solver = solver;
    Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
    return springsOver(*simulation, scene.frames());
  };
  EXPECT_LT(springs("auto"), 2.0 * springs("stoermer"));
}

// A method of high order that a small tolerance had asked for, whose checks the new effort does not pay: the
// net used to stay with it for good (1,060 force passes a frame here), as nobody learned that another one
// does for a quarter. Whichever of the two gives way first.
TEST(Accuracy, ALesserEffortIsNotSpentOnTheMethodOfABetterAccuracy)
{
  for (const double later : {0.2, 1e-4}) {
    bench::Scene scene = bench::uterus();
    scene.net.viscosity *= 4.0;
    SolverSettings settings;
    settings.tolerance = 1e-6;
    Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
    springsOver(*simulation, 3);
    const double before = springsOver(*simulation, 1);
    ASSERT_EQ(simulation->solverName(), "stoermer");
    ASSERT_TRUE(simulation->setAccuracy(later, 100.0 * static_cast<double>(scene.net.springCount())));
    EXPECT_LT(springsOver(*simulation, 4), 2.0 * before) << later;
  }
}

// Whoever asks for the stable step changes nothing, although a look at the bounds leaves traces in how the
// next one looks: the same places, bit by bit.
TEST(Accuracy, AskingForTheStableStepDoesNotChangeTheMotion)
{
  const bench::Scene scene = bench::tube();
  SolverSettings settings;
  settings.solver = "chebyshev";
  settings.duration = scene.duration;
  Result<Simulation> silent = Simulation::create(scene.net, scene.loads, settings),
                     asked = Simulation::create(scene.net, scene.loads, settings);
  EXPECT_GT(asked->stableStep(), 0.0); // once: every other look is the thorough one
  for (int frame = 0; frame < 30; ++frame) {
    silent->advance(1.0 / bench::kFrameRate);
    asked->advance(1.0 / bench::kFrameRate);
  }
  EXPECT_EQ(asked->state().position, silent->state().position);
}

// Hardly damped waves that a small part of the tolerance lets run out of phase: with Stoermer's difference
// the staged steps keep them in phase, and `auto` finds that (0.56 of the force passes here, of `verlet`
// alone).
TEST(Accuracy, ASheetIsKeptInPhase)
{
  const bench::Scene scene = bench::sheet({.seed = 2, .size = 0.1});
  const Outcome in = outcomeOf(scene, "auto", 1e-3, 480, scene.duration);
  const Outcome verlet = outcomeOf(scene, "verlet", 1e-3, 480, scene.duration);
  EXPECT_LT(in.error, 1e-3);
  EXPECT_LT(static_cast<double>(in.springs), 0.75 * static_cast<double>(verlet.springs));
}

} // namespace esm::test
