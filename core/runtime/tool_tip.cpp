// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/tool_tip.h"

#include "core/geometry/edge_table.h"
#include "core/runtime/limited_pull.h"
#include "core/runtime/tool_grip.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

namespace {

constexpr int kMostTriangles = 64;      ///< that a contact slides over in one frame
constexpr double kLeastAgreement = 0.3; ///< of the smooth normal with the face's, as a cosine
constexpr double kLowerPart = 0.5;      ///< of a ball's radius, aside of its lowest point
constexpr double kSameStretch = 0.5;    ///< of two places at rest, as a cosine between their normals
constexpr double kLeastForce = 1e-6;    ///< [N]

bool isClosedSurface(const SpringNet& net)
{
  Mesh mesh;
  mesh.position = net.restPosition;
  mesh.triangles = net.triangles;
  const EdgeTable edges = findEdges(mesh);
  return net.triangleCount() > 0 && std::all_of(edges.triangleCount.begin(), edges.triangleCount.end(),
                                                [](Index count) { return count == 2; });
}

} // namespace

ToolTip::ToolTip(const SpringNet& net, double radius, double maxForce)
  : m_surface(net.triangles, net.restPosition),
    m_rest(net.restPosition),
    m_isClosed(isClosedSurface(net)),
    m_finder(net),
    m_press(net),
    m_radius(std::isfinite(radius) ? std::max(radius, 0.0) : 0.0)
{
  setMaxForce(maxForce);
  m_trianglesOf.build(static_cast<std::size_t>(net.nodeCount()), [&](const auto& add) {
    for (Index t = 0; t < net.triangleCount(); ++t)
      for (int k = 0; k < 3; ++k) add(net.triangles(k, t), t);
  });
}

void ToolTip::adapt(const SpringNet& net)
{
  m_press.adapt(net);
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
  const Eigen::Vector3d face = faceNormal(point.triangle).normalized();
  Eigen::Vector3d smooth = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    smooth += point.weight[k] * nodeNormal(m_surface.triangles()(k, point.triangle));
  }
  smooth.normalize();
  return smooth.dot(face) > kLeastAgreement ? smooth : face;
}

/// Of all that the lower part of the ball would lie on, the point's own among them. On a mesh finer than the ball
/// the triangles there tilt by what each node is off the ball's surface, and the whole pull would tilt with one.
Eigen::Vector3d ToolTip::normalUnder(const SurfacePoint& point)
{
  const Eigen::Vector3d own = normalAt(point), place = m_surface.pointAt(point);
  const Eigen::Vector3i corners = m_surface.triangles().col(point.triangle);
  const double reach = kLowerPart * m_radius;
  m_finder.find(m_surface.position(), {corners.data(), 3}, place, reach, m_around);
  Eigen::Vector3d sum = own;
  for (const PatchNode& found : m_around) {
    // Fades out at the rim, so that nothing jumps as the point slides on.
    const double aside = (m_surface.position().col(found.node) - place).norm() / reach;
    const double weight = aside < 1.0 ? (1.0 - aside * aside) * (1.0 - aside * aside) : 0.0;
    const Eigen::Vector3d normal = nodeNormal(found.node);
    sum += weight * std::max(normal.dot(own), 0.0) * normal;
  }
  return sum.normalized();
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
  if (isNear()) press(state);
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
  m_normal = m_side * normalUnder(m_contact);
  m_place = m_surface.pointAt(m_contact);
  return m_normal.dot(m_hand - m_place) > m_radius;
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
  m_place = m_surface.pointAt(*near);
  const Eigen::Vector3d normal = normalAt(*near);
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
  m_normal = m_side * normalUnder(m_contact);
  m_place = m_surface.pointAt(m_contact);
  const Eigen::Vector3d goal = m_hand - m_radius * m_normal;
  const SurfacePoint free = slideTo(goal, m_contact);
  const Eigen::Vector3d freePlace = m_surface.pointAt(free), back = m_place - freePlace;
  const double most = kFriction * (freePlace - goal).norm(), way = back.norm();
  if (way > most) {
    m_contact = slideTo(freePlace + (most / way) * back, free);
    m_normal = m_side * normalUnder(m_contact);
    m_place = m_surface.pointAt(m_contact);
  }
  place();
}

