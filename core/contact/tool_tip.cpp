// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/contact/tool_tip.h"

#include "core/contact/limited_pull.h"
#include "core/contact/tool_grip.h"
#include "core/geometry/nearest_weights.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

namespace {

constexpr int kMostTriangles = 64;      ///< that a contact slides over in one frame
constexpr double kLeastAgreement = 0.3; ///< of the smooth normal with the face's, as a cosine
constexpr double kSameStretch = 0.5;    ///< of two places at rest, as a cosine between their normals
constexpr double kLeastForce = 1e-6;    ///< [N]
/// What presses on a wall's surface spreads aside as far as its middle, which the net stands for. And so the
/// window's ball of 3 mm presses on an area that meshes of 4 mm still know from a point.
constexpr double kSpread = 0.003; ///< [m]

EdgeTable edgesOf(const SpringNet& net)
{
  Mesh mesh;
  mesh.position = net.restPosition;
  mesh.triangles = net.triangles;
  return findEdges(mesh);
}

bool isClosedSurface(const EdgeTable& edges)
{
  return edges.surfaceEdges > 0 && std::all_of(edges.triangleCount.begin(), edges.triangleCount.end(),
                                               [](Index count) { return count == 2; });
}

/// How stiff a tool's spring is on what a node opposes itself [N/m], and its damping with a mass behind it [N s/m].
double toolStiffness(double own)
{
  constexpr double kStiffnessRatio = 3.0;
  constexpr double kLeastStiffness = 20.0; // [N/m]: felt even on a loose node
  return std::max(kStiffnessRatio * own, kLeastStiffness);
}

double toolViscosity(double stiffness, double mass)
{
  constexpr double kRatio = 0.5; // of critical damping [1]
  return 2.0 * kRatio * std::sqrt(stiffness * mass);
}

const Eigen::Vector3d& agreeing(const Eigen::Vector3d& smooth, const Eigen::Vector3d& face)
{
  return smooth.dot(face) > kLeastAgreement ? smooth : face;
}

} // namespace

ToolTip::ToolTip(const SpringNet& net, double radius, double maxForce)
  : ToolTip(net, edgesOf(net), std::isfinite(radius) ? std::max(radius, 0.0) : 0.0, maxForce)
{}

ToolTip::ToolTip(const SpringNet& net, const EdgeTable& edges, double radius, double maxForce)
  : m_surface(net.triangles, net.restPosition),
    m_rest(net.restPosition),
    m_isClosed(isClosedSurface(edges)),
    m_finder(net.triangles, net.restPosition, edges, radius + kSpread),
    m_radius(radius)
{
  setMaxForce(maxForce);
  m_trianglesOf.build(static_cast<std::size_t>(net.nodeCount()), [&](const auto& add) {
    for (Index t = 0; t < net.triangleCount(); ++t)
      for (int k = 0; k < 3; ++k) add(net.triangles(k, t), t);
  });
  m_restNormal.resize(3, net.nodeCount());
  for (Index i = 0; i < net.nodeCount(); ++i) m_restNormal.col(i) = nodeNormal(i);
  adapt(net);
}

void ToolTip::adapt(const SpringNet& net)
{
  m_own.assign(static_cast<std::size_t>(net.nodeCount()), 0.0);
  for (Index s = 0; s < net.springCount(); ++s)
    for (int end = 0; end < 2; ++end) m_own[static_cast<std::size_t>(net.ends(end, s))] += net.stiffness[s];
  for (Index a = 0; a < net.anchors.count(); ++a)
    m_own[static_cast<std::size_t>(net.anchors.node[static_cast<std::size_t>(a)])] +=
      net.anchors.stiffness[a];
  m_mass.assign(net.mass.data(), net.mass.data() + net.mass.size());
}

void ToolTip::adapt(const SpringNet& net, std::span<const Index> nodes, NodeLinks& links)
{
  for (const Index node : nodes) {
    double& own = m_own[static_cast<std::size_t>(node)];
    own = 0.0;
    for (const Index s : links.springsOf(net, node)) own += net.stiffness[s];
    for (const Index a : links.anchorsOf(net, node)) own += net.anchors.stiffness[a];
    m_mass[static_cast<std::size_t>(node)] = net.mass[node];
  }
}

void ToolTip::setMaxForce(double newtons) noexcept
{
  m_maxForce = std::isfinite(newtons) ? std::max(newtons, kLeastForce) : kLeastForce;
}

