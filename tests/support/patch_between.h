// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/net/parameter_patch.h"

namespace esm::test {

/// What makes `now` of `before`, as far as a patch can: nothing for nets of other springs or nodes.
inline ParameterPatch patchBetween(const SpringNet& before, const SpringNet& now)
{
  const auto differ = [](double a, double b) { return !(a == b); };
  ParameterPatch patch;
  if (before.springCount() != now.springCount() || before.mass.size() != now.mass.size()) return patch;
  for (Index s = 0; s < now.springCount(); ++s) {
    const auto place = static_cast<std::size_t>(s);
    if (differ(before.stiffness[s], now.stiffness[s]) || differ(before.viscosity[s], now.viscosity[s]) ||
        differ(before.lawParameter[s], now.lawParameter[s]) || before.law[place] != now.law[place])
      patch.springs.push_back({s, now.law[place], now.stiffness[s], now.viscosity[s], now.lawParameter[s]});
  }
  const auto damping = [](const SpringNet& net, Index i) {
    return net.massDamping.size() > 0 ? net.massDamping[i] : 0.0;
  };
  for (Index i = 0; i < now.nodeCount(); ++i)
    if (differ(before.mass[i], now.mass[i]) || differ(damping(before, i), damping(now, i)))
      patch.nodes.push_back({i, now.mass[i], damping(now, i)});
  const AnchorSet &old = before.anchors, &anchors = now.anchors;
  if (old.node != anchors.node || old.stiffness.size() != anchors.stiffness.size() ||
      !(old.point.array() == anchors.point.array()).all()) {
    patch.anchorSet = anchors;
    return patch;
  }
  for (Index k = 0; k < anchors.count(); ++k)
    if (differ(old.stiffness[k], anchors.stiffness[k]) || differ(old.viscosity[k], anchors.viscosity[k]))
      patch.anchors.push_back({k, anchors.stiffness[k], anchors.viscosity[k]});
  return patch;
}

} // namespace esm::test