/// A flap of tissue that the tip has turned over would hold on to it for ever. The tip is free when the
/// surface nearest to the hand has it outside, and is the same stretch of surface: the far wall of an organ
/// that was pressed flat sets nobody free.
bool ToolTip::isUnhooked() const
{
  const double depth = (m_hand - m_place).norm();
  const auto near = m_surface.nearest(m_hand, depth);
  if (!near || near->triangle == m_contact.triangle) return false;
  const Eigen::Vector3d away = m_hand - m_surface.pointAt(*near);
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
  m_lift = m_radius;
  const Eigen::Vector3d begin = m_place + 1e-3 * m_radius * m_normal, end = m_place + m_radius * m_normal;
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

/// Not the inner side of a fold, though the way along the surface there is short.
bool ToolTip::facesHand(Index node) const
{
  return m_side * m_normal.dot(nodeNormal(node)) > kLeastAgreement;
}

/// While tissue follows a hand that came out, what was pressed last stays so.
void ToolTip::press(const NetState& state)
{
  const SurfacePoint& point = m_touches ? m_contact : m_near;
  BallContact contact;
  contact.weight = point.weight;
  contact.place = m_place;
  contact.normal = m_normal;
  contact.radius = m_radius;
  for (int k = 0; k < 3; ++k)
    contact.corner[static_cast<std::size_t>(k)] = m_surface.triangles()(k, point.triangle);
  if (m_touches) contact.pull = m_hand - m_radius * m_normal - m_place;
  const bool holds = m_touches && m_wasOut;
  if (holds) {
    m_covered.assign(m_press.nodes().begin(), m_press.nodes().end());
  } else {
    m_covered.clear();
    if (m_touches) m_finder.find(state.position, contact.corner, m_place, m_radius, m_around);
    if (m_touches)
      for (const PatchNode& found : m_around)
        if (facesHand(found.node)) m_covered.push_back(found.node);
  }
  m_press.press(state.position, contact, m_covered, holds, m_maxForce);
}

std::span<const ToolSpring> ToolTip::springs(const NetState& state)
{
  press(state); // the hand may have moved on
  return m_press.springs(state, m_velocity);
}

Eigen::Vector3d ToolTip::forceOnHand(const NetState& state) const
{
  if (!touches()) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d force = m_press.forceOnHand(state, m_velocity);
  if (force.dot(m_normal) <= 0.0) return Eigen::Vector3d::Zero(); // leaving faster than the surface follows
  return limitedForce(force, m_maxForce);
}

ContactModel ToolTip::contactModel(const NetState& state, const Eigen::Matrix3d& compliance) const
{
  ContactModel model;
  model.time = state.time;
  if (!isNear()) return model;
  const double k = m_press.stiffness();
  model.active = true;
  model.normal = m_normal;
  model.friction = 2.0 * kFriction; // the contact point's own cone is the narrower one
  if (!touches()) {                 // where the surface will be met, and how stiff it will be there
    const double across = m_normal.dot(inSeries(k * Eigen::Matrix3d::Identity(), compliance) * m_normal);
    model.position = m_place + m_radius * m_normal;
    model.stiffness = across * m_normal * m_normal.transpose();
    return model;
  }
  model.position = m_hand;
  model.stiffness = inSeries(pullStiffness(m_press.apart(), k, m_maxForce), compliance);
  model.viscosity =
    m_press.viscosity() / k * m_normal.dot(model.stiffness * m_normal) * m_normal * m_normal.transpose();
  model.force = forceOnHand(state) + model.viscosity * m_velocity;
  return model;
}

} // namespace esm