void ToolTip::moveTo(const Eigen::Vector3d& hand, const Eigen::Vector3d& velocity)
{
  if (!hand.allFinite() || !velocity.allFinite()) return;
  m_hand = hand;
  m_velocity = velocity;
}

void ToolTip::letGo() noexcept
{
  m_touches = m_hasLast = false;
  m_lastSide = 0.0;
  m_near = m_contact = {};
}

// === Where the surface is

Eigen::Vector3d ToolTip::faceNormal(Index triangle) const
{
  const Eigen::Vector3d a = m_surface.corner(triangle, 0);
  return (m_surface.corner(triangle, 1) - a).cross(m_surface.corner(triangle, 2) - a);
}

Eigen::Vector3d ToolTip::nodeNormal(Index node) const
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Index triangle : m_trianglesOf[static_cast<std::size_t>(node)]) sum += faceNormal(triangle);
  return sum.normalized();
}

/// The nodes' normals between them, so that the force does not turn suddenly where triangles meet; the face's
/// own where the surface is too sharp for that.
Eigen::Vector3d ToolTip::normalAt(const SurfacePoint& point) const
{
  Eigen::Vector3d smooth = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
    smooth += point.weight[k] * nodeNormal(m_surface.triangles()(k, point.triangle));
  return agreeing(smooth.normalized(), faceNormal(point.triangle).normalized());
}

Eigen::Vector3d ToolTip::restNormalAt(const SurfacePoint& point) const
{
  const Eigen::Vector3i nodes = m_surface.triangles().col(point.triangle);
  Eigen::Vector3d smooth = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) smooth += point.weight[k] * m_restNormal.col(nodes[k]);
  const Eigen::Vector3d a = m_rest.col(nodes[0]);
  const Eigen::Vector3d face = (m_rest.col(nodes[1]) - a).cross(m_rest.col(nodes[2]) - a);
  return agreeing(smooth.normalized(), face.normalized());
}

/// At a point of the surface as it is now, and around it.
void ToolTip::look(const SurfacePoint& point, double side)
{
  if (point.triangle != m_areaAt.triangle || point.weight != m_areaAt.weight) {
    m_finder.find(point, restNormalAt(point), m_area);
    m_areaAt = point;
  }
  const Eigen::Matrix3Xd& position = m_surface.position();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero(), smooth = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < m_area.nodes.node.size(); ++i) {
    mean += m_area.nodes.weight[i] * position.col(m_area.nodes.node[i]);
    smooth += m_area.nodes.weight[i] * nodeNormal(m_area.nodes.node[i]);
  }
  const Eigen::Vector3d normal = agreeing(smooth.normalized(), faceNormal(point.triangle).normalized());
  m_normal = side * normal;
  m_place = m_surface.pointAt(point);
  m_led = mean + m_area.rise * normal;
}

/// Down the distance to `goal`, from triangle to triangle that share a corner: the nearest point of this part
/// of the surface, not of the other side of the organ.
SurfacePoint ToolTip::slideTo(const Eigen::Vector3d& goal, const SurfacePoint& from) const
{
  const auto nearestOn = [&](Index t) {
    return SurfacePoint{
      t, nearestWeights(goal, m_surface.corner(t, 0), m_surface.corner(t, 1), m_surface.corner(t, 2))};
  };
  SurfacePoint best = nearestOn(from.triangle);
  double distance = (m_surface.pointAt(best) - goal).squaredNorm();
  for (int i = 0; i < kMostTriangles; ++i) {
    SurfacePoint next = best;
    for (int k = 0; k < 3; ++k) {
      if (best.weight[k] == 0.0) continue; // only where it has come to: an edge or a corner
      if (best.weight.minCoeff() > 0.0) break;
      const auto node = static_cast<std::size_t>(m_surface.triangles()(k, best.triangle));
      for (const Index triangle : m_trianglesOf[node]) {
        const SurfacePoint candidate = nearestOn(triangle);
        const double squared = (m_surface.pointAt(candidate) - goal).squaredNorm();
        if (squared >= distance) continue;
        distance = squared;
        next = candidate;
      }
    }
    if (next.triangle == best.triangle) break;
    best = next;
  }
  return best;
}

// === Contact

void ToolTip::update(const NetState& state)
{
  if (m_surface.triangles().cols() == 0) return;
  m_surface.refit(state.position);
  if (m_touches)
    hold(state.time);
  else
    search();
  m_last = m_hand;
  m_hasLast = true;
}

