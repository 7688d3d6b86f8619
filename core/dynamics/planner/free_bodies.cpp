// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/free_bodies.h"

#include "core/geometry/union_find.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {
namespace {

constexpr double kOwnShare = 1e-10;                                            ///< of a motion, see keep()
constexpr double kSumRounding = 64.0 * std::numeric_limits<double>::epsilon(); ///< of sums over nodes
constexpr double kBalancedLoads = 1e-12; ///< of what loads pull: forces in balance

Lanes cross(const Lanes& a, const Lanes& b) noexcept
{
  return Lanes{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0], 0.0};
}

double lengthOf(const Lanes& a) noexcept
{
  return std::sqrt(dot(a, a));
}

} // namespace

void FreeBodies::find(const System& system)
{
  const std::size_t nodes = system.nodeCount();
  const ForceModel& forces = system.forces();
  UnionFind parts(static_cast<Index>(nodes));
  for (const ForceModel::Ends& ends : forces.springEnds())
    parts.join(static_cast<Index>(ends.a), static_cast<Index>(ends.b));
  for (std::size_t p = 0; p < forces.pressure().bodyCount(); ++p) {
    const std::vector<Index>& corners = forces.pressure().corners(p);
    for (const Index node : corners) parts.join(node, corners.front());
  }
  std::vector<std::uint8_t> isHeld(nodes, 0);
  const auto partOf = [&](std::size_t node) {
    return static_cast<std::size_t>(parts.root(static_cast<Index>(node)));
  };
  const auto hold = [&](std::size_t node) { isHeld[partOf(node)] = 1; };
  for (std::size_t i = 0; i < nodes; ++i)
    if (!system.isFree(i) || (!forces.massDrag().empty() && forces.massDrag()[i] > 0.0)) hold(i);
  for (const ForceModel::Anchor& anchor : forces.anchors()) hold(static_cast<std::size_t>(anchor.node));
  for (const ToolSpring& tool : system.tools()) hold(static_cast<std::size_t>(tool.node));

  m_bodies.clear();
  m_bodyOf.assign(nodes, kNoIndex);
  std::vector<Index> bodyOfPart(nodes, kNoIndex);
  for (std::size_t i = 0; i < nodes; ++i) {
    const std::size_t part = partOf(i);
    if (isHeld[part]) continue;
    if (bodyOfPart[part] == kNoIndex) {
      bodyOfPart[part] = static_cast<Index>(m_bodies.size());
      m_bodies.emplace_back();
    }
    m_bodyOf[i] = bodyOfPart[part];
    Body& body = m_bodies[static_cast<std::size_t>(m_bodyOf[i])];
    body.mass += system.mass()[i];
    body.weight += forces.weight(i);
  }
  m_nodes.build(m_bodies.size(), [&](const auto& add) {
    for (std::size_t i = 0; i < nodes; ++i)
      if (m_bodyOf[i] != kNoIndex) add(m_bodyOf[i], static_cast<Index>(i));
  });
  m_frameForce.assign(m_bodies.empty() ? 0 : nodes, Lanes{0, 0, 0, 0});
  m_first = m_frameForce;
}

void FreeBodies::begin(const System& system, const MotionState& state)
{
  for (std::size_t b = 0; b < count(); ++b) {
    Lanes squares;
    const Centre centre = centreOf(system, state, b, squares);
    m_bodies[b].x = centre.x;
    m_bodies[b].v = centre.v;
    m_bodies[b].way = 0.0;
    for (const Index node : m_nodes[b])
      m_first[static_cast<std::size_t>(node)] = state.x[static_cast<std::size_t>(node)];
  }
  takeLoads(system, state.time);
}

void FreeBodies::enter(const System& system, double time)
{
  for (Body& body : m_bodies) {
    const Centre centre = centreAt(body, time);
    body.x = centre.x;
    body.v = centre.v;
  }
  takeLoads(system, time);
}

void FreeBodies::takeLoads(const System& system, double time) noexcept
{
  m_begin = time;
  for (Body& body : m_bodies) {
    body.load = body.slope = Lanes{0, 0, 0, 0};
    body.loads = 0.0;
  }
  if (isEmpty()) return;
  system.schedule().forEachForce(time,
                                 [&](std::size_t node, const Lanes& force, const Lanes& slope) noexcept {
                                   if (m_bodyOf[node] == kNoIndex) return;
                                   Body& body = m_bodies[static_cast<std::size_t>(m_bodyOf[node])];
                                   body.load += force;
                                   body.slope += slope;
                                   body.loads += lengthOf(force);
                                 });
}

/// By m a = F, from m_begin on.
FreeBodies::Centre FreeBodies::centreAt(const Body& body, double time) const noexcept
{
  const double t = time - m_begin, rate = 1.0 / body.mass;
  const Lanes a = (body.weight + body.load) * rate, jerk = body.slope * rate;
  return {body.x + (body.v + (a / 2.0 + jerk * (t / 6.0)) * t) * t, body.v + (a + jerk * (t / 2.0)) * t};
}

