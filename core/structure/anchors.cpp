// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/net_builder.h"
#include "core/structure/support_parts.h"

namespace esm::support {

Index addBands(SpringNet& net, const SupportOptions& options)
{
  const Eigen::ArrayXd area = nodeDualAreas(net);
  const bool all = options.anchors == SupportOptions::Anchors::All;
  std::vector<Index> held;
  for (Index node = 0; node < net.nodeCount(); ++node)
    if (area[node] > 0.0 && (all || options.anchorPart.radius(net.restPosition.col(node)) <= 1.0))
      held.push_back(node);
  if (held.empty()) return 0;

  AnchorSet& anchors = net.anchors;
  const Eigen::Index before = anchors.count(), count = before + static_cast<Eigen::Index>(held.size());
  if (anchors.bandLength.size() == 0) anchors.bandLength.setZero(before);
  anchors.node.insert(anchors.node.end(), held.begin(), held.end());
  anchors.point.conservativeResize(Eigen::NoChange, count);
  for (Eigen::ArrayXd* array : {&anchors.stiffness, &anchors.viscosity, &anchors.bandLength})
    array->conservativeResize(count);
  for (Eigen::Index i = before; i < count; ++i) {
    anchors.point.col(i) = net.restPosition.col(held[static_cast<std::size_t>(i - before)]);
    anchors.stiffness[i] = anchors.viscosity[i] = 0.0;
    anchors.bandLength[i] = options.anchorLength;
  }
  return static_cast<Index>(held.size());
}

} // namespace esm::support