/// A contact that the hand has left stays where it is: what is nearest to a hand on its way out is the wall
/// of the dent, not the tissue that comes after it.
void ToolTip::hold(double time)
{
  if (!isOut()) {
    m_wasOut = false;
    follow();
    if (!isOut() && !isUnhooked()) return;
  }
  if (!std::exchange(m_wasOut, true)) m_outSince = time;
  if (time - m_outSince < kFollowTime) return;
  m_touches = m_wasOut = false;
  m_lastSide = m_side;
  m_near = m_contact;
}

/// As the surface is now, at the point that was touched.
bool ToolTip::isOut()
{
  look(m_contact, m_side);
  return m_normal.dot(m_hand - m_led) > m_radius;
}

void ToolTip::begin(const SurfacePoint& point, double side)
{
  m_touches = true;
  m_wasOut = false;
  m_side = side;
  m_contact = point;
  follow();
}

/// A closed surface is touched from outside only; who begins inside comes out freely.
void ToolTip::search()
{
  if (m_hasLast)
    if (const auto hit = m_surface.firstHit(m_last, m_hand, m_isClosed))
      return begin(*hit, faceNormal(hit->triangle).dot(m_hand - m_last) < 0.0 ? 1.0 : -1.0);
  const auto near = m_surface.nearest(m_hand, kReach + m_radius);
  m_near = near.value_or(SurfacePoint{});
  if (!near) {
    m_lastSide = 0.0;
    return;
  }
  look(*near, 1.0);
  const Eigen::Vector3d normal = m_normal;
  const double height = normal.dot(m_hand - m_place);
  const double side = height < 0.0 ? -1.0 : 1.0;
  const bool cameOver = m_lastSide != 0.0 && side != m_lastSide; // the surface came over a hand at rest
  if (cameOver && (m_lastSide > 0.0 || !m_isClosed)) return begin(*near, m_lastSide);
  m_lastSide = side;
  if (side < 0.0 && m_isClosed) {
    m_near = {};
    return;
  }
  m_normal = side * normal;
  if ((m_hand - m_place).squaredNorm() < m_radius * m_radius) begin(*near, side);
}

/// The contact point sticks while it is near the point that it would slide to without friction, by the
/// friction cone, and slides to the cone's rim beyond it. The cone is about that point, not about the normal:
/// a surface that tilts in the contact would hold on to the tip otherwise.
void ToolTip::follow()
{
  look(m_contact, m_side);
  const Eigen::Vector3d goal = m_hand - aside() - m_radius * m_normal;
  const SurfacePoint free = slideTo(goal, m_contact);
  const Eigen::Vector3d freePlace = m_surface.pointAt(free), back = m_place - freePlace;
  const double most = kFriction * (freePlace - goal).norm(), way = back.norm();
  if (way > most) {
    m_contact = slideTo(freePlace + (most / way) * back, free);
    look(m_contact, m_side);
  }
  place();
}

/// A flap of tissue that the tip has turned over would hold on to it for ever. The tip is free when the
/// surface nearest to the hand has it outside, and is the same stretch of surface: the far wall of an organ
/// that was pressed flat sets nobody free.
bool ToolTip::isUnhooked() const
{
  const Eigen::Vector3d hand = m_hand - aside();
  const double depth = (hand - m_place).norm();
  const auto near = m_surface.nearest(hand, depth);
  if (!near || near->triangle == m_contact.triangle) return false;
  const Eigen::Vector3d away = hand - m_surface.pointAt(*near);
  if (m_side * normalAt(*near).dot(away) <= std::max(m_radius, 0.5 * away.norm())) return false;
  const auto atRest = [&](const SurfacePoint& point) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) sum += point.weight[k] * m_rest.col(m_surface.triangles()(k, point.triangle));
    return sum;
  };
  const auto restNormal = [&](Index t) {
    const Eigen::Vector3d a = m_rest.col(m_surface.triangles()(0, t));
    return Eigen::Vector3d((m_rest.col(m_surface.triangles()(1, t)) - a)
                             .cross(m_rest.col(m_surface.triangles()(2, t)) - a)
                             .normalized());
  };
  return restNormal(near->triangle).dot(restNormal(m_contact.triangle)) > kSameStretch &&
         (atRest(*near) - atRest(m_contact)).norm() < 2.0 * depth;
}

