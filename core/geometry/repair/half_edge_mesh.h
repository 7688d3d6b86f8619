// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/types.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace esm {

/// An oriented manifold surface, open or closed, that can be changed edge by edge. Half-edge h is the side of
/// triangle h / 3 that starts at its corner h % 3; `twin` is the same edge seen from the neighbour. Flat
/// arrays only; removed triangles stay as holes in them (corner kNoIndex).
///
///            a
///          /   \          h runs u -> x with its triangle on the left,
///        /   h   \        twin(h) runs x -> u in triangle (x, u, b)
///      u --------> x
///        \       /
///          \   /
///            b
class HalfEdgeMesh {
public:
  enum class Freedom : std::uint8_t {
    Surface, ///< may move within the surface
    Curve,   ///< on a border or crease: may move along it
    None     ///< stays where it is
  };

  std::vector<Eigen::Vector3d> position; ///< by vertex
  std::vector<Freedom> freedom;          ///< by vertex
  std::vector<Index> corner, twin;       ///< by half-edge; twin kNoIndex: border
  std::vector<Index> firstOut; ///< by vertex: a half-edge from it, on borders the border's; kNoIndex: unused
  std::vector<std::uint8_t> isCurve; ///< by half-edge: of a border or crease, the same on both sides
  std::vector<std::uint8_t> isRigid; ///< by half-edge: must neither be split nor vanish
  std::vector<std::uint8_t> isSeam;  ///< by vertex: several sheets meet here; no new edge between two of them
  Index liveTriangles = 0;

  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Index from(Index h) const { return corner[static_cast<std::size_t>(h)]; }
  Index to(Index h) const { return from(next(h)); }
  Index apex(Index h) const { return from(previous(h)); }
  Index twinOf(Index h) const { return twin[static_cast<std::size_t>(h)]; }
  bool isLive(Index h) const { return from(h) != kNoIndex; }
  Index halfEdges() const { return static_cast<Index>(corner.size()); }
  Index vertices() const { return static_cast<Index>(position.size()); }
  /// One of the two half-edges of each edge: the later one.
  bool isLead(Index h) const { return isLive(h) && twinOf(h) < h; }

  /// Calls `visit(h)` for the half-edges from `vertex`, counter-clockwise. On borders the last edge has no
  /// half-edge from here; `visitLast(h)` gets the one that comes in.
  template <class Visit, class VisitLast>
  void forOut(Index vertex, const Visit& visit, const VisitLast& visitLast) const
  {
    const Index first = firstOut[static_cast<std::size_t>(vertex)];
    Index h = first;
    if (h == kNoIndex) return;
    do {
      visit(h);
      const Index in = previous(h);
      h = twinOf(in);
      if (h == kNoIndex) visitLast(in);
    } while (h != kNoIndex && h != first);
  }
  /// Calls `visit(h)` once per triangle at `vertex`, with the half-edge that starts there.
  template <class Visit>
  void forTriangles(Index vertex, const Visit& visit) const
  {
    forOut(vertex, visit, [](Index) {});
  }
  /// Calls `visit(neighbour, h)` once per edge at `vertex`; h is one of its half-edges.
  template <class Visit>
  void forNeighbours(Index vertex, const Visit& visit) const
  {
    forOut(
      vertex, [&](Index h) { visit(to(h), h); }, [&](Index in) { visit(from(in), in); });
  }
  Index valence(Index vertex) const;
  bool isOnBorder(Index vertex) const;
  bool areNeighbours(Index a, Index b) const;
  Eigen::Vector3d areaVector(Index triangle) const; ///< twice the area, along the normal

  /// Fills `twin` (by direction: edges used once each way) and `firstOut` from `corner`.
  /// @pre every vertex has one fan of triangles.
  void setFirstOut();

  /// Puts a vertex on the edge. @return it
  Index split(Index h, const Eigen::Vector3d& at);
  /// Whether taking the edge away by moving `gone` to the other end leaves a manifold with the same topology
  /// (link condition). Freedom and shape are the caller's.
  bool canCollapse(Index h, Index gone);
  /// @pre canCollapse(h, gone)
  void collapse(Index h, Index gone);
  /// Whether the other diagonal is new and would join no two vertices of seams.
  bool canFlip(Index h) const;
  /// @pre canFlip(h). Afterwards the two triangles are (a, u, b) and (b, x, a), in the places of the old
  /// ones.
  void flip(Index h);

private:
  void link(Index h, Index k); ///< makes twins of two, or a border of one; either may be kNoIndex
  void turnToBorder(Index vertex, Index out);
  void setTriangle(Index t, Index a, Index b, Index c);
  void removeTriangle(Index t);

  std::vector<Index> m_stamp; ///< by vertex: marks neighbours
  Index m_stampNow = 0;
};

} // namespace esm
