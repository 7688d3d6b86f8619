// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/contact/node_patch.h"
#include "core/dynamics/solver_settings.h"
#include "core/forces/loads.h"
#include "core/net/parameter_patch.h"
#include "core/runtime/quality_ladder.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

namespace esm {

/// What the window can ask of the simulation thread; one type per member function of SimThread.
namespace command {

struct Load {
  std::uint64_t generation;
  SpringNet net;
  Loads loads;
  SolverSettings settings;
};
struct SetParameters {
  SpringNet net;
};
struct PatchParameters {
  std::vector<std::shared_ptr<const ParameterPatch>> patches; ///< in their order, none null
};
struct Play {};
struct Pause {};
struct StepOnce {};
struct Reset {};
struct SetFrameRate {
  double framesPerSecond;
};
struct SetQuality {
  QualityPlan plan;
};
struct Grab {
  Index node;
  Eigen::Vector3d target;      ///< [m]
  double maxForce;             ///< [N]
  double radius = kGripRadius; ///< of the patch that is held around the node [m]; 0: the node alone
};
struct MoveGrab {
  Eigen::Vector3d target; ///< [m]
};
struct Release {};
struct FollowDevice {
  bool on;
};
struct Touch {
  bool on;
  double radius;   ///< [m]
  double maxForce; ///< [N]
};

} // namespace command

using SimCommand =
  std::variant<command::Load, command::SetParameters, command::PatchParameters, command::Play, command::Pause,
               command::StepOnce, command::Reset, command::SetFrameRate, command::SetQuality, command::Grab,
               command::MoveGrab, command::Release, command::FollowDevice, command::Touch>;

} // namespace esm
