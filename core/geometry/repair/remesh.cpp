// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/repair/remesh.h"

#include "core/base/text_number.h"
#include "core/geometry/edge_table.h"
#include "core/geometry/repair/frame.h"
#include "core/geometry/repair/remesher.h"
#include "core/geometry/repair/sheets.h"
#include "core/geometry/triangle_shape.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace esm {

namespace {

constexpr double kMostTriangles = 2e7;               // some gigabytes
constexpr double kEquilateral = 0.43301270189221932; // area of the triangle with sides of 1: sqrt(3) / 4

double areaOf(const Mesh& mesh)
{
  double twice = 0.0;
  for (Index t = 0; t < mesh.triangleCount(); ++t) twice += areaVector(mesh, t).norm();
  return 0.5 * twice;
}

/// The triangles of a mesh and their vertices, both in spatial order whatever their order in the file, so
/// that neighbours are neighbours in memory too.
struct OrderedSurface {
  Mesh mesh;
  std::vector<Index> fileVertex; ///< by vertex of `mesh`
  std::vector<Index> ofFile;     ///< by vertex of the file: that of `mesh`, or kNoIndex

  OrderedSurface(const Mesh& file, const Frame& frame) : ofFile(at(file.vertexCount()), kNoIndex)
  {
    const std::vector<Index> order = spatialOrder(file.position, file.triangles);
    mesh.triangles.resize(3, file.triangles.cols());
    for (Index t = 0; t < file.triangleCount(); ++t)
      for (int k = 0; k < 3; ++k) {
        const Index vertex = file.triangles(k, order[at(t)]);
        Index& place = ofFile[at(vertex)];
        if (place == kNoIndex) {
          place = static_cast<Index>(fileVertex.size());
          fileVertex.push_back(vertex);
        }
        mesh.triangles(k, t) = place;
      }
    mesh.position.resize(3, static_cast<Eigen::Index>(fileVertex.size()));
    for (Index v = 0; v < mesh.vertexCount(); ++v)
      mesh.position.col(v) = frame.in(file.position.col(fileVertex[at(v)]));
  }
};

/// The new net of one mesh, from the first look to the last.
class SurfaceNet {
public:
  /// @param mesh  without segments and tetrahedra, stays alive.
  SurfaceNet(const Mesh& mesh, const std::vector<std::uint8_t>& isPinned, double edgeLength,
             WorkControl* control)
    : m_original(mesh), m_sheets(cutToSheets(mesh, isPinned, control)), m_control(control)
  {
    if (stopWanted(control)) return;
    m_isRough = markCurves(m_sheets.surface, edgeLength, control);
    if (!stopWanted(control)) findCurves();
  }

  /// @param most  triangles; 0 if only the length counts.
  void make(double edgeLength, Index most)
  {
    constexpr int kRounds = 6;
    const NearestPoint surface(m_original.position, m_original.triangles),
      curves(m_original.position, m_curves);
    Remesher remesher(m_sheets.surface, {&surface, &curves}, m_control);
    remesher.reduce(edgeLength);
    for (int round = 0; round < kRounds && !stopWanted(m_control); ++round) {
      tellDone(m_control, static_cast<double>(round + 1) / (kRounds + 1));
      remesher.improve(edgeLength);
      if (most > 0)
        edgeLength *= std::clamp(std::sqrt(m_sheets.surface.liveTriangles / (0.97 * most)), 0.8, 1.25);
    }
    if (most > 0) remesher.collapseTo(most);
    for (int round = 0; round < 2; ++round) {
      remesher.flipToRegular();
      remesher.relax();
    }
  }
  bool isRough() const { return m_isRough; }

  /// Puts the sheets together again; what has not moved keeps its bits.
  /// @param mesh  as it was in the file.
  void writeTo(Mesh& mesh, const Frame& frame, const OrderedSurface& ordered,
               std::vector<Index>& vertexOf) const;

private:
  void findCurves()
  {
    const HalfEdgeMesh& surface = m_sheets.surface;
    std::vector<Index> corners;
    for (Index h = 0; h < surface.halfEdges(); ++h)
      if (surface.isLead(h) && surface.isCurve[at(h)]) {
        const Index a = m_sheets.origin[at(surface.from(h))], b = m_sheets.origin[at(surface.to(h))];
        corners.insert(corners.end(), {a, b, b});
      }
    m_curves = Eigen::Map<TriangleMatrix>(corners.data(), 3, static_cast<Eigen::Index>(corners.size() / 3));
  }

