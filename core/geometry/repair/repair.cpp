// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/repair/repair.h"

#include "core/geometry/repair/clean.h"
#include "core/geometry/repair/close_t_junctions.h"
#include "core/geometry/repair/fill_holes.h"
#include "core/geometry/repair/remesh.h"

#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace esm {

namespace {

Status checkOptions(const RepairOptions& options)
{
  const auto refuse = [](const char* what) { return Error{ErrorCode::InvalidValue, what}; };
  const auto isLength = [](double value) { return std::isfinite(value) && value >= 0.0; };
  if (!isLength(options.tJunctionTolerance)) return refuse("the tolerance of T-junctions must be 0 or more");
  if (options.dropPartsBelow < 0) return refuse("the least size of a part must be 0 or more");
  if (!(options.dropPartsShare >= 0.0 && options.dropPartsShare <= 1.0))
    return refuse("the share of the largest part must be between 0 and 1");
  if (options.fillHolesUpTo < 0 || !isLength(options.fillHolesLength))
    return refuse("the largest hole to fill must be 0 or more");
  if (options.triangles < 0) return refuse("the number of triangles must be 0 or more");
  if (!isLength(options.edgeLength)) return refuse("the edge length must be 0 or more");
  if (options.triangles > 0 && options.edgeLength > 0.0)
    return refuse("ask for a number of triangles or for an edge length, not for both");
  return {};
}

void tellCounts(RepairReport& report)
{
  const auto tell = [&](Index count, const char* what) {
    if (count > 0) report.notes.push_back("removed " + std::to_string(count) + what);
  };
  if (report.closedTJunctions > 0)
    report.notes.push_back("tied " + std::to_string(report.closedTJunctions) +
                           " vertices to the edges they only lay on");
  tell(report.degenerateFaces, " triangles without area");
  tell(report.duplicateFaces, " triangles that were there twice");
  tell(report.uselessSegments, " lines without length or there twice");
  tell(report.isolatedVertices, " vertices that nothing used");
}

/// Tying vertices to edges may leave slivers without area, and without these more vertices may be loose.
Status cleanAndTie(Mesh& mesh, const RepairOptions& options, RepairReport& report,
                   std::vector<Index>& vertexOf, WorkControl* control)
{
  constexpr int kMostRounds = 8;
  for (int round = 0; round < kMostRounds; ++round) {
    if (options.removeUseless) removeUseless(mesh, report, vertexOf, control);
    if (stopWanted(control)) return cancelledError();
    if (!options.closeTJunctions) return {};
    const Index tied = report.closedTJunctions;
    if (const Status done = closeTJunctions(mesh, options.tJunctionTolerance, report, control); !done)
      return done;
    if (report.closedTJunctions == tied) return {};
  }
  return {};
}

} // namespace

Status repairMesh(Mesh& mesh, const RepairOptions& options, RepairReport& report, WorkControl* control)
{
  report = {};
  if (const Status fine = checkOptions(options); !fine) return fine;
  std::vector<Index> vertexOf(static_cast<std::size_t>(mesh.vertexCount()));
  std::iota(vertexOf.begin(), vertexOf.end(), 0);
  if (options.doesNothing()) {
    report.vertexOf = std::move(vertexOf);
    return {};
  }
  Mesh work = mesh;
  leaveOutNonFinite(work, report, vertexOf);
  if (const Status done = cleanAndTie(work, options, report, vertexOf, control); !done) return done;
  if (options.dropPartsBelow > 0 || options.dropPartsShare > 0.0)
    dropSmallParts(work, options.dropPartsBelow, options.dropPartsShare, report, vertexOf);
  if (stopWanted(control)) return cancelledError();
  if (options.fillHolesUpTo > 0)
    if (const Status done = fillHoles(work, options.fillHolesUpTo, options.fillHolesLength, report, control);
        !done)
      return done;
  if (options.unifyOrientation) unifyOrientation(work, report, control);
  if (stopWanted(control)) return cancelledError();
  if (options.triangles > 0 || options.edgeLength > 0.0) {
    removeUseless(work, report, vertexOf, control); // the new net stands on sound triangles only
    if (stopWanted(control)) return cancelledError();
    if (const Status done =
          remeshSurface(work, options.triangles, options.edgeLength, report, vertexOf, control);
        !done)
      return done;
  }
  if (work.triangleCount() + work.segmentCount() + work.tetrahedronCount() == 0)
    return Error{ErrorCode::EmptyResult, "the repair leaves nothing of the mesh: ask for less of it"};
  tellCounts(report);
  mesh = std::move(work);
  report.vertexOf = std::move(vertexOf);
  return {};
}

} // namespace esm
