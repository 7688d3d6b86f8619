// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/triple_buffer.h"

#include <Eigen/Core>

#include <cstdint>

namespace esm {

/// What crosses between the servo thread (1 kHz) and the simulation thread, by triple buffers, newest wins.
/// Neither waits for the other. Plain data without heap, so that copying is wait-free.

/// Servo to simulation: where the hand is.
struct ToolState {
  std::uint64_t sequence = 0;
  double time = 0.0;                                  ///< servo clock [s]
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< scene coordinates [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); ///< [m/s]
};

/// Simulation to servo: how the tissue answers near the tool. The servo evaluates
///     F(x) = force - stiffness (x - position) - viscosity v
/// on the hand each tick, so a slow frame is felt as a slightly old tissue, never as a gap.
///
/// With a normal the tool only touches: where F.normal <= 0 there is no force, and what acts across the
/// normal is held below `friction` F.normal. Such a model may come before the contact does: the servo then
/// meets the surface on time instead of a frame later. Without a normal the tool holds on, and F has any
/// direction.
///
/// A scene is tissue that moves on without a break: another number, or silence, and the servo begins as
/// softly as after arming. Within a scene a contact may come and go, and an edition says that parameters were
/// changed.
struct ContactModel {
  std::uint64_t sequence = 0;
  std::uint64_t scene = 1;   ///< 0: no tissue moves that could be felt
  std::uint64_t edition = 0; ///< of the tissue's parameters
  double time = 0.0;         ///< simulated time [s]
  bool active = false;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< tool position the model was made for [m]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();     ///< on the hand at that position [N]
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero(); ///< symmetric, positive semidefinite [N/m]
  Eigen::Matrix3d viscosity = Eigen::Matrix3d::Zero(); ///< [N s/m]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< unit, out of the tissue; zero: held, not touched
  double friction = 0.0;                               ///< coefficient [1]
};

} // namespace esm
