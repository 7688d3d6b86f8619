// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/energy_report.h"
#include "core/dynamics/step_report.h"
#include "core/project/project.h"

#include <optional>
#include <string>

namespace esm::cli {

/// Where a run's results go; empty: not wanted.
struct RunOutputs {
  std::string motion;     ///< .csv, .f64 or .pvd
  std::string forceCurve; ///< CSV
  std::string mesh;       ///< the net at the end, by ending
  std::string log;        ///< of the run, see MotionLogWriter
};

/// What finer runs have said of the one that was written, see ToleranceCheck.
struct Verification {
  bool kept = false;                   ///< the tolerance, as far as runs can tell
  std::optional<double> measuredError; ///< relative, as the tolerance; none if a finer run failed
  double worstTime = 0.0;              ///< when it is largest [s]
  double toleranceUsed = 0.0;          ///< with which the motion that was written was run [1]
  double seconds = 0.0;                ///< processor time of the other runs [s]
  std::string why;
};

/// What a run cost and came to.
struct RunSummary {
  double integrationSeconds = 0.0; ///< processor time of set-up and steps; files excluded [s]
  Index nodes = 0, springs = 0;    ///< of the net
  long long frames = 0;            ///< computed, frame 0 included
  StepReport steps;
  double nodesAwake = 0.0;                 ///< at the ends of the frames, on average
  double largestForce = 0.0;               ///< over all frames [N]
  EnergyReport energy;                     ///< since t = 0
  std::vector<EnergyReport> energyOfParts; ///< that move on their own
  double errorGrowth = 1.0,
         errorGrowthTime = 0.0; ///< see Simulation; not looked for in runs that are verified
  std::string solver, reason;
  long long roughFrames = 0;                ///< in which the tolerance was given up
  double roughTime = 0.0;                   ///< end of the first of them [s]
  std::string roughReason;                  ///< then
  std::string suddenMotion;                 ///< that had come by then and that no step follows; empty: none
  std::optional<Verification> verification; ///< if asked for
};

/// Simulates round(duration * frameRate) frames after the initial one and writes the outputs. If the numerics
/// fail, what was computed until then is written all the same, and the summary's steps are not good().
/// Interrupted by a signal, it leaves nothing behind: no file of a part of the motion, no temporary one.
/// Takes the project's net: two of a large one would be a fifth more memory.
/// Errors: of Simulation::create() and of the files.
Result<RunSummary> runSimulation(Project& project, const RunOutputs& outputs);

/// The same, and again with a tenth of the tolerance until two runs agree; the outputs are those of the run
/// that keeps the tolerance, or of the finest. Keeps one motion in memory.
/// Errors: as above; InvalidValue for a motion beyond half of the machine's memory.
Result<RunSummary> runVerified(const Project& project, const RunOutputs& outputs);

} // namespace esm::cli
