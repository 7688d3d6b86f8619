// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"
#include "core/geometry/edge_table.h"
#include "core/geometry/mesh.h"

namespace esm {

/// What is in a mesh and what is wrong with it, before it becomes a net. Counts are of the mesh as
/// given (weld first); the box is in its own unit.
struct MeshReport {
  Index nodes = 0;     ///< vertices that a spring uses; the others are no nodes of the net
  Index springs = 0;   ///< unique edges of triangles and segments (zero-length ends excluded: a != b)
  Index triangles = 0; ///< as given, degenerate and duplicate ones included
  Index segments = 0;
  Index components = 0;        ///< connected parts with at least one spring
  Index isolatedVertices = 0;  ///< used by no spring
  Index boundaryEdges = 0;     ///< used by exactly one triangle
  Index nonManifoldEdges = 0;  ///< used by more than two triangles
  Index degenerateFaces = 0;   ///< two equal corners, or zero area
  Index duplicateFaces = 0;    ///< a later triangle over the same three vertices, whatever their order
  Index nonFiniteVertices = 0; ///< a NaN or infinite coordinate
  Eigen::Vector3d boxMin =
    Eigen::Vector3d::Zero(); ///< over finite nodes; over all vertices if no spring is there
  Eigen::Vector3d boxMax = Eigen::Vector3d::Zero();
  bool finite = true; ///< nonFiniteVertices == 0
};

/// O(V + F log F). Any thread. Never throws on any content with indices in range.
/// @param control may be null; once it is cancelled the report is of no use, ask stopWanted().
MeshReport examine(const Mesh& mesh, WorkControl* control = nullptr);
/// The same for who has the edges: listEdges(mesh).
MeshReport examine(const Mesh& mesh, const EdgeList& edges, WorkControl* control = nullptr);

/// The box around the finite vertices; both corners are 0 if there are none.
struct VertexBox {
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = Eigen::Vector3d::Zero();
  Index nonFinite = 0; ///< vertices that are in no box
};
VertexBox boxOf(const Mesh& mesh);

/// Over the edges with finite ends, in the mesh's own unit. O(E).
double sumRestLength(const Mesh& mesh, const EdgeList& edges);

} // namespace esm
