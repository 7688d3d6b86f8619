// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/force_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace esm::test {

/// The checks that every force law must pass, over any net (after SOFA's idea). Positions and velocities are
/// those of the net; they should be well away from kinks of the law. Differences are central with h = 1e-6:
/// on forces around 10 N and lengths around 1 m they are exact to about 1e-7 of the force.
class ForceHarness {
public:
  explicit ForceHarness(const SpringNet& net)
    : m_model(net, Eigen::Vector3d::Zero()),
      m_x(static_cast<std::size_t>(net.nodeCount())),
      m_v(m_x.size(), Lanes{0, 0, 0, 0})
  {
    copyNodes(net.restPosition, m_x);
    if (net.initialVelocity.cols() > 0) copyNodes(net.initialVelocity, m_v);
  }

  NodeArray forces(const NodeArray& x, const NodeArray& v) const
  {
    NodeArray force(x.size());
    m_model.computeForces(x.data(), v.data(), force.data());
    return force;
  }
  double largest(const NodeArray& force) const
  {
    double most = 0.0;
    for (const Lanes& f : force) most = std::max(most, std::sqrt(dot(f, f)));
    return most;
  }

  /// f = - dE/dx
  void expectMinusGradientOfEnergy() const
  {
    const NodeArray rest(m_x.size(), Lanes{0, 0, 0, 0}), force = forces(m_x, rest);
    const double scale = largest(force);
    for (std::size_t i = 0; i < m_x.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        const double slope =
          difference(i, c, [&](const NodeArray& x) { return m_model.elasticEnergy(x.data()); });
        EXPECT_NEAR(force[i][c], -slope, 1e-6 * scale) << "node " << i << " component " << c;
      }
  }

