// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/node_forces.h"

#include "core/forces/spring_pass.h"

#include <algorithm>

namespace esm {
namespace {

ESM_CPU_CLONES double setBedded(std::size_t count, const Lanes* weight, const Lanes* point,
                                const double* stiffness, const double* viscosity, const Lanes* x,
                                const Lanes* v, Lanes* force) noexcept
{
  Lanes heat = {0, 0, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    const Lanes drag = v[i] * viscosity[i];
    force[i] = weight[i] + ((point[i] - x[i]) * stiffness[i] - drag);
    heat += drag * v[i];
  }
  return sumLanes(heat);
}

} // namespace

NodeForces::NodeForces(const SpringNet& net, const Eigen::Vector3d& gravity,
                       const std::vector<Anchor>& anchors, const std::vector<double>& massDrag)
{
  const auto count = static_cast<std::size_t>(net.nodeCount());
  for (Index node = 0; node < net.nodeCount(); ++node) m_weight.push_back(toLanes(net.mass[node] * gravity));
  if (4 * anchors.size() < count && massDrag.empty()) { // a list entry costs as much as four nodes
    m_few = anchors;
    return;
  }
  m_viscosity = massDrag;
  m_viscosity.resize(count, 0.0);
  m_stiffness.assign(count, 0.0);
  m_point.assign(count, Lanes{0, 0, 0, 0});
  for (const Anchor& anchor : anchors) {
    const auto i = static_cast<std::size_t>(anchor.node);
    const double total = m_stiffness[i] + anchor.stiffness;
    if (m_stiffness[i] == 0.0)
      m_point[i] = anchor.point; // exactly
    else if (total > 0.0)
      m_point[i] += (anchor.point - m_point[i]) * (anchor.stiffness / total);
    m_stiffness[i] = total;
    m_viscosity[i] += anchor.viscosity;
  }
}

double NodeForces::set(const Lanes* x, const Lanes* v, Lanes* force) const noexcept
{
  if (!m_stiffness.empty())
    return setBedded(m_weight.size(), m_weight.data(), m_point.data(), m_stiffness.data(), m_viscosity.data(),
                     x, v, force);
  std::copy(m_weight.begin(), m_weight.end(), force);
  Lanes heat = {0, 0, 0, 0};
  for (const Anchor& anchor : m_few) {
    const Lanes drag = v[anchor.node] * anchor.viscosity;
    force[anchor.node] += (anchor.point - x[anchor.node]) * anchor.stiffness - drag;
    heat += drag * v[anchor.node];
  }
  return sumLanes(heat);
}

void NodeForces::addFewDampers(const Lanes* v, Lanes* force) const noexcept
{
  for (const Anchor& anchor : m_few) force[anchor.node] -= v[anchor.node] * anchor.viscosity;
}

} // namespace esm
