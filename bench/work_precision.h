// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/scenes.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace esm::bench {

using Trajectory = std::vector<Eigen::Matrix3Xd>; ///< frame 0 is the start

struct Row {
  std::string scene, solver;
  double tolerance = 0.0; ///< 0 for hand-chosen steps
  double step = 0.0;      ///< fixed step, or the smallest taken [s]
  double seconds = 0.0;   ///< processor time with set-up
  double error = 0.0;     ///< RMS of the error over RMS of the displacement; NaN without reference
  std::int64_t springs = 0;
  std::uint64_t hash = 0; ///< of the last positions and velocities
  bool good = true;
};

/// Error metric of docs/FILE_FORMAT.md.
double trajectoryError(const Trajectory& reference, const Trajectory& other);

/// Runs the engine. fixedStep > 0 goes without error control.
Row runEngine(const Scene& scene, const std::string& solver, double tolerance, double fixedStep,
              double duration, Trajectory* trajectory);

/// Runs the textbook program, "plain_euler" or "plain_rk4", with `stepsPerFrame`.
Row runPlain(const Scene& scene, const std::string& method, int stepsPerFrame, Trajectory* trajectory);

} // namespace esm::bench
