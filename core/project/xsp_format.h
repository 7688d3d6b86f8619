// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/project/project.h"

#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// Xsp 3.0, the mass-spring text format that SOFA reads: masses with position and velocity (a negative mass
/// is fixed) and linear springs between them. exportFrame() writes it. The net keeps its own numbers, as one
/// of esm-net-1 does.

bool looksLikeXsp(std::string_view bytes) noexcept;

/// @param notes what was passed over, one sentence each; may be null
/// Errors: BadFormat and InvalidValue with file and line, Unsupported for another version, EmptyResult
/// without a spring.
Result<Project> parseXsp(std::string_view bytes, const std::string& origin,
                         std::vector<std::string>* notes = nullptr);

} // namespace esm
