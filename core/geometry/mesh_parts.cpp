// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_parts.h"

#include "core/geometry/union_find.h"

#include <cstdint>

namespace esm {

namespace {

template <class Elements>
void joinCorners(const Elements& elements, UnionFind& sets, std::vector<std::uint8_t>& used)
{
  for (Eigen::Index i = 0; i < elements.cols(); ++i)
    for (Eigen::Index k = 1; k < elements.rows(); ++k) {
      const Index a = elements(0, i), b = elements(k, i);
      if (a == b) continue;
      used[static_cast<std::size_t>(a)] = used[static_cast<std::size_t>(b)] = 1;
      sets.join(a, b);
    }
}

template <class Elements>
void countElements(const Elements& elements, MeshParts& parts)
{
  for (Eigen::Index i = 0; i < elements.cols(); ++i)
    if (const Index part = parts.ofVertex[static_cast<std::size_t>(elements(0, i))]; part != kNoIndex)
      ++parts.elements[static_cast<std::size_t>(part)];
}

} // namespace

MeshParts findParts(const Mesh& mesh)
{
  const Index vertices = mesh.vertexCount();
  UnionFind sets(vertices);
  std::vector<std::uint8_t> used(static_cast<std::size_t>(vertices), 0);
  joinCorners(mesh.triangles, sets, used);
  joinCorners(mesh.segments, sets, used);
  joinCorners(mesh.tetrahedra, sets, used);

  MeshParts parts;
  parts.ofVertex.assign(used.size(), kNoIndex);
  for (Index v = 0; v < vertices; ++v) {
    if (!used[static_cast<std::size_t>(v)]) continue;
    const Index root = sets.root(v); // the smallest member, so its part has a number already
    parts.ofVertex[static_cast<std::size_t>(v)] =
      root == v ? parts.count++ : parts.ofVertex[static_cast<std::size_t>(root)];
  }
  parts.elements.assign(static_cast<std::size_t>(parts.count), 0);
  countElements(mesh.triangles, parts);
  countElements(mesh.segments, parts);
  countElements(mesh.tetrahedra, parts);
  return parts;
}

} // namespace esm
