// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

#include <array>
#include <limits>
#include <vector>

namespace esm::test {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A mesh from lists as one writes them by hand.
inline Mesh makeMesh(const std::vector<std::array<double, 3>>& vertices,
                     const std::vector<std::array<Index, 3>>& triangles,
                     const std::vector<std::array<Index, 2>>& segments = {})
{
  Mesh mesh;
  mesh.position.resize(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    mesh.position.col(static_cast<Eigen::Index>(i)) << vertices[i][0], vertices[i][1], vertices[i][2];
  mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t i = 0; i < triangles.size(); ++i)
    mesh.triangles.col(static_cast<Eigen::Index>(i)) << triangles[i][0], triangles[i][1], triangles[i][2];
  mesh.segments.resize(2, static_cast<Eigen::Index>(segments.size()));
  for (std::size_t i = 0; i < segments.size(); ++i)
    mesh.segments.col(static_cast<Eigen::Index>(i)) << segments[i][0], segments[i][1];
  return mesh;
}

/// Unit cube, 8 corners, 12 triangles, 18 edges: 12 of length 1 and 6 face diagonals.
inline Mesh cube()
{
  return makeMesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                  {{0, 2, 1},
                   {0, 3, 2},
                   {4, 5, 6},
                   {4, 6, 7},
                   {0, 1, 5},
                   {0, 5, 4},
                   {1, 2, 6},
                   {1, 6, 5},
                   {2, 3, 7},
                   {2, 7, 6},
                   {3, 0, 4},
                   {3, 4, 7}});
}

} // namespace esm::test
