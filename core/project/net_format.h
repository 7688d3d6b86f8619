// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/project/project.h"

#include <string>
#include <string_view>

namespace esm {

/// The plain net format `esm-net-1` (docs/FILE_FORMAT.md): a net with its loads in one JSON object.

/// Errors: BadFormat, InvalidValue; detail names `origin` and the JSON path.
Result<Project> parseNetFormat(std::string_view json, const std::string& origin);

/// What the format cannot hold (rules, regions, tension-only flags, tables) is listed in `lost` and left out.
std::string toNetFormat(const Project& project, std::vector<std::string>* lost = nullptr);

} // namespace esm
