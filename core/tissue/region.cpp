// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/region.h"

#include <algorithm>
#include <cmath>

namespace esm {

double profileWeight(FalloffProfile profile, double radius, double falloff) noexcept
{
  if (std::isnan(radius)) return 0.0;
  if (profile == FalloffProfile::Smooth || radius >= 1.0 || radius <= 1.0 - falloff)
    return falloffWeight(radius, falloff);
  const double s = std::clamp((1.0 - radius) / falloff, 0.0, 1.0);
  return profile == FalloffProfile::Linear ? s : s * s * s * (s * (6.0 * s - 15.0) + 10.0);
}

double steepestSlope(FalloffProfile profile) noexcept
{
  switch (profile) {
  case FalloffProfile::Smooth:
    return 1.5;
  case FalloffProfile::Linear:
    return 1.0;
  case FalloffProfile::Smoother:
    break;
  }
  return 1.875;
}

Eigen::Vector3d MirrorPlane::reflect(const Eigen::Vector3d& p) const
{
  return p - (2.0 * normal.dot(p - point) / normal.squaredNorm()) * normal;
}

Ellipsoid mirrored(const Ellipsoid& ellipsoid, const MirrorPlane& plane)
{
  // The reflected axes are left-handed; an ellipsoid looks the same when one axis is turned round.
  Eigen::Matrix3d axes = ellipsoid.rotation.toRotationMatrix();
  for (int i = 0; i < 3; ++i)
    axes.col(i) -= (2.0 * plane.normal.dot(axes.col(i)) / plane.normal.squaredNorm()) * plane.normal;
  axes.col(0) = -axes.col(0);
  return {plane.reflect(ellipsoid.centre), ellipsoid.semiAxes, Eigen::Quaterniond(axes).normalized()};
}

RegionShape::RegionShape(const Region& region)
  : m_ball(ballOf(region.ellipsoid)),
    m_falloff(region.falloff),
    m_profile(region.profile),
    m_insideOut(region.insideOut)
{
  if (region.mirror) m_twin = ballOf(mirrored(region.ellipsoid, *region.mirror));
}

RegionShape::Ball RegionShape::ballOf(const Ellipsoid& ellipsoid)
{
  const Eigen::Matrix3d axes = ellipsoid.rotation.toRotationMatrix();
  const Eigen::Vector3d half = (axes * ellipsoid.semiAxes.asDiagonal()).rowwise().norm();
  return {ellipsoid.centre, half * (1.0 + 1e-12),
          ellipsoid.semiAxes.cwiseInverse().asDiagonal() * axes.transpose()};
}

double RegionShape::weightIn(const Ball& ball, const Eigen::Vector3d& point) const noexcept
{
  const Eigen::Vector3d arm = point - ball.centre;
  if (!(arm.array().abs() < ball.halfBox.array()).all()) return 0.0;
  return profileWeight(m_profile, (ball.toBall * arm).norm(), m_falloff);
}

double RegionShape::weight(const Eigen::Vector3d& point) const noexcept
{
  if (!point.allFinite()) return 0.0;
  double inside = weightIn(m_ball, point);
  if (m_twin && inside < 1.0) inside = std::max(inside, weightIn(*m_twin, point));
  return m_insideOut ? 1.0 - inside : inside;
}

} // namespace esm
