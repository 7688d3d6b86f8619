// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/net_edit.h"
#include "core/structure/support.h"

#include <algorithm>
#include <numeric>

namespace esm {

namespace {

bool removeBands(AnchorSet& anchors)
{
  if (anchors.bandLength.size() == 0) return false;
  const Index before = anchors.count();
  std::vector<Index> others;
  for (Index i = 0; i < before; ++i)
    if (!anchors.isBand(i)) others.push_back(i);
  keepAnchors(anchors, others);
  anchors.bandLength.resize(0);
  return anchors.count() < before;
}

} // namespace

bool removeSupport(SpringNet& net, std::vector<Index>* newOfOld)
{
  const bool hadBands = removeBands(net.anchors), hadPressure = !net.pressure.empty();
  net.pressure.clear();
  NetCut cut{net.supportNode, {}};
  cut.node.resize(static_cast<std::size_t>(net.nodeCount()), 0);
  for (const SpringKind kind : net.kind) cut.spring.push_back(isOfSupport(kind) ? 1 : 0);
  const auto isMarked = [](const std::vector<std::uint8_t>& marks) {
    return std::any_of(marks.begin(), marks.end(), [](std::uint8_t mark) { return mark != 0; });
  };
  if (!isMarked(cut.node) && !isMarked(cut.spring)) {
    if (newOfOld) {
      newOfOld->resize(static_cast<std::size_t>(net.nodeCount()));
      std::iota(newOfOld->begin(), newOfOld->end(), 0);
    }
    return hadBands || hadPressure;
  }
  std::vector<Index> map = shrinkNet(net, cut);
  net.supportNode.clear();
  // Tetrahedra and walls have given sections and volumes to the surface too (there is no layer inside a
  // net that is solid by its file); what is left of the arrays then says nothing.
  net.section.resize(0);
  net.volume.resize(0);
  if (newOfOld) *newOfOld = std::move(map);
  return true;
}

} // namespace esm
