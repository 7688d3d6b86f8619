// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/eigen_memory.h"
#include "core/base/types.h"

#include <Eigen/Core>

namespace esm {

using TriangleMatrix = Eigen::Matrix<Index, 3, Eigen::Dynamic>;    ///< 3 x F, vertex indices
using TetrahedronMatrix = Eigen::Matrix<Index, 4, Eigen::Dynamic>; ///< 4 x T, vertex indices
using SegmentMatrix = Eigen::Matrix<Index, 2, Eigen::Dynamic>;     ///< 2 x S, vertex indices

/// What a mesh file holds: vertices; triangles, line segments and tetrahedra over them. Plain data, no
/// invariants: what a reader returns may have indices in range only; welding and checks come after (weld.h,
/// mesh_report.h). Units are the file's until toScene() (scene_frame.h).
struct Mesh {
  Eigen::Matrix3Xd position;    ///< 3 x V, in the order of the file
  TriangleMatrix triangles;     ///< 3 x F; polygons arrive triangulated
  SegmentMatrix segments;       ///< 2 x S; polylines arrive as their segments
  TetrahedronMatrix tetrahedra; ///< 4 x T, of volume meshes; most files have none
  SegmentMatrix diagonals;      ///< 2 x D, the cuts that made triangles of polygons, each once per polygon

  Index vertexCount() const noexcept { return static_cast<Index>(position.cols()); }
  Index triangleCount() const noexcept { return static_cast<Index>(triangles.cols()); }
  Index segmentCount() const noexcept { return static_cast<Index>(segments.cols()); }
  Index tetrahedronCount() const noexcept { return static_cast<Index>(tetrahedra.cols()); }
};

} // namespace esm
