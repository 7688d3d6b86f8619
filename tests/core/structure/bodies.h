// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/net/net_builder.h"
#include "core/structure/material.h"
#include "core/structure/support.h"

#include <gtest/gtest.h>

namespace esm::test {

/// Closed surface of a box from the origin, normals outwards, cells of about `cell` [m], two triangles each.
Mesh boxMesh(const Eigen::Vector3d& size, double cell);
/// The same box filled with tetrahedra, six to a cube (Kuhn), without triangles.
Mesh tetrahedraBox(const Eigen::Vector3d& size, double cell);
/// Side of a cylinder about the z axis from z = 0, open at both ends.
Mesh tubeMesh(double radius, double length, int around, int along);
/// Closed ellipsoid about the origin with nearly equal triangles: an octahedron's faces in n^2 parts each.
Mesh organMesh(const Eigen::Vector3d& semiAxes, int n);

inline SpringNet netOf(const Mesh& mesh)
{
  auto net = buildNet(mesh);
  if (!net) {
    ADD_FAILURE() << net.error().detail;
    return {};
  }
  return std::move(*net);
}

/// A net that cannot have it is a failure of the test.
inline SupportReport supported(SpringNet& net, const SupportOptions& options)
{
  const auto report = addSupport(net, options);
  if (!report) {
    ADD_FAILURE() << report.error().detail;
    return {};
  }
  if (const Status status = checkNet(net); !status) ADD_FAILURE() << status.error().detail;
  return *report;
}

constexpr MaterialOptions kFittedWall{MaterialOptions::Body::Wall, EdgeFormula::VanGelder, true};
constexpr MaterialOptions kFittedSolid{MaterialOptions::Body::Solid, EdgeFormula::VanGelder, true};
/// A net of default tissue, but of little springiness, so that what swings comes to rest within the seconds
/// of a test; no bed around it.
SpringNet bodyOf(const Mesh& mesh, SupportOptions::Interior interior, const MaterialOptions& material);

/// The volume within the surface at the given places [m^3], normals outwards; open rims closed by fans.
double volumeWithin(const TriangleMatrix& triangles, const Eigen::Matrix3Xd& position);

} // namespace esm::test
