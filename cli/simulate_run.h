// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/project/project.h"

#include <string>

namespace esm::cli {

/// Where a run's results go; empty: not wanted.
struct RunOutputs {
  std::string motion;     ///< .csv, .f64 or .pvd
  std::string forceCurve; ///< CSV
  std::string mesh;       ///< the net at the end, by ending
};

/// What a run cost and came to.
struct RunSummary {
  double integrationSeconds = 0.0; ///< processor time of set-up and steps; files excluded [s]
  long long frames = 0;            ///< computed, frame 0 included
  StepReport steps;
  double nodesAwake = 0.0;   ///< at the ends of the frames, on average
  double largestForce = 0.0; ///< over all frames [N]
  Energies energies;         ///< at the end
  double externalWork = 0.0, dissipated = 0.0;
  std::string solver, reason;
};

/// Simulates round(duration * frameRate) frames after the initial one and writes the outputs. If the numerics
/// fail, what was computed until then is written all the same, and the summary's steps are not good().
/// Interrupted by a signal, it leaves nothing behind: no file of a part of the motion, no temporary one.
/// Errors: of Simulation::create() and of the files.
Result<RunSummary> runSimulation(const Project& project, const RunOutputs& outputs);

} // namespace esm::cli
