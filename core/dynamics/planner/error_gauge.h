// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/error_ledger.h"
#include "core/dynamics/system/stiffness_cg.h"
#include "core/dynamics/system/system.h"

#include <limits>

namespace esm {

/// What the motion so far was like; RMS over the nodes of the whole net.
struct ErrorScale {
  double displacement = 0.0;          ///< now [m]
  double squareOverTime = 0.0;        ///< integral of its square [m^2 s]
  double speed = 0.0, topSpeed = 0.0; ///< now and so far [m/s]
  double calm = 0.0;                  ///< since the start or the last event [s]
  double spent = 0.0;                 ///< error that stretches have added and that still lives [m]
  double spentSquare = 0.0;           ///< integral of its square [m^2 s]
  double beyond = 0.0;        ///< error that lives besides, of stretches whose tolerance was given up [m]
  double latestHeat = 0.0;    ///< of the last two frames [J]
  double latestKinetic = 0.0; ///< the same, integral [J s]
  // Of the last fifth of a second:
  double recentHeat = 0.0;    ///< [J]
  double recentKinetic = 0.0; ///< integral [J s]
  double recentPath = 0.0;    ///< integral of the squared speed [m^2/s]
};

/// Amplitudes of what oscillates fade by the rate heat / (4 kinetic energy); slow modes by half of that.
/// @return time in which they do [s], by the last fifth of a second and by the last two frames, whichever is
/// longer: a blow's first heat must not shorten what swings on after it. Infinity without damping.
double fadingTime(const ErrorScale& scale) noexcept;
/// @return power of the dampers [W], by the last fifth of a second and by the last two frames, whichever is
/// less.
double dampersPower(const ErrorScale& scale, const Policy::Errors& policy = {}) noexcept;
/// @return twice the time that a motion which creeps takes over the way from its start, at its speed of the
/// last fifth of a second [s]. Infinity at rest.
double creepingTime(const ErrorScale& scale, const Policy::Errors& policy = {}) noexcept;

/// Measures errors of stretches of motion, and knows how much of it a stretch may add, so that the error of
/// docs/FILE_FORMAT.md stays below the tolerance.
///
/// What a method errs over long is a shift in time: each mode runs late (or loses amplitude) by its own share
/// of the time that has passed, and the error that this makes dies with the mode. So after a time t of equal
/// steps the error is t times the rate at which it grows *now*, not the sum of what was added on the way: on
/// the uterus within a fifth throughout, while it falls by six decades and the sum would stay where it was.
/// ErrorScale::spent fades with the motion for that reason. Not all of a stretch's error adds up one to one:
/// that of fast waves loses its direction within milliseconds (growing()). Distances are RMS over the nodes
/// of the whole net, of which a System may be a part.
class ErrorGauge {
public:
  explicit ErrorGauge(const Policy& policy = {}) : m_policy(policy.errors), m_ledger(policy.shares) {}

  static constexpr std::size_t kFewNodes = 100; ///< a net below has few modes, and no waves among them

  /// @param duration  of the whole motion [s]; 0 = unknown
  /// @param isDriven  whether loads or tools act; else the displacement fades as errors do, and what these
  /// may have for some time because they fade, they may not.
  void begin(const NodeArray& x, double extent, double duration, bool isDriven = true);
  /// From now on positions are those of a part, whose positions at t = 0 are `rest`.
  /// @param squareElsewhere  sum of squared displacements of the other nodes [m^2]
  void setPart(NodeArray& rest, std::size_t wholeCount, double squareElsewhere) noexcept;

  const ErrorScale& scale() const noexcept { return m_scale; }
  void setScale(const ErrorScale& scale) noexcept { m_scale = scale; }
  /// The scale with one more stretch.
  /// @param error  that it has added [m], of what the tolerance allows
  /// @param beyond  that it has added besides, by strongly damped steps: it does not live long, and budgets know
  ///        nothing of it [m]
  ErrorScale scaleAfter(const System& system, const MotionState& start, const MotionState& end, double error,
                        double beyond = 0.0) const noexcept;
  /// After the first stretch since begin() has been tried: until then nothing tells how long errors live.
  void guessLifetime(const System& system, const MotionState& start, const MotionState& end) noexcept;
  void markDriven() noexcept { m_isDriven = true; } ///< something acts from now on
  /// Loads have jumped or bent.
  void markEvent() noexcept { m_scale.calm = 0.0; }
  /// When nodes that are held now will be let go, infinity if not: until then less may be spent.
  void expectRelease(double time) noexcept { m_release = time; }
  /// When the last force is gone, infinity if one stays. Within the first frame that is a blow, after which the
  /// net only swings out: what it still moves counts in the mean up to a known end, not what it moves now.
  void expectQuiet(double time) noexcept { m_quiet = time; }
  bool awaitsRelease(double time) const noexcept { return m_release < expectedEnd(time); }

