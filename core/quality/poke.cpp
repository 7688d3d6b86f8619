// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/quality/poke.h"

#include "core/geometry/distance.h"
#include "core/net/net_builder.h"
#include "core/net/outward_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace esm {

namespace {

constexpr std::size_t kPokes = 12;
constexpr double kPokeShift = 1e-10; ///< of the stiffest rate

/// Each as far as can be from those before it.
std::vector<Index> spreadOut(const SpringNet& net, const std::vector<Index>& candidates)
{
  std::vector<Index> chosen;
  Eigen::ArrayXd away = Eigen::ArrayXd::Constant(static_cast<Eigen::Index>(candidates.size()),
                                                 std::numeric_limits<double>::infinity());
  Eigen::Index next = 0;
  while (chosen.size() < std::min(kPokes, candidates.size())) {
    chosen.push_back(candidates[static_cast<std::size_t>(next)]);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      double& distance = away[static_cast<Eigen::Index>(i)];
      distance = std::min(distance,
                          (net.restPosition.col(candidates[i]) - net.restPosition.col(chosen.back())).norm());
    }
    if (!(away.maxCoeff(&next) > 0.0)) break;
  }
  return chosen;
}

} // namespace

Eigen::Matrix3Xd pokePatch(const SpringNet& net, const Eigen::Vector3d& place, const Eigen::Vector3d& force,
                           double radius)
{
  const Eigen::ArrayXd area = nodeDualAreas(net);
  Eigen::RowVectorXd weight = Eigen::RowVectorXd::Zero(net.nodeCount());
  for (Index i = 0; i < net.nodeCount(); ++i) {
    const double away = (net.restPosition.col(i) - place).norm();
    if (away >= radius || net.fixed[static_cast<std::size_t>(i)]) continue;
    const double fade = std::cos(0.5 * std::numbers::pi * away / radius);
    weight[i] = area[i] * fade * fade;
  }
  if (!(weight.sum() > 0.0)) weight[nearestOf(net.restPosition, place)] = 1.0;
  return force * (weight / weight.sum());
}

Dent deepestDent(const SpringNet& net, LinearNet& linear, double poke, double radius, WorkControl* control)
{
  Dent deepest;
  const double shift = kPokeShift * linear.stiffestRate();
  if (!(shift > 0.0) || !linear.factor(shift)) {
    deepest.depth = std::numeric_limits<double>::infinity();
    return deepest;
  }
  const Eigen::Matrix3Xd normals = OutwardSurface(net, control).nodeNormals();
  if (stopWanted(control)) return deepest;
  std::vector<Index> candidates;
  for (Index node = 0; node < net.nodeCount(); ++node)
    if (!net.fixed[static_cast<std::size_t>(node)] &&
        (net.triangleCount() == 0 || normals.col(node).squaredNorm() > 0.5))
      candidates.push_back(node);
  const RigidMotions rigid(net, true);
  for (const Index node : spreadOut(net, candidates)) {
    if (stopWanted(control)) return deepest;
    const Eigen::Vector3d inward = net.triangleCount() == 0 ? Eigen::Vector3d(Eigen::Vector3d::UnitX())
                                                            : Eigen::Vector3d(-normals.col(node));
    const Eigen::Matrix3Xd force = pokePatch(net, net.restPosition.col(node), poke * inward, radius);
    Eigen::Matrix3Xd balanced = force;
    rigid.removeFromForce(balanced);
    Eigen::Matrix3Xd moved = linear.solve(balanced);
    rigid.removeFromMotion(moved);
    const double depth = force.cwiseProduct(moved).sum() / poke;
    if (!std::isfinite(depth) || depth > deepest.depth)
      deepest = {std::isfinite(depth) ? depth : std::numeric_limits<double>::infinity(), node};
  }
  return deepest;
}

} // namespace esm
