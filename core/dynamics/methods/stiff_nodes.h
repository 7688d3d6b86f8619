// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/system/system.h"

#include <Eigen/Dense>

#include <vector>

namespace esm {

/// The few nodes that hold all others to small steps: hubs of many springs, light nodes, nodes in a stiff grip.
/// Found from the parameters alone; what the others bear without them, and what these few answer to a step,
/// from the springs' tangents at a place.
class StiffNodes {
public:
  /// Who they are; none if holding them would not let the others take steps kGain times as long.
  static std::vector<Index> find(const System& system);
  static constexpr double kGain = 4.0;

  /// The few whose steps are to be solved for. step() is by the parameters alone until the first look. Allocates.
  void prepare(const System& system, std::vector<Index> nodes);
  const std::vector<Index>& nodes() const noexcept { return m_nodes; }

  /// Stiffness, damping and limit at x and v.
  void look(const System& system, const NodeArray& x, const NodeArray& v);
  /// Largest step of Verlet's method for all others, while these few are held [s].
  double step() const noexcept { return m_step; }
  /// Fastest rates of the others [1/s^2], [1/s].
  double stiffness() const noexcept { return m_stiffness; }
  double damping() const noexcept { return m_damping; }

  /// The inverse of 4 M/h^2 + 2 D/h + K over the few: how far their ends by the trapezoidal rule must go for
  /// forces that nobody balances. @return false if that matrix is not positive.
  bool prepareAnswer(const System& system, double h);
  /// forces [N] become displacements [m].
  void answer(Eigen::VectorXd& forces) const { forces = m_answer * forces; }
  /// K x + D v of the few [N].
  Eigen::VectorXd hold(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const
  {
    return m_springs * x + m_dampers * v;
  }
  /// A displacement has taken away this force: from now on the answer to it is that (Broyden 1965).
  void learn(const Eigen::VectorXd& displacement, const Eigen::VectorXd& force);

private:
  bool isStiff(Index node) const noexcept { return m_placeOf[at(node)] != kNoIndex; }
  void addRows(const System& system, Index a, Index b, double k, double c);
  void addSpring(const SpringTangent& tangent, Index a, Index b);
  void addSingles(const System& system);
  void findLimit();

  std::vector<Index> m_nodes;
  std::vector<Index> m_placeOf; ///< of a node among them, kNoIndex of the others
  std::vector<SpringTangent> m_tangents;
  std::vector<double> m_rowStiffness, m_rowDamping; ///< by node
  Eigen::MatrixXd m_springs, m_dampers;             ///< K and D over them
  Eigen::MatrixXd m_answer;
  double m_step = 0.0, m_stiffness = 0.0, m_damping = 0.0;
};

} // namespace esm
