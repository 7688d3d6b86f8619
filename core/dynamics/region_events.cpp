// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The part of RegionDriver that answers to changes from outside: other tools, other parameters.
#include "core/dynamics/region_driver.h"

#include <algorithm>

namespace esm {
namespace {

/// Flags the nodes whose parameters, or those of their springs, are not what they were. False if the two nets
/// differ in more than that: in fixed nodes, in which nodes have anchors, in tables.
bool flagTouched(const SpringNet& before, const SpringNet& now, std::vector<std::uint8_t>& touched)
{
  const AnchorSet &old = before.anchors, &anchors = now.anchors;
  if (before.fixed != now.fixed || old.node != anchors.node || before.tables != now.tables ||
      before.massDamping.size() != now.massDamping.size() || before.pressure != now.pressure)
    return false;
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
  return true;
}

} // namespace

/// O(nodes + springs).
void RegionDriver::parametersChanged(const SpringNet& before)
{
  m_allMoved = true; // fixed nodes have lost their velocity
  m_bodiesAreKnown = false;
  m_settling.forget();
  m_stirred = m_body.motion.time;
  if (m_on) {
    const SpringNet& net = m_body.net;
    std::vector<std::uint8_t> touched(static_cast<std::size_t>(net.nodeCount()), 0);
    std::vector<Index> seeds;
    const bool known = flagTouched(before, net, touched);
    if (before.fixed != net.fixed) {
      m_region = ActiveRegion(net);
      m_mode = Mode::Rest; // to wake everybody
    }
    for (Index i = 0; i < net.nodeCount(); ++i)
      if (!known || touched[static_cast<std::size_t>(i)]) seeds.push_back(i);
    if (seeds.empty()) return;
    m_cutter.prepare(net);
    wake(seeds, kFirstLayers);
    m_changed = m_mode != Mode::Whole; // the part needs the new parameters, whoever has woken
    applyChange();
    m_watch.watch(m_region.awake(), m_body.motion);
  }
  if (m_mode == Mode::Whole) m_driver.parametersChanged(m_body.system, m_body.motion);
  if (m_mode == Mode::Part) m_driver.parametersChanged(m_partSystem, m_partMotion);
}

void RegionDriver::toolsChanged(const std::vector<ToolSpring>& before)
{
  const std::vector<ToolSpring>& now = m_body.system.tools();
  const auto sameSpring = [](const ToolSpring& a, const ToolSpring& b) {
    return a.node == b.node && a.stiffness == b.stiffness && a.viscosity == b.viscosity;
  };
  const bool sameNodes = std::equal(now.begin(), now.end(), before.begin(), before.end(), sameSpring);
  m_bodiesAreKnown = m_bodiesAreKnown && sameNodes;
  if (m_mode != Mode::Whole) {
    std::vector<Index> seeds;
    for (std::size_t i = 0; i < std::max(now.size(), before.size()); ++i) {
      const bool both = i < now.size() && i < before.size();
      if (both && sameSpring(now[i], before[i]) && now[i].target == before[i].target &&
          now[i].targetVelocity == before[i].targetVelocity)
        continue;
      if (i < now.size()) seeds.push_back(now[i].node);
      if (i < before.size()) seeds.push_back(before[i].node);
    }
    std::erase_if(seeds, [&](Index node) { return m_region.isAwake(node); });
    wake(seeds, kFirstLayers);
    applyChange();
  }
  m_stirred = m_body.motion.time;
  if (m_mode == Mode::Whole) m_driver.toolsChanged(m_body.system, m_body.motion, sameNodes);
  if (m_mode != Mode::Part) return;
  gather();
  m_driver.toolsChanged(m_partSystem, m_partMotion, sameNodes);
}

} // namespace esm
