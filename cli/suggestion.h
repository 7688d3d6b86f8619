// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace esm::cli {

/// The name of a subcommand or option that the first unknown one of the arguments may have been meant to be;
/// empty if all are known or none is near.
std::string nearestName(const CLI::App& program, int argc, const char* const* argv);

} // namespace esm::cli
