// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/structure/bodies.h"

#include "core/tissue/tissue_model.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace esm::test {

namespace {

/// Collects vertices by a key, triangles in order.
class Builder {
public:
  using Key = std::array<long, 3>;
  Index vertex(const Key& key, const Eigen::Vector3d& place)
  {
    const auto [found, isNew] = m_vertex.emplace(key, static_cast<Index>(m_places.size()));
    if (isNew) m_places.push_back(place);
    return found->second;
  }
  void triangle(Index a, Index b, Index c) { m_triangles.push_back({a, b, c}); }
  void tetrahedron(Index a, Index b, Index c, Index d) { m_tetrahedra.push_back({a, b, c, d}); }
  Mesh mesh() const
  {
    Mesh mesh;
    mesh.position.resize(3, static_cast<Eigen::Index>(m_places.size()));
    mesh.triangles.resize(3, static_cast<Eigen::Index>(m_triangles.size()));
    mesh.tetrahedra.resize(4, static_cast<Eigen::Index>(m_tetrahedra.size()));
    for (std::size_t i = 0; i < m_places.size(); ++i)
      mesh.position.col(static_cast<Eigen::Index>(i)) = m_places[i];
    for (std::size_t i = 0; i < m_triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        mesh.triangles(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) = m_triangles[i][k];
    for (std::size_t i = 0; i < m_tetrahedra.size(); ++i)
      for (std::size_t k = 0; k < 4; ++k)
        mesh.tetrahedra(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) = m_tetrahedra[i][k];
    return mesh;
  }

private:
  std::map<Key, Index> m_vertex;
  std::vector<Eigen::Vector3d> m_places;
  std::vector<std::array<Index, 3>> m_triangles;
  std::vector<std::array<Index, 4>> m_tetrahedra;
};

Eigen::Vector3i cellsOf(const Eigen::Vector3d& size, double cell)
{
  return (size / cell).array().round().max(1.0).cast<int>();
}

Index gridVertex(Builder& builder, const Eigen::Vector3i& at, const Eigen::Vector3i& cells,
                 const Eigen::Vector3d& size)
{
  return builder.vertex({at[0], at[1], at[2]},
                        at.cast<double>().cwiseQuotient(cells.cast<double>()).cwiseProduct(size));
}

} // namespace

Mesh boxMesh(const Eigen::Vector3d& size, double cell)
{
  const Eigen::Vector3i cells = cellsOf(size, cell);
  Builder builder;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (int i = 0; i < cells[u]; ++i)
        for (int j = 0; j < cells[v]; ++j) {
          const auto corner = [&](int di, int dj) {
            Eigen::Vector3i at;
            at[axis] = side * cells[axis];
            at[u] = i + di;
            at[v] = j + dj;
            return gridVertex(builder, at, cells, size);
          };
          Index a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          if (side == 0) std::swap(b, d);
          if ((i + j) % 2 == 0) { // diagonals in turn, so that no direction is favoured
            builder.triangle(a, b, c);
            builder.triangle(a, c, d);
          } else {
            builder.triangle(a, b, d);
            builder.triangle(b, c, d);
          }
        }
    }
  return builder.mesh();
}

Mesh tetrahedraBox(const Eigen::Vector3d& size, double cell)
{
  constexpr int kOrders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  const Eigen::Vector3i cells = cellsOf(size, cell);
  Builder builder;
  for (int i = 0; i < cells[0]; ++i)
    for (int j = 0; j < cells[1]; ++j)
      for (int k = 0; k < cells[2]; ++k)
        for (const auto& order : kOrders) {
          Eigen::Vector3i at(i, j, k);
          std::array<Index, 4> node{};
          node[0] = gridVertex(builder, at, cells, size);
          for (std::size_t step = 0; step < 3; ++step) {
            ++at[order[step]];
            node[step + 1] = gridVertex(builder, at, cells, size);
          }
          builder.tetrahedron(node[0], node[1], node[2], node[3]);
        }
  return builder.mesh();
}

