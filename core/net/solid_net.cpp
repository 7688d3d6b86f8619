// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/solid_net.h"

#include "core/geometry/pair_key.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace esm {

namespace {

constexpr int kEdges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
/// The face opposite each corner, seen from outside counter-clockwise in a tetrahedron of positive volume.
constexpr int kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

double signedVolume(const Eigen::Matrix3Xd& position, const TetrahedronMatrix& tetrahedra, Index t)
{
  const Eigen::Vector3d a = position.col(tetrahedra(0, t));
  const Eigen::Vector3d u = position.col(tetrahedra(1, t)) - a, v = position.col(tetrahedra(2, t)) - a,
                        w = position.col(tetrahedra(3, t)) - a;
  return u.cross(v).dot(w) / 6.0;
}

TriangleMatrix boundaryOf(const Mesh& mesh)
{
  struct Face {
    std::array<Index, 3> sorted;
    Index tetrahedron;
    int face;
  };
  std::vector<Face> faces;
  faces.reserve(4 * static_cast<std::size_t>(mesh.tetrahedronCount()));
  for (Index t = 0; t < mesh.tetrahedronCount(); ++t)
    for (int f = 0; f < 4; ++f) {
      Face face{{}, t, f};
      for (std::size_t k = 0; k < 3; ++k) face.sorted[k] = mesh.tetrahedra(kFaces[f][k], t);
      std::sort(face.sorted.begin(), face.sorted.end());
      faces.push_back(face);
    }
  std::stable_sort(faces.begin(), faces.end(),
                   [](const Face& a, const Face& b) { return a.sorted < b.sorted; });
  std::vector<Face> single;
  for (std::size_t i = 0; i < faces.size();) {
    std::size_t end = i + 1;
    while (end < faces.size() && faces[end].sorted == faces[i].sorted) ++end;
    if (end == i + 1) single.push_back(faces[i]);
    i = end;
  }
  std::sort(single.begin(), single.end(), [](const Face& a, const Face& b) {
    return a.tetrahedron != b.tetrahedron ? a.tetrahedron < b.tetrahedron : a.face < b.face;
  });
  TriangleMatrix triangles(3, static_cast<Eigen::Index>(single.size()));
  for (std::size_t i = 0; i < single.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    for (int k = 0; k < 3; ++k)
      triangles(k, column) = mesh.tetrahedra(kFaces[single[i].face][k], single[i].tetrahedron);
    if (signedVolume(mesh.position, mesh.tetrahedra, single[i].tetrahedron) < 0.0)
      std::swap(triangles(1, column), triangles(2, column));
  }
  return triangles;
}

} // namespace

Mesh withoutTetrahedra(const Mesh& mesh)
{
  Mesh plain = mesh;
  plain.tetrahedra.resize(4, 0);
  const Eigen::Index before = mesh.segments.cols();
  plain.segments.conservativeResize(Eigen::NoChange, before + 6 * mesh.tetrahedra.cols());
  for (Index t = 0; t < mesh.tetrahedronCount(); ++t)
    for (int e = 0; e < 6; ++e)
      plain.segments.col(before + 6 * t + e) << mesh.tetrahedra(kEdges[e][0], t),
        mesh.tetrahedra(kEdges[e][1], t);
  if (mesh.triangleCount() == 0) plain.triangles = boundaryOf(mesh);
  return plain;
}

void addSolidShares(const Eigen::Matrix3Xd& position, const TetrahedronMatrix& tetrahedra,
                    const std::vector<Index>& nodeOf, SpringNet& net)
{
  std::unordered_map<std::uint64_t, Index> springOf;
  springOf.reserve(2 * static_cast<std::size_t>(net.springCount()));
  for (Index s = 0; s < net.springCount(); ++s) springOf.emplace(pairKey(net.ends(0, s), net.ends(1, s)), s);
  if (net.section.size() == 0) net.section.setZero(net.springCount());
  if (net.volume.size() == 0) net.volume.setZero(net.nodeCount());
  for (Index t = 0; t < static_cast<Index>(tetrahedra.cols()); ++t) {
    std::array<Index, 4> node{};
    for (std::size_t k = 0; k < 4; ++k)
      node[k] = nodeOf[static_cast<std::size_t>(tetrahedra(static_cast<Eigen::Index>(k), t))];
    if (*std::min_element(node.begin(), node.end()) == kNoIndex) continue;
    const double volume = std::abs(signedVolume(position, tetrahedra, t));
    if (!std::isfinite(volume)) continue;
    for (const Index n : node) net.volume[n] += volume / 4.0;
    for (const auto& edge : kEdges) {
      const auto spring = springOf.find(
        pairKey(node[static_cast<std::size_t>(edge[0])], node[static_cast<std::size_t>(edge[1])]));
      if (spring == springOf.end()) continue; // an edge without length
      net.section[spring->second] += volume / net.restLength[spring->second];
      SpringKind& kind = net.kind[static_cast<std::size_t>(spring->second)];
      if (kind == SpringKind::Line) kind = SpringKind::Edge;
    }
  }
}

bool isSolidNet(const SpringNet& net)
{
  for (Index s = 0; s < net.springCount(); ++s)
    if (net.kind[static_cast<std::size_t>(s)] == SpringKind::Edge && net.sectionOf(s) > 0.0) return true;
  return false;
}

} // namespace esm
