// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace esm {

/// Measures of a Delta robot with three arms (Stamper's construction) [m, rad].
struct Delta3Geometry {
  double armLength = 0.060;        ///< a, from the motor axis to the elbow
  double rodLength = 0.1025;       ///< b, of the parallelogram
  double platformOffset = 0.01443; ///< c
  double hingeLength = 0.0225;     ///< d + e, both hinges of the parallelogram together
  double rodSideways = -0.025;     ///< f
  double baseRadius = 0.0400;      ///< r
  double baseSideways = -0.02309;  ///< s
  Eigen::Vector3d legAngle{1.8325957145940461, -0.26179938779914941,
                           -2.3561944901923448}; ///< 105, -15, -135 deg
  double zeroAngle = 0.61086523819801530;        ///< of an arm at count 0: 35 deg
  double anglePerCount = 6.358640586634e-4;      ///< 2 pi 14.25 mm / (110 mm 1280)
};

/// Pose of a Delta robot from its three arm angles and back.
///
/// In the frame of one leg, u outwards, v sideways, w along the axis of the device,
///
///     u = x cos phi + y sin phi - r,   v = -x sin phi + y cos phi - s,   w = z
///     h = sqrt(b^2 - (v + f)^2),   L = d + e + h,   U = u + c
///     g(theta, x) = (U - a cos theta)^2 + (w - a sin theta)^2 - L^2 = 0
///     theta = atan2(w, U) - acos((U^2 + w^2 + a^2 - L^2) / (2 a sqrt(U^2 + w^2)))
///
/// and the forward direction is Newton's method on the three g, with their exact gradients. Force and torque
/// are dual: torque = J^-T force with d theta = J dx, force = J^T torque.
/// @note Any thread; no allocation.
/// @see Stamper, "A three degree of freedom parallel manipulator with only translational degrees of freedom"
/// (1997).
class Delta3 {
public:
  explicit Delta3(const Delta3Geometry& geometry = {});

  Eigen::Vector3d anglesOfCounts(const Eigen::Vector3d& counts) const noexcept;
  Eigen::Vector3d countsOfAngles(const Eigen::Vector3d& angles) const noexcept;

  /// @return false: out of reach, `angles` is as before.
  bool inverse(const Eigen::Vector3d& position, Eigen::Vector3d& angles) const noexcept;
  /// @param position in: where to start (the last position, or centre()); out: the pose, if true.
  /// @param iterations out, if not null: how many Newton steps it took.
  bool forward(const Eigen::Vector3d& angles, Eigen::Vector3d& position,
               int* iterations = nullptr) const noexcept;
  /// J = d theta / d x [rad/m]. @return false where the mechanism is singular.
  bool jacobian(const Eigen::Vector3d& position, const Eigen::Vector3d& angles,
                Eigen::Matrix3d& jacobian) const noexcept;
  /// Arm torques [N m] that make `force` [N] at the grip. @return false where the mechanism is singular.
  bool torques(const Eigen::Vector3d& position, const Eigen::Vector3d& angles, const Eigen::Vector3d& force,
               Eigen::Vector3d& torques) const noexcept;

  static Eigen::Vector3d centre() noexcept { return {0.0, 0.0, 0.11}; }

private:
  struct Leg {
    double U, v, w, rod; ///< rod = h
  };
  bool leg(int index, const Eigen::Vector3d& position, Leg& leg) const noexcept;
  /// g of one leg, its gradient in x and its derivative in theta.
  bool closure(int index, const Eigen::Vector3d& position, double angle, double& g, Eigen::RowVector3d& slope,
               double& turn) const noexcept;

  Delta3Geometry m_geometry;
  Eigen::Vector3d m_cos, m_sin;
};

} // namespace esm
