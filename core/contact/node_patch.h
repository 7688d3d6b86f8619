// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/grouped.h"
#include "core/net/spring_net.h"

#include <vector>

namespace esm {

inline constexpr double kGripRadius = 0.008; ///< of a fingertip or a jaw [m]

/// How wholly a hand of radius 1 holds at `distance` from its middle: wholly within 0.5, by half at 1, not at all
/// from 1.5 on, smooth between. A sharp rim would stretch one row of springs, whatever their length is.
double gripShare(double distance) noexcept;

struct PatchNode {
  Index node = kNoIndex;
  double share = 0.0; ///< gripShare() at its distance, in (0, 1]
  double area = 0.0;  ///< of the node's cell, > 0 [m^2]
};

/// Nodes around one of them, as a finger or a jaw takes hold of them: all that lie within one and a half radii
/// of it and hang together with it there. On the surface the way goes along triangles, so that the opposite wall
/// is not taken along, where struts join them; nodes without triangles go along springs.
///
/// A cell is a third of the node's triangles, or the square of the node's mean distance from its neighbours where
/// there are none. So sums of share times area hardly depend on the mesh.
class PatchFinder {
public:
  explicit PatchFinder(const SpringNet& net);

  /// @param radius  [m]; 0 or less: the node alone.
  /// @param nodes   receives the patch, `node` at the beginning.
  void find(const Eigen::Matrix3Xd& position, Index node, double radius, std::vector<PatchNode>& nodes);

private:
  std::span<const Index> neighbours(Index node) const { return m_neighbours[static_cast<std::size_t>(node)]; }
  double cell(const Eigen::Matrix3Xd& position, Index node) const;

  Grouped<Index> m_neighbours; ///< of a surface node: the other two of each of its triangles
  std::vector<std::uint8_t> m_isSurface, m_met;
};

} // namespace esm