  const Mesh& m_original;
  Sheets m_sheets;
  TriangleMatrix m_curves; ///< borders and creases as triangles without area
  bool m_isRough = false;
  WorkControl* m_control;
};

void SurfaceNet::writeTo(Mesh& mesh, const Frame& frame, const OrderedSurface& ordered,
                         std::vector<Index>& vertexOf) const
{
  const HalfEdgeMesh& surface = m_sheets.surface;
  std::vector<Index> newOf(at(mesh.vertexCount()), kNoIndex), placeOf(surface.position.size(), kNoIndex);
  Eigen::Matrix3Xd position(3, mesh.vertexCount() + surface.vertices());
  Index count = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v) { // those of the file first, in their order
    const Index place = ordered.ofFile[at(v)];
    if (place != kNoIndex && surface.firstOut[at(place)] == kNoIndex) continue; // collapsed away
    const bool hasMoved = place != kNoIndex && surface.position[at(place)] != m_original.position.col(place);
    position.col(count) =
      hasMoved ? frame.out(surface.position[at(place)]) : Eigen::Vector3d(mesh.position.col(v));
    newOf[at(v)] = count++;
  }
  for (Index v = 0; v < surface.vertices(); ++v) {
    if (v < static_cast<Index>(m_sheets.origin.size())) {
      placeOf[at(v)] = newOf[at(ordered.fileVertex[at(m_sheets.origin[at(v)])])];
    } else if (surface.firstOut[at(v)] != kNoIndex) {
      position.col(count) = frame.out(surface.position[at(v)]);
      placeOf[at(v)] = count++;
    }
  }
  mesh.position = position.leftCols(count);
  mesh.triangles.resize(3, surface.liveTriangles);
  Eigen::Index t = 0;
  for (Index h = 0; h < surface.halfEdges(); h += 3)
    if (surface.isLive(h)) {
      for (int k = 0; k < 3; ++k) mesh.triangles(k, t) = placeOf[at(surface.from(h + k))];
      ++t;
    }
  const auto renumber = [&](Index& vertex) { vertex = newOf[at(vertex)]; };
  std::for_each(mesh.segments.data(), mesh.segments.data() + mesh.segments.size(), renumber);
  std::for_each(mesh.tetrahedra.data(), mesh.tetrahedra.data() + mesh.tetrahedra.size(), renumber);
  for (Index& vertex : vertexOf)
    if (vertex != kNoIndex) renumber(vertex);
}

/// Ends of segments and corners of tetrahedra.
std::vector<std::uint8_t> pinnedVertices(const Mesh& mesh, const OrderedSurface& ordered)
{
  std::vector<std::uint8_t> isPinned(ordered.fileVertex.size(), 0);
  const auto pin = [&](Index vertex) {
    if (const Index place = ordered.ofFile[at(vertex)]; place != kNoIndex) isPinned[at(place)] = 1;
  };
  std::for_each(mesh.segments.data(), mesh.segments.data() + mesh.segments.size(), pin);
  std::for_each(mesh.tetrahedra.data(), mesh.tetrahedra.data() + mesh.tetrahedra.size(), pin);
  return isPinned;
}

bool isDone(const Mesh& mesh, Index triangles, double edgeLength)
{
  const EdgeLengths lengths = edgeLengths(mesh);
  if (!lengths.areAlike()) return false;
  if (triangles > 0) return mesh.triangleCount() <= triangles && mesh.triangleCount() >= 0.85 * triangles;
  return std::abs(lengths.mean - edgeLength) <= 0.15 * edgeLength;
}

void tell(const Mesh& mesh, bool isRough, Index triangles, RepairReport& report)
{
  const EdgeLengths lengths = edgeLengths(mesh);
  report.remeshedTo = mesh.triangleCount();
  report.shortestEdge = lengths.shortest;
  report.longestEdge = lengths.longest;
  report.notes.push_back("made " + std::to_string(report.remeshedTo) + " triangles of " +
                         std::to_string(report.remeshedFrom) + ", with edges from " +
                         formatDouble(lengths.shortest, 3) + " to " + formatDouble(lengths.longest, 3));
  if (isRough)
    report.notes.push_back(
      "took the many fine creases for roughness and smoothed them over; ask for shorter edges to "
      "keep them");
  if (triangles > 0 && report.remeshedTo > triangles)
    report.notes.push_back("could not come down to " + std::to_string(triangles) +
                           " triangles: lines, creases, seams or many small parts hold the others");
  if (!lengths.areAlike())
    report.notes.push_back(
      "some edges stay more than 5 times shorter than others: lines, creases, seams or small "
      "parts hold them, and the shortest sets the time step");
}

} // namespace

EdgeLengths edgeLengths(const Mesh& mesh)
{
  EdgeLengths lengths;
  double sum = 0.0;
  for (Index t = 0; t < mesh.triangleCount(); ++t)
    for (int k = 0; k < 3; ++k) {
      const double length =
        (mesh.position.col(mesh.triangles((k + 1) % 3, t)) - mesh.position.col(mesh.triangles(k, t)))
          .stableNorm();
      const bool isFirst = t == 0 && k == 0;
      lengths.shortest = isFirst ? length : std::min(lengths.shortest, length);
      lengths.longest = std::max(lengths.longest, length);
      sum += length;
    }
  if (mesh.triangleCount() > 0) lengths.mean = sum / (3.0 * mesh.triangleCount());
  return lengths;
}

Status remeshSurface(Mesh& mesh, Index triangles, double edgeLength, RepairReport& report,
                     std::vector<Index>& vertexOf, WorkControl* control)
{
  if (mesh.triangleCount() == 0) return {};
  const Frame frame(mesh.position);
  const OrderedSurface ordered(mesh, frame);
  const double area = areaOf(ordered.mesh);
  if (!(area > 0.0) || !std::isfinite(area))
    return Error{ErrorCode::InvalidValue,
                 "the surface has no area that a number can hold, so no new net can be laid on it"};
  const double wished =
    triangles > 0 ? std::sqrt(area / (kEquilateral * triangles)) : edgeLength * frame.scale;
  if (area / (kEquilateral * wished * wished) > kMostTriangles)
    return Error{ErrorCode::InvalidValue,
                 "edges of " + formatDouble(edgeLength, 3) +
                   " would make more than 20 million triangles: ask for longer ones"};
  if (isDone(ordered.mesh, triangles, wished)) return {};

  report.remeshedFrom = mesh.triangleCount();
  SurfaceNet net(ordered.mesh, pinnedVertices(mesh, ordered), wished, control);
  if (stopWanted(control)) return cancelledError();
  net.make(wished, triangles);
  if (stopWanted(control)) return cancelledError();
  net.writeTo(mesh, frame, ordered, vertexOf);
  tell(mesh, net.isRough(), triangles, report);
  return {};
}

} // namespace esm
