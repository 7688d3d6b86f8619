// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/net_state.h"
#include "core/dynamics/solver_settings.h"
#include "core/dynamics/step_report.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace esm {

/// Whether a motion keeps its tolerance, found by doing it again with a tenth of it, and what to do if not.
///
/// Steps are chosen by what each of them errs. How much of that the motion makes of it later no step can
/// tell: a net that snaps through multiplies it by thousands. Two whole runs tell, by the metric of
/// docs/FILE_FORMAT.md. Where they are too far apart, the finer one is held against one that is finer still,
/// and so on. A run with a solver or a step of the user's own is only measured: it is what was asked for.
///
///     ToleranceCheck check(settings);
///     do {
///       auto simulation = Simulation::create(net, loads, check.settings());
///       check.start(simulation->state());
///       for each frame: check.add(simulation->state(), simulation->advance(...));
///     } while (ToleranceCheck::isOpen(check.endRun(report)));
///
/// Steps at their limit of stability are as large with a tenth of the tolerance: two such runs would agree
/// whatever they err. So the run that judges is done with ever less until it takes more steps in most frames.
///
/// Plain data and arithmetic; any one thread.
class ToleranceCheck {
public:
  /// What becomes of the run that has just ended.
  enum class Next {
    RunAgain,     ///< keep it, forget the one before, and do it again with settings()
    MeasureAgain, ///< keep the one before, forget this one, and do it again with settings()
    TakeFormer,   ///< the one before is the result
    TakeThis,     ///< it is the result itself: there is nothing finer
  };
  static bool isOpen(Next next) noexcept { return next == Next::RunAgain || next == Next::MeasureAgain; }

  /// @param asked  with the tolerance that is to be kept
  explicit ToleranceCheck(SolverSettings asked);

  const SolverSettings& settings() const noexcept { return m_settings; } ///< of the run to come
  void start(const NetState& state); ///< before the first frame of each run
  /// A frame has been done. @pre the same frames in each run
  void add(const NetState& state, const StepReport& frame);
  /// @param report  of the whole run
  Next endRun(const StepReport& report);

  // === After the last run
  bool kept() const noexcept { return m_kept; } ///< by the result, as far as two runs can tell
  /// Of the result from the finest run, relative as the tolerance; of a result that is the finest itself,
  /// from the one before. None if no other run succeeded.
  std::optional<double> measuredError() const noexcept { return m_error; }
  double worstTime() const noexcept { return m_worstTime; }             ///< when they are furthest apart [s]
  double resultTolerance() const noexcept { return m_resultTolerance; } ///< with which the result was run [1]
  std::string why() const;                                              ///< one English sentence

  /// What add() keeps of this many frames of this many nodes [bytes].
  static double memory(double frames, double nodes) noexcept;

private:
  bool isNamed() const noexcept;
  Next end(Next next, bool kept) noexcept;
  Next judge();
  bool isFiner() const noexcept;
  bool refine();

  SolverSettings m_asked, m_settings;
  int m_runs = 0;
  std::vector<Eigen::Matrix3Xd> m_former;  ///< positions of the run before, replaced frame by frame [m]
  std::vector<std::int64_t> m_steps;       ///< of each frame of this run
  std::vector<std::int64_t> m_resultSteps; ///< the same of the run that may be the result
  Eigen::Matrix3Xd m_start;
  double m_apart = 0.0, m_displacement = 0.0; ///< sums of squares over nodes and frames [m^2]
  double m_worst = 0.0;                       ///< largest part of the former in a frame [m^2]
  double m_worstTime = 0.0;                   ///< [s]
  std::optional<double> m_error;              ///< of the result from the latest run, over those in between
  double m_resultTolerance = 0.0, m_finerTolerance = 0.0;
  bool m_kept = false, m_failed = false, m_rough = false;
};

} // namespace esm
