// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/net/net_builder.h"
#include "core/net/spring_net.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

/// Meshes and a linear static solver of their own for the tests of tissue: independent of core/dynamics.
namespace esm::test {

inline SpringNet netOf(const Mesh& mesh)
{
  auto net = buildNet(mesh);
  if (!net) {
    ADD_FAILURE() << net.error().detail;
    return {};
  }
  return std::move(*net);
}

inline Mesh meshOf(const std::vector<Eigen::Vector3d>& vertices,
                   const std::vector<std::array<Index, 3>>& faces,
                   const std::vector<std::array<Index, 2>>& lines = {})
{
  Mesh mesh;
  mesh.position.resize(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    mesh.position.col(static_cast<Eigen::Index>(i)) = vertices[i];
  mesh.triangles.resize(3, static_cast<Eigen::Index>(faces.size()));
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (int k = 0; k < 3; ++k)
      mesh.triangles(k, static_cast<Eigen::Index>(i)) = faces[i][static_cast<std::size_t>(k)];
  mesh.segments.resize(2, static_cast<Eigen::Index>(lines.size()));
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (int k = 0; k < 2; ++k)
      mesh.segments(k, static_cast<Eigen::Index>(i)) = lines[i][static_cast<std::size_t>(k)];
  return mesh;
}

/// An open tube along x from 0 on: rings of `around` nodes, `apart` [m] from each other.
inline Mesh tubeMesh(Index rings, Index around, double apart, double radius)
{
  Mesh mesh;
  mesh.position.resize(3, rings * around);
  mesh.triangles.resize(3, 2 * (rings - 1) * around);
  for (Index ring = 0, t = 0; ring < rings; ++ring)
    for (Index i = 0; i < around; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / around;
      mesh.position.col(ring * around + i) << apart * ring, radius * std::cos(angle),
        radius * std::sin(angle);
      if (ring + 1 == rings) continue;
      const Index a = ring * around + i, b = ring * around + (i + 1) % around;
      mesh.triangles.col(t++) << a, b, a + around;
      mesh.triangles.col(t++) << b, b + around, a + around;
    }
  return mesh;
}

/// An icosahedron with a corner at each pole (z), its faces halved `halvings` times, on the ellipsoid.
inline Mesh ellipsoidMesh(const Eigen::Vector3d& semiAxes, int halvings)
{
  std::vector<Eigen::Vector3d> points = {{0, 0, 1}};
  for (int ring = 0; ring < 2; ++ring)
    for (int i = 0; i < 5; ++i) {
      const double angle = (2.0 * i + ring) * 3.14159265358979323846 / 5.0, z = ring == 0 ? 0.2 : -0.2;
      points.push_back(Eigen::Vector3d(0.4 * std::cos(angle), 0.4 * std::sin(angle), z).normalized());
    }
  points.emplace_back(0, 0, -1);
  std::vector<std::array<Index, 3>> faces;
  for (Index i = 0; i < 5; ++i) {
    const Index next = (i + 1) % 5;
    faces.push_back({0, 1 + i, 1 + next});
    faces.push_back({1 + i, 6 + i, 1 + next});
    faces.push_back({1 + next, 6 + i, 6 + next});
    faces.push_back({11, 6 + next, 6 + i});
  }
  for (int h = 0; h < halvings; ++h) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [place, isNew] = middles.try_emplace(std::minmax(a, b), static_cast<Index>(points.size()));
      if (isNew)
        points.push_back(
          (points[static_cast<std::size_t>(a)] + points[static_cast<std::size_t>(b)]).normalized());
      return place->second;
    };
    std::vector<std::array<Index, 3>> finer;
    for (const auto& [a, b, c] : faces) {
      const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    faces = std::move(finer);
  }
  for (Eigen::Vector3d& point : points) point = point.cwiseProduct(semiAxes);
  return meshOf(points, faces);
}

/// Stiffness matrix of the net at rest: sum of k n n^T over springs, k I over anchors. 3N x 3N [N/m].
inline Eigen::SparseMatrix<double> stiffnessMatrix(const SpringNet& net)
{
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](Index row, Index column, const Eigen::Matrix3d& block) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) entries.emplace_back(3 * row + i, 3 * column + j, block(i, j));
  };
  for (Index s = 0; s < net.springCount(); ++s) {
    const Index a = net.ends(0, s), b = net.ends(1, s);
    const Eigen::Vector3d n = (net.restPosition.col(b) - net.restPosition.col(a)).normalized();
    const Eigen::Matrix3d block = net.stiffness[s] * n * n.transpose();
    add(a, a, block);
    add(b, b, block);
    add(a, b, -block);
    add(b, a, -block);
  }
  for (Index i = 0; i < net.anchors.count(); ++i)
    add(net.anchors.node[static_cast<std::size_t>(i)], net.anchors.node[static_cast<std::size_t>(i)],
        net.anchors.stiffness[i] * Eigen::Matrix3d::Identity());
  Eigen::SparseMatrix<double> matrix(3 * net.nodeCount(), 3 * net.nodeCount());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Small static displacement under nodal forces (3 x N), by Cholesky.
inline Eigen::Matrix3Xd displacement(const SpringNet& net, const Eigen::Matrix3Xd& force)
{
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(stiffnessMatrix(net));
  EXPECT_EQ(solver.info(), Eigen::Success);
  const Eigen::VectorXd x = solver.solve(Eigen::Map<const Eigen::VectorXd>(force.data(), force.size()));
  return Eigen::Map<const Eigen::Matrix3Xd>(x.data(), 3, force.cols());
}

/// A force of `total` spread over the nodes within `radius` of `centre`, by dual area and a cosine bell.
inline Eigen::Matrix3Xd patchForce(const SpringNet& net, const Eigen::Vector3d& centre, double radius,
                                   const Eigen::Vector3d& total)
{
  const Eigen::ArrayXd areas = nodeDualAreas(net);
  Eigen::ArrayXd weights = Eigen::ArrayXd::Zero(net.nodeCount());
  for (Index i = 0; i < net.nodeCount(); ++i) {
    const double distance = (net.restPosition.col(i) - centre).norm() / radius;
    if (distance < 1.0) weights[i] = areas[i] * (1.0 + std::cos(3.14159265358979323846 * distance));
  }
  return total * (weights / weights.sum()).matrix().transpose();
}

} // namespace esm::test
