// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/defects.h"
#include "cli/import_report.h"
#include "core/base/json_line.h"
#include "core/base/text_number.h"
#include "core/geometry/mesh_defects.h"
#include "core/net/net_builder.h"
#include "core/project/project_io.h"
#include "core/support/net_cost.h"
#include "core/support/quality.h"
#include "meshimport/mesh_importer.h"

#include <filesystem>

namespace esm::cli {

namespace {

struct InspectOptions {
  std::string mesh;
  ImportOptions import;
  bool defects = false;
  bool json = false, quality = false;
  std::string unit = "mm";
};

JsonLine jsonOf(const ImportedMesh& imported)
{
  JsonLine line = meshReportJson(imported.report);
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

JsonLine jsonOf(const QualityReport& report, const NetCost& cost)
{
  std::vector<JsonLine> findings;
  for (const QualityFinding& finding : report.findings) {
    constexpr const char* kSeverities[] = {"good", "note", "warning"};
    JsonLine line;
    line.add("kind", nameOf(finding.kind));
    line.add("severity", kSeverities[static_cast<std::size_t>(finding.severity)]);
    line.add("value", finding.value);
    line.add("count", finding.count);
    std::vector<std::string> nodes;
    for (const NodeId node : finding.nodes) nodes.push_back(std::to_string(static_cast<Index>(node)));
    line.add("nodes", nodes);
    line.add("text", finding.text);
    findings.push_back(std::move(line));
  }
  JsonLine line;
  line.add("carries_load", report.carriesLoad());
  line.add("poke", report.poke);
  line.add("poke_radius", report.pokeRadius);
  line.add("dent", report.dent);
  line.add("frequency", report.frequency);
  line.add("mechanisms", report.mechanisms);
  addCost(line, cost);
  line.add("findings", findings);
  return line;
}

/// The net of a project as it is; of a mesh the bare net with the default tissue.
Result<SpringNet> netToJudge(const InspectOptions& options)
{
  const std::string extension = std::filesystem::path(options.mesh).extension().string();
  if (extension == ".esm" || extension == ".esmb" || extension == ".json") {
    Result<Project> project = loadProject(options.mesh);
    if (!project) return project.error();
    return std::move(project->net);
  }
  Result<ImportedMesh> imported = importMesh(options.mesh, options.import);
  if (!imported) return imported.error();
  toScene(imported->mesh, *lengthUnitFromName(options.unit), UpAxis::Z);
  Result<SpringNet> net = buildNet(imported->mesh);
  if (!net) return Error{net.error().code, options.mesh + ": " + net.error().detail};
  if (const auto applied = applyTissue(defaultTissue(), *net); !applied)
    return Error{applied.error().code, options.mesh + ": " + applied.error().detail};
  net->anchors = {}; // what the bare net holds, not what the bed around it holds
  return net;
}

Exit inspectQuality(const InspectOptions& options)
{
  const Result<SpringNet> net = netToJudge(options);
  if (!net) return fail(net.error());
  const Result<QualityReport> report = judgeNet(*net);
  if (!report) return fail({report.error().code, options.mesh + ": " + report.error().detail});
  if (options.json) {
    print(jsonOf(*report, predictCost(*net)).text());
    return Exit::Done;
  }
  for (const QualityFinding& finding : report->findings) {
    constexpr const char* kMarks[] = {"good:    ", "note:    ", "warning: "};
    print(kMarks[static_cast<std::size_t>(finding.severity)] + finding.text);
  }
  return Exit::Done;
}

Exit inspect(const InspectOptions& options)
{
  if (options.quality) return inspectQuality(options);
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
  command->add_flag(
    "--quality", options->quality,
    "Say whether the net carries load; of a mesh the bare net with the default tissue. Also for "
    "projects");
  command->add_option("--unit", options->unit, "Of the mesh file, for --quality: mm, cm, m or inch")
    ->check(CLI::IsMember({"mm", "cm", "m", "inch"}))
    ->capture_default_str();
  command->footer("Example:\n  esm inspect gallbladder.obj --json\n  esm inspect gallbladder.obj --quality");
  command->callback([options, &work] { work = [options] { return inspect(*options); }; });
}

} // namespace esm::cli
