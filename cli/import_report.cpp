// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/import_report.h"

#include "cli/messages.h"
#include "core/base/text_number.h"
#include "core/geometry/extent.h"

#include <algorithm>
#include <cmath>

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
  predicted.add("memory_bytes", predictMemory(imported.net).simulate);
  line.add("before", meshReportJson(imported.before));
  line.add("after", meshReportJson(imported.after));
  if (imported.recipe.material.concernsNet()) line.add("material", materialJson(imported.material));
  line.add("cost", predicted);
  line.add("size_mm", Eigen::Vector3d(1000.0 * sizesOf(imported.net)));
  line.add("notes", imported.notes);
}

std::string sizeInMillimetres(const Eigen::Vector3d& extent)
{
  std::string text;
  constexpr double kWhole = 1e3,
                   kMost = 1e9; // from a metre to a thousand kilometres: no power of ten to read
  for (const double length : extent) {
    const double shown = 1000.0 * length;
    const bool isWhole = shown >= kWhole && shown <= kMost;
    text +=
      (text.empty() ? "" : " x ") + (isWhole ? std::to_string(std::llround(shown)) : formatDouble(shown, 4));
  }
  return text + " mm";
}

Eigen::Vector3d sizesOf(const SpringNet& net)
{
  if (net.nodeCount() == 0) return Eigen::Vector3d::Zero();
  return boxOf(net.restPosition).sizes();
}

void warnOfSize(const std::string& file, const ImportedNet& imported)
{
  const Eigen::Vector3d extent = sizesOf(imported.net);
  if (isUsualSize(extent.maxCoeff())) return;
  const bool isStated = std::any_of(imported.files.begin(), imported.files.end(),
                                    [](const ReadFile& read) { return read.stated.metres.has_value(); });
  say(file + ": warning: " + sizeInMillimetres(extent) +
      " is not the size of an organ (1 mm to 2 m); is the unit right? --unit mm|cm|m|inch sets it" +
      (isStated && !imported.recipe.ignoreStated ? ", with --ignore-stated over what the file states" : ""));
}

} // namespace esm::cli
