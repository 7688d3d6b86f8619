// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/region_gizmo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace esm {

namespace {

using HandleKind = GizmoHandle::Kind;

constexpr double kSpotReach = 10.0, kArrowReach = 7.0, kRingReach = 6.0;  ///< of the mouse [pixels]
constexpr double kArrowGap = 16.0, kArrowLength = 30.0;                   ///< [pixels]
constexpr double kRingGap = 30.0, kLeastRing = 60.0, kLargestRing = 0.44; ///< pixels; share of the view
constexpr double kPointsAtEye = 0.2; ///< sine of the least angle between a line of sight and a usable axis
constexpr double kEdgeOn = 0.2;      ///< sine of the least angle between a line of sight and a usable ring
constexpr int kRingPoints = 72;

/// From a place towards the eye.
Eigen::Vector3d towardsEye(const Camera& camera, const Eigen::Vector3d& place)
{
  return camera.orthographic() ? camera.backward() : (camera.eye() - place).normalized();
}

Eigen::Vector3d axisOf(const Ellipsoid& ellipsoid, int axis)
{
  return ellipsoid.rotation * Eigen::Vector3d::Unit(axis);
}

/// Around the whole ellipsoid, but no wider than the picture.
double ringRadius(const Camera& camera, const Ellipsoid& ellipsoid)
{
  const double perPixel = camera.metresPerPixel(ellipsoid.centre);
  const double most = std::max(kLeastRing, kLargestRing * std::min(camera.width(), camera.height()));
  return perPixel * std::clamp(ellipsoid.semiAxes.maxCoeff() / perPixel + kRingGap, kLeastRing, most);
}

/// From the centre to the handle of the falloff if there were none: that diagonal of the ellipsoid that
/// points most to the upper right, off all axes.
Eigen::Vector3d falloffArm(const Camera& camera, const Ellipsoid& ellipsoid)
{
  const Eigen::Vector3d wanted = ellipsoid.rotation.conjugate() * (camera.right() + camera.up());
  const Eigen::Vector3d octant(wanted.x() < 0.0 ? -1.0 : 1.0, wanted.y() < 0.0 ? -1.0 : 1.0,
                               wanted.z() < 0.0 ? -1.0 : 1.0);
  return ellipsoid.rotation * ellipsoid.semiAxes.cwiseProduct(octant) / std::sqrt(3.0);
}

GizmoLayout::Ring ringOf(const Camera& camera, const Ellipsoid& ellipsoid, int axis)
{
  GizmoLayout::Ring ring{{HandleKind::Turn, axis, 1}, {}, {}};
  const double radius = ringRadius(camera, ellipsoid);
  const Eigen::Vector3d u = axisOf(ellipsoid, (axis + 1) % 3), v = axisOf(ellipsoid, (axis + 2) % 3);
  const Eigen::Vector3d eye = towardsEye(camera, ellipsoid.centre);
  for (int i = 0; i <= kRingPoints; ++i) {
    const double t = 2.0 * std::numbers::pi * i / kRingPoints;
    const Eigen::Vector3d arm = radius * (std::cos(t) * u + std::sin(t) * v);
    ring.pixels.push_back(camera.project(ellipsoid.centre + arm).pixel);
    ring.front.push_back(arm.dot(eye) > -1e-9 * radius);
  }
  return ring;
}

double distanceToSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  const Eigen::Vector2d ab = b - a;
  const double length = ab.squaredNorm();
  const double t = length > 0.0 ? std::clamp((p - a).dot(ab) / length, 0.0, 1.0) : 0.0;
  return (p - a - t * ab).norm();
}

/// Where the line of sight meets the plane through `centre`; nothing if that is not before the eye.
std::optional<Eigen::Vector3d> onPlane(const Camera& camera, const Eigen::Vector2d& pixel,
                                       const Eigen::Vector3d& centre, const Eigen::Vector3d& normal)
{
  const Ray ray = camera.rayThrough(pixel);
  const double slope = ray.direction.dot(normal);
  if (std::abs(slope) < 1e-6) return std::nullopt;
  const double way = (centre - ray.origin).dot(normal) / slope;
  if (!(way > 0.0) || !std::isfinite(way)) return std::nullopt;
  return ray.origin + way * ray.direction;
}

} // namespace

