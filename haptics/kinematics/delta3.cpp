// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/kinematics/delta3.h"

#include <Eigen/LU>

#include <cmath>

namespace esm {

namespace {

constexpr int kMostIterations = 20;
constexpr double kSolved = 1e-15;     ///< [m^2] of g, where a millimetre off is 1e-4
constexpr double kLongestStep = 0.02; ///< [m]; a longer one leaves the region where the tangent says anything
constexpr double kSingular = 1e-9;

} // namespace

Delta3::Delta3(const Delta3Geometry& geometry)
  : m_geometry(geometry), m_cos(geometry.legAngle.array().cos()), m_sin(geometry.legAngle.array().sin())
{}

Eigen::Vector3d Delta3::anglesOfCounts(const Eigen::Vector3d& counts) const noexcept
{
  return Eigen::Vector3d::Constant(m_geometry.zeroAngle) + m_geometry.anglePerCount * counts;
}

Eigen::Vector3d Delta3::countsOfAngles(const Eigen::Vector3d& angles) const noexcept
{
  return (angles - Eigen::Vector3d::Constant(m_geometry.zeroAngle)) / m_geometry.anglePerCount;
}

bool Delta3::leg(int index, const Eigen::Vector3d& position, Leg& leg) const noexcept
{
  const Delta3Geometry& m = m_geometry;
  leg.U = m_cos[index] * position.x() + m_sin[index] * position.y() - m.baseRadius + m.platformOffset;
  leg.v = -m_sin[index] * position.x() + m_cos[index] * position.y() - m.baseSideways;
  leg.w = position.z();
  const double sideways = leg.v + m.rodSideways;
  const double square = m.rodLength * m.rodLength - sideways * sideways;
  if (!(square > kSingular)) return false;
  leg.rod = std::sqrt(square);
  return true;
}

bool Delta3::inverse(const Eigen::Vector3d& position, Eigen::Vector3d& angles) const noexcept
{
  const double a = m_geometry.armLength;
  Eigen::Vector3d found;
  for (int i = 0; i < 3; ++i) {
    Leg l;
    if (!leg(i, position, l)) return false;
    const double length = m_geometry.hingeLength + l.rod;
    const double reach = l.U * l.U + l.w * l.w;
    const double cosine = (reach + a * a - length * length) / (2.0 * a * std::sqrt(reach));
    if (!(std::abs(cosine) <= 1.0)) return false;
    found[i] = std::atan2(l.w, l.U) - std::acos(cosine);
  }
  angles = found;
  return true;
}

bool Delta3::closure(int index, const Eigen::Vector3d& position, double angle, double& g,
                     Eigen::RowVector3d& slope, double& turn) const noexcept
{
  Leg l;
  if (!leg(index, position, l)) return false;
  const double a = m_geometry.armLength;
  const double length = m_geometry.hingeLength + l.rod;
  const double along = l.U - a * std::cos(angle), up = l.w - a * std::sin(angle);
  g = along * along + up * up - length * length;
  // d(L^2)/dv = 2 L dh/dv = -2 L (v + f) / h
  const double sideways = 2.0 * length * (l.v + m_geometry.rodSideways) / l.rod;
  slope.x() = 2.0 * along * m_cos[index] - sideways * m_sin[index];
  slope.y() = 2.0 * along * m_sin[index] + sideways * m_cos[index];
  slope.z() = 2.0 * up;
  turn = 2.0 * a * (along * std::sin(angle) - up * std::cos(angle));
  return true;
}

bool Delta3::forward(const Eigen::Vector3d& angles, Eigen::Vector3d& position, int* iterations) const noexcept
{
  if (!angles.allFinite()) return false;
  Eigen::Vector3d x = position.allFinite() ? position : centre();
  for (int count = 0; count <= kMostIterations; ++count) {
    Eigen::Vector3d g;
    Eigen::Matrix3d slopes;
    for (int i = 0; i < 3; ++i) {
      Eigen::RowVector3d slope;
      double turn = 0.0;
      if (!closure(i, x, angles[i], g[i], slope, turn)) return false;
      slopes.row(i) = slope;
    }
    if (iterations) *iterations = count;
    if (g.cwiseAbs().maxCoeff() < kSolved) {
      if (!(x.z() > 0.0)) return false; // the mirror pose behind the base
      position = x;
      return true;
    }
    Eigen::Matrix3d inverse;
    bool regular = false;
    slopes.computeInverseWithCheck(inverse, regular, kSingular);
    if (!regular) return false;
    Eigen::Vector3d step = inverse * g;
    const double length = step.norm();
    if (!std::isfinite(length)) return false;
    if (length > kLongestStep) step *= kLongestStep / length;
    x -= step;
  }
  return false;
}

bool Delta3::jacobian(const Eigen::Vector3d& position, const Eigen::Vector3d& angles,
                      Eigen::Matrix3d& jacobian) const noexcept
{
  Eigen::Matrix3d found;
  for (int i = 0; i < 3; ++i) {
    double g = 0.0, turn = 0.0;
    Eigen::RowVector3d slope;
    if (!closure(i, position, angles[i], g, slope, turn) || std::abs(turn) < kSingular) return false;
    found.row(i) = -slope / turn;
  }
  jacobian = found;
  return true;
}

bool Delta3::torques(const Eigen::Vector3d& position, const Eigen::Vector3d& angles,
                     const Eigen::Vector3d& force, Eigen::Vector3d& torques) const noexcept
{
  Eigen::Matrix3d j;
  if (!jacobian(position, angles, j)) return false;
  Eigen::Matrix3d inverse;
  bool regular = false;
  j.computeInverseWithCheck(inverse, regular, kSingular);
  if (!regular) return false;
  torques = inverse.transpose() * force;
  return torques.allFinite();
}

} // namespace esm
