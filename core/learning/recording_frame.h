// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/base/types.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace esm::learning {

/// Whether places of a file are those of a net, told by pairs that should lie near each other: their unit, axes, origin
/// and whether two of them have exchanged their names.
/// @param names of the pairs, for messages. @param seen, rest  3 x M [m], all finite.
/// Errors: InvalidValue; the detail says what is wrong and the way out.
Status checkFrame(const std::vector<std::string>& names, const Eigen::Matrix3Xd& seen,
                  const Eigen::Matrix3Xd& rest);

} // namespace esm::learning
