// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <Eigen/Core>

#include <string>

namespace esm {

/// What a stick or wheel cannot tell by itself, and the user measures or sees. Plain data.
struct StickCalibration {
  double newtonsAtFull = 1.0;  ///< force at 100 % [N]
  bool reversedAcross = false; ///< it pushes to the left what should go to the right
  bool reversedAlong = false;  ///< it pushes towards the user what should go away from him
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< where the scene's zero lies in the device [m]
};

/// As the profile in force says.
Result<StickCalibration> stickCalibration(const std::string& kind);

/// Writes it into the user's own profile; all else in the file stays. Holds from the next connection on.
/// Errors: FileUnreadable, BadFormat (the file is no JSON object), FileUnwritable.
Status setStickCalibration(const std::string& kind, const StickCalibration& calibration);

} // namespace esm