  double extent() const noexcept { return m_extent; } ///< a length that positions are small against [m]
  double floor() const noexcept
  {
    return m_policy.floor * m_extent;
  }                                                         ///< displacements below it do not matter [m]
  double displacementOf(const NodeArray& x) const noexcept; ///< [m]
  double speedOf(const NodeArray& v) const noexcept;        ///< [m/s]
  /// Error that a stretch of this length may add before `state` or after it [m]: as much as could be added
  /// again and again until the end, if errors go on to fade as of late, without more than the tolerance in
  /// the mean over time.
  double budget(double tolerance, const MotionState& state, double length) const noexcept;
  /// Of that, what may be spent where waves hardly fade: what they err is still there when the motion that it
  /// was measured against is over. Less at tight tolerances, all in nets of thousands of nodes, whose errors
  /// spread over many waves.
  double lastingShare(double tolerance, double time) const noexcept;
  /// Error that the motion may still add, were it to live for good [m].
  double unspent(double tolerance, const MotionState& state) const noexcept;
  /// The part of a stretch's error that counts, as long as it lives and until the end, if it was `early` [m]
  /// after a `share` of the stretch from `time` on and is `late` [m] at its end. That shows the power of time
  /// with which it grows: with 1 it adds up one to one, 0.85 is the least that is believed of small nets,
  /// less of large ones.
  double growing(double time, double length, double early, double late, double share) const noexcept;
  /// How far apart two ends of a stretch are [m].
  double distance(const NodeArray& x, const MotionState& state) const noexcept;
  /// Readies swing() for ends near this one. Allocates when the net has changed.
  void prepareSwing(const System& system, const MotionState& state);
  /// How far apart two ends of a stretch are whichever way their difference swings just now [m]: by their
  /// distance, and by what their velocities are going to make of it.
  double swing(const System& system, double distance, const NodeArray& otherV, const MotionState& state);
  /// How much of the difference of two ends lies along the motion, 0 to 1: of their places along its velocity
  /// or displacement, or of their velocities along the latter, whichever is most. After prepareSwing().
  double alongMotion(const System& system, const NodeArray& otherX, const NodeArray& otherV,
                     const MotionState& state) const noexcept;
  /// What the same steps typically err in a net of this size, over what they do in one of up to 2,500 nodes.
  double typicalShare() const noexcept;
  /// Root of a sum of squares over nodes, outside of which it is 0, to the whole net's RMS.
  double rmsOfWhole(double root) const noexcept;
  /// From the whole net's RMS to that over `nodes` nodes, outside of which nothing errs.
  double shareOfWhole(std::size_t nodes) const noexcept;
  /// The end of the motion as seen at `time` before it or at it [s]; infinity if nobody knows it.
  double knownEnd(double time) const noexcept;

private:
  double allowance(double tolerance, const MotionState& state) const noexcept;
  double presentScale(const MotionState& state) const noexcept;
  double meanShare(const MotionState& state, double left) const noexcept;
  double timeLeft(double time) const noexcept;
  double expectedEnd(double time) const noexcept;
  double fading() const noexcept;
  double lifetime() const noexcept;
  double peak(double left, double meanSpent) const noexcept;

  Policy::Errors m_policy;
  ErrorLedger m_ledger;
  NodeArray m_rest; ///< positions at t = 0 [m]
  StiffnessCg m_stiffness;
  NodeArray m_displacement, m_momentum; ///< at prepareSwing() [m]; difference of two ends [kg m/s]
  std::size_t m_count = 0;
  double m_squareElsewhere = 0.0;
  double m_extent = 1.0;
  double m_duration = 0.0; ///< [s]
  bool m_isDriven = true;
  double m_release = std::numeric_limits<double>::infinity(); ///< see expectRelease() [s]
  double m_quiet = std::numeric_limits<double>::infinity();   ///< see expectQuiet() [s]
  double m_guessedLifetime = 0.0; ///< of errors, until motion tells it [s]; set by begin()
  ErrorScale m_scale;
};

} // namespace esm
