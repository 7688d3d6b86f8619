// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The part of RegionDriver that answers to changes from outside: other tools, other parameters.
#include "core/dynamics/rest/region_driver.h"

#include <algorithm>
#include <numeric>

namespace esm {

void RegionDriver::parametersChanged(const ParameterChange& change)
{
  m_allMoved = m_allMoved || change.otherFixed; // fixed nodes have lost their velocity
  m_bodiesAreKnown = false;
  m_settling.forget();
  m_stirred = m_body.motion.time;
  if (m_on) {
    if (change.otherFixed) {
      m_region = ActiveRegion(m_body.net);
      m_mode = Mode::Rest; // to wake everybody
    }
    if (change.isNone()) return;
    if (change.otherAnchors || change.otherFixed) m_cutter.prepare(m_body.net);
    if (change.everything) {
      std::vector<Index> all(static_cast<std::size_t>(m_body.net.nodeCount()));
      std::iota(all.begin(), all.end(), 0);
      wake(all, kFirstLayers);
    } else {
      wake(change.nodes, kFirstLayers);
    }
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
      if (both && now[i] == before[i] && !now[i].isLed()) continue;
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
