// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace esm {

/// A place in an array. Cutting and importing renumber places; see NodeId for names that last.
using Index = std::int32_t;

/// An index that is no less than zero, as containers of the standard library want it.
constexpr std::size_t at(Index i)
{
  return static_cast<std::size_t>(i);
}

/// The name of a node or spring: survives saving, cutting and renumbering. Interfaces between modules
/// and files take ids, loops take indices.
enum class NodeId : Index {};
enum class SpringId : Index {};

inline constexpr Index kNoIndex = -1;

/// The human languages in which rules can be written and terms are named.
enum class Language { English, German };

} // namespace esm
