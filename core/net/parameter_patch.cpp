// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/parameter_patch.h"

#include <utility>

namespace esm {

namespace {

/// Of two lists that rise by `index`; where both name one, the later word counts.
template <class Entry>
void mergeInto(std::vector<Entry>& list, const std::vector<Entry>& later, Index Entry::*index)
{
  if (later.empty()) return;
  if (list.empty() || list.back().*index < later.front().*index) {
    list.insert(list.end(), later.begin(), later.end());
    return;
  }
  std::vector<Entry> both;
  both.reserve(list.size() + later.size());
  auto old = list.cbegin();
  for (const Entry& entry : later) {
    for (; old != list.cend() && (*old).*index < entry.*index; ++old) both.push_back(*old);
    if (old != list.cend() && (*old).*index == entry.*index) ++old;
    both.push_back(entry);
  }
  both.insert(both.end(), old, list.cend());
  list = std::move(both);
}

void write(const std::vector<ParameterPatch::Anchor>& anchors, AnchorSet& set)
{
  for (const ParameterPatch::Anchor& anchor : anchors) {
    set.stiffness[anchor.anchor] = anchor.stiffness;
    set.viscosity[anchor.anchor] = anchor.viscosity;
  }
}

} // namespace

void ParameterPatch::applyTo(SpringNet& net) const
{
  for (const Spring& spring : springs) {
    net.law[static_cast<std::size_t>(spring.spring)] = spring.law;
    net.stiffness[spring.spring] = spring.stiffness;
    net.viscosity[spring.spring] = spring.viscosity;
    net.lawParameter[spring.spring] = spring.lawParameter;
  }
  for (const Node& node : nodes) {
    net.mass[node.node] = node.mass;
    if (net.massDamping.size() == 0 && node.massDamping != 0.0) net.massDamping.setZero(net.nodeCount());
    if (net.massDamping.size() > 0) net.massDamping[node.node] = node.massDamping;
  }
  if (anchorSet) net.anchors = *anchorSet;
  write(anchors, net.anchors);
  for (std::size_t body = 0; body < bulkModuli.size(); ++body)
    net.pressure[body].bulkModulus = bulkModuli[body];
}

void ParameterPatch::append(const ParameterPatch& later)
{
  mergeInto(springs, later.springs, &Spring::spring);
  mergeInto(nodes, later.nodes, &Node::node);
  if (later.anchorSet) {
    anchorSet = later.anchorSet;
    anchors.clear();
  }
  mergeInto(anchors, later.anchors, &Anchor::anchor);
  if (!later.bulkModuli.empty()) bulkModuli = later.bulkModuli;
}

} // namespace esm