/// In a fold that is narrower than the ball the proxy stays half-way to the other wall.
void ToolTip::place()
{
  m_lift = m_radius + std::max(0.0, m_normal.dot(aside()));
  const Eigen::Vector3d begin = m_place + 1e-3 * m_radius * m_normal, end = m_place + m_lift * m_normal;
  if (const auto wall = m_surface.firstHit(begin, end, false))
    m_lift = 0.5 * (m_surface.pointAt(*wall) - m_place).norm();
}

double ToolTip::gap() const noexcept
{
  if (m_touches) return 0.0;
  return isNear() ? std::max(0.0, (m_hand - m_place).norm() - m_radius) : kReach;
}

Eigen::Vector3d ToolTip::proxy() const noexcept
{
  return touches() ? Eigen::Vector3d(m_place + m_lift * m_normal) : m_hand;
}

// === Forces

Eigen::Vector3d ToolTip::pull() const
{
  return m_hand - m_radius * m_normal - m_led;
}

double ToolTip::stiffness() const noexcept
{
  double own = 0.0;
  for (std::size_t i = 0; i < m_area.nodes.node.size(); ++i)
    own += m_area.nodes.weight[i] * m_own[static_cast<std::size_t>(m_area.nodes.node[i])];
  return toolStiffness(own);
}

/// By the mass that the area moves with as one point: of all its nodes, where it has many.
double ToolTip::viscosity(double stiffness) const noexcept
{
  double ease = 0.0; // [1/kg]
  for (std::size_t i = 0; i < m_area.nodes.node.size(); ++i) {
    const double weight = m_area.nodes.weight[i];
    ease += weight * weight / m_mass[static_cast<std::size_t>(m_area.nodes.node[i])];
  }
  return toolViscosity(stiffness, 1.0 / ease);
}

Eigen::Vector3d ToolTip::surfaceVelocity(const NetState& state) const
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < m_area.nodes.node.size(); ++i)
    sum += m_area.nodes.weight[i] * state.velocity.col(m_area.nodes.node[i]);
  return sum;
}

/// One on each node by its weight, all alike: together they pull the area's mean like one, and none turns it.
std::span<const ToolSpring> ToolTip::springs(const NetState& state)
{
  const double k = stiffness();
  const LimitedPull limited = limitedPull(pull(), k, m_maxForce);
  const double stiff = limited.softness * k, viscous = limited.softness * viscosity(k);
  const Eigen::Vector3d surface = surfaceVelocity(state);
  // Along the surface the damper moves with it: drag is friction's.
  const Eigen::Vector3d velocity = surface + m_normal.dot(m_velocity - surface) * m_normal;
  m_springs.clear();
  for (std::size_t i = 0; i < m_area.nodes.node.size(); ++i) {
    const Index node = m_area.nodes.node[i];
    const double weight = m_area.nodes.weight[i];
    m_springs.push_back(
      {node, state.position.col(node) + limited.offset, velocity, weight * stiff, weight * viscous});
  }
  return m_springs;
}

Eigen::Vector3d ToolTip::forceOnHand(const NetState& state) const
{
  if (!touches()) return Eigen::Vector3d::Zero();
  const double k = stiffness();
  const LimitedPull limited = limitedPull(pull(), k, m_maxForce);
  const double closing = m_normal.dot(surfaceVelocity(state) - m_velocity); // [m/s]
  const Eigen::Vector3d force = limited.softness * (viscosity(k) * closing * m_normal - k * limited.offset);
  if (force.dot(m_normal) <= 0.0) return Eigen::Vector3d::Zero(); // leaving faster than the surface follows
  return limitedForce(force, m_maxForce);
}

ContactModel ToolTip::contactModel(const NetState& state, const Eigen::Matrix3d& compliance) const
{
  ContactModel model;
  model.time = state.time;
  if (!isNear()) return model;
  const double k = stiffness();
  model.active = true;
  model.normal = m_normal;
  model.friction = 2.0 * kFriction; // the contact point's own cone is the narrower one
  if (!touches()) {                 // where the surface will be met, and how stiff it will be there
    const double across = m_normal.dot(inSeries(k * Eigen::Matrix3d::Identity(), compliance) * m_normal);
    model.position = m_led + m_radius * m_normal;
    model.stiffness = across * m_normal * m_normal.transpose();
    return model;
  }
  model.position = m_hand;
  model.stiffness = inSeries(pullStiffness(pull(), k, m_maxForce), compliance);
  model.viscosity =
    viscosity(k) / k * m_normal.dot(model.stiffness * m_normal) * m_normal * m_normal.transpose();
  model.force = forceOnHand(state) + model.viscosity * m_velocity;
  return model;
}

} // namespace esm
