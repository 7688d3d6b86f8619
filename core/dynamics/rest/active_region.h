// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/grouped.h"
#include "core/net/spring_net.h"

#include <cstdint>
#include <span>
#include <vector>

namespace esm {

/// Which nodes of a net are awake, which sleep, and how far the awake ones are from the sleepers, counted in
/// layers of springs. Knows nothing of forces: RegionDriver decides who wakes and who sleeps.
///
/// Fixed nodes are neither: they do not move, and no layer goes through them. The rim are the sleepers and
/// fixed nodes that springs join to awake nodes; held in their places they close the awake part. The depth of
/// an awake node is its distance from the nearest sleeper of the rim, the radius is the largest depth.
///
/// Costs: creation O(nodes + springs); all else goes with the awake part and its rim.
class ActiveRegion {
public:
  ActiveRegion() = default;
  explicit ActiveRegion(const SpringNet& net);

  /// Wakes the seeds and all nodes within `layers` springs of them. @return who was asleep before; valid
  /// until the next call.
  std::span<const Index> wake(std::span<const Index> seeds, int layers);
  void sleep(std::span<const Index> nodes);
  /// Sets awake(), rim(), depths and radius() after wake() and sleep(). A sleeper of `fresh` (N flags) hands
  /// its mark on to the awake nodes that are nearest to it.
  void update(const std::vector<std::uint8_t>& fresh);

  bool isAwake(Index node) const noexcept { return m_awake[static_cast<std::size_t>(node)] != 0; }
  Index freeCount() const noexcept { return m_freeCount; }            ///< nodes that are not fixed
  const std::vector<Index>& awake() const noexcept { return m_list; } ///< rising
  const std::vector<Index>& rim() const noexcept { return m_rim; }    ///< rising
  int radius() const noexcept { return m_radius; }                    ///< 0 if no sleeper is near

  struct Layered {
    Index node = kNoIndex;
    int depth = 0;          ///< 1 = joined to a sleeper
    bool nearFresh = false; ///< the nearest sleeper is one of `fresh`
  };
  /// Awake nodes by rising depth, those that no path joins to a sleeper left out.
  const std::vector<Layered>& layers() const noexcept { return m_layers; }

  /// The candidates that are further than `layers` springs from every awake node that is none; none at all if they are
  /// fewer than `least`, which struts soon tell: they join everything to everything.
  /// @param isCandidate  N flags.
  std::vector<Index> inside(const std::vector<std::uint8_t>& isCandidate, int layers, std::size_t least = 0);

  /// Springs of a node.
  std::span<const Index> springsOf(Index node) const noexcept
  {
    return m_springsOf[static_cast<std::size_t>(node)];
  }
  Index otherEnd(Index spring, Index node) const noexcept
  {
    const auto s = static_cast<std::size_t>(spring);
    return m_ends[2 * s] == node ? m_ends[2 * s + 1] : m_ends[2 * s];
  }

private:
  std::uint32_t newStamp();

  Grouped<Index> m_springsOf;        ///< by node
  std::vector<Index> m_ends;         ///< a, b of each spring
  std::vector<std::uint8_t> m_fixed; ///< N
  std::vector<std::uint8_t> m_awake; ///< N
  Index m_freeCount = 0;
  std::vector<Index> m_list, m_rim, m_woken;
  std::vector<Layered> m_layers;
  int m_radius = 0;
  std::vector<std::uint32_t> m_stamp; ///< N, who was visited in the present search
  std::uint32_t m_lastStamp = 0;
};

} // namespace esm
