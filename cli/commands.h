// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/messages.h"

#include <functional>

namespace CLI {
class App;
}

/// The subcommands of `esm`, one file each. Adding one is one file, one line here and one in main.cpp.
///
/// Each add...() describes its arguments to the parser; when the parser has met the subcommand it puts the
/// work to do into `work`, which main() runs after parsing. So usage faults come before any work.
namespace esm::cli {

using Work = std::function<Exit()>;

void addInspect(CLI::App& program, Work& work);
void addImport(CLI::App& program, Work& work);
void addInfo(CLI::App& program, Work& work);
void addValidate(CLI::App& program, Work& work);
void addApply(CLI::App& program, Work& work);
void addSimulate(CLI::App& program, Work& work);
void addReplayLog(CLI::App& program, Work& work);
void addExplain(CLI::App& program, Work& work);
void addExport(CLI::App& program, Work& work);
void addFuzzy(CLI::App& program, Work& work);
void addHaptics(CLI::App& program, Work& work);
void addLearn(CLI::App& program, Work& work);
void addSolvers(CLI::App& program, Work& work);

} // namespace esm::cli
