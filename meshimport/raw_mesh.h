// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/base/work_control.h"
#include "core/geometry/mesh.h"

#include <string>
#include <vector>

namespace esm {

/// What a reader collects while it walks through a file, before polygons become triangles.
struct RawMesh {
  std::vector<double> coordinates; ///< x y z of each vertex
  std::vector<Index> corners;      ///< of all faces, one face after the other
  std::vector<Index> faceEnd;      ///< where each face ends in `corners`
  std::vector<Index> segments;     ///< pairs of vertices
  std::vector<Index> tetrahedra;   ///< fours of vertices

  /// Vertices with a coordinate that is no finite number, and their lines (0 in binary files).
  struct NonFinite {
    Index vertex;
    long line;
  };
  std::vector<NonFinite> nonFinite;

  Index vertexCount() const noexcept { return static_cast<Index>(coordinates.size() / 3); }
  /// Whether nothing a net could be made of has come.
  bool isEmpty() const noexcept { return faceEnd.empty() && segments.empty() && tetrahedra.empty(); }
  void addVertex(double x, double y, double z, long line);
  void addPolyline(const std::vector<Index>& vertices);
  /// Two corners make a segment, one makes nothing; returns whether it was a face.
  bool addFace(const std::vector<Index>& vertices);
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
/// Vertices, corners and segment ends together stay below this, so that edges can be counted too.
inline constexpr std::size_t kMostItems = 700'000'000;

} // namespace esm
