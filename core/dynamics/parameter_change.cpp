// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/parameter_change.h"

#include <algorithm>

namespace esm {

ParameterChange changeBetween(const SpringNet& before, const SpringNet& now)
{
  const AnchorSet &old = before.anchors, &anchors = now.anchors;
  ParameterChange change;
  change.otherFixed = before.fixed != now.fixed;
  change.otherAnchors = old.node != anchors.node;
  change.everything = change.otherFixed || change.otherAnchors || before.tables != now.tables ||
                      before.massDamping.size() != now.massDamping.size() || before.pressure != now.pressure;
  change.springsSeen = now.springCount();
  if (change.everything) return change;
  std::vector<std::uint8_t> touched(static_cast<std::size_t>(now.nodeCount()), 0);
  for (Index i = 0; i < now.nodeCount(); ++i) {
    const bool drag = now.massDamping.size() > 0 && before.massDamping[i] != now.massDamping[i];
    touched[static_cast<std::size_t>(i)] = before.mass[i] != now.mass[i] || drag;
  }
  for (Index s = 0; s < now.springCount(); ++s) {
    const auto i = static_cast<std::size_t>(s);
    if (before.stiffness[s] == now.stiffness[s] && before.viscosity[s] == now.viscosity[s] &&
        before.restLength[s] == now.restLength[s] && before.law[i] == now.law[i] &&
        before.lawParameter[s] == now.lawParameter[s] && before.tensionOnly[i] == now.tensionOnly[i])
      continue;
    for (const Index node : {now.ends(0, s), now.ends(1, s)}) touched[static_cast<std::size_t>(node)] = 1;
  }
  for (Index k = 0; k < anchors.count(); ++k)
    if (old.stiffness[k] != anchors.stiffness[k] || old.viscosity[k] != anchors.viscosity[k] ||
        old.point.col(k) != anchors.point.col(k))
      touched[static_cast<std::size_t>(anchors.node[static_cast<std::size_t>(k)])] = 1;
  for (Index i = 0; i < now.nodeCount(); ++i)
    if (touched[static_cast<std::size_t>(i)]) change.nodes.push_back(i);
  return change;
}

ParameterChange changeBy(const ParameterPatch& patch, const SpringNet& net)
{
  ParameterChange change;
  change.springsSeen = std::ssize(patch.springs);
  for (const ParameterPatch::Spring& spring : patch.springs) {
    const Index s = spring.spring;
    if (net.stiffness[s] == spring.stiffness && net.viscosity[s] == spring.viscosity &&
        net.law[static_cast<std::size_t>(s)] == spring.law && net.lawParameter[s] == spring.lawParameter)
      continue;
    change.springs.push_back(s);
    for (const Index node : {net.ends(0, s), net.ends(1, s)}) change.nodes.push_back(node);
  }
  const bool hasDrag = net.massDamping.size() > 0;
  for (const ParameterPatch::Node& node : patch.nodes) {
    const double damping = hasDrag ? net.massDamping[node.node] : 0.0;
    if (net.mass[node.node] != node.mass || damping != node.massDamping) change.nodes.push_back(node.node);
    change.everything = change.everything || (!hasDrag && node.massDamping != 0.0);
  }
  const AnchorSet &old = net.anchors, &anchors = patch.anchorSet ? *patch.anchorSet : old;
  change.otherAnchors = old.node != anchors.node;
  const auto touchAnchor = [&](Index k, double stiffness, double viscosity) {
    if (old.stiffness[k] != stiffness || old.viscosity[k] != viscosity ||
        old.point.col(k) != anchors.point.col(k))
      change.nodes.push_back(anchors.node[static_cast<std::size_t>(k)]);
  };
  if (patch.anchorSet && !change.otherAnchors) { // the numbers of `anchors` come over those of the set
    auto given = patch.anchors.begin();
    for (Index k = 0; k < anchors.count(); ++k) {
      const bool isGiven = given != patch.anchors.end() && given->anchor == k;
      touchAnchor(k, isGiven ? given->stiffness : anchors.stiffness[k],
                  isGiven ? given->viscosity : anchors.viscosity[k]);
      if (isGiven) ++given;
    }
  } else if (!patch.anchorSet) {
    for (const ParameterPatch::Anchor& anchor : patch.anchors)
      touchAnchor(anchor.anchor, anchor.stiffness, anchor.viscosity);
  }
  for (std::size_t body = 0; body < patch.bulkModuli.size(); ++body)
    change.everything = change.everything || net.pressure[body].bulkModulus != patch.bulkModuli[body];
  change.everything = change.everything || change.otherAnchors;
  std::sort(change.nodes.begin(), change.nodes.end());
  change.nodes.erase(std::unique(change.nodes.begin(), change.nodes.end()), change.nodes.end());
  if (change.everything) change.nodes.clear();
  return change;
}

} // namespace esm
