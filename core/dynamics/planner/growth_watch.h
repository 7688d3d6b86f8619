// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/system/stiffness_cg.h"

namespace esm {

/// Looks whether a motion multiplies small errors. Nets with a positive stiffness do not, so now and then
/// some products with it are asked (StiffnessCg::givesWay()). Where a net gives way, and a frame later or at a
/// later look does so once more, a small difference in that pattern is followed for some frames: two
/// neighbours, from where the motion is at the start of each frame, by plain steps at their limit (finer ones
/// without dampers), and their difference is carried over. What it grows by from any time to any later one, as
/// long as no frame was left out between them, is what becomes of an error: laid onto another phase of the
/// motion a difference would grow anew, and each time multiply what drifts.
/// Where it does not, the next frames are not followed until the work since then has paid for it; looks cost
/// a seventieth of the work. A phase or a place that drifts grows in proportion to time, without end, and
/// multiplies nothing: what counts must have come faster than that.
class GrowthWatch {
public:
  void begin(const SpringNet& net, const Loads& loads);
  /// Before a frame.
  void remember(const MotionState& motion);
  /// After it. @param passes  that it took [force passes]; carryOn() takes a dozen times that at most
  void pay(double passes) noexcept;
  bool isFollowing() const noexcept { return m_left > 0; }
  bool lookIsDue() const noexcept; ///< while it does not follow
  /// @return whether it is going to follow the next frames, by steps that bear this mode; see setMode().
  bool look(const System& system, const MotionState& motion);
  void setMode(const FastestMode& mode) noexcept;
  void carryOn(const MotionState& motion); ///< over the frame that has just been done

  double largest() const noexcept { return m_largest; } ///< factor seen so far [1], at least 1
  double time() const noexcept { return m_time; }       ///< when it was reached [s]
  double spent() const noexcept { return m_spent; }     ///< on looking and following [force passes]

private:
  void start();
  bool run(MotionState& state, double end, double step);
  double size() const noexcept;
  bool onlyDrifts() noexcept;

  const SpringNet* m_net = nullptr;
  const Loads* m_loads = nullptr;
  System m_system; ///< of the two neighbours, once there are two
  MotionState m_before, m_here, m_beside;
  NodeArray m_pattern; ///< in which the net gave way last
  NodeArray m_x, m_v;  ///< the difference [m, m/s]
  std::unique_ptr<Integrator> m_integrator;
  StiffnessCg m_stiffness;
  double m_extent = 1.0;      ///< [m]
  double m_step = 0.0;        ///< [s]
  double m_share = 0.0;       ///< of the motion's work that looks may take
  double m_work = 0.0;        ///< of the motion since the last look [force passes]
  double m_framePasses = 0.0; ///< of the last frame alone
  double m_debt = 0.0;        ///< that following has cost and the motion has not paid yet [force passes]
  double m_size = 0.0;        ///< logarithm of the difference now, as it would be had it not been made small
  double m_least = 0.0;       ///< of it so far
  int m_frames = 0;           ///< followed since then
  int m_mark = 1;             ///< a power of two of them, the last that was passed
  double m_mostSoFar = 0.0, m_mostAtMark = 0.0, m_mostAtFormerMark = 0.0; ///< of it since then
  double m_burstStart = 0.0; ///< of it, when the present frames began
  int m_left = 0;            ///< frames still to follow
  bool m_hasStart = false;
  double m_largest = 1.0, m_time = 0.0;
  double m_spent = 0.0, m_lookCost = 0.0; ///< in all, and by the last look [force passes]
  int m_timesGivenWay = 0;
  bool m_looksAgain = false; ///< in the next frame
};

} // namespace esm
