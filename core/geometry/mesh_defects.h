// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"
#include "core/geometry/boundary_loops.h"
#include "core/geometry/mesh.h"
#include "core/geometry/t_junctions.h"

#include <vector>

namespace esm {

/// One connected part of a mesh.
struct MeshPart {
  Index firstVertex = kNoIndex;
  Index vertices = 0, triangles = 0, segments = 0, tetrahedra = 0;
  Eigen::Vector3d boxMin = Eigen::Vector3d::Zero(), boxMax = Eigen::Vector3d::Zero(); ///< of finite vertices
  bool isClosed = false;    ///< has triangles, and each of their edges has two of them
  bool isInsideOut = false; ///< closed, and its volume is negative
  double volume = 0.0;      ///< [unit^3] if closed; as its triangles stand, those of `turnedFaces` turned
};

/// What is wrong with a mesh and where: the lists behind the counts of MeshReport, and what only lists can
/// say. Numbers are places in the mesh as given, ascending.
struct MeshDefects {
  std::vector<MeshPart> parts;             ///< in the order of their first vertices
  std::vector<BoundaryLoop> boundaryLoops; ///< no vertex twice in one loop
  SegmentMatrix nonManifoldEdges;          ///< 2 x n: more than two triangles
  std::vector<Index> nonManifoldVertices; ///< several fans of triangles meet in the vertex, and no edge above
  std::vector<Index> degenerateFaces, duplicateFaces;
  std::vector<Index> isolatedVertices, nonFiniteVertices;
  std::vector<Index> facesOnNonFinite; ///< are left out of the net
  std::vector<Index> turnedFaces;      ///< look to the other side than most of their surface
  SegmentMatrix unorientableEdges;     ///< 2 x n: neighbours cannot agree over them (Moebius strips)
  std::vector<TJunction> tJunctions;   ///< one per vertex
};

/// Looks for everything. O((V + F) log F). Any thread.
/// @param tJunctionTolerance  as in RepairOptions.
/// @param control  may be null; once it is cancelled the lists are of no use, ask stopWanted().
/// @pre indices in range
MeshDefects findDefects(const Mesh& mesh, double tJunctionTolerance = 0.0, WorkControl* control = nullptr);

} // namespace esm
