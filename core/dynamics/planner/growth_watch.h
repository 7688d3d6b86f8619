// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/growth_tally.h"
#include "core/dynamics/planner/neighbour_motion.h"
#include "core/dynamics/system/stiffness_cg.h"

namespace esm {

/// Looks whether a motion multiplies small errors. Nets with a positive stiffness do not, so now and then
/// some products with it are asked (StiffnessCg::givesWay()). Where a net gives way, and a frame later or at a
/// later look does so once more, a small difference in that pattern is followed for some frames, from where the
/// motion is at the start of each frame (NeighbourMotion). What it grows by counts from any time to any later one, as
/// long as no frame was left out between them (GrowthTally): laid onto another phase of the
/// motion a difference would grow anew, and each time multiply what drifts.
/// Where it does not, the next frames are not followed until the work since then has paid for it; looks cost
/// a seventieth of the work.
class GrowthWatch {
public:
  explicit GrowthWatch(const Policy::Growth& policy = {}) : m_policy(policy), m_tally(policy.driftPower) {}
  GrowthWatch(const GrowthWatch&) = delete;
  GrowthWatch& operator=(const GrowthWatch&) = delete;

  void begin(const SpringNet& net, const Loads& loads);
  /// Before a frame.
  void remember(const MotionState& motion);
  /// After it. @param passes  that it took [force passes]; carryOn() takes a dozen times that at most
  void pay(double passes) noexcept;
  bool isFollowing() const noexcept { return m_left > 0; }
  bool lookIsDue() const noexcept; ///< while it does not follow
  /// @return whether it is going to follow the next frames, by steps that bear this mode; see setMode().
  bool look(const System& system, const MotionState& motion);
  void setMode(const FastestMode& mode) noexcept { m_neighbour.setMode(mode); }
  void carryOn(const MotionState& motion); ///< over the frame that has just been done

  double largest() const noexcept { return m_largest; } ///< factor seen so far [1], at least 1
  double time() const noexcept { return m_time; }       ///< when it was reached [s]
  double spent() const noexcept { return m_spent; }     ///< on looking and following [force passes]

private:
  /// What looking may cost, all in force passes.
  struct Account {
    double work = 0.0;        ///< of the motion since the last look
    double framePasses = 0.0; ///< of the last frame alone
    double debt = 0.0;        ///< that following has cost and the motion has not paid yet
    double lookCost = 0.0;    ///< of the last look
  };
  void stop() noexcept;

  const Policy::Growth m_policy;
  const SpringNet* m_net = nullptr;
  const Loads* m_loads = nullptr;
  NodeArray m_pattern; ///< in which the net gave way last
  StiffnessCg m_stiffness;
  NeighbourMotion m_neighbour{m_policy};
  GrowthTally m_tally;
  Account m_account;
  bool m_isDamped = false;
  int m_left = 0; ///< frames still to follow
  int m_timesGivenWay = 0;
  bool m_looksAgain = false; ///< in the next frame
  double m_largest = 1.0, m_time = 0.0;
  double m_spent = 0.0; ///< in all [force passes]
};

} // namespace esm
