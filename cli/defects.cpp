// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/defects.h"

#include "cli/messages.h"
#include "core/base/text_number.h"

#include <functional>
#include <string>
#include <vector>

namespace esm::cli {

namespace {

std::string place(const Eigen::Vector3d& p)
{
  return "(" + formatDouble(p[0], 6) + ", " + formatDouble(p[1], 6) + ", " + formatDouble(p[2], 6) + ")";
}

std::string vertexPlace(const Mesh& mesh, Index v)
{
  return "vertex " + std::to_string(v) + " at " + place(mesh.position.col(v));
}

std::string trianglePlace(const Mesh& mesh, Index t)
{
  const Eigen::Vector3d middle =
    (mesh.position.col(mesh.triangles(0, t)) + mesh.position.col(mesh.triangles(1, t)) +
     mesh.position.col(mesh.triangles(2, t))) /
    3.0;
  return "triangle " + std::to_string(t) + " around " + place(middle);
}

std::string edgePlace(const Mesh& mesh, Index a, Index b)
{
  return "edge " + std::to_string(a) + "-" + std::to_string(b) + " around " +
         place(0.5 * (mesh.position.col(a) + mesh.position.col(b)));
}

std::string partText(const MeshPart& part)
{
  std::string text = std::to_string(part.vertices) + " vertices, " + std::to_string(part.triangles) +
                     " triangles, " + std::to_string(part.segments) + " lines";
  if (part.tetrahedra > 0) text += ", " + std::to_string(part.tetrahedra) + " tetrahedra";
  text += ", from " + place(part.boxMin) + " to " + place(part.boxMax);
  if (part.isClosed) text += ", closed, volume " + formatDouble(part.volume, 4);
  if (part.isInsideOut) text += " (inside out)";
  return text;
}

std::string loopText(const Mesh& mesh, const BoundaryLoop& loop)
{
  return std::to_string(loop.edges()) + " edges, length " + formatDouble(loop.length, 4) +
         (loop.isClosed ? "" : ", not closed") + ", from " + vertexPlace(mesh, loop.vertices.front());
}

template <class Items>
void printList(const char* what, const Items& items, const std::function<std::string(std::size_t)>& text)
{
  constexpr std::size_t kShown = 20;
  const auto count = static_cast<std::size_t>(std::size(items));
  if (count == 0) return;
  print(std::string(what) + ": " + std::to_string(count));
  for (std::size_t i = 0; i < std::min(count, kShown); ++i) print("  " + text(i));
  if (count > kShown) print("  and " + std::to_string(count - kShown) + " more; --json lists all");
}

std::vector<Index> flat(const SegmentMatrix& edges)
{
  return {edges.data(), edges.data() + edges.size()};
}

std::vector<JsonLine> jsonOfParts(const MeshDefects& defects)
{
  std::vector<JsonLine> parts;
  for (const MeshPart& part : defects.parts) {
    JsonLine& line = parts.emplace_back();
    line.add("first_vertex", part.firstVertex);
    line.add("vertices", part.vertices);
    line.add("triangles", part.triangles);
    line.add("segments", part.segments);
    line.add("tetrahedra", part.tetrahedra);
    line.add("bbox_min", part.boxMin);
    line.add("bbox_max", part.boxMax);
    line.add("closed", part.isClosed);
    line.add("inside_out", part.isInsideOut);
    line.add("volume", part.volume);
  }
  return parts;
}

} // namespace

JsonLine jsonOfDefects(const MeshDefects& defects, const SelfIntersections& crossings, const Mesh& mesh)
{
  JsonLine json;
  json.add("parts", jsonOfParts(defects));
  std::vector<JsonLine> loops, junctions;
  for (const BoundaryLoop& loop : defects.boundaryLoops) {
    JsonLine& line = loops.emplace_back();
    line.add("vertices", loop.vertices);
    line.add("length", loop.length);
    line.add("closed", loop.isClosed);
  }
  json.add("boundary_loops", loops);
  for (const TJunction& junction : defects.tJunctions) {
    JsonLine& line = junctions.emplace_back();
    line.add("vertex", junction.vertex);
    line.add("edge", std::vector<Index>{junction.ends[0], junction.ends[1]});
    line.add("position", Eigen::Vector3d(mesh.position.col(junction.vertex)));
  }
  json.add("t_junctions", junctions);
  json.add("nonmanifold_edges", flat(defects.nonManifoldEdges)); // pairs of vertices, one after the other
  json.add("nonmanifold_vertices", defects.nonManifoldVertices);
  json.add("degenerate_faces", defects.degenerateFaces);
  json.add("duplicate_faces", defects.duplicateFaces);
  json.add("isolated_vertices", defects.isolatedVertices);
  json.add("nonfinite_vertices", defects.nonFiniteVertices);
  json.add("faces_on_nonfinite", defects.facesOnNonFinite);
  json.add("turned_faces", defects.turnedFaces);
  json.add("unorientable_edges", flat(defects.unorientableEdges));
  std::vector<JsonLine> pairs;
  for (const SelfIntersection& crossing : crossings.pairs) {
    JsonLine& line = pairs.emplace_back();
    line.add("triangles", std::vector<Index>{crossing.first, crossing.second});
    line.add("position", crossing.place);
  }
  json.add("self_intersections", pairs);
  json.add("self_intersections_complete", crossings.isComplete);
  return json;
}

void printDefects(const MeshDefects& defects, const SelfIntersections& crossings, const Mesh& mesh)
{
  const auto vertices = [&](const char* what, const std::vector<Index>& list) {
    printList(what, list, [&](std::size_t i) { return vertexPlace(mesh, list[i]); });
  };
  const auto triangles = [&](const char* what, const std::vector<Index>& list) {
    printList(what, list, [&](std::size_t i) { return trianglePlace(mesh, list[i]); });
  };
  const auto edges = [&](const char* what, const SegmentMatrix& list) {
    printList(what, std::vector<int>(static_cast<std::size_t>(list.cols())), [&](std::size_t i) {
      const auto column = static_cast<Eigen::Index>(i);
      return edgePlace(mesh, list(0, column), list(1, column));
    });
  };
  printList("parts", defects.parts, [&](std::size_t i) { return partText(defects.parts[i]); });
  printList("borders", defects.boundaryLoops,
            [&](std::size_t i) { return loopText(mesh, defects.boundaryLoops[i]); });
  printList("T-junctions", defects.tJunctions, [&](std::size_t i) {
    const TJunction& junction = defects.tJunctions[i];
    return vertexPlace(mesh, junction.vertex) + " on " + edgePlace(mesh, junction.ends[0], junction.ends[1]);
  });
  edges("non-manifold edges", defects.nonManifoldEdges);
  vertices("non-manifold vertices", defects.nonManifoldVertices);
  triangles("degenerate faces", defects.degenerateFaces);
  triangles("duplicate faces", defects.duplicateFaces);
  vertices("isolated vertices", defects.isolatedVertices);
  vertices("non-finite vertices", defects.nonFiniteVertices);
  triangles("faces on non-finite vertices, left out of the net", defects.facesOnNonFinite);
  triangles("turned faces", defects.turnedFaces);
  edges("edges over which neighbours cannot agree on a side", defects.unorientableEdges);
  printList("triangles that run through others", crossings.pairs, [&](std::size_t i) {
    const SelfIntersection& crossing = crossings.pairs[i];
    return "triangles " + std::to_string(crossing.first) + " and " + std::to_string(crossing.second) +
           " at " + place(crossing.place);
  });
  if (!crossings.isComplete) print("  there may be more that run through others; --intersections looks on");
}

} // namespace esm::cli
