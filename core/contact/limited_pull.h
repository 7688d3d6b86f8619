// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace esm {

/// The force, or one of this size along it [N].
inline Eigen::Vector3d limitedForce(const Eigen::Vector3d& force, double maxForce)
{
  const double norm = force.norm();
  return norm > maxForce ? Eigen::Vector3d(force * (maxForce / norm)) : force;
}

/// A tool's spring that pulls with no more than a limit, whatever its length: its end is moved closer, to
/// where it pulls with the limit, and from twice that distance on it also softens, by octaves. So the force
/// changes little while the tissue moves within a frame, and the stiffness changes rarely, which spares the
/// solver new preparations.
struct LimitedPull {
  Eigen::Vector3d offset; ///< from the tissue to the spring's end [m]
  double softness = 1.0;  ///< of the stiffness [1], <= 1
  bool isLimited = false;
};

inline LimitedPull limitedPull(const Eigen::Vector3d& apart, double stiffness, double maxForce)
{
  const double length = apart.norm();
  if (!(stiffness * length > maxForce)) return {apart};
  const double softness = std::exp2(-std::floor(std::log2(stiffness * length / maxForce)));
  return {maxForce / (softness * stiffness * length) * apart, softness, true};
}

/// The stiffness of that spring to small motions of its far end: under the limit k, at the limit only across
/// the pull, which follows the direction and keeps its size.
inline Eigen::Matrix3d pullStiffness(const Eigen::Vector3d& apart, double stiffness, double maxForce)
{
  const double length = apart.norm();
  if (!(stiffness * length > maxForce)) return stiffness * Eigen::Matrix3d::Identity();
  const Eigen::Vector3d direction = apart / length;
  return maxForce / length * (Eigen::Matrix3d::Identity() - direction * direction.transpose());
}

} // namespace esm
