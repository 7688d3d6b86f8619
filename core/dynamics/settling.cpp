// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/settling.h"

#include "core/dynamics/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();
constexpr double kInertia = 1e-2; ///< share of the mass in the stiffness, 1/(10 s)^2 [1/s^2]
/// Of the forces, that may be left at the goal: the net is nearly linear on its way there, or it is not near.
constexpr double kLeft = 0.5;
/// Of the sum of squares that may be missed for good: what is left of the way does not fade.
constexpr double kForGood = 0.1;
/// Further steps with the same factor, each of which must be that much shorter than the one before: forces
/// along stiff springs hardly fall with the first one, which knows them at the start only, and vanish with
/// the second.
constexpr int kMostCorrections = 3;

/// Of the mean square over the nodes, that a single one may miss: nobody shall see one spot stop at a blow.
constexpr double kMostLocal = 25.0;
constexpr std::size_t kMostNodes = 10000; ///< a factor of 150 MB in a solid
constexpr double kNear = 12.0; ///< speeds with which nets of usual frequencies are as near as they must be
constexpr double kGradientsCost = 80.0; ///< force passes, of both solutions
/// Iterations of conjugate gradients where a factor might cost less; else as many as some frames may cost.
constexpr int kFewIterations = 48;
constexpr double kLayoutCost = 1500.0; ///< spring evaluations per node, measured
constexpr double kLongestTry = 4.0;    ///< frames
constexpr double kPatience = 3.0;
constexpr int kLongestWait = 32; ///< looks
constexpr int kWaitUnknown = 3;  ///< the same after an attempt that told no distance: the net bends too much
/// Of the time in which amplitudes fade to what may be missed: no attempt before. They are not known to fade
/// faster than that, and a swing that is slow where it turns is no nearer to its end.
constexpr double kLeastWait = 0.4;
/// Of the amplitude that may be missed: from there on each attempt only waits for what has to fade, and may
/// cost more, as it may save the next frame. Where waves meet on their way about an organ its speed rises
/// once more.
constexpr double kNearlyThere = 1.5;
constexpr int kGlances = 16;          ///< iterations of each bound
constexpr double kGlanceCost = 40.0;  ///< force passes, with all of them
constexpr double kFarEnough = 16.0;   ///< share of what may be missed, that a bound need not go beyond
constexpr double kMostSquares = 16.0; ///< see SettlingBudget

/// Mean square over what is left of the motion, if that ended now.
/// @param way, swing  sums of squares: how far the goal is, and how far the velocities carry a net beyond it
double missedOf(double way, double swing) noexcept
{
  return std::max(way, 0.5 * (way + swing));
}

/// What is missed over what may be; a net that creeps takes amplitude over speed to its goal, if that is
/// longer than it takes to fade. Rises with what is missed.
/// @param missed, speed  sums of squares over the nodes
double shareOf(double missed, double speed, const SettlingBudget& budget) noexcept
{
  const double creeping = speed > 0.0 ? std::sqrt(missed / speed) : std::numeric_limits<double>::infinity();
  return missed / budget.squareAt(std::max(budget.fading, creeping));
}

} // namespace

double SettlingBudget::squareAt(double fadingTime) const noexcept
{
  const double gain = since > 0.0 ? 1.0 + 2.0 * since / fadingTime : 1.0;
  return square * std::min(gain, kMostSquares);
}

/// Forces on nodes at x that stand still, into m_force; 0 where a support holds. @return their norm [N].
double Settling::forcesAt(System& system, double time, NodeArray& x, StepReport& report)
{
  const std::int64_t before = system.springsEvaluated;
  m_still.assign(x.size(), Lanes{0, 0, 0, 0});
  m_force.resize(x.size());
  system.evaluate(time, x, m_still, m_force);
  report.springsEvaluated += system.springsEvaluated - before;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (!system.isFree(i)) m_force[i] = Lanes{0, 0, 0, 0};
  return std::sqrt(sumOfSquares(m_force));
}

void Settling::begin() noexcept
{
  forget();
  m_isNear = false;
  m_dueSpeed = m_dueTime = m_work = m_workAtGlance = 0.0;
  m_looksLeft = 0;
}

void Settling::forget() noexcept
{
  m_isLaidOut = m_gradientsFail = false;
}

