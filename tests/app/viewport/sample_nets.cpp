// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/viewport/sample_nets.h"

#include <map>
#include <vector>

namespace esm::samples {

namespace {

struct Sphere {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<Index, 3>> triangles;
};

Sphere refinedOctahedron(int levels)
{
  Sphere s;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) s.vertices.push_back(sign * Eigen::Vector3d::Unit(axis));
  for (const Index x : {0, 1})
    for (const Index y : {2, 3})
      for (const Index z : {4, 5}) {
        const bool outward = ((x + y + z) % 2) == 0; // an even number of mirrored axes keeps the winding
        s.triangles.push_back(outward ? std::array<Index, 3>{x, y, z} : std::array<Index, 3>{x, z, y});
      }
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [entry, added] =
        middles.try_emplace(std::minmax(a, b), static_cast<Index>(s.vertices.size()));
      if (added)
        s.vertices.push_back(
          (s.vertices[static_cast<std::size_t>(a)] + s.vertices[static_cast<std::size_t>(b)]).normalized());
      return entry->second;
    };
    std::vector<std::array<Index, 3>> finer;
    for (const auto& [a, b, c] : s.triangles) {
      const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    s.triangles = std::move(finer);
  }
  return s;
}

void appendSpring(SpringNet& net, Index s, Index a, Index b, SpringKind kind)
{
  const auto at = static_cast<std::size_t>(s);
  net.ends.col(s) << a, b;
  net.restLength(s) = (net.restPosition.col(a) - net.restPosition.col(b)).norm();
  net.stiffness(s) = 100.0;
  net.viscosity(s) = 0.0;
  net.lawParameter(s) = 0.0;
  net.law[at] = SpringLaw::Linear;
  net.tensionOnly[at] = 0;
  net.kind[at] = kind;
  net.springId[at] = SpringId(s);
}

void resizeSprings(SpringNet& net, Index count)
{
  const auto size = static_cast<std::size_t>(count);
  net.ends.conservativeResize(2, count);
  for (Eigen::ArrayXd* array : {&net.restLength, &net.stiffness, &net.viscosity, &net.lawParameter})
    array->conservativeResize(count);
  net.law.resize(size);
  net.tensionOnly.resize(size);
  net.kind.resize(size);
  net.springId.resize(size);
}

} // namespace

std::shared_ptr<SpringNet> ball(int levels, const Shape& shape)
{
  const Sphere s = refinedOctahedron(levels);
  auto net = std::make_shared<SpringNet>();
  const auto nodes = static_cast<Index>(s.vertices.size());
  net->restPosition.resize(3, nodes);
  net->mass = Eigen::ArrayXd::Constant(nodes, 0.001);
  net->fixed.assign(s.vertices.size(), 0);
  for (Index i = 0; i < nodes; ++i) {
    net->restPosition.col(i) = shape(s.vertices[static_cast<std::size_t>(i)]);
    net->nodeId.push_back(NodeId(i));
  }
  net->triangles.resize(3, static_cast<Eigen::Index>(s.triangles.size()));
  std::vector<std::pair<Index, Index>> edges;
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = s.triangles[t][k], b = s.triangles[t][(k + 1) % 3];
      net->triangles(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(t)) = a;
      if (a < b) edges.emplace_back(a, b); // closed and outward: the other side has b < a
    }
  }
  resizeSprings(*net, static_cast<Index>(edges.size()));
  for (std::size_t e = 0; e < edges.size(); ++e)
    appendSpring(*net, static_cast<Index>(e), edges[e].first, edges[e].second, SpringKind::Edge);
  return net;
}

std::shared_ptr<SpringNet> sphere(int levels, double radius, const Eigen::Vector3d& centre)
{
  return ball(levels, [&](const Eigen::Vector3d& unit) { return Eigen::Vector3d(centre + radius * unit); });
}

void addStruts(SpringNet& net, const std::vector<std::pair<Index, Index>>& pairs)
{
  const Index before = net.springCount();
  resizeSprings(net, before + static_cast<Index>(pairs.size()));
  for (std::size_t p = 0; p < pairs.size(); ++p)
    appendSpring(net, before + static_cast<Index>(p), pairs[p].first, pairs[p].second, SpringKind::Line);
}

SimSnapshot restSnapshot(const SpringNet& net, std::uint64_t generation, std::uint64_t sequence)
{
  SimSnapshot snapshot;
  snapshot.generation = generation;
  snapshot.sequence = sequence;
  snapshot.position = net.restPosition;
  snapshot.tension = Eigen::ArrayXd::Zero(net.springCount());
  return snapshot;
}

} // namespace esm::samples
