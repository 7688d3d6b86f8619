// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/viewport/camera.h"
#include "core/geometry/mesh.h"

#include <functional>
#include <optional>
#include <vector>

namespace esm {

/// Distance along the ray to the triangle a, b, c [m], hit from either side; nothing if it misses or runs
/// in the triangle's plane. (Moeller and Trumbore 1997.)
std::optional<double> hitTriangle(const Ray& ray, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  const Eigen::Vector3d& c);

/// The node that a user means with a click: it lies within `radius` pixels, no triangle hides it, it belongs
/// to what is in front there (matters for nets of bare springs), and of those it is nearest to the click. If
/// there is none, but a triangle is under the click, it is that one's nearest corner: meshes may be coarse,
/// or near.
/// @param position 3 x N [m]. @param triangles what can hide; 3 x 0 for nothing.
/// Cost: O(N + F) projections, and ray tests with the triangles that are seen near the click.
Index pickNode(const Camera& camera, const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles,
               const Eigen::Vector2d& pixel, double radius);

/// The same for springs, by their middles. A triangle at whose edge a spring lies does not hide it.
/// @param ends 2 x S, columns of `position`. @param shown whether a spring counts; null: all do.
Index pickSpring(const Camera& camera, const Eigen::Matrix3Xd& position, const SegmentMatrix& ends,
                 const TriangleMatrix& triangles, const Eigen::Vector2d& pixel, double radius,
                 const std::function<bool(Index)>& shown = {});

/// The nodes whose pixels lie in a box and that no triangle hides, in rising order.
/// @param position 3 x N [m]. @param triangles what can hide; 3 x 0 for nothing.
/// Cost: O(N + F), and each node in the box is tested only against triangles that are seen near it.
std::vector<Index> nodesInBox(const Camera& camera, const Eigen::Matrix3Xd& position,
                              const TriangleMatrix& triangles, const Eigen::AlignedBox2d& pixels);

} // namespace esm
