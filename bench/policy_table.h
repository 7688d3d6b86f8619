// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/policy.h"

#include <span>
#include <string_view>

namespace esm::bench {

/// A constant of the policy, and what the engine would do without it.
struct Constant {
  std::string_view name;     ///< as in policy.h
  void (*leaveOut)(Policy&); ///< to the value with which it has no say
};

/// All constants that were fitted, and those rules that could be left out.
std::span<const Constant> constants();

} // namespace esm::bench