/// The pressure of a body couples all of its nodes, which only the factor knows.
bool Settling::takesFactor(const System& system) const noexcept
{
  return m_gradientsFail || !system.forces().pressure().isEmpty();
}

double Settling::patience() const noexcept
{
  return m_isNear ? 1.0 : kPatience;
}

bool Settling::mayGlance(const System& system) const noexcept
{
  const double cost = kGlanceCost * static_cast<double>(system.forces().activeSprings());
  return patience() * cost <= m_work - m_workAtGlance;
}

/// By what is known so far: what a factor costs is so once it is laid out.
bool Settling::mayAttempt(const System& system, double effort) const noexcept
{
  if (!takesFactor(system) || m_isLaidOut)
    return attemptCost(system) <= std::min(m_work / patience(), effort);
  return system.nodeCount() <= kMostNodes &&
         kLayoutCost * static_cast<double>(system.nodeCount()) <= std::min(m_work, kLongestTry * effort);
}

double Settling::attemptCost(const System& system) const noexcept
{
  return takesFactor(system) ? m_matrix.factorCost() + 2.0 * m_matrix.solveCost()
                             : kGradientsCost * static_cast<double>(system.forces().activeSprings());
}

bool Settling::settleIfDue(System& system, MotionState& motion, const SettlingBudget& budget, double effort,
                           StepReport& report)
{
  const double speed = std::sqrt(sumOfSquares(motion.v) / static_cast<double>(motion.x.size())); // RMS
  const double most = budget.squareAt(budget.fading);
  const double within = std::sqrt(most / static_cast<double>(motion.x.size()));
  if (speed * kFrame > kNear * within) {
    m_dueSpeed = std::numeric_limits<double>::infinity();
    return false;
  }
  if (m_looksLeft > 0 && (motion.time < m_dueTime || speed > m_dueSpeed)) {
    --m_looksLeft;
    return false;
  }
  if (!mayGlance(system) || !mayAttempt(system, effort)) return false;
  m_looksLeft = kLongestWait;
  m_workAtGlance = m_work;
  double missed = glance(system, motion, budget, report);
  if (missed <= 1.0) missed = attempt(system, motion, budget, effort, report);
  const double times = std::sqrt(std::max(missed, 1.0)); // of the amplitude that may be missed
  m_isNear = times < kNearlyThere;
  if (!std::isfinite(missed)) { // nothing to go by
    m_looksLeft = kWaitUnknown;
    m_dueSpeed = 0.0;
    return false;
  }
  m_dueSpeed = m_isNear ? std::numeric_limits<double>::infinity() : 0.9 * speed / times;
  m_dueTime = motion.time + kLeastWait * budget.fading * std::log(times);
  return missed <= 1.0;
}

/// settle(); once more by a factor where gradients take too long, as soon as that is worth it.
double Settling::attempt(System& system, MotionState& motion, const SettlingBudget& budget, double effort,
                         StepReport& report)
{
  double missed = kUnknown;
  if (!takesFactor(system)) {
    const double springs = std::max(static_cast<double>(system.forces().activeSprings()), 1.0);
    const double most = motion.x.size() > kMostNodes ? kMostIterations : kFewIterations;
    m_mostIterations = // of each of two solutions
      static_cast<int>(std::clamp(0.5 * kLongestTry * effort / springs, double{kFewIterations}, most));
    missed = settle(system, motion, budget, report);
    if (m_gradientsFail) return attempt(system, motion, budget, effort, report);
  } else {
    if (!mayAttempt(system, effort)) return kUnknown;
    layOut(system);
    if (attemptCost(system) <= std::min(m_work, effort)) missed = settle(system, motion, budget, report);
  }
  m_work = m_workAtGlance = 0.0;
  return missed;
}

double Settling::glance(System& system, MotionState& motion, const SettlingBudget& budget, StepReport& report)
{
  if (!system.forces().pressure().isEmpty()) return 0.0;
  m_gradients.prepare(system, motion.x, kInertia);
  const double speed = sumOfSquares(motion.v), enough = kFarEnough * budget.squareAt(budget.fading);
  m_way.resize(motion.x.size());
  scaleNodes(m_way.size(), system.mass().data(), motion.v.data(), m_way.data());
  const double momentum = std::sqrt(sumOfSquares(m_way));
  double way = 0.0, swing = 0.0;
  if (momentum > 0.0) {
    const double perEnergy = std::sqrt(speed) / momentum; // |v| |y| >= |v|/|M v| (M v).y
    swing = perEnergy * m_gradients.below(system, m_way, 2.0 * enough / perEnergy, kGlances);
  }
  if (missedOf(way, swing) <= enough && !m_gradients.metNegative()) {
    const double force = forcesAt(system, motion.time, motion.x, report);
    if (force > 0.0)
      way = std::pow(m_gradients.below(system, m_force, force * std::sqrt(enough), kGlances) / force, 2);
  }
  return m_gradients.metNegative() ? kUnknown : shareOf(missedOf(way, swing), speed, budget);
}

