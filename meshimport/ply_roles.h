// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/ply_header.h"

#include <array>

namespace esm {

enum class PlyShape { None, Face, Strip, Fan, Edge, Polyline, Tetrahedron };

/// What an element of a PLY file means for a net. The format fixes no names; "face" and "edge" are a habit.
struct PlyRole {
  PlyShape shape = PlyShape::None;
  int list = -1;                      ///< place of the list of vertices
  std::array<int, 2> ends = {-1, -1}; ///< places of the two ends of an edge
  const char* note = nullptr;         ///< what it was read as, where the name is not the usual one
};

PlyRole plyRole(const PlyElement& element);
/// The element with the points, or null.
const PlyElement* plyVertices(const PlyHeader& header);
/// Whether it is a scan whose points lie in rows and columns, to be triangulated by depth.
bool isPlyGrid(const PlyElement& element);

} // namespace esm
