// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace esm {

/// A place in an array. Cutting and importing renumber places; see NodeId for names that last.
using Index = std::int32_t;

/// The name of a node or spring: survives saving, cutting and renumbering. Interfaces between modules
/// and files take ids, loops take indices.
enum class NodeId : Index {};
enum class SpringId : Index {};

inline constexpr Index kNoIndex = -1;

/// The human languages in which rules can be written and terms are named.
enum class Language { English, German };

} // namespace esm
