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

#include <cmath>

namespace esm::test {
namespace {

double errorOf(const bench::Scene& scene, const std::string& solver, double tolerance, int stepsPerFrame)
{
  SolverSettings settings;
  settings.solver = solver;
  settings.tolerance = tolerance;
  Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
  bench::PlainNet reference(scene.net, scene.loads);
  Eigen::Matrix3Xd start, x;
  reference.positions(start);
  double error = 0.0, displacement = 0.0;
  for (long frame = 1; frame <= scene.frames(); ++frame) {
    for (int step = 0; step < stepsPerFrame; ++step)
      reference.stepRungeKutta4(1.0 / bench::kFrameRate / stepsPerFrame);
    EXPECT_TRUE(simulation->advance(1.0 / bench::kFrameRate).good()) << simulation->why();
    reference.positions(x);
    error += (simulation->state().position - x).squaredNorm();
    displacement += (x - start).squaredNorm();
  }
  return std::sqrt(error / displacement);
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
  }
}

// A blow's speed says little of how far it will throw: taken for 30 ms of displacement it let errors through
// that ended 12 % above a tolerance of 1e-3.
TEST(Accuracy, AStruckOrganKeepsTheToleranceToo)
{
  const bench::SkipScene scene = bench::struckOrgan(1500, 0.3);
  for (const double tolerance : {1e-2, 1e-3})
    EXPECT_LT(errorOf(scene, "auto", tolerance, 400), tolerance) << tolerance;
}

} // namespace esm::test
