// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"
#include "core/net/spring_net.h"

namespace esm {

/// How far a net can be pushed in before it loses its balance. Springs that are pressed push sideways; a net
/// that carries a little poke may snap under a deep one.
struct PushTest {
  bool isDone = false; ///< false: nothing was pushed, the other numbers are 0
  bool snaps = false;  ///< beyond `force` there is no balance nearby
  double force = 0.0;  ///< the largest that the net bore [N]
  double depth = 0.0;  ///< how deep it was then, mean over the patch [m]
  double way = 0.0;    ///< from there to the opposite wall [m]
};

/// Pushes a round patch of the surface inwards, in ten equal steps up to the force that would dent it by 30 % of
/// the way to the opposite wall if the net were linear; to that wall's own patch the opposite force, where nothing
/// holds the part. Each step is Newton's method on the balance, without inertia; a step that finds no balance in 25
/// iterations, or one that is not stable (the stiffness has a negative pivot), has snapped.
/// Not done: on nets without a surface or without an opposite wall, where the factor of the stiffness would take more
/// than a tenth of a second, or if cancelled. Deterministic; any thread.
/// @param node middle of the patch. @param compliance dent per force of small pokes there [m/N], > 0.
PushTest pushUntilItSnaps(const SpringNet& net, Index node, double radius, double compliance,
                          WorkControl* control = nullptr);

} // namespace esm
