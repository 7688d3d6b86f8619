// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/system.h"

#include <limits>

namespace esm {

/// What the motion so far was like; RMS over the nodes of the whole net.
struct ErrorScale {
  double displacement = 0.0;          ///< now [m]
  double squareOverTime = 0.0;        ///< integral of its square [m^2 s]
  double speed = 0.0, topSpeed = 0.0; ///< now and so far [m/s]
  double calm = 0.0;                  ///< since the start or the last event [s]
  double spent = 0.0;                 ///< error that stretches have added and that still lives [m]
  // Of the last fifth of a second:
  double recentHeat = 0.0;    ///< [J]
  double recentKinetic = 0.0; ///< integral [J s]
  double recentPath = 0.0;    ///< integral of the squared speed [m^2/s]
};

/// Amplitudes of what oscillates fade by the rate heat / (4 kinetic energy); slow modes, where errors gather,
/// by a quarter of that. @return time in which they do, as of late [s]; infinity without damping
double fadingTime(const ErrorScale& scale) noexcept;

/// Measures errors of stretches of motion, and knows how much of it a stretch may add, so that the error of
/// docs/FILE_FORMAT.md stays below the tolerance.
///
/// An error lives as long as the motion's damping lets it (horizon()). Were errors to add up one to one, a
/// stretch could have only its share of that time; those of fast waves do not, but lose their direction or
/// fade within milliseconds, and add up like the steps of a random walk. Which it is shows inside a stretch:
/// its error grows with a power of time (errorPower()), and the share of the budget goes with the same power.
/// Motion errs unevenly: what calm stretches leave of their shares, a lively one may have
/// (ErrorScale::spent). Distances are RMS over the nodes of the whole net, of which a System may be a part.
class ErrorGauge {
public:
  static constexpr std::size_t kFewNodes = 100; ///< a net below has few modes, and no waves among them

  /// @param duration  of the whole motion [s]; 0 = unknown
  void begin(const NodeArray& x, double extent, double duration);
  /// From now on positions are those of a part, whose positions at t = 0 are `rest`.
  /// @param squareElsewhere  sum of squared displacements of the other nodes [m^2]
  void setPart(NodeArray& rest, std::size_t wholeCount, double squareElsewhere) noexcept;

  const ErrorScale& scale() const noexcept { return m_scale; }
  void setScale(const ErrorScale& scale) noexcept { m_scale = scale; }
  /// The scale with one more stretch.
  /// @param error  that it has added [m]
  /// @param power  with which errors grow over time, see errorPower()
  ErrorScale scaleAfter(const System& system, const MotionState& start, const MotionState& end, double error,
                        double power) const noexcept;
  /// After the first stretch since begin() has been tried: until then nothing tells how long errors live.
  void guessLifetime(const System& system, const MotionState& start, const MotionState& end) noexcept;
  /// Loads have jumped or bent.
  void markEvent() noexcept { m_scale.calm = 0.0; }
  /// When nodes that are held now will be let go, infinity if not: until then less may be spent.
  void expectRelease(double time) noexcept { m_release = time; }

  double extent() const noexcept { return m_extent; }       ///< a length that positions are small against [m]
  double floor() const noexcept { return 1e-6 * m_extent; } ///< displacements below it do not matter [m]
  double displacementOf(const NodeArray& x) const noexcept; ///< [m]
  double speedOf(const NodeArray& v) const noexcept;        ///< [m/s]
  /// Error that a stretch of this length may add before `state` or after it [m].
  /// @param power with which errors grow over time, see errorPower()
  double budget(double tolerance, const MotionState& state, double length, double power) const noexcept;
  /// Error that the motion may still add, were it to live for good [m].
  double unspent(double tolerance, const MotionState& state) const noexcept;
  /// The power of time with which an error has grown that was `early` [m] after a `share` of the stretch and
  /// `late` [m] at its end: 1 adds up without end, 0.85 is the least that is believed.
  static double errorPower(double early, double late, double share) noexcept;
  /// How far apart two ends of a stretch are [m].
  double distance(const NodeArray& x, const MotionState& state) const noexcept;
  /// How far apart their slow motion will bring them [m].
  double slowDistance(const System& system, const NodeArray& v, const MotionState& state) const noexcept;
  /// From the whole net's RMS to that over `nodes` nodes, outside of which nothing errs.
  double shareOfWhole(std::size_t nodes) const noexcept;

private:
  double allowance(double tolerance, const MotionState& state) const noexcept;
  double lifetime() const noexcept;
  double knownEnd(double time) const noexcept;
  double horizon(double time) const noexcept;

  NodeArray m_rest; ///< positions at t = 0 [m]
  std::size_t m_count = 0;
  double m_squareElsewhere = 0.0;
  double m_extent = 1.0;
  double m_duration = 0.0;                                    ///< [s]
  double m_release = std::numeric_limits<double>::infinity(); ///< see expectRelease() [s]
  double m_guessedLifetime = 0.0; ///< of errors, until motion tells it [s]; set by begin()
  ErrorScale m_scale;
};

} // namespace esm
