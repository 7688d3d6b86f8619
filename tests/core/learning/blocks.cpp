// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/learning/blocks.h"

#include "tests/support/dice.h"
#include "tests/support/nets.h"

#include <algorithm>

namespace esm::test {
namespace {

/// Two triangles for each square of the lattice's hull.
void addHull(const BlockShape& shape, SpringNet& net)
{
  const Index size[3] = {shape.x, shape.y, shape.z};
  const auto node = [&](const Index(&p)[3]) { return p[0] + shape.x * (p[1] + shape.y * p[2]); };
  std::vector<Eigen::Vector3i> triangles;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool far : {false, true}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (Index i = 0; i + 1 < size[u]; ++i)
        for (Index j = 0; j + 1 < size[v]; ++j) {
          Index corner[4];
          for (int c = 0; c < 4; ++c) {
            Index p[3];
            p[axis] = far ? size[axis] - 1 : 0;
            p[u] = i + (c == 1 || c == 2 ? 1 : 0);
            p[v] = j + (c >= 2 ? 1 : 0);
            corner[c] = node(p);
          }
          if (!far) std::swap(corner[1], corner[3]);
          triangles.emplace_back(corner[0], corner[1], corner[2]);
          triangles.emplace_back(corner[0], corner[2], corner[3]);
        }
    }
  net.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t)
    net.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
}

} // namespace

SpringNet block(const BlockShape& shape)
{
  SpringNet net;
  for (Index k = 0; k < shape.z; ++k)
    for (Index j = 0; j < shape.y; ++j)
      for (Index i = 0; i < shape.x; ++i) {
        const Index node = addNode(net, shape.spacing * Eigen::Vector3d(i, j, k));
        net.mass[node] = 1e-3;
        net.fixed[at(node)] = k == 0;
      }
  const double reach = 1.8 * shape.spacing;
  for (Index a = 0; a < net.nodeCount(); ++a)
    for (Index b = a + 1; b < net.nodeCount(); ++b) {
      const double length = (net.restPosition.col(a) - net.restPosition.col(b)).norm();
      if (length < reach) addSpring(net, a, b, shape.modulus * shape.spacing * shape.spacing / length);
    }
  addHull(shape, net);
  return net;
}

SpringNet unevenBlock(const BlockShape& shape, SpringLaw law, std::uint32_t seed)
{
  SpringNet net = block(shape);
  Dice dice(seed);
  for (Index s = 0; s < net.springCount(); ++s) {
    net.stiffness[s] *= dice.uniform(0.7, 1.4);
    net.restLength[s] *= dice.uniform(0.98, 1.02);
    net.law[at(s)] = law;
    if (law == SpringLaw::Exponential) net.lawParameter[s] = dice.uniform(-4.0, 8.0);
    if (law == SpringLaw::Cubic) net.lawParameter[s] = dice.uniform(0.0, 20.0);
    if (law == SpringLaw::Table) net.lawParameter[s] = static_cast<double>(dice.below(2));
  }
  if (law == SpringLaw::Table)
    net.tables = {{{-0.5, -0.045, 0.045, 0.6}, {-0.409, -0.045, 0.045, 1.155}},
                  {{-0.4, 0.045, 0.5}, {-0.36, 0.0405, 0.723}}};
  return net;
}

NodalForce sharedForce(std::vector<Index> nodes, const Eigen::Vector3d& force)
{
  NodalForce load;
  load.force.time = {0.0};
  load.force.value = force / static_cast<double>(nodes.size());
  load.nodes = std::move(nodes);
  return load;
}

std::vector<Index> nodesNear(const SpringNet& net, const Eigen::Vector3d& point, double radius)
{
  std::vector<Index> nodes;
  for (Index i = 0; i < net.nodeCount(); ++i)
    if (net.fixed[at(i)] == 0 && (net.restPosition.col(i) - point).norm() <= radius) nodes.push_back(i);
  return nodes;
}

} // namespace esm::test
