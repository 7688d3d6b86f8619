// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace esm {

struct Policy;

/// How a net is to be moved; see Simulation.
struct SolverSettings {
  std::string solver = "auto"; ///< a name of solverNames(), or "auto"
  double tolerance = 1e-3;     ///< wanted error, metric of docs/FILE_FORMAT.md (relative, RMS), > 0
  double fixedStep = 0.0; ///< [s]; > 0 takes this substep without error control (for convergence studies)
  /// Threads that may share the work, the caller's included; more than there are processors do not help, and
  /// nets of less than 30,000 springs are left to one. The motion is the same bit for bit on any number.
  int threads = 1;
  /// Spring evaluations (about 8 ns each) that `auto` may spend on a sixtieth of a second of motion. Where
  /// the tolerance asks for more, it is given up, the net stays bounded by implicit steps of up to 1/60 s,
  /// and why() says so. The default is half a second of one core; whoever keeps time with a clock asks for
  /// less.
  double effort = 1e8;
  /// Most force passes over the net for each sixtieth of a second of a run, in the mean up to the end of
  /// advance() or of `duration`, whichever is later; a step counts as one at least. At the limit advance()
  /// ends before its time (StepReport::stepLimit). `auto` plans to stay below. 0: none, for whoever keeps
  /// time with a clock and asks for little effort.
  double workLimit = 2e5;
  /// For whoever keeps time with a clock: where plain steps would cost more than the effort, `auto` moves a net
  /// of some hundreds of nodes or more by one step of `block-descent` for each sixtieth of a second, before it
  /// has tried and failed. Its error is some per cent of a hand's way, which the report calls rough.
  bool keepsTime = false;
  /// How long the motion will be looked at, from t = 0 [s]; 0 = unknown, as in a window that runs on. Errors
  /// of a short run have less time to add up, so each step may err more; beyond it the tolerance is kept as
  /// if it had never been known.
  double duration = 0.0;
  /// Nodes at rest sleep until something moves them, and cost nothing; what they miss stays within the
  /// tolerance. Without effect on fixed steps.
  bool skipResting = true;
  /// How the engine judges (core/dynamics/planner/policy.h, which is not public); null: as it is delivered. For
  /// programs that ask what one of its constants is worth. Not written to files.
  std::shared_ptr<const Policy> policy = nullptr;
};

/// The names that SolverSettings::solver takes, "auto" excluded; with one line on each.
struct SolverInfo {
  std::string name;
  std::string description;
};
std::vector<SolverInfo> solverNames();

} // namespace esm
