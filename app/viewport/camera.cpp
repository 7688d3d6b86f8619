// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/camera.h"

#include "core/geometry/extent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace esm {

namespace {
constexpr double kHalfPi = std::numbers::pi / 2.0;
constexpr double kFitMargin = 0.82; ///< share of the picture that a fitted box may fill; overlays need room
} // namespace

void Camera::setPose(const Eigen::Vector3d& target, double distance, double azimuth, double elevation)
{
  if (target.allFinite()) m_target = target;
  if (std::isfinite(distance) && distance > 0.0) m_distance = distance;
  setDirection(azimuth, elevation);
}

void Camera::setDirection(double azimuth, double elevation)
{
  if (std::isfinite(azimuth)) m_azimuth = std::remainder(azimuth, 2.0 * std::numbers::pi);
  if (std::isfinite(elevation)) m_elevation = std::clamp(elevation, -kHalfPi, kHalfPi);
}

void Camera::setViewport(double width, double height)
{
  m_width = std::max(width, 1.0);
  m_height = std::max(height, 1.0);
}

void Camera::setCovered(double right)
{
  m_covered = std::max(right, 0.0);
}

double Camera::clearWidth() const
{
  return m_width - std::min(m_covered, 0.4 * m_width);
}

Eigen::Vector2d Camera::middle() const
{
  return {clearWidth() / 2.0, m_height / 2.0};
}

void Camera::setScene(const Eigen::Vector3d& centre, double radius)
{
  m_sceneCentre = centre;
  m_sceneRadius = std::max(radius, 1e-9);
}

void Camera::orbit(double dx, double dy)
{
  const double perPixel = std::numbers::pi / m_height;
  setDirection(m_azimuth - dx * perPixel, m_elevation + dy * perPixel);
}

void Camera::pan(double dx, double dy)
{
  m_target += metresPerPixel(m_target) * (dy * up() - dx * right());
}

void Camera::zoomAt(const Eigen::Vector2d& pixel, double factor)
{
  // A homothety about a point p of the cursor's ray maps the eye along, so p keeps its pixel:
  // eye' = p + s (eye - p), target' = p + s (target - p).
  const Eigen::Vector3d p = onPlane(pixel, m_target);
  const double before = m_distance;
  m_distance *= factor;
  clampDistance();
  m_target = p + m_distance / before * (m_target - p);
}

void Camera::clampDistance()
{
  m_distance = std::clamp(m_distance, 1e-3 * m_sceneRadius, 200.0 * m_sceneRadius);
}

void Camera::fit(const Eigen::Matrix3Xd& points)
{
  const Eigen::AlignedBox3d box = boxOf(points);
  if (box.isEmpty()) return;
  m_target = box.center();
  const Eigen::Vector3d toEye = backward(), toRight = right(), toTop = up();
  const double tanY = halfHeight() * kFitMargin;
  const double tanX = tanY * clearWidth() / m_height;
  double distance = 1e-6;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d p = points.col(i) - m_target;
    if (!p.allFinite()) continue;
    const double reach = std::max(std::abs(p.dot(toRight)) / tanX, std::abs(p.dot(toTop)) / tanY);
    distance = std::max(distance, p.dot(toEye) + reach);
  }
  m_distance = distance;
}

Eigen::Vector3d Camera::backward() const
{
  const double c = std::cos(m_elevation);
  return {std::sin(m_azimuth) * c, -std::cos(m_azimuth) * c, std::sin(m_elevation)};
}

Eigen::Vector3d Camera::right() const
{
  return {std::cos(m_azimuth), std::sin(m_azimuth), 0.0};
}

Eigen::Vector3d Camera::up() const
{
  return backward().cross(right());
}

Eigen::Matrix4d Camera::view() const
{
  Eigen::Matrix3d rotation;
  rotation << right().transpose(), up().transpose(), backward().transpose();
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view.topLeftCorner<3, 3>() = rotation;
  view.topRightCorner<3, 1>() = -rotation * eye();
  return view;
}

Eigen::Matrix4d Camera::projection() const
{
  const double depth = (eye() - m_sceneCentre).dot(backward()); // of the scene's centre
  const double f = depth + m_sceneRadius;
  Eigen::Matrix4d p = Eigen::Matrix4d::Zero();
  const double aspect = m_width / m_height;
  const double aside = 2.0 * middle().x() / m_width - 1.0; // of the target from the picture's middle
  if (m_orthographic) {
    const double n = depth - m_sceneRadius;
    const double h = halfHeight() * m_distance;
    p(0, 0) = 1.0 / (h * aspect);
    p(1, 1) = 1.0 / h;
    p(0, 3) = aside;
    p(2, 2) = -2.0 / (f - n);
    p(2, 3) = -(f + n) / (f - n);
    p(3, 3) = 1.0;
    return p;
  }
  const double far = std::max(f, 1e-3 * m_distance);
  const double near = std::max(depth - m_sceneRadius, 1e-3 * far); // 24 bits stand a ratio of 1000 well
  p(0, 0) = 1.0 / (halfHeight() * aspect);
  p(1, 1) = 1.0 / halfHeight();
  p(0, 2) = -aside;
  p(2, 2) = -(far + near) / (far - near);
  p(2, 3) = -2.0 * far * near / (far - near);
  p(3, 2) = -1.0;
  return p;
}

double Camera::halfHeight() const
{
  return std::tan(kFieldOfView / 2.0);
}

Projector Camera::projector() const
{
  Projector p;
  p.m_eye = eye();
  p.m_right = right();
  p.m_up = up();
  p.m_backward = backward();
  p.m_parallel = m_orthographic;
  p.m_pixelsPerMetre = m_height / (2.0 * halfHeight() * (m_orthographic ? m_distance : 1.0));
  p.m_middle = middle();
  return p;
}

ScreenPoint Projector::operator()(const Eigen::Vector3d& point) const
{
  const Eigen::Vector3d fromEye = point - m_eye;
  ScreenPoint result;
  result.depth = -fromEye.dot(m_backward);
  if (!m_parallel && result.depth <= 0.0) {
    result.pixel.setConstant(std::numeric_limits<double>::quiet_NaN());
    return result;
  }
  const double scale = m_parallel ? m_pixelsPerMetre : m_pixelsPerMetre / result.depth;
  result.pixel = m_middle + scale * Eigen::Vector2d(fromEye.dot(m_right), -fromEye.dot(m_up));
  return result;
}

Ray Camera::rayThrough(const Eigen::Vector2d& pixel) const
{
  const Eigen::Vector2d fromMiddle = pixel - middle();
  const Eigen::Vector3d inTargetPlane =
    m_target + metresPerPixel(m_target) * (fromMiddle.x() * right() - fromMiddle.y() * up());
  if (!m_orthographic) return {eye(), (inTargetPlane - eye()).normalized()};
  // Parallel rays start before the whole scene, wherever the eye is.
  return {inTargetPlane + (m_distance + 4.0 * m_sceneRadius) * backward(), -backward()};
}

Eigen::Vector3d Camera::onPlane(const Eigen::Vector2d& pixel, const Eigen::Vector3d& through) const
{
  const Ray ray = rayThrough(pixel);
  const double along = (through - ray.origin).dot(backward()) / ray.direction.dot(backward());
  return ray.origin + along * ray.direction;
}

double Camera::metresPerPixel(const Eigen::Vector3d& at) const
{
  const double depth = m_orthographic ? m_distance : (eye() - at).dot(backward());
  return 2.0 * halfHeight() * depth / m_height;
}

} // namespace esm
