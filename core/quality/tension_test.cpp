// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/quality/tension_test.h"

#include "core/geometry/extent.h"
#include "core/net/net_builder.h"
#include "core/quality/linear_net.h"
#include "core/tissue/derivation_places.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double kRoller = 1e4;  ///< stiffness of a roller over that of the stiffest node
constexpr double kShift = 1e-10; ///< of the stiffest rate, against what nothing holds

/// Twice the energy of a wall that is stretched by 1 along the axis, per Young's modulus [m^3]: the integral
/// of its sections across the axis, thickness times outline times the share of the wall that runs along it.
double wallAlong(const SpringNet& net, const Eigen::Vector3d& axis, double thickness)
{
  double sum = 0.0;
  for (Eigen::Index t = 0; t < net.triangles.cols(); ++t) {
    const Eigen::Vector3d a = net.restPosition.col(net.triangles(0, t)),
                          b = net.restPosition.col(net.triangles(1, t)),
                          c = net.restPosition.col(net.triangles(2, t));
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    const double area = 0.5 * normal.norm();
    if (!(area > 0.0)) continue;
    const double across = normal.dot(axis) / (2.0 * area);
    sum += thickness * area * (1.0 - across * across);
  }
  return sum;
}

/// Twice the energy of springs [m^3], their stiffness per Young's modulus.
double energyOf(const SpringNet& net, const Eigen::ArrayXd& stiffness, const Eigen::Matrix3Xd& moved)
{
  double sum = 0.0;
  for (Index s = 0; s < net.springCount(); ++s) {
    const Index a = net.ends(0, s), b = net.ends(1, s);
    const Eigen::Vector3d along = (net.restPosition.col(b) - net.restPosition.col(a)).normalized();
    const double longer = along.dot(moved.col(b) - moved.col(a));
    sum += stiffness[s] * longer * longer;
  }
  return sum;
}

} // namespace

Eigen::Vector3d longestAxis(const SpringNet& net, const Eigen::ArrayXd& area)
{
  const Eigen::Vector3d centre = (net.restPosition * area.matrix()) / area.sum();
  const Eigen::Matrix3Xd away = net.restPosition.colwise() - centre;
  const Eigen::Matrix3d spread = away * area.matrix().asDiagonal() * away.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  if (solver.eigenvalues()[2] > 1.2 * solver.eigenvalues()[1]) return solver.eigenvectors().col(2);
  int side = 0;
  boxOf(net.restPosition).sizes().maxCoeff(&side);
  return Eigen::Vector3d::Unit(side);
}

Result<TensionTest> testTension(const SpringNet& net, double thickness, bool isSolid, WorkControl* control)
{
  const auto impossible = [](const char* why) { return Error{ErrorCode::Numerics, why}; };
  const Eigen::ArrayXd area = nodeDualAreas(net);
  if (!(area.sum() > 0.0)) return impossible("without a surface there is nothing that could be pulled at");
  TensionTest test;
  test.axis = longestAxis(net, area);
  test.wanted = isSolid ? net.volume.sum() : wallAlong(net, test.axis, thickness);
  if (!(test.wanted > 0.0)) return impossible("the body has no tissue that could be pulled at");

  DerivationPlaces places(net);
  places.setThickness(thickness, net);
  SpringNet free = net;
  std::fill(free.fixed.begin(), free.fixed.end(), std::uint8_t{0});
  free.mass.setOnes();
  free.pressure.clear(); // the springs alone are what is scaled
  LinearNet linear(free, places.perModulus, false);
  linear.watch(control);
  const double rate = linear.stiffestRate();
  if (!(rate > 0.0)) return impossible("the net has no stiffness that could be scaled");

  // Drawn along the axis all over, then let go across it: the rollers hold what is left to move to that.
  const Eigen::RowVectorXd height = test.axis.transpose() * net.restPosition;
  const Eigen::Matrix3Xd drawn = test.axis * (height.array() - height.mean()).matrix();
  const Eigen::Matrix3Xd pull = linear.multiply(drawn);
  for (Index node = 0; node < net.nodeCount(); ++node)
    if (area[node] > 0.0) linear.addSupport(node, test.axis, kRoller * rate);
  if (!linear.factor(kShift * rate)) return impossible("the net has no stiffness that could be scaled");
  if (stopWanted(control)) return cancelledError();
  const Eigen::Matrix3Xd moved = drawn - linear.solve(pull);
  if (stopWanted(control)) return cancelledError();
  test.measured = energyOf(net, places.perModulus, moved);
  if (!(std::isfinite(test.measured) && test.measured > 1e-6 * test.wanted))
    return impossible(
      "drawn along its longest axis the net gives way without resistance: it has loose parts or "
      "needs interior struts");
  return test;
}

} // namespace esm
