// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/kinematics/laparoscope4.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

double transverseShare(double insertion) noexcept
{
  const double least = Laparoscope4::kLeastInsertion;
  return std::clamp((insertion - least) / (Laparoscope4::kFadeInsertion - least), 0.0, 1.0);
}

} // namespace

Laparoscope4::Laparoscope4(const Eigen::Vector3d& pivot, double length) noexcept
  : m_pivot(pivot), m_length(std::max(length, 3.0 * kLeastInsertion))
{}

Eigen::Vector3d Laparoscope4::tip(const LaparoscopePose& pose) const noexcept
{
  const double insertion = std::max(pose.insertion, kLeastInsertion);
  // R_y(yaw) R_x(pitch) (0, 0, -1)
  const Eigen::Vector3d axis(-std::sin(pose.yaw) * std::cos(pose.pitch), std::sin(pose.pitch),
                             -std::cos(pose.yaw) * std::cos(pose.pitch));
  return m_pivot + insertion * axis;
}

LaparoscopePose Laparoscope4::pose(const Eigen::Vector3d& tip) const noexcept
{
  const Eigen::Vector3d rod = tip - m_pivot;
  const double length = rod.norm();
  if (length < 1e-9) return {0.0, 0.0, kLeastInsertion};
  const Eigen::Vector3d axis = rod / length;
  return {std::atan2(-axis.x(), -axis.z()), std::asin(std::clamp(axis.y(), -1.0, 1.0)),
          std::max(length, kLeastInsertion)};
}

Eigen::Vector3d Laparoscope4::generalisedForce(const LaparoscopePose& pose,
                                               const Eigen::Vector3d& force) const noexcept
{
  const double insertion = std::max(pose.insertion, kLeastInsertion);
  const double cosYaw = std::cos(pose.yaw), sinYaw = std::sin(pose.yaw);
  const double cosPitch = std::cos(pose.pitch), sinPitch = std::sin(pose.pitch);
  const Eigen::Vector3d alongYaw(-cosYaw * cosPitch, 0.0, sinYaw * cosPitch);
  const Eigen::Vector3d alongPitch(sinYaw * sinPitch, cosPitch, cosYaw * sinPitch);
  const Eigen::Vector3d axis(-sinYaw * cosPitch, sinPitch, -cosYaw * cosPitch);
  const double lever = insertion * transverseShare(insertion);
  return {lever * alongYaw.dot(force), lever * alongPitch.dot(force), axis.dot(force)};
}

double Laparoscope4::outside(const Eigen::Vector3d& handle, Eigen::Vector3d& direction) const noexcept
{
  const Eigen::Vector3d rod = m_pivot - handle;
  const double distance = rod.norm();
  direction = distance > 1e-9 ? Eigen::Vector3d(rod / distance) : Eigen::Vector3d(0.0, 0.0, -1.0);
  return std::clamp(distance, kLeastInsertion, m_length - kLeastInsertion);
}

Eigen::Vector3d Laparoscope4::tipOfHandle(const Eigen::Vector3d& handle) const noexcept
{
  Eigen::Vector3d direction;
  const double out = outside(handle, direction);
  return m_pivot + (m_length - out) * direction;
}

Eigen::Vector3d Laparoscope4::handleOfTip(const Eigen::Vector3d& tip) const noexcept
{
  return tipOfHandle(tip); // the same rod, seen from its other end
}

Eigen::Matrix3d Laparoscope4::tipJacobian(const Eigen::Vector3d& handle) const noexcept
{
  Eigen::Vector3d direction;
  const double out = outside(handle, direction);
  const Eigen::Matrix3d along = direction * direction.transpose();
  return along - (m_length - out) / out * (Eigen::Matrix3d::Identity() - along);
}

Eigen::Vector3d Laparoscope4::handleForce(const Eigen::Vector3d& handle,
                                          const Eigen::Vector3d& force) const noexcept
{
  Eigen::Vector3d direction;
  const double out = outside(handle, direction), insertion = m_length - out;
  const Eigen::Vector3d axial = direction * direction.dot(force);
  const double share = transverseShare(insertion) * transverseShare(out);
  return axial - share * insertion / out * (force - axial);
}

} // namespace esm
