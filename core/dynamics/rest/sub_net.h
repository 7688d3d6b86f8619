// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/rest/active_region.h"
#include "core/forces/loads.h"

namespace esm {

/// The awake part of a net as a net of its own, closed by its rim of held nodes; with the loads on it.
/// Positions at t = 0, which prescribed motions count from, are those of the whole net.
struct SubNet {
  SpringNet net;
  Loads loads;
  std::vector<Index> nodes;   ///< place of each node in the whole net, rising
  std::vector<Index> springs; ///< the same for springs
};

/// Cuts the awake part out of nets, again and again.
class SubNetCutter {
public:
  SubNetCutter() = default;
  /// Anchors may change with the parameters: call again.
  void prepare(const SpringNet& net);

  /// Cost: goes with the part and with the number of nodes in lists of loads.
  SubNet cut(const SpringNet& net, const Loads& loads, const ActiveRegion& region);
  /// A node's place in the last cut; kNoIndex if it is not in it.
  Index placeOf(Index node) const noexcept { return m_place[static_cast<std::size_t>(node)]; }

private:
  void cutSprings(const SpringNet& net, const ActiveRegion& region, SubNet& part) const;
  void cutAnchors(const SpringNet& net, const ActiveRegion& region, SubNet& part) const;

  std::vector<Index> m_place;             ///< N
  std::vector<Index> m_last;              ///< nodes of the last cut
  std::vector<std::size_t> m_firstAnchor; ///< anchors of node i: m_anchors[m_firstAnchor[i] .. + 1)
  std::vector<Index> m_anchors;
};

} // namespace esm
