// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/runtime/sim_command.h"

#include <vector>

namespace esm {

/// Makes one command of parameter patches that follow each other with nothing in between: a slider sends dozens
/// while a slow frame lasts, and each would ask for a look at the net's bounds. All of them stay, in their order.
void coalesce(std::vector<SimCommand>& batch);

} // namespace esm
