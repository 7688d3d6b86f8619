// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/bound_watch.h"

#include "core/dynamics/methods/stiff_nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {
void BoundWatch::look(const System& system, const MotionState& state, bool asksForFew)
{
  m_mode = m_bound.compute(system, state.x, state.v);
  m_isOld = false;
  m_stiffest = {};
  if (m_mode.node != kNoIndex)
    m_stiffest = {m_names.of(m_mode.node), system.mass()[static_cast<std::size_t>(m_mode.node)]};
  m_since = 0.0;
  m_fewHoldAll = asksForFew && !StiffNodes::find(system).empty();
}

bool BoundWatch::lookIfDue(const System& system, const MotionState& state, bool asksForFew, bool implicit)
{
  const Policy::Bound& policy = m_policy->bound;
  const double usual = implicit                        ? policy.patienceImplicit
                       : system.forces().isNonlinear() ? policy.patienceNonlinear
                                                       : policy.patienceLinear;
  if (m_since < usual) return false;
  look(system, state, asksForFew);
  return true;
}

void BoundWatch::hurry() noexcept
{
  m_since = std::numeric_limits<double>::infinity();
}

FastestMode BoundWatch::ask(const System& system, const MotionState& state) const
{
  StepBound bound = m_bound;
  return bound.compute(system, state.x, state.v);
}

} // namespace esm
