// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_defects.h"

#include "core/geometry/edge_table.h"
#include "core/geometry/mesh_parts.h"
#include "core/geometry/orientation.h"
#include "core/geometry/triangle_shape.h"
#include "core/geometry/union_find.h"

#include <cmath>
#include <cstdint>

namespace esm {

namespace {

SegmentMatrix edgesOf(const EdgeTable& edges, const std::vector<Index>& numbers)
{
  SegmentMatrix ends(2, static_cast<Eigen::Index>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    ends.col(static_cast<Eigen::Index>(i)) = edges.ends.col(numbers[i]);
  return ends;
}

template <class Elements>
void countElements(const Elements& elements, const MeshParts& parts, Index MeshPart::*count,
                   std::vector<MeshPart>& into)
{
  for (Eigen::Index i = 0; i < elements.cols(); ++i)
    if (const Index part = parts.ofVertex[at(elements(0, i))]; part != kNoIndex) ++(into[at(part)].*count);
}

std::vector<MeshPart> describeParts(const Mesh& mesh, const MeshParts& parts, const Orientation& orientation)
{
  std::vector<MeshPart> described(at(parts.count));
  std::vector<std::uint8_t> hasBox(at(parts.count), 0);
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (parts.ofVertex[at(v)] == kNoIndex) continue;
    MeshPart& part = described[at(parts.ofVertex[at(v)])];
    if (part.vertices++ == 0) part.firstVertex = v;
    const Eigen::Vector3d p = mesh.position.col(v);
    if (!p.allFinite()) continue;
    std::uint8_t& any = hasBox[at(parts.ofVertex[at(v)])];
    part.boxMin = any ? part.boxMin.cwiseMin(p) : p;
    part.boxMax = any ? part.boxMax.cwiseMax(p) : p;
    any = 1;
  }
  countElements(mesh.triangles, parts, &MeshPart::triangles, described);
  countElements(mesh.segments, parts, &MeshPart::segments, described);
  countElements(mesh.tetrahedra, parts, &MeshPart::tetrahedra, described);
  for (MeshPart& part : described) part.isClosed = part.triangles > 0;
  // A part may have several patches, which meet in vertices or non-manifold edges.
  for (const SurfacePatch& patch : orientation.patches) {
    MeshPart& part = described[at(parts.ofVertex[at(mesh.triangles(0, patch.firstTriangle))])];
    part.isClosed = part.isClosed && patch.isClosed;
    part.volume += patch.volume;
  }
  for (MeshPart& part : described) {
    part.isClosed = part.isClosed && std::isfinite(part.volume);
    if (!part.isClosed) part.volume = 0.0;
    part.isInsideOut = part.volume < 0.0;
  }
  return described;
}

/// Vertices in which several fans of triangles meet although none of their edges has more than two triangles.
/// Corners of triangles that share an edge at their vertex belong to one fan.
std::vector<Index> verticesWithManyFans(const Mesh& mesh, const EdgeTable& edges)
{
  const Index* vertexOf = mesh.triangles.data();
  UnionFind fans(static_cast<Index>(mesh.triangles.size()));
  std::vector<Index> firstSide(at(edges.surfaceEdges), kNoIndex);
  for (Index side = 0; side < static_cast<Index>(mesh.triangles.size()); ++side) {
    const Index e = edges.edgeOfSide[at(side)];
    if (e == kNoIndex) continue;
    Index& first = firstSide[at(e)];
    if (first == kNoIndex) {
      first = side;
      continue;
    }
    const auto end = [](Index s) { return s % 3 == 2 ? s - 2 : s + 1; };
    const bool isOpposite = vertexOf[first] != vertexOf[side];
    fans.join(first, isOpposite ? end(side) : side);
    fans.join(end(first), isOpposite ? side : end(side));
  }
  std::vector<std::uint8_t> count(at(mesh.vertexCount()), 0);
  for (Index corner = 0; corner < static_cast<Index>(mesh.triangles.size()); ++corner)
    if (fans.root(corner) == corner && !hasEqualCorners(mesh, corner / 3) && count[at(vertexOf[corner])] < 2)
      ++count[at(vertexOf[corner])];
  for (Index e = 0; e < edges.surfaceEdges; ++e)
    if (edges.triangleCount[at(e)] > 2) count[at(edges.ends(0, e))] = count[at(edges.ends(1, e))] = 0;
  std::vector<Index> many;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    if (count[at(v)] > 1) many.push_back(v);
  return many;
}

void listVertices(const Mesh& mesh, const EdgeTable& edges, MeshDefects& defects)
{
  std::vector<std::uint8_t> isUsed(at(mesh.vertexCount()), 0);
  for (Index i = 0; i < static_cast<Index>(edges.ends.size()); ++i) isUsed[at(edges.ends.data()[i])] = 1;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (!isUsed[at(v)]) defects.isolatedVertices.push_back(v);
    if (!mesh.position.col(v).allFinite()) defects.nonFiniteVertices.push_back(v);
  }
  defects.nonManifoldVertices = verticesWithManyFans(mesh, edges);
}

void listFaces(const Mesh& mesh, const Orientation& orientation, MeshDefects& defects)
{
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    if (isDegenerate(mesh, t)) defects.degenerateFaces.push_back(t);
    bool isFinite = true;
    for (int k = 0; k < 3; ++k) isFinite = isFinite && mesh.position.col(mesh.triangles(k, t)).allFinite();
    if (!isFinite) defects.facesOnNonFinite.push_back(t);
    if (orientation.isTurned[at(t)]) defects.turnedFaces.push_back(t);
  }
}

} // namespace

MeshDefects findDefects(const Mesh& mesh, double tJunctionTolerance, WorkControl* control)
{
  MeshDefects defects;
  const EdgeTable edges = findEdges(mesh, control);
  if (stopWanted(control)) return defects;
  const Orientation orientation = findOrientation(mesh, edges, control);
  if (stopWanted(control)) return defects;
  defects.parts = describeParts(mesh, findParts(mesh), orientation);
  if (stopWanted(control)) return defects;
  defects.unorientableEdges = edgesOf(edges, orientation.unorientable);
  listVertices(mesh, edges, defects);
  if (stopWanted(control)) return defects;
  listFaces(mesh, orientation, defects);
  defects.duplicateFaces = edges.repeated;
  if (stopWanted(control)) return defects;
  std::vector<Index> crowded;
  for (Index e = 0; e < edges.surfaceEdges; ++e)
    if (edges.triangleCount[at(e)] > 2) crowded.push_back(e);
  defects.nonManifoldEdges = edgesOf(edges, crowded);
  defects.boundaryLoops = findBoundaryLoops(mesh, edges);
  defects.tJunctions = findTJunctions(mesh, edges, tJunctionTolerance, control);
  return defects;
}

} // namespace esm
