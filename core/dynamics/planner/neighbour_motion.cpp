// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/neighbour_motion.h"

#include "core/dynamics/system/frame.h"

#include <algorithm>
#include <cmath>

namespace esm {

void NeighbourMotion::begin(const SpringNet& net, const Loads& loads, const NodeArray& pattern, double extent)
{
  m_system = System(net, loads);
  m_integrator = makeIntegrator("leapfrog");
  m_integrator->prepare(m_system);
  m_extent = extent;
  m_v = pattern;
  m_x.assign(m_v.size(), Lanes{0, 0, 0, 0});
  const double scale = m_policy->small * m_extent / size();
  for (Lanes& v : m_v) v *= scale;
  m_isReady = std::isfinite(scale);
}

void NeighbourMotion::setMode(const FastestMode& mode) noexcept
{
  m_integrator->tune(m_system, mode);
  m_step = m_policy->shareOfStable * m_integrator->stableStep(mode);
}

double NeighbourMotion::springs() const noexcept
{
  return std::max(static_cast<double>(m_system.forces().activeSprings()), 1.0);
}

double NeighbourMotion::passesTo(double end, bool isDamped) const noexcept
{
  return 2.0 * (end - m_before.time) / stepFor(isDamped);
}

/// RMS over the nodes, velocities by what they move in a frame [m].
double NeighbourMotion::size() const noexcept
{
  return std::sqrt((sumOfSquares(m_x) + kFrame * kFrame * sumOfSquares(m_v)) /
                   static_cast<double>(m_x.size()));
}

bool NeighbourMotion::run(MotionState& state, double end, double step)
{
  StepReport report;
  while (state.time < end) {
    m_system.enter(state, true);
    const double to = std::min(end, m_system.nextEvent(state.time));
    const double steps = std::ceil((to - state.time) / step);
    m_integrator->restart();
    if (!(steps >= 1.0 && steps < 1e6)) return false;
    if (m_integrator->run(m_system, state, to, static_cast<std::int64_t>(steps), report) != StepResult::Done)
      return false;
  }
  return true;
}

std::optional<double> NeighbourMotion::carryOn(double end, bool isDamped, double& passes)
{
  const double step = stepFor(isDamped);
  m_here = m_beside = m_before;
  for (std::size_t i = 0; i < m_x.size(); ++i) {
    m_beside.x[i] += m_x[i];
    m_beside.v[i] += m_v[i];
  }
  m_system.springsEvaluated = 0;
  const bool done = run(m_here, end, step) && run(m_beside, end, step);
  passes = static_cast<double>(m_system.springsEvaluated) / springs();
  if (done)
    for (std::size_t i = 0; i < m_x.size(); ++i) {
      m_x[i] = m_beside.x[i] - m_here.x[i];
      m_v[i] = m_beside.v[i] - m_here.v[i];
    }
  const double now = size(), target = m_policy->small * m_extent;
  if (!done || !std::isfinite(now) || !(now > 0.0)) return std::nullopt; // nothing to go by
  for (std::size_t i = 0; i < m_x.size(); ++i) {
    m_x[i] *= target / now;
    m_v[i] *= target / now;
  }
  return std::log(now / target);
}

} // namespace esm
