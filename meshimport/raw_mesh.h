// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/base/work_control.h"
#include "core/geometry/mesh.h"
#include "meshimport/growing_columns.h"

#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace esm {

/// Coordinates, corners, segment ends and two per corner of a tetrahedron together stay below this, so that
/// edges can be counted too.
inline constexpr std::size_t kMostItems = 700'000'000;

/// What a reader collects while it walks through a file, before polygons become triangles.
struct RawMesh {
  GrowingColumns<Eigen::Matrix3Xd> vertices;
  /// Faces go here as long as all have three corners. The first other one moves them to the lists behind.
  GrowingColumns<TriangleMatrix> triangles;
  std::vector<Index> corners;    ///< of all faces, one face after the other
  std::vector<Index> faceEnd;    ///< where each face ends in `corners`
  std::vector<Index> segments;   ///< pairs of vertices
  std::vector<Index> tetrahedra; ///< fours of vertices

  /// Vertices with a coordinate that is no finite number, and their lines (0 in binary files).
  struct NonFinite {
    Index vertex;
    long line;
  };
  std::vector<NonFinite> nonFinite;

  Index vertexCount() const noexcept { return static_cast<Index>(vertices.count()); }
  std::size_t cornerCount() const noexcept
  {
    return corners.size() + 3 * static_cast<std::size_t>(triangles.count());
  }
  bool hasPolygons() const noexcept { return !faceEnd.empty(); }
  /// Whether nothing a net could be made of has come.
  bool isEmpty() const noexcept { return cornerCount() == 0 && segments.empty() && tetrahedra.empty(); }
  /// Whether so much has come that the edges could no longer be counted, see kMostItems.
  bool isTooLarge() const noexcept
  {
    // Each tetrahedron has six sides for the table of edges.
    return 3 * static_cast<std::size_t>(vertices.count()) + cornerCount() + segments.size() +
             2 * tetrahedra.size() >
           kMostItems;
  }

  void addVertex(double x, double y, double z, long line)
  {
    if (!std::isfinite(x + y + z)) noteIfNotFinite(x, y, z, line); // finite ones may also have such a sum
    double* const place = vertices.add();
    place[0] = x, place[1] = y, place[2] = z;
  }
  void addPolyline(const std::vector<Index>& line);
  void addTriangle(Index a, Index b, Index c)
  {
    if (hasPolygons()) return addPolygon({{a, b, c}});
    Index* const place = triangles.add();
    place[0] = a, place[1] = b, place[2] = c;
  }
  /// Two corners make a segment, one makes nothing; returns whether it was a face.
  bool addFace(const std::vector<Index>& face)
  {
    if (face.size() != 3) return addOtherFace(face);
    addTriangle(face[0], face[1], face[2]);
    return true;
  }

private:
  bool addOtherFace(const std::vector<Index>& face); ///< than a triangle, see addFace()
  void noteIfNotFinite(double x, double y, double z, long line);
  void addPolygon(std::span<const Index> face);
};

/// Triangulates the faces. @pre all corners and segments in range.
/// Errors: InvalidValue if a face or line uses a vertex that is not finite, unused ones become a note;
/// Cancelled.
Result<Mesh> finishMesh(RawMesh&& raw, const std::string& origin, std::vector<std::string>& notes,
                        WorkControl* control = nullptr);

/// "organ.obj: line 7: " + text; without the line if it is 0.
Error fault(ErrorCode code, const std::string& origin, long line, const std::string& text);

/// The error for more vertices or corners than an Index can count.
Error tooManyError(const std::string& origin);

} // namespace esm
