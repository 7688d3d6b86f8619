// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/replay/replay.h"

#include <vector>

namespace esm {

/// The force that the hand should have felt: the net at its project's own accuracy, led at 5 kHz by where the
/// grip truly was, without frames, servo, limits or device in between.
/// At 5 kHz it is within 1.0 % of what it is at 20 kHz (the sample uterus, pressed).
/// @param stepsPerTick  of the tool; 5 are 5 kHz with ticks of 1 ms. @pre positive.
/// @return on the hand at each tick's time, 3 x ticks.size() [N]. Errors: as Simulation; Numerics where the
/// net did not bear the way of the grip.
Result<Eigen::Matrix3Xd> trueForce(const ReplayScene& scene, const std::vector<ReplayTick>& ticks,
                                   int stepsPerTick = 5);

/// How far what was felt is from what was true, over the largest true force.
struct ForceError {
  double peak = 0.0;            ///< largest true force [N]
  double most = 0.0, rms = 0.0; ///< [1]
};

/// From the first tick on that has faded in; all zero if there is none.
/// @param scale  of the force felt over that of the tissue [1].
ForceError forceError(const std::vector<ReplayTick>& ticks, const Eigen::Matrix3Xd& truth,
                      double scale = 1.0);

} // namespace esm
