// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/simulation.h"
#include "core/dynamics/system/system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace esm::test {

/// Creation that must succeed.
inline Simulation simulate(SpringNet net, Loads loads = {}, SolverSettings settings = {})
{
  Result<Simulation> simulation = Simulation::create(std::move(net), std::move(loads), std::move(settings));
  if (!simulation) ADD_FAILURE() << simulation.error().detail;
  return std::move(simulation).value();
}

inline SolverSettings fixedSteps(const std::string& solver, double step)
{
  SolverSettings settings;
  settings.solver = solver;
  settings.fixedStep = step;
  settings.workLimit = 0.0; // convergence is shown by steps as small as it takes
  return settings;
}

/// The net as it stands at the start, for tests of a part of the engine; still to enter() a System.
inline MotionState startOf(const SpringNet& net)
{
  MotionState state;
  state.x.resize(static_cast<std::size_t>(net.nodeCount()));
  state.v.assign(state.x.size(), Lanes{0, 0, 0, 0});
  copyNodes(net.restPosition, state.x);
  if (net.initialVelocity.cols() > 0) copyNodes(net.initialVelocity, state.v);
  return state;
}

/// Sum of strength u u^T over springs that have their rest length, with both signs; dense, 3 N x 3 N. With
/// stiffness as the strength it is their tangent stiffness.
inline Eigen::MatrixXd axialMatrix(const SpringNet& net, const Eigen::ArrayXd& strength)
{
  const Eigen::Index n = 3 * net.nodeCount();
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n);
  for (Index s = 0; s < net.springCount(); ++s) {
    const Index a = net.ends(0, s), b = net.ends(1, s);
    const Eigen::Vector3d u = (net.restPosition.col(b) - net.restPosition.col(a)).normalized();
    const Eigen::Matrix3d block = strength[s] * u * u.transpose();
    k.block<3, 3>(3 * a, 3 * a) += block;
    k.block<3, 3>(3 * b, 3 * b) += block;
    k.block<3, 3>(3 * a, 3 * b) -= block;
    k.block<3, 3>(3 * b, 3 * a) -= block;
  }
  return k;
}

/// M^-1/2 K M^-1/2 of springs at rest length (only the axial part), dense.
inline Eigen::MatrixXd scaledMatrix(const SpringNet& net, const Eigen::ArrayXd& stiffness)
{
  Eigen::MatrixXd k = axialMatrix(net, stiffness);
  const Eigen::Index n = k.rows();
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) k(i, j) /= std::sqrt(net.mass[i / 3] * net.mass[j / 3]);
  return k;
}

/// kinetic + elastic + gravity + heat - work: constant in time, whatever happens.
inline double balance(const Simulation& simulation)
{
  return simulation.energies().total() + simulation.dissipatedEnergy() - simulation.externalWork();
}

inline void advanceWell(Simulation& simulation, double time)
{
  const StepReport report = simulation.advance(time);
  ASSERT_TRUE(report.good()) << simulation.why();
}

/// Nodes one after the other.
inline Eigen::VectorXd stacked(const NodeArray& nodes)
{
  Eigen::VectorXd result(3 * static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    result.segment<3>(3 * static_cast<Eigen::Index>(i)) = toVector(nodes[i]);
  return result;
}

} // namespace esm::test
