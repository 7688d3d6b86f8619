// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/learning/statics.h"

#include <algorithm>
#include <cmath>

namespace esm::learning {
namespace {

constexpr double kArmijo = 1e-4;
constexpr double kRounding = 1e-13;      ///< relative, of sums over a net
constexpr double kLeastPart = 1.0 / 512; ///< of a step
/// Where so little force is left and a step of Newton's method takes no more of it away, it is rounding.
constexpr double kNearlyNone = 1e-8;
constexpr double kLastDigits = 1e-14;                      ///< of a step, over the places
constexpr double kFirstShift = 1e-6, kLargestShift = 1e-2; ///< of the mass, for what has no stiffness

} // namespace

Status Statics::check(const SpringNet& net, const Loads& loads)
{
  if (!net.pressure.empty())
    return Error{
      ErrorCode::Unsupported,
      "the net keeps the volume of closed surfaces, which learning does not know yet; import it without "
      "a bulk modulus"};
  const bool isHeld = net.anchors.count() > 0 || !loads.motions.empty() ||
                      std::any_of(net.fixed.begin(), net.fixed.end(), [](std::uint8_t f) { return f != 0; });
  if (!isHeld)
    return invalidValue(
      "nothing holds the net: no node is fixed, prescribed or anchored, so that it rests nowhere");
  return {};
}

Statics::Statics(const SpringNet& net, const Loads& loads, double time)
  : m_system(net, loads), m_gravity(loads.gravity), m_time(time), m_rest(at(net.nodeCount()))
{
  copyNodes(net.restPosition, m_rest);
  for (NodeArray* array : {&m_x, &m_base, &m_still, &m_force, &m_step, &m_vector})
    array->assign(m_rest.size(), Lanes{0, 0, 0, 0});
  m_tension.resize(at(net.springCount()));
  m_pull.resize(m_rest.size());
  MotionState state;
  state.x = m_rest;
  state.v = m_still;
  state.time = m_time;
  m_system.enter(state, true);
  m_matrix.prepare(m_system);
  goToRest();
}

void Statics::setParameters(const SpringNet& net)
{
  m_system.setParameters(net, m_gravity);
  m_matrix.prepare(m_system); // the layout stays, unless other springs pull at all
}

void Statics::setPlace(const NodeArray& place)
{
  m_x = place;
  m_system.place(m_time, m_x, m_still);
  std::fill(m_still.begin(), m_still.end(), Lanes{0, 0, 0, 0});
}

void Statics::goToRest()
{
  setPlace(m_rest);
}

/// At m_x into m_force. @return their norm [N].
double Statics::findForces()
{
  m_system.evaluate(m_time, m_x, m_still, m_force);
  std::fill(m_still.begin(), m_still.end(), Lanes{0, 0, 0, 0}); // motions have a velocity, statics none
  for (std::size_t i = 0; i < m_force.size(); ++i)
    if (!m_system.isFree(i)) m_force[i] = Lanes{0, 0, 0, 0};
  return std::sqrt(sumOfSquares(m_force));
}

/// The sizes of all that pulls at each free node, added, as a norm over the nodes [N]: what is left of forces is
/// measured by it.
double Statics::pullAtNodes()
{
  const auto size = [](const Lanes& force) { return std::sqrt(dot(force, force)); };
  m_system.forces().springTensions(m_x.data(), m_still.data(), m_tension.data());
  std::fill(m_pull.begin(), m_pull.end(), 0.0);
  for (const SpringBatch& batch : m_system.forces().batches())
    for (std::size_t i = 0; i < batch.count; ++i) {
      const double tension = std::abs(m_tension[at(batch.spring[i])]);
      m_pull[at(batch.a[i])] += tension;
      m_pull[at(batch.b[i])] += tension;
    }
  for (const Anchor& anchor : m_system.forces().anchors())
    m_pull[at(anchor.node)] += anchor.stiffness * size(m_x[at(anchor.node)] - anchor.point);
  m_system.schedule().forEachForce(
    m_time, [&](std::size_t node, const Lanes& force, const Lanes&) { m_pull[node] += size(force); });
  double sum = 0.0;
  for (std::size_t i = 0; i < m_pull.size(); ++i) {
    if (!m_system.isFree(i)) continue;
    const double pull = m_pull[i] + size(m_system.forces().weight(i));
    sum += pull * pull;
  }
  return std::sqrt(sum);
}

double Statics::energy(const NodeArray& x) const noexcept
{
  double energy = m_system.storedEnergy(x);
  m_system.schedule().forEachForce(m_time, [&](std::size_t node, const Lanes& force, const Lanes&) {
    if (m_system.isFree(node)) energy -= dot(force, x[node]);
  });
  return energy;
}

double Statics::farthest() const noexcept
{
  double square = 0.0;
  for (std::size_t i = 0; i < m_x.size(); ++i) {
    if (!m_system.isFree(i)) continue;
    const Lanes way = m_x[i] - m_rest[i];
    square = std::max(square, dot(way, way));
  }
  return std::sqrt(square);
}

bool Statics::factor(bool convex, double shift)
{
  ++m_cost.factorizations;
  return m_matrix.factor(m_system, m_x, m_still, {shift, 0.0, 1.0}, convex);
}

/// m_step = K^-1 m_force; by the convex part of K where it is not positive definite. @return false without a factor.
bool Statics::findStep()
{
  bool isThere = factor(false, 0.0) && m_matrix.negativePivots() == 0;
  if (!isThere) {
    const double rate = m_matrix.stiffestRate(m_system, m_x, m_still);
    for (double shift = kFirstShift; !isThere && shift <= kLargestShift; shift *= 100.0)
      isThere = factor(true, shift * rate) && m_matrix.negativePivots() == 0;
  }
  if (!isThere) return false;
  m_step = m_force;
  solveTangent(m_step);
  return std::isfinite(sumOfSquares(m_step));
}

/// As much of m_step as makes the energy fall; where that is lost in rounding, as much as halves the forces.
bool Statics::takeStep(double& norm)
{
  const double before = energy(m_x), slope = -sumOfProducts(m_force, m_step), last = norm;
  m_base = m_x;
  for (double part = 1.0; part >= kLeastPart; part *= 0.5) {
    advanceNodes(m_x.size(), part, m_base.data(), m_step.data(), m_x.data());
    const double height = energy(m_x);
    const bool falls = height <= before + kArmijo * part * slope + kRounding * std::abs(before);
    norm = findForces();
    if (std::isfinite(norm) && std::isfinite(height) && (falls || norm <= 0.5 * last)) return true;
  }
  m_x = m_base;
  norm = findForces();
  return false;
}

/// Whether m_step is lost in the digits of the places: soft loads on stiff springs cannot be met better.
bool Statics::isRounding() const noexcept
{
  double step = 0.0, place = 0.0;
  for (std::size_t i = 0; i < m_x.size(); ++i) {
    step = std::max(step, dot(m_step[i], m_step[i]));
    place = std::max(place, dot(m_x[i], m_x[i]));
  }
  return step <= kLastDigits * kLastDigits * place;
}

bool Statics::firstStep(NodeArray& change)
{
  findForces();
  if (!factor(false, 0.0)) return false;
  change = m_force;
  solveTangent(change);
  return std::isfinite(sumOfSquares(change));
}

StaticAnswer Statics::solve(const StaticsLimits& limits)
{
  StaticAnswer answer;
  const StaticsCost before = m_cost;
  const auto finish = [&](StaticsOutcome outcome) {
    answer.outcome = outcome;
    answer.cost = {m_cost.factorizations - before.factorizations, m_cost.solves - before.solves};
    return answer;
  };
  double norm = findForces();
  if (m_matrix.freeCount() == 0) return finish(StaticsOutcome::Balanced);
  while (true) {
    const double pull = pullAtNodes();
    answer.force = pull > 0.0 ? norm / pull : 0.0;
    answer.farthest = farthest();
    if (!(answer.farthest <= limits.farthest)) return finish(StaticsOutcome::Snapped);
    if (answer.force <= limits.force) break;
    if (answer.steps == limits.steps) return finish(StaticsOutcome::Snapped);
    if (!findStep()) return finish(StaticsOutcome::Loose);
    ++answer.steps;
    const double last = norm;
    const bool isTaken = takeStep(norm);
    const bool isLast = answer.force <= kNearlyNone || isRounding();
    if (isLast && (!isTaken || norm > 0.5 * last)) break;
    if (!isTaken) return finish(StaticsOutcome::Snapped);
  }
  if (!factor(false, 0.0)) return finish(StaticsOutcome::Loose);
  answer.negativePivots = m_matrix.negativePivots();
  return finish(answer.negativePivots == 0 ? StaticsOutcome::Balanced : StaticsOutcome::Snapped);
}

void Statics::solveTangent(NodeArray& vector)
{
  ++m_cost.solves;
  m_matrix.solve(vector);
}

} // namespace esm::learning
