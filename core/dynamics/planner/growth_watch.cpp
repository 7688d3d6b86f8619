// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/growth_watch.h"

#include "core/dynamics/system/frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {
namespace {

constexpr double kFirstLookCost = 12.0; ///< a guess [force passes]
constexpr double kWatchShare = 0.015;   ///< of the work
constexpr double kShareUndamped = 0.05; ///< where no damper lets errors fade
constexpr double kDebtShare = 0.03;
constexpr int kOften = 2; ///< looks: what gives way once, as a poked organ, seldom does for long
constexpr int kBurst = 6; ///< frames
/// Logarithm of what it must grow by in each of them, but for so much, else they end: what only wobbles does
/// not pay.
constexpr double kLeastRate = 0.1, kSlack = 0.2;
constexpr double kGrows = 1.4;         ///< logarithm of what they must grow by to be followed further
constexpr double kSmall = 1e-7;        ///< of the extent: the difference that is followed
constexpr double kGrownEnough = 8.0;   ///< logarithm of a growth beyond which nobody needs to know more
constexpr double kShareOfStable = 0.9; ///< of the stable step, as stiffness may rise in the frame
/// Of that, where no damper is: steps at their limit turn the waves by other angles than the motion has done, and
/// a frame after the other of that multiplies what the motion does not. With 0.9 a free pair seemed to.
constexpr double kFineness = 0.25;
/// Of what the motion's own frame took, that following it may: explicit steps take a few times that. Where the motion
/// goes by implicit steps they may take a million.
constexpr double kMostOfFrame = 12.0;
constexpr double kAnyFrame = 2e5; ///< besides, of any motion [spring evaluations]

bool isDamped(const SpringNet& net)
{
  const auto any = [](const Eigen::ArrayXd& values) { return values.size() > 0 && values.maxCoeff() > 0.0; };
  return any(net.viscosity) || any(net.massDamping) || any(net.anchors.viscosity);
}

} // namespace

void GrowthWatch::begin(const SpringNet& net, const Loads& loads)
{
  m_net = &net;
  m_loads = &loads;
  const Eigen::Vector3d box = net.restPosition.rowwise().maxCoeff() - net.restPosition.rowwise().minCoeff();
  m_extent = std::max(box.norm(), 1e-12);
  m_share = isDamped(net) ? kWatchShare : kShareUndamped;
  m_work = m_debt = m_spent = 0.0;
  m_lookCost = kFirstLookCost;
  m_left = 0;
  m_timesGivenWay = 0;
  m_looksAgain = false;
  m_hasStart = false;
  m_largest = 1.0;
}

void GrowthWatch::pay(double passes) noexcept
{
  m_work += passes;
  m_framePasses = passes;
  m_debt = std::max(m_debt - kDebtShare * passes, 0.0);
}

bool GrowthWatch::lookIsDue() const noexcept
{
  if (std::log(m_largest) >= kGrownEnough) return false;
  return m_looksAgain || (m_work * m_share >= m_lookCost && m_debt <= 0.0);
}

void GrowthWatch::remember(const MotionState& motion)
{
  if (m_left > 0) m_before = motion; // same size: no allocation
}

bool GrowthWatch::look(const System& system, const MotionState& motion)
{
  constexpr double kPreparation = 2.0; // force passes
  m_work = 0.0;
  m_stiffness.prepare(system, motion.x, 0.0);
  const bool givesWay =
    m_stiffness.givesWay(system, std::exchange(m_looksAgain, false) ? &m_pattern : nullptr);
  if (givesWay) m_pattern = m_stiffness.direction();
  m_lookCost = kPreparation + m_stiffness.products();
  m_spent += m_lookCost;
  m_stiffness = StiffnessCg(); // looks are rare
  if (!givesWay) return false;
  m_looksAgain = ++m_timesGivenWay < kOften;
  if (m_looksAgain) return false;
  if (!m_hasStart) start();
  if (!m_hasStart) return false;
  m_size = m_least = m_burstStart = 0.0;
  m_frames = 0;
  m_left = kBurst;
  return true;
}

