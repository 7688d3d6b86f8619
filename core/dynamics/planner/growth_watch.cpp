// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/growth_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {
namespace {

bool hasDampers(const SpringNet& net)
{
  const auto any = [](const Eigen::ArrayXd& values) { return values.size() > 0 && values.maxCoeff() > 0.0; };
  return any(net.viscosity) || any(net.massDamping) || any(net.anchors.viscosity);
}

} // namespace

void GrowthWatch::begin(const SpringNet& net, const Loads& loads)
{
  m_net = &net;
  m_loads = &loads;
  m_isDamped = hasDampers(net);
  m_account = {};
  m_account.lookCost = m_policy.firstLookCost;
  m_spent = 0.0;
  m_timesGivenWay = 0;
  m_looksAgain = false;
  m_largest = 1.0;
  stop();
}

void GrowthWatch::stop() noexcept
{
  m_neighbour.drop();
  m_left = 0;
}

void GrowthWatch::pay(double passes) noexcept
{
  m_account.work += passes;
  m_account.framePasses = passes;
  m_account.debt = std::max(m_account.debt - m_policy.debtShare * passes, 0.0);
}

bool GrowthWatch::lookIsDue() const noexcept
{
  if (std::log(m_largest) >= m_policy.grownEnough) return false;
  const double share = m_isDamped ? m_policy.share : m_policy.shareUndamped;
  return m_looksAgain || (m_account.work * share >= m_account.lookCost && m_account.debt <= 0.0);
}

void GrowthWatch::remember(const MotionState& motion)
{
  if (m_left > 0) m_neighbour.remember(motion);
}

bool GrowthWatch::look(const System& system, const MotionState& motion)
{
  m_account.work = 0.0;
  m_stiffness.prepare(system, motion.x, 0.0);
  const bool givesWay =
    m_stiffness.givesWay(system, std::exchange(m_looksAgain, false) ? &m_pattern : nullptr);
  if (givesWay) m_pattern = m_stiffness.direction();
  m_account.lookCost = m_policy.preparation + m_stiffness.products();
  m_spent += m_account.lookCost;
  m_stiffness = StiffnessCg(); // looks are rare
  if (!givesWay) return false;
  m_looksAgain = ++m_timesGivenWay < m_policy.often;
  if (m_looksAgain) return false;
  if (!m_neighbour.isReady()) {
    const Eigen::Vector3d box =
      m_net->restPosition.rowwise().maxCoeff() - m_net->restPosition.rowwise().minCoeff();
    m_neighbour.begin(*m_net, *m_loads, m_pattern, std::max(box.norm(), 1e-12));
  }
  if (!m_neighbour.isReady()) return false;
  m_tally.restart();
  m_left = m_policy.burst;
  return true;
}

void GrowthWatch::carryOn(const MotionState& motion)
{
  const double most =
    m_policy.mostOfFrame * m_account.framePasses + m_policy.anyFrame / m_neighbour.springs();
  if (!(m_neighbour.passesTo(motion.time, m_isDamped) <= most)) return stop();
  double passes = 0.0;
  const std::optional<double> grown = m_neighbour.carryOn(motion.time, m_isDamped, passes);
  m_account.debt += passes;
  m_spent += passes;
  if (!grown) return stop();
  const bool drifts = m_tally.add(*grown);
  if (const double growth = std::exp(std::min(m_tally.sinceLeast(), m_policy.grownEnough));
      !drifts && growth > m_largest) {
    m_largest = growth;
    m_time = motion.time;
  }
  const int frames = m_policy.burst + 1 - m_left;
  const double inBurst = m_tally.inBurst();
  if (!(inBurst >= m_policy.leastRate * frames - m_policy.slack)) m_left = 1;
  if (--m_left > 0 || inBurst < m_policy.grows || m_tally.sinceLeast() >= m_policy.grownEnough) return;
  m_left = m_policy.burst;
  m_tally.beginBurst();
}

} // namespace esm
