// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/dynamics/solver_settings.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// What can give way when a scene is too heavy for the clock.
enum class QualityMeasure : std::uint8_t {
  Tolerance, ///< a looser tolerance, in steps of about 5, down to the lowest allowed one
  Effort,    ///< fewer spring evaluations per frame: the solver goes rough or implicit sooner
  SlowMotion ///< the clock; what stands after it never gives way
};

/// The user's wishes: what gives way first, and how far. Plain data.
struct QualityPlan {
  std::vector<QualityMeasure> order = usualOrder();
  double finest = 1e-2;  ///< tolerance wanted on the clock; the project's own holds where it is looser
  double coarsest = 0.2; ///< lowest allowed accuracy
  double effort = 2e6;   ///< wanted, see SolverSettings: about a half of each frame

  static std::vector<QualityMeasure> usualOrder(); ///< tolerance, effort, slow motion
  /// Nothing but the clock gives way, whatever the settings ask for.
  static QualityPlan clockOnly();
  bool operator==(const QualityPlan&) const = default;
};

/// "tolerance,effort,slow-motion" and back. Errors: InvalidValue for other words or a word given twice.
std::string formatQualityOrder(const std::vector<QualityMeasure>& order);
Result<std::vector<QualityMeasure>> parseQualityOrder(std::string_view text);

/// Where the ladder stands; part of SimSnapshot.
struct QualityState {
  std::size_t rung = 0, lastRung = 0; ///< 0: as wanted; last: nothing is left but slow motion
  QualityMeasure measure = QualityMeasure::SlowMotion; ///< that led to this rung, if it is not 0
  double wantedTolerance = 0.0, tolerance = 0.0;       ///< on rung 0, and in force
  double effort = 0.0;                                 ///< in force
};

/// Keeps simulated time on the wall clock by giving up accuracy, rung by rung in the user's order:
///
///     0  tolerance 1e-2, effort 2e6       as wanted
///     1  tolerance 5e-2, effort 2e6       down while frames take > 0.9 of their period,
///     2  tolerance 2e-1, effort 2e6         for some frames
///     3  tolerance 2e-1, effort 5e5       up while they take < 0.5 of it, for a second;
///     4  tolerance 2e-1, effort 1.3e5     longer each time that it proves too early
///     5  slow motion                      FrameClock lets the time go that cannot be caught up
///
/// Single dear frames (the solver checks its error now and then) do not count, a series does. After each
/// change a moment passes unjudged, for the solver to find its steps. While nothing moves it goes up a rung a
/// second, which proves nothing: what the motion before needed is kept in mind, and where the next one is too
/// dear again it goes back there at once. Only arithmetic: the caller brings the times, tests bring invented
/// ones. All times in [s].
class QualityLadder {
public:
  QualityLadder() : QualityLadder(QualityPlan::clockOnly()) {}
  explicit QualityLadder(QualityPlan plan);

  /// Another scene, or other wishes: from the top rung on.
  void setPlan(QualityPlan plan);
  void start(const SolverSettings& wanted);

  /// A frame of `period` has taken `took` (waiting excluded). @return whether another rung is in force now.
  /// @param isAtRest  nothing moved in it
  bool endFrame(double took, double period, bool isAtRest = false) noexcept;

  double tolerance() const noexcept { return m_rungs[m_rung].tolerance; }
  double effort() const noexcept { return m_rungs[m_rung].effort; }
  QualityState state() const noexcept;

private:
  struct Rung {
    QualityMeasure measure;
    double tolerance, effort;
  };
  void build();
  bool endRestingFrame(double passed) noexcept;
  bool moveTo(std::size_t rung) noexcept;
  bool accuracyRises() const noexcept;

  QualityPlan m_plan;
  double m_wantedTolerance = 1e-3, m_wantedEffort = 1e8; ///< the scene's
  bool m_fixedStep = false;                              ///< then accuracy is nothing to choose
  std::vector<Rung> m_rungs;                             ///< never empty
  std::size_t m_rung = 0;
  double m_unjudged = 0.0; ///< time
  int m_heavy = 0;         ///< frames too dear, less those that were not
  double m_light = 0.0, m_patience = 0.0;
  double m_sinceRise = 0.0;     ///< since the last way up that was tried in motion
  std::size_t m_formerRung = 0; ///< that the motion before a rest needed; 0: nothing is known
  double m_inMotion = 0.0;      ///< since the last rest
};

} // namespace esm
