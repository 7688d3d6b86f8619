// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/repair/clean.h"

#include "core/geometry/edge_table.h"
#include "core/geometry/first_appearance.h"
#include "core/geometry/mesh_parts.h"
#include "core/geometry/orientation.h"
#include "core/geometry/repair/compact.h"
#include "core/geometry/triangle_shape.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace esm {

namespace {

std::vector<Index> firstSameSegment(const Mesh& mesh)
{
  return firstAppearances<Index>(mesh.segmentCount(), mesh.vertexCount(), [&](Index s) {
    const auto [low, high] = std::minmax({mesh.segments(0, s), mesh.segments(1, s)});
    return std::pair{low, high};
  });
}

template <class Elements>
void markUsed(const Elements& elements, const std::vector<std::uint8_t>& kept,
              std::vector<std::uint8_t>& used)
{
  for (Eigen::Index i = 0; i < elements.cols(); ++i)
    if (kept[static_cast<std::size_t>(i)])
      for (Eigen::Index k = 0; k < elements.rows(); ++k) used[at(elements(k, i))] = 1;
}

void markUseless(const Mesh& mesh, Kept& kept, RepairReport& report, WorkControl* control)
{
  std::vector<std::uint8_t> isRepeated(at(mesh.triangleCount()), 0);
  const EdgeTable edges = findEdges(mesh, control);
  if (stopWanted(control)) return;
  for (const Index t : edges.repeated) isRepeated[at(t)] = 1;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    if (stopWantedAt(at(t), at(mesh.triangleCount()), control)) return;
    const bool isFlat = isDegenerate(mesh, t), isAgain = isRepeated[at(t)] != 0;
    kept.triangles[at(t)] = !isFlat && !isAgain;
    report.degenerateFaces += isFlat;
    report.duplicateFaces += isAgain && !isFlat;
  }
  const std::vector<Index> sameSegment = firstSameSegment(mesh);
  for (Index s = 0; s < mesh.segmentCount(); ++s) {
    kept.segments[at(s)] = sameSegment[at(s)] == s && mesh.segments(0, s) != mesh.segments(1, s);
    report.uselessSegments += !kept.segments[at(s)];
  }
}

} // namespace

void leaveOutNonFinite(Mesh& mesh, RepairReport& report, std::vector<Index>& vertexOf)
{
  Kept kept(mesh);
  Index count = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    if (!mesh.position.col(v).allFinite()) {
      kept.vertices[at(v)] = 0;
      ++count;
    }
  if (count == 0) return;
  const Index triangles = mesh.triangleCount();
  keepOnly(mesh, kept, vertexOf);
  report.nonFiniteVertices = count;
  report.notes.push_back("left out " + std::to_string(count) +
                         " vertices that lie nowhere (NaN or infinite), and " +
                         std::to_string(triangles - mesh.triangleCount()) + " triangles on them");
}

void removeUseless(Mesh& mesh, RepairReport& report, std::vector<Index>& vertexOf, WorkControl* control)
{
  Kept kept(mesh);
  markUseless(mesh, kept, report, control);
  if (stopWanted(control)) return;
  kept.vertices.assign(kept.vertices.size(), 0);
  markUsed(mesh.triangles, kept.triangles, kept.vertices);
  markUsed(mesh.segments, kept.segments, kept.vertices);
  markUsed(mesh.tetrahedra, kept.tetrahedra, kept.vertices);
  const auto gone = [](const std::vector<std::uint8_t>& of) { return std::count(of.begin(), of.end(), 0); };
  report.isolatedVertices += static_cast<Index>(gone(kept.vertices));
  if (gone(kept.vertices) + gone(kept.triangles) + gone(kept.segments) > 0) keepOnly(mesh, kept, vertexOf);
}

void dropSmallParts(Mesh& mesh, Index below, double share, RepairReport& report, std::vector<Index>& vertexOf)
{
  const MeshParts parts = findParts(mesh);
  if (parts.count == 0) return;
  const Index largest = *std::max_element(parts.elements.begin(), parts.elements.end());
  const double least = std::max(static_cast<double>(below), share * static_cast<double>(largest));
  std::vector<std::uint8_t> stays(parts.elements.size());
  Index dropped = 0, elements = 0;
  for (std::size_t p = 0; p < stays.size(); ++p) {
    stays[p] = static_cast<double>(parts.elements[p]) >= least;
    if (stays[p]) continue;
    ++dropped;
    elements += parts.elements[p];
  }
  if (dropped == 0) return;
  Kept kept(mesh);
  for (std::size_t v = 0; v < kept.vertices.size(); ++v)
    if (const Index part = parts.ofVertex[v]; part != kNoIndex) kept.vertices[v] = stays[at(part)];
  keepOnly(mesh, kept, vertexOf);
  report.droppedParts += dropped;
  report.droppedElements += elements;
  report.notes.push_back("dropped " + std::to_string(dropped) + " of " + std::to_string(parts.count) +
                         " parts, " + std::to_string(elements) + " elements in all");
}

void unifyOrientation(Mesh& mesh, RepairReport& report, WorkControl* control)
{
  const EdgeTable edges = findEdges(mesh, control);
  if (stopWanted(control)) return;
  const Orientation orientation = findOrientation(mesh, edges, control);
  if (stopWanted(control)) return;
  Index turned = 0;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    const Index patch = orientation.patchOf[at(t)];
    if (patch == kNoIndex) continue;
    const SurfacePatch& surface = orientation.patches[at(patch)];
    const bool isInsideOut = surface.isClosed && surface.volume < 0.0;
    if ((orientation.isTurned[at(t)] != 0) == isInsideOut) continue;
    std::swap(mesh.triangles(1, t), mesh.triangles(2, t));
    ++turned;
  }
  report.turnedFaces += turned;
  report.unorientable = static_cast<Index>(orientation.unorientable.size());
  if (turned > 0) report.notes.push_back("turned " + std::to_string(turned) + " triangles round");
  if (report.unorientable > 0)
    report.notes.push_back(
      "over " + std::to_string(report.unorientable) +
      " edges neighbours cannot agree on a side: the surface is twisted like a Moebius strip");
}

} // namespace esm
