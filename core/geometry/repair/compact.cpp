// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/repair/compact.h"

namespace esm {

namespace {

template <class Elements>
void keepElements(Elements& elements, const std::vector<std::uint8_t>& kept, const std::vector<Index>& newOf)
{
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < elements.cols(); ++i) {
    bool isWhole = kept[static_cast<std::size_t>(i)] != 0;
    for (Eigen::Index k = 0; k < elements.rows(); ++k)
      isWhole = isWhole && newOf[static_cast<std::size_t>(elements(k, i))] != kNoIndex;
    if (!isWhole) continue;
    for (Eigen::Index k = 0; k < elements.rows(); ++k)
      elements(k, count) = newOf[static_cast<std::size_t>(elements(k, i))];
    ++count;
  }
  elements.conservativeResize(Eigen::NoChange, count);
}

} // namespace

Kept::Kept(const Mesh& mesh)
  : vertices(static_cast<std::size_t>(mesh.vertexCount()), 1),
    triangles(static_cast<std::size_t>(mesh.triangleCount()), 1),
    segments(static_cast<std::size_t>(mesh.segmentCount()), 1),
    tetrahedra(static_cast<std::size_t>(mesh.tetrahedronCount()), 1)
{}

void keepOnly(Mesh& mesh, const Kept& kept, std::vector<Index>& vertexOf)
{
  std::vector<Index> newOf(kept.vertices.size(), kNoIndex);
  Index count = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (!kept.vertices[static_cast<std::size_t>(v)]) continue;
    if (count != v) mesh.position.col(count) = mesh.position.col(v).eval();
    newOf[static_cast<std::size_t>(v)] = count++;
  }
  mesh.position.conservativeResize(Eigen::NoChange, count);
  keepElements(mesh.triangles, kept.triangles, newOf);
  keepElements(mesh.segments, kept.segments, newOf);
  keepElements(mesh.tetrahedra, kept.tetrahedra, newOf);
  for (Index& vertex : vertexOf)
    if (vertex != kNoIndex) vertex = newOf[static_cast<std::size_t>(vertex)];
}

} // namespace esm