void GrowthWatch::setMode(const FastestMode& mode) noexcept
{
  m_integrator->tune(m_system, mode);
  m_step = kShareOfStable * m_integrator->stableStep(mode);
}

/// A difference in the velocities, in the pattern in which the net gives way.
void GrowthWatch::start()
{
  m_system = System(*m_net, *m_loads);
  m_integrator = makeIntegrator("leapfrog");
  m_integrator->prepare(m_system);
  m_v = m_pattern;
  m_x.assign(m_v.size(), Lanes{0, 0, 0, 0});
  const double scale = kSmall * m_extent / size();
  for (Lanes& v : m_v) v *= scale;
  m_size = m_least = 0.0;
  m_frames = 0;
  m_hasStart = std::isfinite(scale);
}

/// RMS over the nodes, velocities by what they move in a frame [m].
double GrowthWatch::size() const noexcept
{
  return std::sqrt((sumOfSquares(m_x) + kFrame * kFrame * sumOfSquares(m_v)) /
                   static_cast<double>(m_x.size()));
}

bool GrowthWatch::run(MotionState& state, double end, double step)
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

/// Whether the difference has grown no faster than with the square of the frames that were followed, since it
/// was at its least. Marks stand at powers of two of them, so the former one at a half to a quarter of the way.
bool GrowthWatch::onlyDrifts() noexcept
{
  constexpr double kPower = 2.0;
  if (m_frames == 0 || m_size < m_least) {
    m_least = std::min(m_least, m_size);
    m_frames = m_mark = 1;
    m_mostSoFar = m_mostAtMark = m_mostAtFormerMark = m_least;
    return true;
  }
  if (++m_frames >= 2 * m_mark) {
    m_mark *= 2;
    m_mostAtFormerMark = std::exchange(m_mostAtMark, m_mostSoFar);
  }
  m_mostSoFar = std::max(m_mostSoFar, m_size);
  const double share = 2.0 * m_frames / m_mark; // of now over the former mark
  return m_size - m_mostAtFormerMark <= kPower * std::log(share);
}

void GrowthWatch::carryOn(const MotionState& motion)
{
  const double step = m_share == kShareUndamped ? kFineness * m_step : m_step;
  const double springs = std::max(static_cast<double>(m_system.forces().activeSprings()), 1.0);
  if (!(2.0 * (motion.time - m_before.time) / step <= kMostOfFrame * m_framePasses + kAnyFrame / springs)) {
    m_hasStart = false;
    m_left = 0;
    return;
  }
  m_here = m_beside = m_before;
  for (std::size_t i = 0; i < m_x.size(); ++i) {
    m_beside.x[i] += m_x[i];
    m_beside.v[i] += m_v[i];
  }
  m_system.springsEvaluated = 0;
  const bool done = run(m_here, motion.time, step) && run(m_beside, motion.time, step);
  const double passes = static_cast<double>(m_system.springsEvaluated) / springs;
  m_debt += passes;
  m_spent += passes;
  const double target = kSmall * m_extent;
  if (done)
    for (std::size_t i = 0; i < m_x.size(); ++i) {
      m_x[i] = m_beside.x[i] - m_here.x[i];
      m_v[i] = m_beside.v[i] - m_here.v[i];
    }
  const double now = size();
  if (!done || !std::isfinite(now) || !(now > 0.0)) { // nothing to go by
    m_hasStart = false;
    m_left = 0;
    return;
  }
  m_size += std::log(now / target);
  const bool drifts = onlyDrifts();
  if (const double growth = std::exp(std::min(m_size - m_least, kGrownEnough));
      !drifts && growth > m_largest) {
    m_largest = growth;
    m_time = motion.time;
  }
  for (std::size_t i = 0; i < m_x.size(); ++i) {
    m_x[i] *= target / now;
    m_v[i] *= target / now;
  }
  const double grown = m_size - m_burstStart;
  const int frames = kBurst + 1 - m_left;
  if (!(grown >= kLeastRate * frames - kSlack)) m_left = 1;
  if (--m_left > 0 || grown < kGrows || m_size - m_least >= kGrownEnough) return;
  m_left = kBurst;
  m_burstStart = m_size;
}

} // namespace esm
