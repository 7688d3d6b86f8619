// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/mesh_defects.h"
#include "core/geometry/self_intersections.h"

#include <array>
#include <vector>

namespace esm {

enum class DefectKind {
  Hole,
  NonManifoldEdge,
  NonManifoldVertex,
  TJunction,
  DegenerateFace,
  DuplicateFace,
  TurnedFace,
  UnorientableEdge,
  SelfIntersection,
  IsolatedVertex,
  LoosePart
};
inline constexpr int kDefectKinds = 11;

/// All defects of one kind, each with the points at which it is to be looked at.
struct DefectGroup {
  struct Defect {
    Eigen::Matrix3Xd places; ///< 3 x K [m]
    Index elements = 0;      ///< edges of a hole, triangles and segments of a part; else 0
    double length = 0.0;     ///< of a hole's rim [m]; else 0
  };
  DefectKind kind = DefectKind::Hole;
  std::size_t count = 0;       ///< in all, as far as they were looked for
  bool isComplete = true;      ///< false: the search has ended early, there may be more
  std::vector<Defect> defects; ///< the first kMostDefects of them
};
inline constexpr std::size_t kMostDefects = 500;

/// The kinds that occur, in the order of DefectKind; also a kind of which nothing was found before the search
/// for it ended early. Of several parts all but the largest are loose.
/// @param mesh in the scene [m]. @param defects of that mesh, or of it before it was scaled and turned.
/// @param crossings of that mesh
std::vector<DefectGroup> defectPlaces(const Mesh& mesh, const MeshDefects& defects,
                                      const SelfIntersections& crossings);

} // namespace esm
