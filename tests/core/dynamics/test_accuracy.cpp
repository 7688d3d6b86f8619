// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The tolerance means something: the measured error of a trajectory, in the metric of docs/FILE_FORMAT.md,
// stays below it. The reference is the bench's textbook Runge-Kutta program, which shares no code with the
// engine.
#include "bench/scenes.h"
#include "bench/work_precision.h"

#include <gtest/gtest.h>

namespace esm::testing {

TEST(Accuracy, TrajectoryErrorStaysBelowTheTolerance)
{
  for (bench::Scene scene : {bench::tube(), bench::uterus()}) {
    // A quarter of a second: the tube is pulled and released in it, the uterus pressed. The full length is
    // the bench's, a debug build takes minutes for it.
    scene.duration = scene.name == "tube" ? 0.25 : 0.05;
    bench::Trajectory reference, other;
    ASSERT_TRUE(bench::runPlain(scene, "plain_rk4", 240, &reference).good);
    for (const double tolerance : {1e-2, 1e-3}) {
      const bench::Row row = bench::runEngine(scene, "auto", tolerance, 0.0, scene.duration, &other);
      ASSERT_TRUE(row.good);
      EXPECT_LT(bench::trajectoryError(reference, other), tolerance) << scene.name << " with " << row.solver;
    }
  }
}

} // namespace esm::testing
