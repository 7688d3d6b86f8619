// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"
#include "core/linear/block_cholesky.h"
#include "core/linear/low_rank.h"
#include "core/net/spring_net.h"

#include <Eigen/Core>

#include <vector>

namespace esm {

/// A net for small motions about its rest shape: K of its springs (along their axes, at their stiffness at
/// rest), anchors and pressure, M of its masses. Fixed nodes are held. Springs count as stress-free.
///
/// A skin has a sparse factor. Struts join everything to everything, so that the factor of a fat body is
/// nearly full; but then the matrix is well conditioned, and conjugate gradients take its place.
class LinearNet {
public:
  /// @param withAnchors false: the net as if nothing held it but its fixed nodes.
  /// @param stiffness per spring [N/m]; the net's own in the other constructor.
  LinearNet(const SpringNet& net, const Eigen::ArrayXd& stiffness, bool withAnchors);
  explicit LinearNet(const SpringNet& net, bool withAnchors = true)
    : LinearNet(net, net.stiffness, withAnchors)
  {}

  /// Adds k axis axis^T at a node, as a support that gives way in all other directions.
  void addSupport(Index node, const Eigen::Vector3d& axis, double k);
  /// Makes ready for solve() with K + shift M. @return whether that is possible.
  bool factor(double shift);
  bool isIterative() const noexcept
  {
    return m_isIterative;
  } ///< of the last factor(): no factor, no modesBelow()
  void watch(WorkControl* control) noexcept { m_control = control; } ///< that ends long solves early
  /// Modes with K u = w2 M u, w2 < -shift, of the last factor(); Sylvester's law of inertia.
  std::int64_t modesBelow() const noexcept
  {
    return m_cholesky.negativePivots() - (m_pressure.empty() ? 0 : m_update.negativesGone());
  }
  /// (K + shift M)^-1 force, 3 x N; held nodes stay at 0. @pre factor() was true
  Eigen::Matrix3Xd solve(const Eigen::Matrix3Xd& force);
  Eigen::Matrix3Xd multiply(const Eigen::Matrix3Xd& displacement) const; ///< K u, also at held nodes
  /// Largest trace of a node's block of K over 3 m [1/s^2]: what shifts are measured by.
  double stiffestRate() const noexcept;
  Index freeCount() const noexcept { return static_cast<Index>(m_nodeOf.size()); }
  const SpringNet& net() const noexcept { return m_net; }

private:
  Eigen::Matrix3Xd solveByGradients(const Eigen::Matrix3Xd& force) const;
  Eigen::Matrix3Xd solveByFactor(const Eigen::Matrix3Xd& force);
  Eigen::Matrix3d blockAt(Index node) const;

  const SpringNet& m_net;
  WorkControl* m_control = nullptr;
  bool m_isIterative = false;
  double m_shift = 0.0;
  Eigen::ArrayXd m_stiffness;
  Eigen::Matrix3Xd m_direction; ///< 3 x S
  std::vector<Index> m_blockOf, m_nodeOf;
  std::vector<NodePair> m_pairs;
  std::vector<Eigen::Matrix3d> m_diagonal; ///< per node
  NodeBlocks m_coupling;
  BlockCholesky m_cholesky;
  NodeArray m_vector;
  struct PressureColumn {
    Eigen::Matrix3Xd gradient; ///< dV/dx at rest [m^2]
    double stiffness;          ///< K/V0 [Pa/m^3]
    Eigen::Matrix3Xd solved;   ///< of the last factor()
  };
  std::vector<PressureColumn> m_pressure;
  LowRankUpdate m_update; ///< of the springs' factor by the pressure
};

/// The slowest motions of a net.
struct SlowModes {
  Eigen::ArrayXd frequency;            ///< [Hz], ascending
  std::vector<Eigen::Matrix3Xd> shape; ///< largest displacement 1
};
/// By subspace iteration, without the rigid motions of parts that nothing holds. Empty if there is no factor
/// or the work was cancelled.
SlowModes slowestModes(LinearNet& net, int count, WorkControl* control = nullptr);

/// The rigid motions of the connected parts of a net that neither fixed nodes nor anchors hold.
class RigidMotions {
public:
  RigidMotions(const SpringNet& net, bool withAnchors);
  /// Takes their share off a field of motions, so that it has no momentum and no angular momentum.
  void removeFromMotion(Eigen::Matrix3Xd& motion) const;
  /// Takes off what accelerates them, so that a force is in balance (inertia relief).
  void removeFromForce(Eigen::Matrix3Xd& force) const;
  Index partOf(Index node) const { return m_part[static_cast<std::size_t>(node)]; }
  Index partCount() const noexcept { return static_cast<Index>(m_loose.size()); }
  bool isLoose(Index part) const { return m_loose[static_cast<std::size_t>(part)] != 0; }

private:
  using Motion6 = Eigen::Matrix<double, 6, 1>;
  std::vector<Motion6> coefficients(const Eigen::Matrix3Xd& impulse) const;
  Eigen::Vector3d motionOf(const Motion6& motion, Index node) const;
  const SpringNet& m_net;
  std::vector<Index> m_part;
  std::vector<std::uint8_t> m_loose; ///< per part
  std::vector<Eigen::Vector3d> m_centre;
  std::vector<Eigen::Matrix<double, 6, 6>> m_inverseInertia;
};

} // namespace esm
