// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/import/defect_places.h"

#include <algorithm>

namespace esm {

namespace {

/// Makes a group of `items`, each of which `defectOf` turns into a Defect.
template <class Items, class DefectOf>
void addGroup(std::vector<DefectGroup>& groups, DefectKind kind, const Items& items, DefectOf defectOf,
              bool isComplete = true)
{
  const auto count = static_cast<std::size_t>(std::size(items));
  if (count == 0 && isComplete) return;
  DefectGroup group{kind, count, isComplete, {}};
  for (std::size_t i = 0; i < std::min(count, kMostDefects); ++i) group.defects.push_back(defectOf(items[i]));
  groups.push_back(std::move(group));
}

std::vector<MeshPart> looseParts(const std::vector<MeshPart>& parts)
{
  const auto size = [](const MeshPart& part) { return part.triangles + part.segments + part.tetrahedra; };
  std::vector<MeshPart> loose;
  for (const MeshPart& part : parts)
    if (size(part) > 0) loose.push_back(part); // isolated vertices have a list of their own
  if (loose.empty()) return loose;
  loose.erase(std::max_element(loose.begin(), loose.end(),
                               [&](const auto& a, const auto& b) { return size(a) < size(b); }));
  return loose;
}

} // namespace

std::vector<DefectGroup> defectPlaces(const Mesh& mesh, const MeshDefects& defects,
                                      const SelfIntersections& crossings)
{
  std::vector<DefectGroup> groups;
  using Defect = DefectGroup::Defect;
  const auto vertex = [&](Index v) { return Defect{mesh.position.col(v)}; };
  const auto face = [&](Index f) { return Defect{mesh.position(Eigen::all, mesh.triangles.col(f))}; };
  const auto edge = [&](const Eigen::Vector2i& ends) { return Defect{mesh.position(Eigen::all, ends)}; };
  const auto edges = [](const SegmentMatrix& list) {
    std::vector<Eigen::Vector2i> out;
    for (Eigen::Index i = 0; i < list.cols(); ++i) out.emplace_back(list(0, i), list(1, i));
    return out;
  };

  addGroup(groups, DefectKind::Hole, defects.boundaryLoops, [&](const BoundaryLoop& loop) {
    Defect hole{mesh.position(Eigen::all, loop.vertices), loop.edges()};
    for (Eigen::Index i = 0; i < hole.elements; ++i)
      hole.length += (hole.places.col((i + 1) % hole.places.cols()) - hole.places.col(i)).norm();
    return hole;
  });
  addGroup(groups, DefectKind::NonManifoldEdge, edges(defects.nonManifoldEdges), edge);
  addGroup(groups, DefectKind::NonManifoldVertex, defects.nonManifoldVertices, vertex);
  addGroup(groups, DefectKind::TJunction, defects.tJunctions,
           [&](const TJunction& junction) { return vertex(junction.vertex); });
  addGroup(groups, DefectKind::DegenerateFace, defects.degenerateFaces, face);
  addGroup(groups, DefectKind::DuplicateFace, defects.duplicateFaces, face);
  addGroup(groups, DefectKind::TurnedFace, defects.turnedFaces, face);
  addGroup(groups, DefectKind::UnorientableEdge, edges(defects.unorientableEdges), edge);
  addGroup(
    groups, DefectKind::SelfIntersection, crossings.pairs,
    [&](const SelfIntersection& crossing) { return Defect{crossing.place}; }, crossings.isComplete);
  addGroup(groups, DefectKind::IsolatedVertex, defects.isolatedVertices, vertex);
  addGroup(groups, DefectKind::LoosePart, looseParts(defects.parts), [&](const MeshPart& part) {
    return Defect{mesh.position.col(part.firstVertex), part.triangles + part.segments + part.tetrahedra};
  });
  return groups;
}

} // namespace esm
