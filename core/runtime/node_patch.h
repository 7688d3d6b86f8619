// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/grouped.h"
#include "core/net/spring_net.h"

#include <span>
#include <vector>

namespace esm {

inline constexpr double kGripRadius = 0.008; ///< of a fingertip or a jaw [m]

struct PatchNode {
  Index node = kNoIndex;
  double share = 0.0; ///< of the node's cell that lies in the patch, in (0, 1]
};

/// Nodes around a point, as a finger or a jaw takes hold of them: all that lie within a radius of it and hang
/// together with the first ones there. On the surface the way goes along triangles, so that the opposite wall
/// is not taken along, where struts join them; nodes without triangles go along springs.
///
/// A node counts by the part of its cell that lies within the radius, its cell reaching half-way to its
/// neighbours. So the patch is the same area on every mesh, and changes little when a node is a little beside.
class PatchFinder {
public:
  explicit PatchFinder(const SpringNet& net);

  /// @param first  where the search begins; they count wholly where their cells are larger than the patch.
  /// @param nodes  receives the patch, `first` at the beginning. No allocation once it is large enough.
  void find(const Eigen::Matrix3Xd& position, std::span<const Index> first, const Eigen::Vector3d& centre,
            double radius, std::vector<PatchNode>& nodes);

private:
  std::span<const Index> neighbours(Index node) const { return m_neighbours[static_cast<std::size_t>(node)]; }
  double halfCell(const Eigen::Matrix3Xd& position, Index node) const;

  Grouped<Index> m_neighbours; ///< those on the surface twice each
  std::vector<std::uint8_t> m_met;
};

} // namespace esm
