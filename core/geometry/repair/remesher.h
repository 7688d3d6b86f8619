// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"
#include "core/geometry/repair/half_edge_mesh.h"
#include "core/geometry/repair/nearest_point.h"

#include <vector>

namespace esm {

/// Makes the triangles of a surface nearly equilateral and its edges nearly equally long, by local changes
/// that keep its topology and every rule of HalfEdgeMesh: Botsch and Kobbelt, A Remeshing Approach to
/// Multiresolution Modeling (2004). One object works on one surface. Deterministic.
class Remesher {
public:
  /// Where points belong; null: to the surface as it has become (a soap film over its border).
  struct Shape {
    const NearestPoint* surface = nullptr;
    const NearestPoint* curves = nullptr; ///< borders and creases, as triangles without area
  };

  Remesher(HalfEdgeMesh& mesh, const Shape& shape, WorkControl* control);

  /// Collapses edges, shorter ones first by powers of two, until few shorter than `edgeLength` are left.
  void reduce(double edgeLength);
  /// Splits edges longer than `longest`, the longest first.
  void splitLong(double longest);
  /// Collapses edges shorter than `shortest`, unless one longer than `longest` came of it.
  void collapseShort(double shortest, double longest);
  /// Flips edges where that brings numbers of neighbours nearer to 6 (4 on borders).
  void flipToRegular();
  /// Moves points to the middle of their neighbours and back to the shape.
  void relax();
  /// One round of all, for edges of about `edgeLength`.
  void improve(double edgeLength);
  /// Collapses the shortest edges until no more than `most` triangles are left, as far as that can be.
  void collapseTo(Index most);

private:
  bool isStopped() const { return stopWanted(m_control); }
  double squaredLength(Index h) const;
  /// Tries to take away the edge, by either end. @return success
  bool tryCollapse(Index h, double longest);
  bool mayVanish(Index h, Index gone) const;
  bool keepsShape(Index gone, Index kept, double longest) const;
  bool flipKeepsShape(Index h) const;
  Eigen::Vector3d normalAt(Index vertex) const;
  Eigen::Vector3d middleOfNeighbours(Index vertex) const;
  /// The point of the shape next to `target`, for a vertex of this freedom and normal.
  Eigen::Vector3d onShape(Index vertex, const Eigen::Vector3d& target);
  void moveTo(Index vertex, const Eigen::Vector3d& target);

  HalfEdgeMesh& m_mesh;
  Shape m_shape;
  WorkControl* m_control;
  std::vector<Index> m_hints; ///< by vertex: where on the shape it was last
  struct Candidate {
    double squaredLength;
    Index halfEdge;
  };
  std::vector<Candidate> m_candidates;
};

} // namespace esm
