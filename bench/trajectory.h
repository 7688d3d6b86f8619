// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/reference/method.h"
#include "bench/scenes.h"

#include <Eigen/Core>

#include <filesystem>
#include <vector>

namespace esm::bench {

using Trajectory = std::vector<Eigen::Matrix3Xd>; ///< 3 x N [m] per frame; frame 0 is the start

/// Error metric of docs/FILE_FORMAT.md: RMS of the error over RMS of the reference's displacement.
double trajectoryError(const Trajectory& reference, const Trajectory& other);

/// What errors are measured against: the textbook program (PlainNet, classical Runge-Kutta), and how far
/// another program with another method and step (FastNet, Dormand-Prince) is away from it.
struct Reference {
  Trajectory frames;
  double agreement = 0.0; ///< distance of the two; errors below ten times this mean nothing
  Scales scales;
};

/// Sums the error up, frame by frame, so that a long run needs no second trajectory.
class ErrorMeter {
public:
  explicit ErrorMeter(const Reference& reference);
  void add(std::size_t frame, const Eigen::Matrix3Xd& x);
  double error() const;
  /// Not finite, or a hundred times further away than the reference ever moves.
  bool lost() const { return m_lost; }

private:
  const Reference& m_reference;
  double m_error = 0.0, m_displacement = 0.0;
  bool m_lost = false;
};

/// Where references and tuned steps are kept: ESM_BENCH_CACHE, or esm-bench in the user's cache folder.
std::filesystem::path& cacheFolder();

/// From the cache, or computed (seconds to minutes, told on stderr) and stored there.
Reference referenceOf(const Scene& scene);

} // namespace esm::bench
