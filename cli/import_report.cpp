// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/import_report.h"

namespace esm::cli {

namespace {

JsonLine materialJson(const MaterialReport& report)
{
  JsonLine line;
  line.add("volume", report.volume);
  line.add("wall_area", report.wallArea);
  line.add("modulus_scale", report.scale);
  line.add("measured_stiffness", report.measured);
  return line;
}

} // namespace

JsonLine meshReportJson(const MeshReport& report)
{
  JsonLine line;
  line.add("nodes", report.nodes);
  line.add("springs", report.springs);
  line.add("triangles", report.triangles);
  line.add("segments", report.segments);
  line.add("components", report.components);
  line.add("isolated_vertices", report.isolatedVertices);
  line.add("boundary_edges", report.boundaryEdges);
  line.add("nonmanifold_edges", report.nonManifoldEdges);
  line.add("degenerate_faces", report.degenerateFaces);
  line.add("duplicate_faces", report.duplicateFaces);
  line.add("nonfinite_vertices", report.nonFiniteVertices);
  line.add("bbox_min", report.boxMin);
  line.add("bbox_max", report.boxMax);
  line.add("finite", report.finite);
  return line;
}

void addCost(JsonLine& line, const NetCost& cost)
{
  line.add("nodes", cost.nodes);
  line.add("springs", cost.springs);
  line.add("shortest_spring", cost.shortest);
  line.add("stable_step", cost.step);
}

void addImported(JsonLine& line, const ImportedNet& imported, const NetCost& cost)
{
  JsonLine predicted;
  addCost(predicted, cost);
  line.add("before", meshReportJson(imported.before));
  line.add("after", meshReportJson(imported.after));
  if (imported.recipe.material.concernsNet()) line.add("material", materialJson(imported.material));
  line.add("cost", predicted);
  line.add("notes", imported.notes);
}

} // namespace esm::cli