/// @param squares  gets the means of x^2 and v^2, by mass
FreeBodies::Centre FreeBodies::centreOf(const System& system, const MotionState& state, std::size_t body,
                                        Lanes& squares) const noexcept
{
  Centre sum{{0, 0, 0, 0}, {0, 0, 0, 0}};
  double xSquare = 0.0, vSquare = 0.0;
  for (const Index node : m_nodes[body]) {
    const auto i = static_cast<std::size_t>(node);
    const double mass = system.mass()[i];
    sum.x += state.x[i] * mass;
    sum.v += state.v[i] * mass;
    xSquare += dot(state.x[i], state.x[i]) * mass;
    vSquare += dot(state.v[i], state.v[i]) * mass;
  }
  const double rate = 1.0 / m_bodies[body].mass;
  squares = Lanes{xSquare * rate, vSquare * rate, 0, 0};
  return {sum.x * rate, sum.v * rate};
}

bool FreeBodies::keep(const System& system, MotionState& state, double length) noexcept
{
  bool moved = false;
  for (std::size_t b = 0; b < count(); ++b) {
    constexpr int kTries = 3; // back from very far away rounding leaves it beside its place
    for (int i = 0; i < kTries && putInPlace(system, state, b, length); ++i) moved = true;
  }
  return moved;
}

/// Of its nodes since begin(), RMS by mass [m].
double FreeBodies::wayOf(const System& system, const MotionState& state, std::size_t body) const noexcept
{
  double sum = 0.0;
  for (const Index node : m_nodes[body]) {
    const auto i = static_cast<std::size_t>(node);
    const Lanes way = state.x[i] - m_first[i];
    sum += system.mass()[i] * dot(way, way);
  }
  return std::sqrt(sum / m_bodies[body].mass);
}

/// @return whether the body was elsewhere
bool FreeBodies::putInPlace(const System& system, MotionState& state, std::size_t index,
                            double length) noexcept
{
  Body& body = m_bodies[index];
  Lanes squares;
  const Centre is = centreOf(system, state, index, squares), should = centreAt(body, state.time);
  const Lanes way = should.x - is.x, change = should.v - is.v;
  const double speed = std::sqrt(squares[1]);
  body.way = std::max(body.way, wayOf(system, state, index));
  const double motion = std::min(length * speed, body.way);
  const bool isThere = lengthOf(way) <= kOwnShare * motion + kSumRounding * std::sqrt(squares[0]) &&
                       lengthOf(change) <= kOwnShare * speed;
  if (isThere || !std::isfinite(dot(way, way) + dot(change, change))) return false;
  const Lanes load = body.load + body.slope * (state.time - m_begin);
  state.work += dot(load, way);
  state.restored += body.mass * dot(is.v + change * 0.5, change) - dot(body.weight + load, way);
  for (const Index node : m_nodes[index]) {
    state.x[static_cast<std::size_t>(node)] += way;
    state.v[static_cast<std::size_t>(node)] += change;
  }
  return true;
}

void FreeBodies::enterFrame(System& system, MotionState& state, double end) noexcept
{
  if (isEmpty()) return;
  m_frameBegin = state.time;
  for (std::size_t b = 0; b < count(); ++b) {
    Body& body = m_bodies[b];
    const Centre from = centreAt(body, state.time);
    Lanes squares;
    const Centre is = centreOf(system, state, b, squares);
    body.frameX = from.x;
    body.frameV = from.v;
    body.enteredX = is.x;
    body.enteredV = is.v;
    body.spin = spinOf(system, state, b).momentum;
    body.frameA = (body.weight + body.load + body.slope * (end - m_begin)) / body.mass;
    for (const Index node : m_nodes[b]) {
      const auto i = static_cast<std::size_t>(node);
      state.v[i] -= from.v;
      m_frameForce[i] = body.frameA * -system.mass()[i];
    }
  }
  system.setFrame(m_frameForce.data());
  m_frameEnergy = energyOf(system, state);
}

/// In the frame: constant but for what steps lose.
double FreeBodies::energyOf(const System& system, const MotionState& state) noexcept
{
  return system.kineticEnergy(state.v) + system.storedEnergy(state.x) + state.heat - state.work;
}

FreeBodies::Spin FreeBodies::spinOf(const System& system, const MotionState& state,
                                    std::size_t body) const noexcept
{
  Lanes squares;
  const Centre centre = centreOf(system, state, body, squares);
  Spin spin;
  for (const Index node : m_nodes[body]) {
    const auto i = static_cast<std::size_t>(node);
    const Eigen::Vector3d arm = toVector(state.x[i] - centre.x), v = toVector(state.v[i] - centre.v);
    const double mass = system.mass()[i];
    spin.momentum += mass * arm.cross(v);
    spin.inertia += mass * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
  }
  return spin;
}

