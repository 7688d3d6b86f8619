// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/net/spring_net.h"

#include <vector>

namespace esm {

/// Nodes whose removal leaves parts of at least `leastPart` nodes each that do not hang together
/// (articulation points, Hopcroft and Tarjan 1973). Ascending.
std::vector<Index> hingeNodes(const SpringNet& net, Index leastPart = 3);

/// Straight rows of nodes along edges of more than two triangles whose removal does the same: the parts turn
/// about them. One list per row.
std::vector<std::vector<Index>> hingeLines(const SpringNet& net, Index leastPart = 3);

/// Nodes whose springs and anchors resist some direction by less than `share` of what they resist the
/// stiffest one.
std::vector<Index> flatNodes(const SpringNet& net, double share = 1e-6);

} // namespace esm
