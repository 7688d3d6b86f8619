// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/raw_mesh.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace esm {

/// The cells of finite-element and visualization files, by what becomes of them in a net.
enum class CellShape {
  Point,
  Polyline,
  Polygon,
  Pixel,
  Strip,
  Tetrahedron,
  Voxel,
  Hexahedron,
  Wedge,
  Pyramid
};

struct CellKind {
  CellShape shape = CellShape::Point;
  int corners = 0; ///< 0: as many as there are
  int nodes = 0;   ///< more than corners: of higher order, corners come first; 0: as many as there are
};

/// Of a VTK cell (VTK file formats, cell types); empty for types that are no simple shape.
std::optional<CellKind> vtkCell(int type) noexcept;
/// Of a Gmsh element (Gmsh manual, MSH file format); empty for types beyond the fifth order.
std::optional<CellKind> gmshElement(int type) noexcept;

/// Puts cells into a RawMesh and makes a mesh of it. Tetrahedra stay tetrahedra; hexahedra, wedges and
/// pyramids become their edges; what is of higher order is reduced to its corners, points are passed over,
/// and all that is said.
class CellCollector {
public:
  explicit CellCollector(RawMesh& raw) : m_raw(raw) {}
  /// @param nodes of the cell, in range; as many as `kind` wants
  void add(const CellKind& kind, std::span<const Index> nodes);
  /// The end of a reader: what was left out goes to `notes`, the RawMesh becomes the mesh.
  /// Errors: EmptyResult without a line, face or tetrahedron, and those of finishMesh().
  Result<Mesh> finish(const std::string& origin, std::vector<std::string>& notes, WorkControl* control);

private:
  void tellNotes(std::vector<std::string>& notes) const;
  void addEdges(std::span<const Index> nodes, std::span<const int> pairs);
  RawMesh& m_raw;
  std::vector<Index> m_corners;
  std::size_t m_points = 0, m_reduced = 0, m_solids = 0;
};

} // namespace esm
