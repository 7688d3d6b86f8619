// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/support/tension_test.h"

#include "core/net/net_builder.h"
#include "core/support/linear_net.h"
#include "core/support/outward_surface.h"
#include "core/tissue/derivation_places.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace esm {

namespace {

constexpr double kEnd = 0.1;     ///< of the length, held at each end
constexpr int kStations = 64;    ///< sections between the ends
constexpr double kRoller = 1e4;  ///< stiffness of a roller over that of the stiffest node
constexpr double kShift = 1e-10; ///< of the stiffest rate, against what nothing holds

/// A(x) at one place of the axis: area within the outline of the surface, or of the wall that is cut.
double sectionAt(const OutwardSurface& surface, const SpringNet& net, const Eigen::ArrayXd& height,
                 const Eigen::Vector3d& axis, double at, double thickness, bool isSolid)
{
  double sum = 0.0;
  for (Index t = 0; t < static_cast<Index>(surface.triangles().cols()); ++t) {
    const auto corners = surface.triangles().col(t);
    Eigen::Vector3d cut[2];
    int cuts = 0;
    bool rises = false; // of the first cut
    for (int k = 0; k < 3; ++k) {
      const Index a = corners[k], b = corners[(k + 1) % 3];
      const bool below = height[a] < at, nextBelow = height[b] < at;
      if (below == nextBelow || cuts == 2) continue;
      if (cuts == 0) rises = below;
      const double share = (at - height[a]) / (height[b] - height[a]);
      cut[cuts++] = net.restPosition.col(a) + share * (net.restPosition.col(b) - net.restPosition.col(a));
    }
    if (cuts < 2) continue;
    if (!rises) std::swap(cut[0], cut[1]);
    if (isSolid) {
      sum += 0.5 * axis.dot(cut[0].cross(cut[1]));
    } else {
      const double along = surface.triangleNormal(t).normalized().dot(axis);
      sum += thickness * (cut[1] - cut[0]).norm() * std::sqrt(std::max(0.0, 1.0 - along * along));
    }
  }
  return std::abs(sum);
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
  (net.restPosition.rowwise().maxCoeff() - net.restPosition.rowwise().minCoeff()).maxCoeff(&side);
  return Eigen::Vector3d::Unit(side);
}

Result<TensionTest> testTension(const SpringNet& net, double thickness, bool isSolid, WorkControl* control)
{
  const auto impossible = [](const char* why) { return Error{ErrorCode::Numerics, why}; };
  const Eigen::ArrayXd area = nodeDualAreas(net);
  if (!(area.sum() > 0.0)) return impossible("without a surface there is no section that could be pulled at");
  TensionTest test;
  test.axis = longestAxis(net, area);
  const Eigen::ArrayXd height = net.restPosition.transpose() * test.axis;
  const double low = height.minCoeff(), length = height.maxCoeff() - low;

  // What the ends hold, and from where to where the body is free.
  std::vector<Index> bottom, top;
  double from = low, to = low + length;
  for (Index node = 0; node < net.nodeCount(); ++node) {
    if (height[node] <= low + kEnd * length) {
      bottom.push_back(node);
      from = std::max(from, height[node]);
    } else if (height[node] >= low + (1.0 - kEnd) * length) {
      top.push_back(node);
      to = std::min(to, height[node]);
    }
  }
  const OutwardSurface surface(net, control);
  if (stopWanted(control)) return cancelledError();
  double resistance = 0.0;
  for (int i = 0; i < kStations; ++i) {
    const double at = from + (to - from) * (i + 0.5) / kStations;
    const double section = sectionAt(surface, net, height, test.axis, at, thickness, isSolid);
    if (!(section > 0.0))
      return impossible("the surface has gaps across its longest axis: nothing to pull at");
    resistance += (to - from) / kStations / section;
  }
  test.wanted = 1.0 / resistance;

  DerivationPlaces places(net);
  places.setThickness(thickness, net);
  SpringNet free = net;
  std::fill(free.fixed.begin(), free.fixed.end(), std::uint8_t{0});
  free.mass.setOnes();
  free.pressure.clear(); // the springs alone are what is scaled
  LinearNet linear(free, places.perModulus, false);
  linear.watch(control);
  const double roller = kRoller * linear.stiffestRate();
  // The ends are stretched as a bar is, by a strain of 1, so that springs that reach into them pull as all
  // others.
  Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, net.nodeCount());
  for (const std::vector<Index>* end : {&bottom, &top})
    for (const Index node : *end) {
      linear.addSupport(node, test.axis, roller);
      force.col(node) = roller * (height[node] - from) * test.axis;
    }
  if (!(roller > 0.0) || !linear.factor(kShift * roller / kRoller))
    return impossible("the net has no stiffness that could be scaled");
  if (stopWanted(control)) return cancelledError();
  const Eigen::Matrix3Xd moved = linear.solve(force);
  if (stopWanted(control)) return cancelledError();
  double pull = 0.0;
  for (const Index node : top) pull += roller * (height[node] - from - test.axis.dot(moved.col(node)));
  test.measured = pull / (to - from);
  if (!(std::isfinite(test.measured) && test.measured > 1e-6 * test.wanted))
    return impossible(
      "pulled along its longest axis the net gives way without resistance: it has loose parts or "
      "needs interior struts");
  return test;
}

} // namespace esm
