// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/scene_shapes.h"

#include "core/net/net_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace esm::bench {

Eigen::Vector3d onGrid(const Eigen::Vector3d& x)
{
  return x.unaryExpr(
    [](double value) { return std::ldexp(std::round(std::ldexp(value, 40)), -40) + 0.0; }); // no -0
}

double uniform(std::mt19937& random, double low, double high)
{
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

SpringNet netOf(const std::vector<Eigen::Vector3d>& positions, const Edges& edges)
{
  SpringNet net;
  resizeNet(net, static_cast<Index>(positions.size()), static_cast<Index>(edges.size()));
  for (std::size_t i = 0; i < positions.size(); ++i)
    net.restPosition.col(static_cast<Index>(i)) = positions[i];
  for (std::size_t s = 0; s < edges.size(); ++s) {
    const auto place = static_cast<Index>(s);
    net.ends.col(place) << edges[s].first, edges[s].second;
    net.restLength[place] = (positions[static_cast<std::size_t>(edges[s].first)] -
                             positions[static_cast<std::size_t>(edges[s].second)])
                              .norm();
  }
  return net;
}

void anchorAll(SpringNet& net, double stiffness, double viscosity)
{
  const Index count = net.nodeCount();
  net.anchors.node.resize(static_cast<std::size_t>(count));
  for (Index i = 0; i < count; ++i) net.anchors.node[static_cast<std::size_t>(i)] = i;
  net.anchors.point = net.restPosition;
  net.anchors.stiffness = Eigen::ArrayXd::Constant(count, stiffness);
  net.anchors.viscosity = Eigen::ArrayXd::Constant(count, viscosity);
}

VectorCurve curve(std::vector<double> time, std::vector<Eigen::Vector3d> values)
{
  VectorCurve result;
  result.time = std::move(time);
  result.value.resize(3, static_cast<Eigen::Index>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) result.value.col(static_cast<Eigen::Index>(i)) = values[i];
  return result;
}

SpringNet tubeNet(Index rings)
{
  constexpr Index kAround = 20;
  constexpr double kLength = 0.10, kRadius = 0.006;
  std::vector<Eigen::Vector3d> positions;
  Edges edges;
  for (Index r = 0; r < rings; ++r)
    for (Index a = 0; a < kAround; ++a) {
      const double angle = 2 * std::numbers::pi * (a + 0.5 * (r % 2)) / kAround;
      positions.push_back(
        onGrid({kLength * r / (rings - 1), kRadius * std::cos(angle), kRadius * std::sin(angle)}));
      const Index here = r * kAround + a, next = r * kAround + (a + 1) % kAround;
      edges.emplace_back(here, next);
      if (r + 1 == rings) continue;
      edges.emplace_back(here, here + kAround);
      edges.emplace_back(r % 2 ? here : next, (r % 2 ? next : here) + kAround);
    }
  SpringNet net = netOf(positions, edges);
  for (Index a = 0; a < kAround; ++a)
    net.fixed[static_cast<std::size_t>(a)] = net.fixed[static_cast<std::size_t>((rings - 1) * kAround + a)] =
      1;
  return net;
}

double powerOfTen(double exponent)
{
  return std::pow(10.0, exponent);
}

void geodesicSphere(Index frequency, std::vector<Eigen::Vector3d>& positions, Edges& edges)
{
  // A subdivided icosahedron: each face carries a triangular grid; nodes on common edges are found again by
  // the corners and steps that they stand for.
  const double g = std::numbers::phi;
  const double corners[12][3] = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                 {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  const Index faces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                              {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                              {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                              {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  std::map<std::array<Index, 6>, Index> known;
  std::set<std::pair<Index, Index>> joined;
  for (const auto& face : faces) {
    const auto node = [&](Index i, Index j) {
      std::array<std::pair<Index, Index>, 3> weights{
        {{face[0], frequency - i - j}, {face[1], i}, {face[2], j}}};
      std::sort(weights.begin(), weights.end());
      std::array<Index, 6> key{-1, -1, -1, -1, -1, -1};
      std::size_t used = 0;
      Eigen::Vector3d x = Eigen::Vector3d::Zero();
      for (const auto& [corner, weight] : weights) {
        if (weight == 0) continue;
        key[used++] = corner;
        key[used++] = weight;
        x += weight * Eigen::Vector3d(corners[corner][0], corners[corner][1], corners[corner][2]);
      }
      const auto [found, isNew] = known.try_emplace(key, static_cast<Index>(positions.size()));
      if (isNew) positions.push_back(x.normalized());
      return found->second;
    };
    const auto join = [&](Index a, Index b) {
      if (joined.insert(std::minmax(a, b)).second) edges.emplace_back(a, b);
    };
    for (Index i = 0; i < frequency; ++i)
      for (Index j = 0; i + j < frequency; ++j) {
        const Index here = node(i, j), right = node(i + 1, j), up = node(i, j + 1);
        join(here, right);
        join(here, up);
        join(right, up);
      }
  }
}

} // namespace esm::bench
