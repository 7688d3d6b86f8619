// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/types.h"

#include <vector>

namespace esm {

/// What the nodes of a system are called in sentences: their places in the whole net.
struct NodeNames {
  std::vector<Index> names;  ///< of the body's nodes; empty: their places
  std::vector<Index> places; ///< of the system's nodes in the body; empty: it is the whole body

  Index of(Index node) const noexcept
  {
    const Index place = places.empty() ? node : places[static_cast<std::size_t>(node)];
    return names.empty() ? place : names[static_cast<std::size_t>(place)];
  }
};

} // namespace esm
