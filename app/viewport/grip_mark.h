// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/grouped.h"
#include "core/net/spring_net.h"

#include <memory>
#include <vector>

namespace esm {

/// What the pull tool would hold, or holds: the outline of its patch where the hand still holds by half, which is
/// at the radius, and how wholly it holds each node (gripShare()). The outline lies on the triangles and goes with
/// them: it is kept as places on edges. Costs what the patch costs, not the net. GUI thread.
class GripMark {
public:
  /// A place on an edge: this share of the way from one node to the other.
  struct Place {
    Index from = kNoIndex, to = kNoIndex;
    double share = 0.0;
    Index triangle = kNoIndex; ///< whose piece of the outline it ends
  };
  /// Two places to a piece, in no order.
  using Outline = std::vector<Place>;

  void setNet(std::shared_ptr<const SpringNet> net);
  bool setRadius(double metres); ///< of what is taken hold of next; returns whether it changes
  double radius() const noexcept { return m_radius; }

  /// Around a node, as the net lies now. Empty where there are no triangles, or no radius.
  Outline outline(const Eigen::Matrix3Xd& position, Index node) const;
  Eigen::Vector3d normal(const Eigen::Matrix3Xd& position,
                         Index node) const; ///< not of length 1; 0 without triangles

  /// The hand takes hold of these, around `node`. None: it lets go.
  void hold(const Eigen::Matrix3Xd& position, Index node, const std::vector<Index>& nodes);
  Index heldNode() const noexcept { return m_held.empty() ? kNoIndex : m_middle; }
  const std::vector<Index>& heldNodes() const noexcept { return m_held; }
  const std::vector<double>& heldShares() const noexcept { return m_shares; } ///< one for each, in (0, 1]
  const Outline& heldOutline() const noexcept { return m_heldOutline; }

private:
  const Grouped<Index>& triangles() const;

  std::shared_ptr<const SpringNet> m_net;
  double m_radius = 0.0;                   ///< [m]
  mutable Grouped<Index> m_triangles;      ///< of each node, once somebody has asked
  mutable std::vector<std::uint8_t> m_met; ///< by node; all 0 between two calls
  Index m_middle = kNoIndex;
  std::vector<Index> m_held;
  std::vector<double> m_shares;
  Outline m_heldOutline;
};

} // namespace esm
