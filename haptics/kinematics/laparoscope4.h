// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace esm {

/// How an instrument hangs in its trocar.
struct LaparoscopePose {
  double yaw = 0.0, pitch = 0.0; ///< about the pivot [rad]
  double insertion = 0.1;        ///< from the pivot to the tip [m]
};

/// A laparoscopic instrument: two rotations about a fixed pivot, insertion, roll about the shaft.
///
///     tip = pivot + insertion R_y(yaw) R_x(pitch) (0, 0, -1)
///
/// Led by the handle of any device with three axes, the shaft is a rigid rod through the pivot: the tip goes
/// the other way than the hand, and faster or slower than it by insertion / (length - insertion).
/// At the pivot itself directions mean nothing: insertion stays above kLeastInsertion, and the transverse
/// force fades on the way there.
/// @note Any thread; no allocation.
class Laparoscope4 {
public:
  static constexpr double kLeastInsertion = 0.010; ///< [m]
  static constexpr double kFadeInsertion = 0.030;  ///< [m]; transverse force is whole from here on

  /// @param length from the handle to the tip [m]; at least 3 kLeastInsertion.
  Laparoscope4(const Eigen::Vector3d& pivot, double length) noexcept;

  Eigen::Vector3d tip(const LaparoscopePose& pose) const noexcept;
  LaparoscopePose pose(const Eigen::Vector3d& tip) const noexcept;
  /// (yaw, pitch, insertion): torques [N m], force [N] that `force` at the tip makes.
  Eigen::Vector3d generalisedForce(const LaparoscopePose& pose, const Eigen::Vector3d& force) const noexcept;

  Eigen::Vector3d tipOfHandle(const Eigen::Vector3d& handle) const noexcept;
  Eigen::Vector3d handleOfTip(const Eigen::Vector3d& tip) const noexcept;
  /// Force at the handle that the hand feels for `force` at the tip: the power is the same.
  Eigen::Vector3d handleForce(const Eigen::Vector3d& handle, const Eigen::Vector3d& force) const noexcept;
  /// The same orders for the tip's velocity: d tip / d handle.
  Eigen::Matrix3d tipJacobian(const Eigen::Vector3d& handle) const noexcept;

  const Eigen::Vector3d& pivot() const noexcept { return m_pivot; }
  double length() const noexcept { return m_length; }

private:
  /// Outside length of the shaft, kept so that both its ends have one.
  double outside(const Eigen::Vector3d& handle, Eigen::Vector3d& direction) const noexcept;

  Eigen::Vector3d m_pivot;
  double m_length;
};

} // namespace esm
