// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/rest/load_watch.h"

#include <algorithm>

namespace esm {
namespace {

void append(std::vector<Index>& to, const std::vector<Index>& nodes)
{
  to.insert(to.end(), nodes.begin(), nodes.end());
}

/// Whether the curve turns or jumps at `event`, its slope before being `slope`.
bool changesAt(const VectorCurve& curve, double event, const Eigen::Vector3d& slope)
{
  const auto [first, last] = std::equal_range(curve.time.begin(), curve.time.end(), event);
  if (first == last) return false;
  return last - first > 1 || !slope.isZero(0.0) || !curve.slopeAt(event).isZero(0.0);
}

} // namespace

void LoadWatch::enter(const Loads& loads, double t, double nextEvent)
{
  m_moving.clear();
  m_atEvent.clear();
  for (const NodalForce& force : loads.forces) {
    const Eigen::Vector3d slope = force.force.slopeAt(t);
    if (!slope.isZero(0.0)) append(m_moving, force.nodes);
    if (changesAt(force.force, nextEvent, slope)) append(m_atEvent, force.nodes);
  }
  for (const PrescribedMotion& motion : loads.motions) {
    if (motion.release && t >= *motion.release) continue;
    const Eigen::Vector3d slope = motion.displacement.slopeAt(t);
    if (!slope.isZero(0.0)) append(m_moving, motion.nodes);
    if (changesAt(motion.displacement, nextEvent, slope) || (motion.release && *motion.release == nextEvent))
      append(m_atEvent, motion.nodes);
  }
}

} // namespace esm
