// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

#include <functional>
#include <random>

namespace esm::test {

/// An octahedron whose sides are cut into n^2 triangles each and blown up to radius 1; 8 n^2 triangles.
Mesh sphere(Index n);
/// Radii 1 and 0.4, 2 x n x m triangles, round the z axis.
Mesh torus(Index n, Index m);
/// Along z from 0 to `height`, radius 1, open at both ends; n squares round, m along.
Mesh tube(Index n, Index m, double height);
/// n x n squares in the plane z = 0 from (0, 0) to (1, 1).
Mesh grid(Index n);
/// Unit cube, its sides cut into n x n squares each, welded.
Mesh cubeOf(Index n);

void append(Mesh& mesh, const Mesh& more, const Eigen::Vector3d& shift = Eigen::Vector3d::Zero());
/// Without the triangles whose number fulfils `isGone`; vertices stay.
Mesh without(const Mesh& mesh, const std::function<bool(Index)>& isGone);

double areaOf(const Mesh& mesh);
double volumeOf(const Mesh& mesh); ///< of closed, oriented meshes
/// V - E + F over the vertices in use: 2 per sphere, 0 per torus, less one per hole.
Index eulerCharacteristic(const Mesh& mesh);
bool sameBits(const Mesh& a, const Mesh& b);

/// Uniform in [0, 1), the same everywhere.
inline double uniform(std::mt19937_64& random)
{
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

} // namespace esm::test