GizmoLayout layoutGizmo(const Camera& camera, const GizmoShape& shape)
{
  GizmoLayout layout;
  const Ellipsoid& ellipsoid = shape.ellipsoid;
  const Eigen::Vector2d centre = camera.project(ellipsoid.centre).pixel;
  if (!centre.allFinite()) return layout;
  const Eigen::Vector3d eye = towardsEye(camera, ellipsoid.centre);

  const Eigen::Vector3d inner = ellipsoid.centre + (1.0 - shape.falloff) * falloffArm(camera, ellipsoid);
  layout.spots.push_back({{HandleKind::Falloff, 0, 1}, camera.project(inner).pixel});
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d along = axisOf(ellipsoid, axis);
    if (along.cross(eye).norm() < kPointsAtEye) continue;
    for (const int side : {1, -1}) {
      const Eigen::Vector3d end = ellipsoid.centre + side * ellipsoid.semiAxes[axis] * along;
      const Eigen::Vector2d pixel = camera.project(end).pixel;
      layout.spots.push_back({{HandleKind::Stretch, axis, side}, pixel});
      if (side < 0) continue;
      const Eigen::Vector2d way = (pixel - centre).normalized();
      layout.arrows.push_back(
        {{HandleKind::Slide, axis, 1}, pixel + kArrowGap * way, pixel + (kArrowGap + kArrowLength) * way});
    }
  }
  layout.spots.push_back({{HandleKind::Move, 0, 1}, centre});
  for (int axis = 0; axis < 3; ++axis) layout.rings.push_back(ringOf(camera, ellipsoid, axis));
  return layout;
}

GizmoHandle handleAt(const GizmoLayout& layout, const Eigen::Vector2d& pixel)
{
  GizmoHandle found;
  double nearest = kSpotReach;
  for (const GizmoLayout::Spot& spot : layout.spots)
    if (const double away = (spot.pixel - pixel).norm(); away < nearest) // false for NaN
      nearest = away, found = spot.handle;
  if (found) return found;

  nearest = kArrowReach;
  for (const GizmoLayout::Arrow& arrow : layout.arrows)
    if (const double away = distanceToSegment(pixel, arrow.from, arrow.to); away < nearest)
      nearest = away, found = arrow.handle;
  if (found) return found;

  nearest = kRingReach;
  for (const bool front : {true, false}) {
    for (const GizmoLayout::Ring& ring : layout.rings)
      for (std::size_t i = 0; i + 1 < ring.pixels.size(); ++i)
        if (ring.front[i] == front)
          if (const double away = distanceToSegment(pixel, ring.pixels[i], ring.pixels[i + 1]);
              away < nearest)
            nearest = away, found = ring.handle;
    if (found) break;
  }
  return found;
}

std::optional<double> wayOnLine(const Camera& camera, const Eigen::Vector2d& pixel,
                                const Eigen::Vector3d& origin, const Eigen::Vector3d& direction)
{
  const Projector project = camera.projector();
  const Eigen::Vector2d from = project(origin).pixel;
  const Eigen::Vector2d along = project(origin + camera.metresPerPixel(origin) * direction).pixel - from;
  const double length = along.norm();
  if (!(length > 1e-3)) return std::nullopt;
  // A line is seen as a line: the nearest place on the screen, and there the line of sight meets the line.
  const Eigen::Vector2d unit = along / length;
  const Ray ray = camera.rayThrough(from + unit.dot(pixel - from) * unit);
  const Eigen::Vector3d between = origin - ray.origin;
  const double cosine = ray.direction.dot(direction);
  const double sine2 = 1.0 - cosine * cosine;
  if (sine2 < 1e-8) return std::nullopt;
  const double way = (cosine * ray.direction.dot(between) - direction.dot(between)) / sine2;
  if (!std::isfinite(way) || !project(origin + way * direction).pixel.allFinite()) return std::nullopt;
  return way;
}

GizmoDrag::GizmoDrag(const Camera& camera, const GizmoHandle& handle, const GizmoShape& start,
                     const Eigen::Vector2d& pixel)
  : m_camera(camera), m_handle(handle), m_start(start), m_shape(start), m_origin(start.ellipsoid.centre)
{
  const Ellipsoid& ellipsoid = start.ellipsoid;
  m_along = axisOf(ellipsoid, handle.axis);
  switch (handle.kind) {
  case HandleKind::Move:
    m_grabOffset = camera.project(ellipsoid.centre).pixel - pixel;
    break;
  case HandleKind::Falloff:
    m_along = falloffArm(camera, ellipsoid).normalized();
    break;
  case HandleKind::Turn: {
    const Eigen::Vector3d normal = m_along;
    const auto taken = onPlane(camera, pixel, ellipsoid.centre, normal);
    m_edgeOn = std::abs(normal.dot(towardsEye(camera, ellipsoid.centre))) < kEdgeOn || !taken;
    if (!m_edgeOn)
      m_arm = *taken - ellipsoid.centre;
    else
      m_along = normal.cross(towardsEye(camera, ellipsoid.centre)).normalized(); // the near side's way
    break;
  }
  default:
    break;
  }
  m_taken = wayOnLine(camera, pixel, m_origin, m_along).value_or(0.0);
}

