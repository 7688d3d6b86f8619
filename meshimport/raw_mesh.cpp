// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/raw_mesh.h"

#include "core/base/large_pages.h"
#include "meshimport/triangulate.h"

#include <algorithm>
#include <cstdint>

namespace esm {

namespace {

/// The first non-finite vertex that something uses, if any.
const RawMesh::NonFinite* usedNonFinite(const RawMesh& raw)
{
  if (raw.nonFinite.empty()) return nullptr;
  std::vector<std::uint8_t> used(static_cast<std::size_t>(raw.vertexCount()), 0);
  const std::span triangles(raw.triangles.data(), 3 * static_cast<std::size_t>(raw.triangles.count()));
  for (const Index vertex : triangles) used[static_cast<std::size_t>(vertex)] = 1;
  for (const Index vertex : raw.corners) used[static_cast<std::size_t>(vertex)] = 1;
  for (const Index vertex : raw.segments) used[static_cast<std::size_t>(vertex)] = 1;
  for (const Index vertex : raw.tetrahedra) used[static_cast<std::size_t>(vertex)] = 1;
  const auto found = std::find_if(raw.nonFinite.begin(), raw.nonFinite.end(), [&](const auto& bad) {
    return used[static_cast<std::size_t>(bad.vertex)] != 0;
  });
  return found == raw.nonFinite.end() ? nullptr : &*found;
}

/// The sides that two triangles of one polygon share, as pairs of vertices.
/// @param sides room to work in, for meshes have many polygons
void addDiagonals(std::span<const Index> triangles, std::vector<std::pair<Index, Index>>& sides,
                  std::vector<Index>& out)
{
  sides.clear();
  for (std::size_t t = 0; t < triangles.size(); t += 3)
    for (std::size_t k = 0; k < 3; ++k)
      sides.push_back(std::minmax(triangles[t + k], triangles[t + (k + 1) % 3]));
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
    if (sides[i] == sides[i + 1]) {
      out.insert(out.end(), {sides[i].first, sides[i].second});
      ++i;
    }
}

/// Puts the faces into the mesh as triangles, and the cuts as diagonals.
Status cutPolygons(const RawMesh& raw, Mesh& mesh, std::vector<std::string>& notes, WorkControl* control)
{
  std::vector<Index> triangles, diagonals;
  std::vector<std::pair<Index, Index>> sides;
  Index begin = 0;
  std::size_t polygons = 0;
  for (const Index end : raw.faceEnd) {
    if (stopWanted(control)) return cancelledError();
    const std::span face(raw.corners.data() + begin, static_cast<std::size_t>(end - begin));
    const std::size_t first = triangles.size();
    triangulate(mesh.position, face, triangles);
    if (face.size() > 3) {
      ++polygons;
      addDiagonals(std::span(triangles).subspan(first), sides, diagonals);
    }
    begin = end;
  }
  mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size() / 3));
  useLargePages(mesh.triangles);
  std::copy(triangles.begin(), triangles.end(), mesh.triangles.data());
  mesh.diagonals =
    Eigen::Map<const SegmentMatrix>(diagonals.data(), 2, static_cast<Eigen::Index>(diagonals.size() / 2));
  notes.push_back(std::to_string(polygons) + " faces with more than three corners were cut into triangles.");
  return {};
}

} // namespace

void RawMesh::noteIfNotFinite(double x, double y, double z, long line)
{
  if (!(std::isfinite(x) && std::isfinite(y) && std::isfinite(z))) nonFinite.push_back({vertexCount(), line});
}

void RawMesh::addPolyline(const std::vector<Index>& line)
{
  for (std::size_t i = 1; i < line.size(); ++i) segments.insert(segments.end(), {line[i - 1], line[i]});
}

bool RawMesh::addOtherFace(const std::vector<Index>& face)
{
  if (face.size() < 3) {
    addPolyline(face);
    return false;
  }
  addPolygon(face);
  return true;
}

void RawMesh::addPolygon(std::span<const Index> face)
{
  if (!hasPolygons()) { // so far there were triangles only
    const auto expected = static_cast<std::size_t>(triangles.capacity());
    const TriangleMatrix before = triangles.take();
    reserveLarge(corners, 3 * expected);
    reserveLarge(faceEnd, expected);
    corners.assign(before.data(), before.data() + before.size());
    for (Index end = 3; end <= static_cast<Index>(before.size()); end += 3) faceEnd.push_back(end);
  }
  corners.insert(corners.end(), face.begin(), face.end());
  faceEnd.push_back(static_cast<Index>(corners.size()));
}

Result<Mesh> finishMesh(RawMesh&& raw, const std::string& origin, std::vector<std::string>& notes,
                        WorkControl* control)
{
  if (const RawMesh::NonFinite* bad = usedNonFinite(raw))
    return fault(ErrorCode::InvalidValue, origin, bad->line,
                 "vertex " + std::to_string(bad->vertex + 1) +
                   " has a coordinate that is not a finite number (NaN or infinite), and a face or line "
                   "uses it; mend the file in the program that wrote it");
  if (!raw.nonFinite.empty())
    notes.push_back(std::to_string(raw.nonFinite.size()) +
                    " vertices that nothing uses have coordinates that are not finite numbers.");
  if (raw.isTooLarge()) return tooManyError(origin);

  Mesh mesh;
  mesh.position = raw.vertices.take();
  if (!raw.hasPolygons()) {
    mesh.triangles = raw.triangles.take();
  } else if (Status cut = cutPolygons(raw, mesh, notes, control); !cut) {
    return cut.error();
  }
  mesh.segments = Eigen::Map<const SegmentMatrix>(raw.segments.data(), 2,
                                                  static_cast<Eigen::Index>(raw.segments.size() / 2));
  mesh.tetrahedra = Eigen::Map<const TetrahedronMatrix>(raw.tetrahedra.data(), 4,
                                                        static_cast<Eigen::Index>(raw.tetrahedra.size() / 4));
  return mesh;
}

Error fault(ErrorCode code, const std::string& origin, long line, const std::string& text)
{
  return Error{code, origin + ": " + (line > 0 ? "line " + std::to_string(line) + ": " : "") + text};
}

Error tooManyError(const std::string& origin)
{
  return fault(ErrorCode::Unsupported, origin, 0,
               "the mesh has more vertices and corners than this program can count (" +
                 std::to_string(kMostItems) + "); simplify it first");
}

} // namespace esm