  /// Without anchors: no net force and no net torque, up to the rounding of the sums.
  void expectThirdLaw() const
  {
    const NodeArray force = forces(m_x, m_v);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), torque = sum;
    for (std::size_t i = 0; i < m_x.size(); ++i) {
      const Eigen::Vector3d x = toVector(m_x[i]), f = toVector(force[i]);
      sum += f;
      torque += Eigen::Vector3d(x.y() * f.z() - x.z() * f.y(), x.z() * f.x() - x.x() * f.z(),
                                x.x() * f.y() - x.y() * f.x());
    }
    EXPECT_LT(sum.norm(), 1e-13 * largest(force) * static_cast<double>(m_x.size()));
    EXPECT_LT(torque.norm(), 1e-13 * largest(force) * static_cast<double>(m_x.size()));
  }

  /// A turned and shifted net has the same forces, turned.
  void expectRigidMotionInvariance() const
  {
    const double angle = 0.7;
    Eigen::Matrix3d about; // about z, then about x
    about << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
    Eigen::Matrix3d tilt;
    tilt << 1, 0, 0, 0, 0.6, -0.8, 0, 0.8, 0.6;
    const Eigen::Matrix3d turn = tilt * about;
    const Eigen::Vector3d shift(0.3, -2.0, 1.1);
    NodeArray x = m_x, v = m_v;
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = toLanes(turn * toVector(m_x[i]) + shift);
      v[i] = toLanes(turn * toVector(m_v[i]));
    }
    const NodeArray before = forces(m_x, m_v), after = forces(x, v);
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_LT((toVector(after[i]) - turn * toVector(before[i])).norm(), 1e-12 * largest(before))
        << "node " << i;
    EXPECT_NEAR(m_model.elasticEnergy(x.data()), m_model.elasticEnergy(m_x.data()),
                1e-12 * std::abs(m_model.elasticEnergy(m_x.data())));
  }

  /// The viscous part of the force takes exactly the power that is counted as heat, and heat is never
  /// negative.
  void expectDampingTakesEnergy() const
  {
    const NodeArray rest(m_x.size(), Lanes{0, 0, 0, 0}), elastic = forces(m_x, rest);
    NodeArray force(m_x.size());
    const double heat = m_model.computeForces(m_x.data(), m_v.data(), force.data());
    double power = 0.0;
    for (std::size_t i = 0; i < m_x.size(); ++i) power += dot(force[i] - elastic[i], m_v[i]);
    EXPECT_GE(heat, 0.0);
    EXPECT_NEAR(-power, heat, 1e-12 * std::max(1.0, heat));
  }

  /// The blocks of SpringTangent against differences of the forces, in position and in velocity.
  void expectTangentsAreDerivatives() const
  {
    const std::size_t n = 3 * m_x.size();
    Eigen::MatrixXd byX = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    Eigen::MatrixXd byV = byX;
    std::vector<SpringTangent> tangents;
    m_model.springTangents(m_x.data(), m_v.data(), tangents);
    for (std::size_t s = 0; s < tangents.size(); ++s) {
      const SpringTangent& t = tangents[s];
      const Eigen::Matrix3d uu = t.direction * t.direction.transpose();
      Eigen::Matrix3d k = t.axial * uu + t.direction * t.shear.transpose();
      if (!uu.isZero(0.0)) k += t.lateral * (Eigen::Matrix3d::Identity() - uu);
      addBlocks(byX, m_model.springEnds()[s], k);
      addBlocks(byV, m_model.springEnds()[s], t.viscous * uu);
    }
    for (const ForceModel::Anchor& anchor : m_model.anchors()) {
      byX.diagonal().segment<3>(3 * anchor.node).array() -= anchor.stiffness;
      byV.diagonal().segment<3>(3 * anchor.node).array() -= anchor.viscosity;
    }
    for (std::size_t i = 0; i < m_model.massDrag().size(); ++i)
      byV.diagonal().segment<3>(3 * static_cast<Eigen::Index>(i)).array() -= m_model.massDrag()[i];
    for (std::size_t i = 0; i < m_x.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        expectColumn(byX, i, c, m_x, [&](const NodeArray& x) { return forces(x, m_v); });
        expectColumn(byV, i, c, m_v, [&](const NodeArray& v) { return forces(m_x, v); });
      }
  }

  void expectAll() const
  {
    expectMinusGradientOfEnergy();
    expectThirdLaw();
    expectRigidMotionInvariance();
    expectDampingTakesEnergy();
    expectTangentsAreDerivatives();
  }

private:
  static constexpr double kStep = 1e-6;

  template <class Function>
  double difference(std::size_t node, int component, const Function& function) const
  {
    NodeArray plus = m_x, minus = m_x;
    plus[node][component] += kStep;
    minus[node][component] -= kStep;
    return (function(plus) - function(minus)) / (2 * kStep);
  }

  static void addBlocks(Eigen::MatrixXd& matrix, const ForceModel::Ends& ends, const Eigen::Matrix3d& k)
  {
    const Eigen::Index a = 3 * ends.a, b = 3 * ends.b;
    matrix.block<3, 3>(a, b) += k;
    matrix.block<3, 3>(a, a) -= k;
    matrix.block<3, 3>(b, a) += k;
    matrix.block<3, 3>(b, b) -= k;
  }

  template <class Function>
  void expectColumn(const Eigen::MatrixXd& matrix, std::size_t node, int component, const NodeArray& at,
                    const Function& function) const
  {
    NodeArray plus = at, minus = at;
    plus[node][component] += kStep;
    minus[node][component] -= kStep;
    const NodeArray high = function(plus), low = function(minus);
    const auto column = 3 * static_cast<Eigen::Index>(node) + component;
    const double scale = std::max(1.0, matrix.cwiseAbs().maxCoeff());
    for (std::size_t i = 0; i < at.size(); ++i)
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR((high[i][c] - low[i][c]) / (2 * kStep),
                    matrix(3 * static_cast<Eigen::Index>(i) + c, column), 1e-7 * scale)
          << "force on node " << i << " by node " << node;
  }

  ForceModel m_model;
  NodeArray m_x, m_v;
};

} // namespace esm::test
