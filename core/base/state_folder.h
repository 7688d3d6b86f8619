// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace esm {

/// Where the window keeps what outlives it but is no document: <state folder>/esm-modeler/<part>, the state
/// folder being $XDG_STATE_HOME or ~/.local/state; empty if neither can be known (XDG base directories).
std::filesystem::path stateFolder(const std::string& part);

} // namespace esm