Mesh tubeMesh(double radius, double length, int around, int along)
{
  Builder builder;
  const auto vertex = [&](int i, int j) {
    const double angle = 2.0 * std::numbers::pi * (i % around + 0.5 * (j % 2)) / around;
    return builder.vertex({i % around, j, 0},
                          {radius * std::cos(angle), radius * std::sin(angle), length * j / along});
  };
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i) {
      const Index a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i, j + 1), d = vertex(i + 1, j + 1);
      if (j % 2 == 0) {
        builder.triangle(a, b, c);
        builder.triangle(b, d, c);
      } else {
        builder.triangle(a, b, d);
        builder.triangle(a, d, c);
      }
    }
  return builder.mesh();
}

Mesh organMesh(const Eigen::Vector3d& semiAxes, int n)
{
  Builder builder;
  const auto vertex = [&](const Eigen::Vector3i& at) {
    return builder.vertex({at[0], at[1], at[2]}, at.cast<double>().normalized().cwiseProduct(semiAxes));
  };
  for (int sign = 0; sign < 8; ++sign) {
    const Eigen::Vector3i s(sign & 1 ? -1 : 1, sign & 2 ? -1 : 1, sign & 4 ? -1 : 1);
    const bool isMirrored = s.prod() < 0;
    const auto add = [&](Eigen::Vector3i a, Eigen::Vector3i b, Eigen::Vector3i c) {
      if (isMirrored) std::swap(b, c);
      builder.triangle(vertex(a.cwiseProduct(s)), vertex(b.cwiseProduct(s)), vertex(c.cwiseProduct(s)));
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        const Eigen::Vector3i a(n - i - j, i, j), b(n - i - j - 1, i + 1, j), c(n - i - j - 1, i, j + 1);
        add(a, b, c);
        if (i + j < n - 1) add(b, Eigen::Vector3i(n - i - j - 2, i + 1, j + 1), c);
      }
  }
  return builder.mesh();
}

SpringNet bodyOf(const Mesh& mesh, SupportOptions::Interior interior, const MaterialOptions& material)
{
  SpringNet net = netOf(mesh);
  SupportOptions support;
  support.interior = interior;
  const auto added = addSupport(net, support);
  if (!added) ADD_FAILURE() << added.error().detail;
  TissueModel tissue = defaultTissue();
  for (std::size_t i = 0; i < tissue.rules.inputs.size(); ++i)
    if (tissue.rules.inputs[i].id == "elasticity") tissue.inputs[i] = 0.0;
  const auto made = setMaterial(net, material, tissue.thickness);
  if (!made) ADD_FAILURE() << made.error().detail;
  const auto applied = applyTissue(tissue, net);
  if (!applied) ADD_FAILURE() << applied.error().detail;
  net.anchors = {};
  return net;
}

double volumeWithin(const TriangleMatrix& triangles, const Eigen::Matrix3Xd& position)
{
  const auto tripleOf = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    return a.cross(b).dot(c) / 6.0;
  };
  double sum = 0.0;
  std::map<std::pair<Index, Index>, int> sides; // directed, to find the rims
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    sum +=
      tripleOf(position.col(triangles(0, t)), position.col(triangles(1, t)), position.col(triangles(2, t)));
    for (int k = 0; k < 3; ++k) ++sides[{triangles(k, t), triangles((k + 1) % 3, t)}];
  }
  // Rims: each connected one is closed by a fan about its middle.
  std::map<Index, Index> next;
  for (const auto& [side, count] : sides)
    if (!sides.count({side.second, side.first})) next[side.second] = side.first;
  while (!next.empty()) {
    std::vector<Index> rim;
    Index at = next.begin()->first;
    while (next.count(at)) {
      rim.push_back(at);
      const Index to = next[at];
      next.erase(at);
      at = to;
    }
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Index node : rim) middle += position.col(node) / static_cast<double>(rim.size());
    for (std::size_t i = 0; i < rim.size(); ++i)
      sum += tripleOf(position.col(rim[i]), position.col(rim[(i + 1) % rim.size()]), middle);
  }
  return sum;
}

} // namespace esm::test
