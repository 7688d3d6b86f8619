// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/step_bound.h"

#include <algorithm>
#include <cmath>

namespace esm {

void StepBound::prepare(const System& system)
{
  const auto& ends = system.forces().springEnds();
  const std::size_t nodes = system.nodeCount();
  m_first.assign(nodes + 1, 0);
  for (const auto& end : ends) {
    ++m_first[static_cast<std::size_t>(end.a) + 1];
    ++m_first[static_cast<std::size_t>(end.b) + 1];
  }
  for (std::size_t i = 0; i < nodes; ++i) m_first[i + 1] += m_first[i];
  m_incident.resize(2 * ends.size());
  std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
  for (std::size_t s = 0; s < ends.size(); ++s)
    for (const Index node : {ends[s].a, ends[s].b})
      m_incident[next[static_cast<std::size_t>(node)]++] = static_cast<std::uint32_t>(s);
  m_tangents.resize(ends.size());
  for (auto* array : {&m_rootStiffness, &m_rootViscosity, &m_rowStiffness, &m_rowViscosity})
    array->resize(ends.size());
  m_nodes.resize(nodes);
}

/// Row sums over nodes, scaled by the masses' roots: sum k (1/m_i + 1/sqrt(m_i m_j)).
void StepBound::sumNodes(const System& system)
{
  const auto& inverseMass = system.inverseMass();
  std::fill(m_nodes.begin(), m_nodes.end(), NodeSums{});
  for (const ForceModel::Anchor& anchor : system.forces().anchors()) {
    NodeSums& node = m_nodes[static_cast<std::size_t>(anchor.node)];
    node.stiffness += anchor.stiffness;
    node.damping += anchor.viscosity;
  }
  for (const ToolSpring& tool : system.tools()) {
    NodeSums& node = m_nodes[static_cast<std::size_t>(tool.node)];
    node.stiffness += tool.stiffness;
    node.damping += tool.viscosity;
  }
  const auto& massDrag = system.forces().massDrag();
  for (std::size_t i = 0; i < m_nodes.size(); ++i) {
    m_nodes[i].total = m_nodes[i].stiffness;
    m_nodes[i].stiffness *= inverseMass[i];
    m_nodes[i].damping = (m_nodes[i].damping + (massDrag.empty() ? 0.0 : massDrag[i])) * inverseMass[i];
  }
  const auto& ends = system.forces().springEnds();
  for (std::size_t s = 0; s < ends.size(); ++s) {
    const auto a = static_cast<std::size_t>(ends[s].a), b = static_cast<std::size_t>(ends[s].b);
    const double axial = std::max(m_tangents[s].axial, 0.0), lateral = std::abs(m_tangents[s].lateral);
    const double cross = std::sqrt(inverseMass[a] * inverseMass[b]);
    for (const std::size_t i : {a, b}) {
      const double weight = inverseMass[i] + cross;
      m_nodes[i].axial += axial * weight;
      m_nodes[i].lateral += lateral * weight;
      m_nodes[i].viscous += m_tangents[s].viscous * weight;
      m_nodes[i].total += axial;
    }
  }
}

/// Row sums of |G|, which sees the angles between springs.
void StepBound::sumSprings(const System& system)
{
  const auto& inverseMass = system.inverseMass();
  for (std::size_t s = 0; s < m_tangents.size(); ++s) {
    m_rootStiffness[s] = std::sqrt(std::max(m_tangents[s].axial, 0.0));
    m_rootViscosity[s] = std::sqrt(m_tangents[s].viscous);
    m_rowStiffness[s] = m_rowViscosity[s] = 0.0;
  }
  for (std::size_t i = 0; i < m_nodes.size(); ++i) {
    if (inverseMass[i] == 0.0) continue;
    for (std::size_t p = m_first[i]; p < m_first[i + 1]; ++p)
      for (std::size_t q = m_first[i]; q <= p; ++q) {
        const std::uint32_t e = m_incident[p], f = m_incident[q];
        const double cosine = std::abs(m_tangents[e].direction.dot(m_tangents[f].direction)) * inverseMass[i];
        const double k = cosine * m_rootStiffness[e] * m_rootStiffness[f];
        const double c = cosine * m_rootViscosity[e] * m_rootViscosity[f];
        m_rowStiffness[e] += k;
        m_rowViscosity[e] += c;
        if (p == q) continue;
        m_rowStiffness[f] += k;
        m_rowViscosity[f] += c;
      }
  }
}

FastestMode StepBound::compute(const System& system, const NodeArray& x, const NodeArray& v)
{
  system.forces().springTangents(x.data(), v.data(), m_tangents);
  sumNodes(system);
  sumSprings(system);
  double axial = 0.0, viscous = 0.0, lateral = 0.0, anchored = 0.0, drag = 0.0;
  double nodeStiffness = 0.0, nodeDamping = 0.0, fastest = -1.0;
  for (const double row : m_rowStiffness) axial = std::max(axial, row);
  for (const double row : m_rowViscosity) viscous = std::max(viscous, row);
  FastestMode mode;
  for (std::size_t i = 0; i < m_nodes.size(); ++i) {
    const NodeSums& node = m_nodes[i];
    lateral = std::max(lateral, node.lateral);
    anchored = std::max(anchored, node.stiffness);
    drag = std::max(drag, node.damping);
    const double k = node.axial + node.lateral + node.stiffness, c = node.viscous + node.damping;
    nodeStiffness = std::max(nodeStiffness, k);
    nodeDamping = std::max(nodeDamping, c);
    const double rate = std::max(0.5 * std::sqrt(k), 0.6 * c); // as velocity Verlet weighs them
    if (rate > fastest && system.isFree(i)) {
      fastest = rate;
      mode.node = static_cast<Index>(i);
      mode.springStiffness = node.total;
    }
  }
  mode.stiffness = std::min(nodeStiffness, axial + lateral + anchored);
  mode.damping = std::min(nodeDamping, viscous + drag);
  return mode;
}

} // namespace esm
