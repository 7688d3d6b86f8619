// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace esm {

/// Measures of a serial arm with three capstan-driven revolute joints, as WoodenHaptics has by default.
struct Serial3RGeometry {
  double capstanDiameter = 0.010;                    ///< [m], all three
  Eigen::Vector3d bodyDiameter{0.160, 0.120, 0.120}; ///< [m]
  Eigen::Vector3d linkLength{0.080, 0.205, 0.245};   ///< La, Lb, Lc [m]
  double countsPerTurn = 2000.0;                     ///< of a motor
  double torquePerAmpere = 0.0259;                   ///< of a motor [N m/A]
  Eigen::Vector3d origin{0.220, 0.0, 0.080};         ///< where the user's zero lies [m]
};

/// Kinematics of WoodenHaptics: joint a turns the column, b and c lift the two links.
///
///     x = cos A (Lb sin B + Lc sin C),  y = sin A (Lb sin B + Lc sin C),  z = La + Lb cos B - Lc cos C
///
/// with C measured from the vertical: the third encoder gives 90 degrees less it. Encoder a counts backwards,
/// b is geared the other way. torque = J^T force in the joints; the motors of b and c pull the other way.
/// @note Any thread; no allocation.
class Serial3R {
public:
  explicit Serial3R(const Serial3RGeometry& geometry = {});

  Eigen::Vector3d anglesOfCounts(const Eigen::Vector3d& counts) const noexcept; ///< A, B, C [rad]
  Eigen::Vector3d countsOfAngles(const Eigen::Vector3d& angles) const noexcept;
  Eigen::Vector3d forward(const Eigen::Vector3d& angles) const noexcept; ///< [m], seen from the origin
  /// Elbow-up solution. @return false: out of reach, `angles` is as before.
  bool inverse(const Eigen::Vector3d& position, Eigen::Vector3d& angles) const noexcept;
  Eigen::Matrix3d jacobian(const Eigen::Vector3d& angles) const noexcept; ///< d x / d angle [m/rad]
  /// Motor currents [A] that make `force` [N] at the tip, and back.
  Eigen::Vector3d currents(const Eigen::Vector3d& angles, const Eigen::Vector3d& force) const noexcept;
  Eigen::Vector3d forceOfCurrents(const Eigen::Vector3d& angles,
                                  const Eigen::Vector3d& currents) const noexcept;

private:
  Serial3RGeometry m_geometry;
  Eigen::Vector3d m_gear;      ///< motor turns per joint turn, with the sign of the encoder
  Eigen::Vector3d m_motorSign; ///< of the torque
};

} // namespace esm
