// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/geometry/shapes.h"

#include "core/geometry/edge_table.h"
#include "core/geometry/weld.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstring>
#include <vector>

namespace esm::test {

namespace {

/// A sheet of n x m squares; `place(i, j)` says where its points are, `close...` join its ends.
Mesh sheet(Index n, Index m, bool closeFirst, bool closeSecond,
           const std::function<Eigen::Vector3d(Index, Index)>& place)
{
  const Index rows = closeFirst ? n : n + 1, columns = closeSecond ? m : m + 1;
  Mesh mesh;
  mesh.position.resize(3, rows * columns);
  for (Index i = 0; i < rows; ++i)
    for (Index j = 0; j < columns; ++j) mesh.position.col(i * columns + j) = place(i, j);
  const auto at = [&](Index i, Index j) { return i % rows * columns + j % columns; };
  mesh.triangles.resize(3, 2 * n * m);
  Index t = 0;
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < m; ++j) {
      mesh.triangles.col(t++) << at(i, j), at(i + 1, j), at(i + 1, j + 1);
      mesh.triangles.col(t++) << at(i, j), at(i + 1, j + 1), at(i, j + 1);
    }
  return mesh;
}

} // namespace

Mesh sphere(Index n)
{
  Mesh mesh;
  for (int side = 0; side < 8; ++side) {
    const Eigen::Vector3d x = (side & 1 ? -1.0 : 1.0) * Eigen::Vector3d::UnitX(),
                          y = (side & 2 ? -1.0 : 1.0) * Eigen::Vector3d::UnitY(),
                          z = (side & 4 ? -1.0 : 1.0) * Eigen::Vector3d::UnitZ();
    const bool isTurned = (x.cross(y)).dot(z) < 0.0;
    Mesh part;
    part.position.resize(3, (n + 1) * (n + 2) / 2);
    std::vector<Index> corners;
    const auto at = [n](Index i, Index j) { return i * (n + 1) - i * (i - 1) / 2 + j; };
    for (Index i = 0; i <= n; ++i)
      for (Index j = 0; i + j <= n; ++j)
        part.position.col(at(i, j)) = (i * x + j * y + (n - i - j) * z).normalized();
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; i + j < n; ++j) {
        corners.insert(corners.end(), {at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j < n - 1) corners.insert(corners.end(), {at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    part.triangles =
      Eigen::Map<TriangleMatrix>(corners.data(), 3, static_cast<Eigen::Index>(corners.size() / 3));
    if (isTurned) part.triangles.row(1).swap(part.triangles.row(2));
    append(mesh, part);
  }
  weldVertices(mesh);
  return mesh;
}

Mesh torus(Index n, Index m)
{
  return sheet(n, m, true, true, [&](Index i, Index j) -> Eigen::Vector3d {
    const double a = 2.0 * M_PI * i / n, b = 2.0 * M_PI * j / m, r = 1.0 + 0.4 * std::cos(b);
    return {r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)};
  });
}

Mesh tube(Index n, Index m, double height)
{
  return sheet(n, m, true, false, [&](Index i, Index j) -> Eigen::Vector3d {
    const double a = 2.0 * M_PI * i / n;
    return {std::cos(a), std::sin(a), height * j / m};
  });
}

Mesh grid(Index n)
{
  return sheet(n, n, false, false, [&](Index i, Index j) -> Eigen::Vector3d {
    return {static_cast<double>(i) / n, static_cast<double>(j) / n, 0.0};
  });
}

Mesh cubeOf(Index n)
{
  Mesh mesh;
  for (int side = 0; side < 6; ++side) {
    Mesh part = grid(n);
    const int axis = side % 3;
    const Eigen::Matrix3Xd flat = part.position;
    for (int k = 0; k < 3; ++k) part.position.row((axis + k) % 3) = flat.row(k);
    if (side >= 3)
      part.position.row((axis + 2) % 3).setOnes();
    else
      part.triangles.row(1).swap(part.triangles.row(2));
    append(mesh, part);
  }
  weldVertices(mesh);
  return mesh;
}

void append(Mesh& mesh, const Mesh& more, const Eigen::Vector3d& shift)
{
  const Index offset = mesh.vertexCount();
  const auto join = [](auto& matrix, const auto& next) {
    const Eigen::Index old = matrix.cols();
    matrix.conservativeResize(Eigen::NoChange, old + next.cols());
    matrix.rightCols(next.cols()) = next;
  };
  join(mesh.position, (more.position.colwise() + shift).eval());
  join(mesh.triangles, (more.triangles.array() + offset).matrix().eval());
  join(mesh.segments, (more.segments.array() + offset).matrix().eval());
}

Mesh without(const Mesh& mesh, const std::function<bool(Index)>& isGone)
{
  Mesh left = mesh;
  Index count = 0;
  for (Index t = 0; t < mesh.triangleCount(); ++t)
    if (!isGone(t)) left.triangles.col(count++) = mesh.triangles.col(t);
  left.triangles.conservativeResize(Eigen::NoChange, count);
  return left;
}

double areaOf(const Mesh& mesh)
{
  double area = 0.0;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    const Eigen::Vector3d a = mesh.position.col(mesh.triangles(0, t)),
                          b = mesh.position.col(mesh.triangles(1, t)),
                          c = mesh.position.col(mesh.triangles(2, t));
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  return area;
}

double volumeOf(const Mesh& mesh)
{
  double volume = 0.0;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    const Eigen::Vector3d a = mesh.position.col(mesh.triangles(0, t)),
                          b = mesh.position.col(mesh.triangles(1, t)),
                          c = mesh.position.col(mesh.triangles(2, t));
    volume += a.dot(b.cross(c)) / 6.0;
  }
  return volume;
}

Index eulerCharacteristic(const Mesh& mesh)
{
  const EdgeTable edges = findEdges(mesh);
  std::vector<std::uint8_t> isUsed(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i)
    isUsed[static_cast<std::size_t>(mesh.triangles.data()[i])] = 1;
  Index vertices = 0;
  for (const std::uint8_t used : isUsed) vertices += used;
  return vertices - edges.surfaceEdges + mesh.triangleCount();
}

bool sameBits(const Mesh& a, const Mesh& b)
{
  const auto same = [](const auto& x, const auto& y) {
    return x.cols() == y.cols() &&
           (x.size() == 0 ||
            std::memcmp(x.data(), y.data(), static_cast<std::size_t>(x.size()) * sizeof(*x.data())) == 0);
  };
  return same(a.position, b.position) && same(a.triangles, b.triangles) && same(a.segments, b.segments) &&
         same(a.tetrahedra, b.tetrahedra);
}

} // namespace esm::test