/// By turning each body as one. Where nodes lie on a line, about that nothing can turn.
void FreeBodies::restoreSpins(const System& system, MotionState& state) noexcept
{
  constexpr double kFlat = 1e-9;
  const double lost = m_frameEnergy - energyOf(system, state);
  if (!(lost > 0.0)) return;
  double price = 0.0;
  for (std::size_t b = 0; b < count(); ++b) {
    Body& body = m_bodies[b];
    body.turn.setZero();
    if (body.loads > 0.0 || !(dot(body.slope, body.slope) == 0.0)) continue;
    const Spin spin = spinOf(system, state, b);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spin.inertia);
    const Eigen::Vector3d missing = axes.eigenvectors().transpose() * (body.spin - spin.momentum);
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      if (axes.eigenvalues()[axis] > kFlat * axes.eigenvalues()[2])
        turn[axis] = missing[axis] / axes.eigenvalues()[axis];
    body.turn = axes.eigenvectors() * turn;
    price += body.turn.dot(spin.momentum) + 0.5 * body.turn.dot(spin.inertia * body.turn);
  }
  if (!std::isfinite(price)) return;
  const double share = price > lost ? lost / price : 1.0; // energy is convex: no more than that share of it
  for (std::size_t b = 0; b < count(); ++b) {
    if (m_bodies[b].turn.isZero(0.0)) continue;
    const Spin spin = spinOf(system, state, b);
    const Eigen::Vector3d turned = share * m_bodies[b].turn;
    state.restored += turned.dot(spin.momentum + 0.5 * spin.inertia * turned);
    Lanes squares;
    const Centre centre = centreOf(system, state, b, squares);
    const Lanes turn = toLanes(turned);
    for (const Index node : m_nodes[b]) {
      const auto i = static_cast<std::size_t>(node);
      state.v[i] += cross(turn, state.x[i] - centre.x);
    }
  }
}

void FreeBodies::leaveFrame(System& system, MotionState& state) noexcept
{
  if (isEmpty()) return;
  restoreSpins(system, state);
  system.setFrame(nullptr);
  for (std::size_t b = 0; b < count(); ++b) {
    const Centre to = centreAt(m_bodies[b], state.time);
    bookFrame(system, state, b, to);
    const Lanes way = to.x - m_bodies[b].frameX;
    for (const Index node : m_nodes[b]) {
      state.x[static_cast<std::size_t>(node)] += way;
      state.v[static_cast<std::size_t>(node)] += to.v;
    }
  }
}

/// The work of the loads on a centre that goes where it belongs, and what else its energy changes by: nothing,
/// if its momentum in the frame is still none.
void FreeBodies::bookFrame(const System& system, MotionState& state, std::size_t index,
                           const Centre& to) const noexcept
{
  const Body& body = m_bodies[index];
  // The integral of force times speed, both of them polynomials: by Simpson's rule with its rest.
  const double t = state.time - m_frameBegin;
  const Lanes first = body.load + body.slope * (m_frameBegin - m_begin);
  const Lanes half = first + body.slope * (t / 2.0), last = first + body.slope * t;
  const Lanes middle = centreAt(body, m_frameBegin + t / 2.0).v;
  const double work = (dot(first, body.frameV) + 4.0 * dot(half, middle) + dot(last, to.v)) * t / 6.0;
  Lanes squares;
  const Centre left = centreOf(system, state, index, squares);
  const double put = body.mass * dot(left.v + to.v * 0.5, to.v);
  const double taken = body.mass * dot(body.enteredV - body.frameV * 0.5, body.frameV);
  const double inFrame = body.mass * dot(body.frameA, left.x - body.enteredX); // was booked as stored
  state.work += work;
  state.restored += (put - taken) - inFrame - dot(body.weight, to.x - body.frameX) - work;
}

FreeBodies::RigidMotion FreeBodies::rigidMotion(const System& system, const MotionState& state,
                                                std::size_t index) const noexcept
{
  const Body& body = m_bodies[index];
  Lanes squares;
  const Centre centre = centreOf(system, state, index, squares);
  const Lanes force = body.weight + body.load + body.slope * (state.time - m_begin);
  if (lengthOf(force) > kBalancedLoads * (lengthOf(body.weight) + body.loads))
    return {true, lengthOf(centre.v), 0.0};
  Lanes spin = {0, 0, 0, 0};
  double inertia = 0.0;
  for (const Index node : m_nodes[index]) {
    const auto i = static_cast<std::size_t>(node);
    const Lanes arm = state.x[i] - centre.x;
    spin += cross(arm, state.v[i] - centre.v) * system.mass()[i];
    inertia += dot(arm, arm) * system.mass()[i];
  }
  Lanes torque = {0, 0, 0, 0};
  double most = 0.0;
  system.schedule().forEachForce(state.time, [&](std::size_t node, const Lanes& pull, const Lanes&) noexcept {
    if (m_bodyOf[node] != static_cast<Index>(index)) return;
    const Lanes arm = state.x[node] - centre.x;
    torque += cross(arm, pull);
    most += lengthOf(arm) * lengthOf(pull);
  });
  return {lengthOf(torque) > kBalancedLoads * most, lengthOf(centre.v),
          inertia > 0.0 ? lengthOf(spin) / std::sqrt(body.mass * inertia) : 0.0};
}

} // namespace esm
