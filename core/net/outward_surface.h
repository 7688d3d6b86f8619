// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"
#include "core/geometry/triangle_tree.h"
#include "core/net/spring_net.h"

#include <vector>

namespace esm {

/// A net's surface with its triangles turned so that their normals point out of the tissue, whatever way the
/// file had them: neighbours alike across each edge; a part by the sign of its volume; a closed part that
/// lies in an odd number of others (the cavity of a hollow body) the other way round.
class OutwardSurface {
public:
  /// @param control may be null; once it is cancelled the surface is not whole: ask stopWanted().
  explicit OutwardSurface(const SpringNet& net, WorkControl* control = nullptr);

  struct Part {
    bool isClosed = false;  ///< every edge has two triangles
    bool isOriented = true; ///< false: a Moebius strip or an edge of three triangles; sides are a guess
    bool isCavity = false;  ///< lies in an odd number of others
    double volume =
      0.0; ///< enclosed, of a cavity negative; of open parts with their rims joined to their centre [m^3]
  };
  const TriangleMatrix& triangles() const noexcept { return m_triangles; } ///< in the net's order
  const std::vector<Part>& parts() const noexcept { return m_parts; }
  Index partOf(Index triangle) const noexcept { return m_part[static_cast<std::size_t>(triangle)]; }
  bool isClosed() const noexcept; ///< there are triangles, and all parts are closed
  double volume() const noexcept; ///< of the closed parts, cavities taken off [m^3]
  const TriangleTree& tree() const noexcept { return m_tree; }
  Eigen::Vector3d triangleNormal(Index triangle) const; ///< twice the area long
  /// 3 x N, unit, by the corners' angles (Thuermer and Wuethrich 1998); 0 for nodes off the surface.
  Eigen::Matrix3Xd nodeNormals() const;

private:
  void joinParts(WorkControl* control);
  void turnOutwards(WorkControl* control);

  const Eigen::Matrix3Xd& m_position;
  TriangleMatrix m_triangles;
  std::vector<Index> m_part;
  std::vector<Part> m_parts;
  TriangleTree m_tree;
};

} // namespace esm
