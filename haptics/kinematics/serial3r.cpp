// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/kinematics/serial3r.h"

#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace esm {

Serial3R::Serial3R(const Serial3RGeometry& geometry) : m_geometry(geometry), m_motorSign(1.0, -1.0, -1.0)
{
  m_gear = geometry.bodyDiameter / geometry.capstanDiameter;
  m_gear[0] = -m_gear[0];
  m_gear[1] = -m_gear[1];
}

Eigen::Vector3d Serial3R::anglesOfCounts(const Eigen::Vector3d& counts) const noexcept
{
  Eigen::Vector3d angles = (2.0 * std::numbers::pi / m_geometry.countsPerTurn * counts).cwiseQuotient(m_gear);
  angles[2] = 0.5 * std::numbers::pi - angles[2];
  return angles;
}

Eigen::Vector3d Serial3R::countsOfAngles(const Eigen::Vector3d& angles) const noexcept
{
  Eigen::Vector3d raw = angles;
  raw[2] = 0.5 * std::numbers::pi - raw[2];
  return raw.cwiseProduct(m_gear) * (m_geometry.countsPerTurn / (2.0 * std::numbers::pi));
}

Eigen::Vector3d Serial3R::forward(const Eigen::Vector3d& angles) const noexcept
{
  const Eigen::Vector3d& l = m_geometry.linkLength;
  const double out = l[1] * std::sin(angles[1]) + l[2] * std::sin(angles[2]);
  const double up = l[0] + l[1] * std::cos(angles[1]) - l[2] * std::cos(angles[2]);
  return Eigen::Vector3d(std::cos(angles[0]) * out, std::sin(angles[0]) * out, up) - m_geometry.origin;
}

bool Serial3R::inverse(const Eigen::Vector3d& position, Eigen::Vector3d& angles) const noexcept
{
  const Eigen::Vector3d& l = m_geometry.linkLength;
  const Eigen::Vector3d p = position + m_geometry.origin;
  const double out = std::hypot(p.x(), p.y()), up = p.z() - l[0];
  const double distance = std::hypot(out, up);
  const double cosine = (l[1] * l[1] + distance * distance - l[2] * l[2]) / (2.0 * l[1] * distance);
  if (!(std::abs(cosine) <= 1.0)) return false;
  const double b = std::atan2(out, up) - std::acos(cosine); // from the vertical
  angles[0] = std::atan2(p.y(), p.x());
  angles[1] = b;
  angles[2] = std::atan2(out - l[1] * std::sin(b), l[1] * std::cos(b) - up);
  return true;
}

Eigen::Matrix3d Serial3R::jacobian(const Eigen::Vector3d& angles) const noexcept
{
  const Eigen::Vector3d& l = m_geometry.linkLength;
  const double cosA = std::cos(angles[0]), sinA = std::sin(angles[0]);
  const double sinB = std::sin(angles[1]), cosB = std::cos(angles[1]);
  const double sinC = std::sin(angles[2]), cosC = std::cos(angles[2]);
  const double out = l[1] * sinB + l[2] * sinC;
  Eigen::Matrix3d j;
  j << -sinA * out, cosA * l[1] * cosB, cosA * l[2] * cosC, //
    cosA * out, sinA * l[1] * cosB, sinA * l[2] * cosC,     //
    0.0, -l[1] * sinB, l[2] * sinC;
  return j;
}

Eigen::Vector3d Serial3R::currents(const Eigen::Vector3d& angles, const Eigen::Vector3d& force) const noexcept
{
  const Eigen::Vector3d torque = jacobian(angles).transpose() * force;
  return torque.cwiseQuotient(m_gear.cwiseAbs()).cwiseProduct(m_motorSign) / m_geometry.torquePerAmpere;
}

Eigen::Vector3d Serial3R::forceOfCurrents(const Eigen::Vector3d& angles,
                                          const Eigen::Vector3d& currents) const noexcept
{
  const Eigen::Vector3d torque =
    currents.cwiseProduct(m_motorSign).cwiseProduct(m_gear.cwiseAbs()) * m_geometry.torquePerAmpere;
  const Eigen::Matrix3d j = jacobian(angles);
  if (std::abs(j.determinant()) < 1e-9) return Eigen::Vector3d::Zero();
  return j.transpose().inverse() * torque;
}

} // namespace esm