const GizmoShape& GizmoDrag::to(const Eigen::Vector2d& pixel, bool uniform)
{
  switch (m_handle.kind) {
  case HandleKind::Move:
    move(pixel);
    break;
  case HandleKind::Slide:
    slide(pixel);
    break;
  case HandleKind::Turn:
    turn(pixel);
    break;
  case HandleKind::Stretch:
    stretch(pixel, uniform);
    break;
  case HandleKind::Falloff:
    fade(pixel);
    break;
  case HandleKind::None:
    break;
  }
  return m_shape;
}

std::optional<double> GizmoDrag::wayAlong(const Eigen::Vector2d& pixel) const
{
  const auto way = wayOnLine(m_camera, pixel, m_origin, m_along);
  constexpr double kHorizon = 100.0; // [distances of the eye]: what is so far is not meant
  if (!way || !(std::abs(*way - m_taken) < kHorizon * m_camera.distance())) return std::nullopt;
  return *way - m_taken;
}

void GizmoDrag::move(const Eigen::Vector2d& pixel)
{
  const Eigen::Vector3d centre = m_camera.onPlane(pixel + m_grabOffset, m_start.ellipsoid.centre);
  if (centre.allFinite()) m_shape.ellipsoid.centre = centre;
}

void GizmoDrag::slide(const Eigen::Vector2d& pixel)
{
  if (const auto way = wayAlong(pixel)) m_shape.ellipsoid.centre = m_start.ellipsoid.centre + *way * m_along;
}

std::optional<double> GizmoDrag::angleAt(const Eigen::Vector2d& pixel) const
{
  const Ellipsoid& ellipsoid = m_start.ellipsoid;
  if (m_edgeOn) {
    const auto way = wayAlong(pixel);
    if (!way) return std::nullopt;
    return *way / ringRadius(m_camera, ellipsoid);
  }
  const Eigen::Vector3d normal = axisOf(ellipsoid, m_handle.axis);
  const auto hit = onPlane(m_camera, pixel, ellipsoid.centre, normal);
  if (!hit) return std::nullopt;
  const Eigen::Vector3d arm = *hit - ellipsoid.centre;
  const double angle = std::atan2(normal.dot(m_arm.cross(arm)), m_arm.dot(arm));
  if (!std::isfinite(angle)) return std::nullopt;
  return angle;
}

void GizmoDrag::turn(const Eigen::Vector2d& pixel)
{
  const auto angle = angleAt(pixel);
  if (!angle) return;
  m_angle = std::remainder(*angle, 2.0 * std::numbers::pi);
  const Eigen::AngleAxisd about(m_angle, Eigen::Vector3d::Unit(m_handle.axis));
  m_shape.ellipsoid.rotation = (m_start.ellipsoid.rotation * about).normalized();
}

void GizmoDrag::stretch(const Eigen::Vector2d& pixel, bool uniform)
{
  const auto way = wayAlong(pixel);
  if (!way) return;
  const Eigen::Vector3d& before = m_start.ellipsoid.semiAxes;
  const double wanted = before[m_handle.axis] + m_handle.side * *way;
  Eigen::Vector3d& semiAxes = m_shape.ellipsoid.semiAxes;
  semiAxes = before;
  if (uniform) // in proportion, at the limits too
    semiAxes *=
      std::clamp(wanted / before[m_handle.axis], kLeastSemiAxis / before.minCoeff(),
                 std::max(kLargestSemiAxis / before.maxCoeff(), kLeastSemiAxis / before.minCoeff()));
  else
    semiAxes[m_handle.axis] = std::clamp(wanted, kLeastSemiAxis, kLargestSemiAxis);
}

void GizmoDrag::fade(const Eigen::Vector2d& pixel)
{
  const auto way = wayAlong(pixel);
  if (!way) return;
  const double reach = falloffArm(m_camera, m_start.ellipsoid).norm();
  m_shape.falloff = std::clamp(m_start.falloff - *way / reach, 0.0, 1.0);
}

} // namespace esm
