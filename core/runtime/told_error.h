// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace esm {

/// What the screen says of the error: the part that it is of the motion since a hand took hold (or since the
/// start), root mean square over all nodes and over about the last second,
///
///     sqrt(sum e^2 dt / sum u^2 dt),   e: Simulation::livingError(), u: way of the nodes since begin().
///
/// The way counts from where the hand found the tissue, not from t = 0: what has sagged under its weight is no
/// excuse for an error of the pull.
/// @note One thread.
class ToldError {
public:
  void begin(const Eigen::Matrix3Xd& position) { *this = ToldError(position); }
  /// @param position  after `interval` [s] more, of the same nodes; @param error  in it [m]
  void add(const Eigen::Matrix3Xd& position, double error, double interval);
  double share() const noexcept; ///< [1], at most 1; 0 before anything has moved

  ToldError() = default;

private:
  explicit ToldError(const Eigen::Matrix3Xd& position) : m_begin(position) {}

  Eigen::Matrix3Xd m_begin;            ///< [m]
  double m_wrong = 0.0, m_moved = 0.0; ///< the two sums [m^2 s]
};

} // namespace esm