/// What is missed over what may be, by m_way and m_swing.
double Settling::shareOfWay(const MotionState& motion, const SettlingBudget& budget) const noexcept
{
  const double speed = sumOfSquares(motion.v);
  double missed = missedOf(sumOfSquares(m_way), std::sqrt(speed * sumOfSquares(m_swing))), local = 0.0;
  for (std::size_t i = 0; i < m_way.size(); ++i)
    local = std::max(local, dot(m_way[i], m_way[i]) +
                              std::sqrt(dot(motion.v[i], motion.v[i]) * dot(m_swing[i], m_swing[i])));
  missed = std::max(missed, local / kMostLocal * static_cast<double>(m_way.size()));
  return shareOf(missed, speed, budget);
}

void Settling::layOut(const System& system)
{
  if (m_isLaidOut) return;
  m_matrix.prepare(system);
  m_isLaidOut = true;
}

/// @return whether the stiffness is positive definite, as far as known.
bool Settling::prepareSolve(System& system, const NodeArray& x, StepReport& report)
{
  if (!takesFactor(system)) {
    m_gradients.prepare(system, x, kInertia);
    return !m_gradients.givesWay(system);
  }
  layOut(system);
  m_matrix.constraintsChanged(system);
  ++report.factorizations;
  return m_matrix.factor(system, x, m_still, {kInertia, 0.0, 1.0}, false) && m_matrix.negativePivots() == 0;
}

/// vector = K^-1 vector. @return false where that cannot be told.
bool Settling::solve(System& system, NodeArray& vector)
{
  if (takesFactor(system)) {
    m_matrix.solve(vector);
    return true;
  }
  const StiffnessCg::Result result = m_gradients.solve(system, vector, m_mostIterations);
  m_gradientsFail = result == StiffnessCg::Result::TooSlow;
  return result == StiffnessCg::Result::Solved;
}

double Settling::settle(System& system, MotionState& motion, const SettlingBudget& budget, StepReport& report)
{
  m_goal = motion.x;
  const double force = forcesAt(system, motion.time, m_goal, report);
  if (!prepareSolve(system, motion.x, report)) return kUnknown;
  m_swing.resize(motion.x.size());
  scaleNodes(m_swing.size(), system.mass().data(), motion.v.data(), m_swing.data());
  if (!solve(system, m_swing)) return kUnknown;
  m_way.assign(motion.x.size(), Lanes{0, 0, 0, 0});
  double share = 0.0, last = kUnknown; // of the way so far; length of its last step
  for (int corrections = 0;; ++corrections) {
    if (!solve(system, m_force)) return kUnknown;
    const double length = std::sqrt(sumOfSquares(m_force));
    if (!(length <= kLeft * last)) return kUnknown;
    last = length;
    for (std::size_t i = 0; i < m_goal.size(); ++i) {
      m_goal[i] += m_force[i];
      m_way[i] += m_force[i];
    }
    share = shareOfWay(motion, budget);
    if (!(share <= 1.0)) return std::isfinite(share) ? share : kUnknown;
    const double forceThere = forcesAt(system, motion.time, m_goal, report);
    const double left = force > 0.0 ? forceThere / force : 0.0; // of the way, about
    if (left <= kLeft && left * left * sumOfSquares(m_way) <= kForGood * budget.square) break;
    if (corrections == kMostCorrections) return kUnknown;
  }
  const double loads = system.loadPower(motion.time, m_way); // over the way: their work
  motion.work += loads;
  motion.heat +=
    system.kineticEnergy(motion.v) + system.storedEnergy(motion.x) - system.storedEnergy(m_goal) + loads;
  motion.x.swap(m_goal);
  motion.v.swap(m_still);
  return share;
}

} // namespace esm
