// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/support/nets.h"

#include <cmath>
#include <random>

namespace esm::test {
namespace {

/// Uniform in [low, high) from the raw bits, so that every standard library gives the same net.
double uniform(std::mt19937& random, double low, double high)
{
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

double decade(std::mt19937& random, double low)
{
  return low * std::pow(10.0, uniform(random, 0.0, 1.0));
}

} // namespace

Index addNode(SpringNet& net, const Eigen::Vector3d& position)
{
  const Index node = net.nodeCount();
  net.restPosition.conservativeResize(3, node + 1);
  net.restPosition.col(node) = position;
  net.mass.conservativeResize(node + 1);
  net.mass[node] = 1.0;
  net.fixed.push_back(0);
  net.nodeId.push_back(NodeId{node});
  return node;
}

Index addSpring(SpringNet& net, Index a, Index b, double k, double c)
{
  const Index s = net.springCount();
  net.ends.conservativeResize(2, s + 1);
  net.ends.col(s) << a, b;
  const auto append = [s](Eigen::ArrayXd& array, double value) {
    array.conservativeResize(s + 1);
    array[s] = value;
  };
  append(net.restLength, (net.restPosition.col(a) - net.restPosition.col(b)).norm());
  append(net.stiffness, k);
  append(net.viscosity, c);
  append(net.lawParameter, 0.0);
  net.law.push_back(SpringLaw::Linear);
  net.tensionOnly.push_back(0);
  net.kind.push_back(SpringKind::Edge);
  net.springId.push_back(SpringId{s});
  return s;
}

void addAnchor(SpringNet& net, Index node, const Eigen::Vector3d& point, double k, double c)
{
  AnchorSet& anchors = net.anchors;
  const Index i = anchors.count();
  anchors.node.push_back(node);
  anchors.point.conservativeResize(3, i + 1);
  anchors.point.col(i) = point;
  anchors.stiffness.conservativeResize(i + 1);
  anchors.stiffness[i] = k;
  anchors.viscosity.conservativeResize(i + 1);
  anchors.viscosity[i] = c;
}

SpringNet chain(Index nodes, double spacing, double k)
{
  SpringNet net;
  for (Index i = 0; i < nodes; ++i) addNode(net, {spacing * i, 0.0, 0.0});
  for (Index i = 0; i + 1 < nodes; ++i) addSpring(net, i, i + 1, k);
  return net;
}

SpringNet sheet(Index n, double spacing, double k)
{
  SpringNet net;
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) addNode(net, {spacing * i, spacing * j, 0.0});
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index here = j * n + i;
      if (i + 1 < n) addSpring(net, here, here + 1, k);
      if (j + 1 < n) addSpring(net, here, here + n, k);
      if (i + 1 < n && j + 1 < n) addSpring(net, here, here + n + 1, k);
    }
  return net;
}

SpringNet randomNet(std::uint32_t seed, Index nodes, SpringLaw law)
{
  std::mt19937 random(seed);
  SpringNet net;
  for (Index i = 0; i < nodes; ++i) {
    const double x = uniform(random, 0, 1), y = uniform(random, 0, 1), z = uniform(random, 0, 1);
    addNode(net, {x, y, z});
    net.mass[i] = decade(random, 0.1);
  }
  for (Index i = 1; i < nodes; ++i)
    for (int k = 0; k < 3; ++k) {
      const auto other = static_cast<Index>(random() % static_cast<std::uint32_t>(i));
      const double stiffness = decade(random, 10.0), viscosity = decade(random, 0.1);
      const Index s = addSpring(net, i, other, stiffness, viscosity);
      net.restLength[s] *= uniform(random, 0.7, 1.3);
      net.law[static_cast<std::size_t>(s)] = law;
      net.lawParameter[s] = uniform(random, 0.5, 4.0);
      if (law == SpringLaw::Table) net.lawParameter[s] = static_cast<double>(random() % 2);
    }
  if (law == SpringLaw::Table)
    net.tables = {{{-0.5, 0.0, 0.1, 0.4}, {-0.3, 0.0, 0.1, 1.2}}, {{-0.1, 0.05, 0.3}, {-0.2, 0.02, 0.5}}};
  return net;
}

SpringNet relaxed(std::uint32_t seed, Index nodes)
{
  SpringNet net = randomNet(seed, nodes);
  for (Index s = 0; s < net.springCount(); ++s)
    net.restLength[s] = (net.restPosition.col(net.ends(0, s)) - net.restPosition.col(net.ends(1, s))).norm();
  return net;
}

} // namespace esm::test
