// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/cells.h"

namespace esm {

namespace {

struct NumberedKind {
  int type;
  CellKind kind;
};

using enum CellShape;

constexpr NumberedKind kVtk[] = {
  {1, {Point, 1, 1}},     {2, {Point, 0, 0}},         {3, {Polyline, 2, 2}},     {4, {Polyline, 0, 0}},
  {5, {Polygon, 3, 3}},   {6, {Strip, 0, 0}},         {7, {Polygon, 0, 0}},      {8, {Pixel, 4, 4}},
  {9, {Polygon, 4, 4}},   {10, {Tetrahedron, 4, 4}},  {11, {Voxel, 8, 8}},       {12, {Hexahedron, 8, 8}},
  {13, {Wedge, 6, 6}},    {14, {Pyramid, 5, 5}},      {21, {Polyline, 2, 3}},    {22, {Polygon, 3, 6}},
  {23, {Polygon, 4, 8}},  {24, {Tetrahedron, 4, 10}}, {25, {Hexahedron, 8, 20}}, {26, {Wedge, 6, 15}},
  {27, {Pyramid, 5, 13}}, {28, {Polygon, 4, 9}},      {29, {Hexahedron, 8, 27}}};

constexpr NumberedKind kGmsh[] = {
  {1, {Polyline, 2, 2}},     {2, {Polygon, 3, 3}},       {3, {Polygon, 4, 4}},
  {4, {Tetrahedron, 4, 4}},  {5, {Hexahedron, 8, 8}},    {6, {Wedge, 6, 6}},
  {7, {Pyramid, 5, 5}},      {8, {Polyline, 2, 3}},      {9, {Polygon, 3, 6}},
  {10, {Polygon, 4, 9}},     {11, {Tetrahedron, 4, 10}}, {12, {Hexahedron, 8, 27}},
  {13, {Wedge, 6, 18}},      {14, {Pyramid, 5, 14}},     {15, {Point, 1, 1}},
  {16, {Polygon, 4, 8}},     {17, {Hexahedron, 8, 20}},  {18, {Wedge, 6, 15}},
  {19, {Pyramid, 5, 13}},    {20, {Polygon, 3, 9}},      {21, {Polygon, 3, 10}},
  {22, {Polygon, 3, 12}},    {23, {Polygon, 3, 15}},     {24, {Polygon, 3, 15}},
  {25, {Polygon, 3, 21}},    {26, {Polyline, 2, 4}},     {27, {Polyline, 2, 5}},
  {28, {Polyline, 2, 6}},    {29, {Tetrahedron, 4, 20}}, {30, {Tetrahedron, 4, 35}},
  {31, {Tetrahedron, 4, 56}}};

template <std::size_t n>
std::optional<CellKind> kindOf(const NumberedKind (&table)[n], int type) noexcept
{
  for (const NumberedKind& entry : table)
    if (entry.type == type) return entry.kind;
  return std::nullopt;
}

constexpr int kHexahedronEdges[] = {0, 1, 1, 2, 2, 3, 3, 0, 4, 5, 5, 6, 6, 7, 7, 4, 0, 4, 1, 5, 2, 6, 3, 7};
constexpr int kVoxelEdges[] = {0, 1, 1, 3, 3, 2, 2, 0, 4, 5, 5, 7, 7, 6, 6, 4, 0, 4, 1, 5, 2, 6, 3, 7};
constexpr int kWedgeEdges[] = {0, 1, 1, 2, 2, 0, 3, 4, 4, 5, 5, 3, 0, 3, 1, 4, 2, 5};
constexpr int kPyramidEdges[] = {0, 1, 1, 2, 2, 3, 3, 0, 0, 4, 1, 4, 2, 4, 3, 4};

} // namespace

std::optional<CellKind> vtkCell(int type) noexcept
{
  return kindOf(kVtk, type);
}

std::optional<CellKind> gmshElement(int type) noexcept
{
  return kindOf(kGmsh, type);
}

void CellCollector::addEdges(std::span<const Index> nodes, std::span<const int> pairs)
{
  for (const int node : pairs) m_raw.segments.push_back(nodes[static_cast<std::size_t>(node)]);
  ++m_solids;
}

void CellCollector::add(const CellKind& kind, std::span<const Index> nodes)
{
  const std::size_t corners = kind.corners > 0 ? static_cast<std::size_t>(kind.corners) : nodes.size();
  if (nodes.size() < corners) return; // callers check; nothing is made of half a cell
  if (nodes.size() > corners) ++m_reduced;
  m_corners.assign(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(corners));
  switch (kind.shape) {
  case Point:
    m_points += corners;
    return;
  case Polyline:
    return m_raw.addPolyline(m_corners);
  case Pixel:
    std::swap(m_corners[2], m_corners[3]);
    [[fallthrough]];
  case Polygon:
    m_raw.addFace(m_corners);
    return;
  case Strip:
    for (std::size_t i = 2; i < corners; ++i) { // every other triangle is turned round
      const Index a = nodes[i - 2], b = nodes[i - 1];
      m_raw.addFace(i % 2 == 0 ? std::vector{a, b, nodes[i]} : std::vector{b, a, nodes[i]});
    }
    return;
  case Tetrahedron:
    m_raw.tetrahedra.insert(m_raw.tetrahedra.end(), m_corners.begin(), m_corners.end());
    return;
  case Voxel:
    return addEdges(nodes, kVoxelEdges);
  case Hexahedron:
    return addEdges(nodes, kHexahedronEdges);
  case Wedge:
    return addEdges(nodes, kWedgeEdges);
  case Pyramid:
    return addEdges(nodes, kPyramidEdges);
  }
}

Result<Mesh> CellCollector::finish(const std::string& origin, std::vector<std::string>& notes,
                                   WorkControl* control)
{
  if (m_raw.isEmpty())
    return fault(ErrorCode::EmptyResult, origin, 0,
                 "it holds " + std::to_string(m_raw.vertexCount()) +
                   " points but no line, face or tetrahedron");
  tellNotes(notes);
  return finishMesh(std::move(m_raw), origin, notes, control);
}

void CellCollector::tellNotes(std::vector<std::string>& notes) const
{
  const auto tell = [&notes](std::size_t count, const char* text) {
    if (count > 0) notes.push_back(std::to_string(count) + text);
  };
  tell(m_points, " single points were passed over.");
  tell(m_reduced, " cells of higher order were reduced to their corners.");
  tell(m_solids, " hexahedra, wedges and pyramids became their edges.");
}

} // namespace esm
