// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/defects.h"
#include "cli/import_report.h"
#include "cli/recipe_arguments.h"
#include "core/base/json_line.h"
#include "core/base/text_number.h"
#include "core/geometry/mesh_defects.h"
#include "core/geometry/self_intersections.h"
#include "core/net/net_edit.h"
#include "core/project/project_io.h"
#include "core/quality/quality.h"
#include "meshimport/net_import.h"

#include <filesystem>

namespace esm::cli {

namespace {

struct InspectOptions {
  std::string mesh;
  RecipeArguments choices;
  bool defects = false, intersections = false;
  bool json = false, quality = false;
};

/// Of a self-intersection search that nobody asked to be complete [s].
constexpr double kIntersectionTime = 1.0;

/// Whether the choices say nothing but how vertices are joined: then the mesh is shown as the file has it.
bool isPlain(ImportRecipe recipe)
{
  recipe.weldTolerance = 0.0;
  return recipe == ImportRecipe{};
}

/// The size in the scene, if the file says its unit.
Eigen::Vector3d statedExtent(const ImportedMesh& imported)
{
  return extentInScene(imported.report.boxMin, imported.report.boxMax, frameOf(imported.stated, {}));
}

JsonLine jsonOf(const ImportedMesh& imported)
{
  JsonLine line = meshReportJson(imported.report);
  if (!imported.stated.isEmpty()) line.add("stated", inWords(imported.stated));
  if (imported.stated.metres) line.add("size_mm", Eigen::Vector3d(1000.0 * statedExtent(imported)));
  line.add("sum_rest_length", sumRestLength(imported.mesh, imported.edges));
  line.add("format", imported.format);
  line.add("notes", imported.notes);
  return line;
}

void row(const std::string& what, const std::string& value)
{
  print(what + std::string(what.size() < 22 ? 22 - what.size() : 1, ' ') + value);
}

void printReport(const MeshReport& report, const std::string& format)
{
  const auto point = [](const Eigen::Vector3d& p) {
    return formatDouble(p[0], 6) + " " + formatDouble(p[1], 6) + " " + formatDouble(p[2], 6);
  };
  row("format", format);
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

/// The net that `esm import` would make, with its tissue.
Result<ImportedNet> netOfRecipe(const InspectOptions& options, ImportRecipe recipe)
{
  recipe.files = {{options.mesh, 0}};
  const Result<TissueModel> tissue = tissueOf(recipe.material, defaultTissue());
  if (!tissue) return tissue.error();
  Result<ImportedNet> made = importNet(recipe, ".", tissue->thickness);
  if (!made) return made.error();
  if (const auto applied = applyTissue(*tissue, made->net); !applied)
    return Error{applied.error().code, options.mesh + ": " + applied.error().detail};
  return made;
}

/// What tissue's bed holds says nothing of the net; bands of the recipe do.
void keepOnlyBands(AnchorSet& anchors)
{
  std::vector<Index> bands;
  for (Index i = 0; i < anchors.count(); ++i)
    if (anchors.isBand(i)) bands.push_back(i);
  keepAnchors(anchors, bands);
}

/// The net of a project as it is; of a mesh what the choices make of it, or without any the bare net in mm.
Result<SpringNet> netToJudge(const InspectOptions& options, ImportRecipe recipe)
{
  const std::string extension = std::filesystem::path(options.mesh).extension().string();
  if (extension == ".esm" || extension == ".esmb" || extension == ".json") {
    Result<Project> project = loadProject(options.mesh);
    if (!project) return project.error();
    return std::move(project->net);
  }
  if (isPlain(recipe)) recipe.unit = LengthUnit::Millimetre;
  Result<ImportedNet> made = netOfRecipe(options, std::move(recipe));
  if (!made) return made.error();
  keepOnlyBands(made->net.anchors);
  return std::move(made->net);
}

Exit inspectQuality(const InspectOptions& options, const ImportRecipe& recipe)
{
  const Result<SpringNet> net = netToJudge(options, recipe);
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

/// What an import with these choices would make.
Exit inspectRecipe(const InspectOptions& options, const ImportRecipe& recipe)
{
  const Result<ImportedNet> made = netOfRecipe(options, recipe);
  if (!made) return fail(made.error());
  for (const std::string& note : made->notes) say(options.mesh + ": " + note);
  const NetCost cost = predictCost(made->net);
  if (options.json) {
    JsonLine line;
    line.add("nodes", made->net.nodeCount());
    line.add("springs", made->net.springCount());
    line.add("triangles", made->net.triangleCount());
    addImported(line, *made, cost);
    print(line.text());
    return Exit::Done;
  }
  print("the mesh after repair, in metres:");
  printReport(made->after, made->files.front().format);
  print("the net: " + std::to_string(made->net.nodeCount()) + " nodes, " +
        std::to_string(made->net.springCount()) + " springs, shortest " + formatDouble(cost.shortest, 4) +
        " m, largest explicit step " + formatDouble(cost.step, 3) + " s, about " +
        std::to_string(predictMemory(made->net).simulate / 1'000'000) + " MB of memory to simulate");
  return Exit::Done;
}

Exit inspectFile(const InspectOptions& options, const ImportRecipe& recipe)
{
  ImportOptions import;
  import.weld = recipe.weldTolerance >= 0.0;
  if (import.weld) import.weldTolerance = recipe.weldTolerance;
  Result<ImportedMesh> imported = importMesh(options.mesh, import);
  if (!imported) return fail(imported.error());
  if (std::string note = frameNote(imported->stated, recipe); !note.empty())
    imported->notes.push_back(std::move(note));
  for (const std::string& note : imported->notes) say(options.mesh + ": " + note);
  const Mesh& mesh = imported->mesh;
  MeshDefects defects;
  SelfIntersections crossings;
  if (options.defects) {
    defects = findDefects(mesh);
    crossings = findSelfIntersections(mesh, options.intersections ? 0.0 : kIntersectionTime);
  }
  if (options.json) {
    JsonLine line = jsonOf(*imported);
    if (options.defects) line.add("defects", jsonOfDefects(defects, crossings, mesh));
    print(line.text());
  } else {
    printReport(imported->report, imported->format);
    if (imported->stated.metres) row("size, as stated", sizeInMillimetres(statedExtent(*imported)));
    row("sum of rest lengths", formatDouble(sumRestLength(mesh, imported->edges), 6));
    if (options.defects) printDefects(defects, crossings, mesh);
  }
  return Exit::Done;
}

Exit inspect(const InspectOptions& options)
{
  const Result<ImportRecipe> recipe = options.choices.recipe();
  if (!recipe) return fail(recipe.error());
  if (options.quality) return inspectQuality(options, *recipe);
  if (!options.defects && !isPlain(*recipe)) return inspectRecipe(options, *recipe);
  return inspectFile(options, *recipe);
}

} // namespace

void addInspect(CLI::App& program, Work& work)
{
  auto options = std::make_shared<InspectOptions>();
  CLI::App* command = program.add_subcommand(
    "inspect",
    "Say what a mesh file holds, in its own unit; or with the choices of an import what it would make");
  command->add_option("MESH", options->mesh, "OBJ, STL, PLY or another mesh file")->required();
  addRecipeOptions(*command, options->choices);
  CLI::Option* defects = command->add_flag(
    "--defects", options->defects,
    "also list parts, borders, T-junctions and all that is wrong in the file, each with its place");
  command
    ->add_flag(
      "--intersections", options->intersections,
      "with --defects: look for triangles that run through others for as long as it takes, not for 1 s")
    ->needs(defects);
  addJsonFlag(*command, options->json);
  command->add_flag(
    "--quality", options->quality,
    "Say whether the net carries load that these choices make; without any the bare net, in mm. "
    "Also for projects");
  command->footer("Examples:\n  esm inspect gallbladder.obj --json\n"
                  "  esm inspect gallbladder.obj --quality --unit mm --interior struts --fit-modulus");
  command->callback([options, &work] { work = [options] { return inspect(*options); }; });
}

} // namespace esm::cli
