// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/grouped.h"
#include "core/net/spring_net.h"

#include <span>

namespace esm {

/// Springs and anchors by node, for those who look at a few nodes of a net again and again. Made when somebody
/// asks first, once for a net: parameters may change, topology may not.
class NodeLinks {
public:
  void forget() noexcept { m_knowsSprings = m_knowsAnchors = false; } ///< another net
  void forgetAnchors() noexcept { m_knowsAnchors = false; }           ///< other nodes have anchors

  std::span<const Index> springsOf(const SpringNet& net, Index node) ///< rising
  {
    if (!m_knowsSprings) findSprings(net);
    return m_springs[static_cast<std::size_t>(node)];
  }
  std::span<const Index> anchorsOf(const SpringNet& net, Index node) ///< rising
  {
    if (!m_knowsAnchors) findAnchors(net);
    return m_anchors[static_cast<std::size_t>(node)];
  }

private:
  void findSprings(const SpringNet& net);
  void findAnchors(const SpringNet& net);

  bool m_knowsSprings = false, m_knowsAnchors = false;
  Grouped<Index> m_springs, m_anchors;
};

} // namespace esm
