// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/node_links.h"

namespace esm {

void NodeLinks::findSprings(const SpringNet& net)
{
  m_springs.build(static_cast<std::size_t>(net.nodeCount()), [&](const auto& add) {
    for (Index s = 0; s < net.springCount(); ++s)
      for (const int end : {0, 1}) add(net.ends(end, s), s);
  });
  m_knowsSprings = true;
}

void NodeLinks::findAnchors(const SpringNet& net)
{
  m_anchors.build(static_cast<std::size_t>(net.nodeCount()), [&](const auto& add) {
    for (Index k = 0; k < net.anchors.count(); ++k) add(net.anchors.node[static_cast<std::size_t>(k)], k);
  });
  m_knowsAnchors = true;
}

} // namespace esm
