// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/system/step_loss.h"

#include <cmath>

namespace esm {

void StepLoss::prepare(const System& system)
{
  for (NodeArray* array : {&m_still, &m_place, &m_first, &m_last, &m_between}) *array = NodeArray();
  if (system.nodeCount() <= System::kLarge) makeRoom(system.nodeCount());
  m_isKnown = false;
}

void StepLoss::makeRoom(std::size_t nodes)
{
  for (NodeArray* array : {&m_still, &m_place, &m_first, &m_last, &m_between})
    array->assign(nodes, Lanes{0, 0, 0, 0});
}

/// Of springs, anchors, tools and weight, at rest at x.
void StepLoss::findForces(const System& system, const NodeArray& x, NodeArray& force) noexcept
{
  system.forces().computeForces(x.data(), m_still.data(), force.data(), nullptr, system.workers());
  for (const ToolSpring& tool : system.tools()) {
    const auto node = static_cast<std::size_t>(tool.node);
    force[node] += (toLanes(tool.target) - x[node]) * tool.stiffness;
  }
}

/// Of the forces at a share of the straight way, along all of it [J].
double StepLoss::powerAt(const System& system, const NodeArray& from, const NodeArray& to,
                         double share) noexcept
{
  for (std::size_t i = 0; i < to.size(); ++i) m_place[i] = from[i] + (to[i] - from[i]) * share;
  findForces(system, m_place, m_between);
  double sum = 0.0;
  for (std::size_t i = 0; i < to.size(); ++i) sum += dot(m_between[i], to[i] - from[i]);
  return sum;
}

double StepLoss::find(const System& system, const MotionState& start, const NodeArray& x, const NodeArray& v,
                      double work, double heat, double precision)
{
  constexpr int kMostParts = 256;
  if (m_still.empty()) makeRoom(x.size());
  if (!m_isKnown) findForces(system, start.x, m_first);
  findForces(system, x, m_last);
  double ends = 0.0, gained = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    ends += 0.5 * dot(m_first[i] + m_last[i], x[i] - start.x[i]);
    gained += 0.5 * system.mass()[i] * dot(v[i] - start.v[i], v[i] + start.v[i]);
  }
  m_first.swap(m_last);
  m_isKnown = true;
  const double middle = powerAt(system, start.x, x, 0.5);
  double rule = 0.5 * (ends + middle), simpson = (ends + 2.0 * middle) / 3.0, worked = simpson;
  const double others = std::abs(gained) + std::abs(work) + std::abs(heat);
  for (int parts = 4; precision < 1.0 && parts <= kMostParts; parts *= 2) { // Romberg's scheme, two columns
    double inner = 0.0;
    for (int i = 1; i < parts; i += 2) inner += powerAt(system, start.x, x, static_cast<double>(i) / parts);
    const double finer = 0.5 * rule + inner / parts, next = (4.0 * finer - rule) / 3.0;
    const double change = std::abs(next - simpson);
    worked = next + (next - simpson) / 15.0;
    rule = finer;
    simpson = next;
    if (change <= 15.0 * precision * (std::abs(worked) + others)) break;
  }
  return worked + work - heat - gained;
}

} // namespace esm
