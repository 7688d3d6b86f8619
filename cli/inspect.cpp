// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/defects.h"
#include "core/base/json_line.h"
#include "core/base/text_number.h"
#include "core/geometry/mesh_defects.h"
#include "meshimport/mesh_importer.h"

namespace esm::cli {

namespace {

struct InspectOptions {
  std::string mesh;
  ImportOptions import;
  bool defects = false;
  bool json = false;
};

JsonLine jsonOf(const ImportedMesh& imported)
{
  const MeshReport& report = imported.report;
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
  line.add("sum_rest_length", report.sumRestLength);
  line.add("format", imported.format);
  line.add("notes", imported.notes);
  return line;
}

void printReport(const ImportedMesh& imported)
{
  const MeshReport& report = imported.report;
  const auto row = [](const std::string& what, const std::string& value) {
    print(what + std::string(what.size() < 22 ? 22 - what.size() : 1, ' ') + value);
  };
  const auto point = [](const Eigen::Vector3d& p) {
    return formatDouble(p[0], 6) + " " + formatDouble(p[1], 6) + " " + formatDouble(p[2], 6);
  };
  row("format", imported.format);
  row("nodes", std::to_string(report.nodes));
  row("springs", std::to_string(report.springs));
  row("triangles", std::to_string(report.triangles));
  row("line segments", std::to_string(report.segments));
  row("components", std::to_string(report.components));
  row("isolated vertices", std::to_string(report.isolatedVertices));
  row("boundary edges", std::to_string(report.boundaryEdges));
  row("non-manifold edges", std::to_string(report.nonManifoldEdges));
  row("degenerate faces", std::to_string(report.degenerateFaces));
  row("duplicate faces", std::to_string(report.duplicateFaces));
  row("non-finite vertices", std::to_string(report.nonFiniteVertices));
  row("box from", point(report.boxMin));
  row("box to", point(report.boxMax));
  row("sum of rest lengths", formatDouble(report.sumRestLength, 6));
}

Exit inspect(const InspectOptions& options)
{
  const Result<ImportedMesh> imported = importMesh(options.mesh, options.import);
  if (!imported) return fail(imported.error());
  for (const std::string& note : imported->notes) say(options.mesh + ": " + note);
  if (options.json) {
    JsonLine line = jsonOf(*imported);
    if (options.defects) line.add("defects", jsonOfDefects(findDefects(imported->mesh), imported->mesh));
    print(line.text());
  } else {
    printReport(*imported);
    if (options.defects) printDefects(findDefects(imported->mesh), imported->mesh);
  }
  return Exit::Done;
}

} // namespace

void addInspect(CLI::App& program, Work& work)
{
  auto options = std::make_shared<InspectOptions>();
  CLI::App* command = program.add_subcommand("inspect", "Say what a mesh file holds, in its own unit");
  command->add_option("MESH", options->mesh, "OBJ, STL, PLY or another mesh file")->required();
  addWeldOptions(*command, options->import);
  command->add_flag("--defects", options->defects,
                    "also list parts, borders, T-junctions and all that is wrong, each with its place");
  addJsonFlag(*command, options->json);
  command->footer("Example:\n  esm inspect gallbladder.obj --json");
  command->callback([options, &work] { work = [options] { return inspect(*options); }; });
}

} // namespace esm::cli
