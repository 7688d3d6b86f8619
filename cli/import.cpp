// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/rules_file.h"
#include "core/base/file_io.h"
#include "core/base/json_line.h"
#include "core/geometry/weld.h"
#include "core/net/net_builder.h"
#include "core/project/net_format.h"
#include "core/project/project_io.h"
#include "meshimport/mesh_importer.h"

namespace esm::cli {

namespace {

struct ImportArguments {
  std::vector<std::string> files;
  std::string output, unit = "m", up = "z", rules, name;
  ImportOptions import;
  bool json = false;
};

/// Whether the bytes claim to be a net in our plain format; a mesh may be JSON too (glTF).
bool looksLikePlainNet(std::string_view bytes)
{
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  return start != std::string_view::npos && bytes[start] == '{' &&
         bytes.find("\"esm-net-1\"") != std::string_view::npos;
}

void append(Mesh& mesh, const Mesh& next)
{
  const Index offset = mesh.vertexCount();
  const auto join = [](auto& matrix, const auto& more) {
    const Eigen::Index old = matrix.cols();
    matrix.conservativeResize(Eigen::NoChange, old + more.cols());
    matrix.rightCols(more.cols()) = more;
  };
  join(mesh.position, next.position);
  join(mesh.triangles, (next.triangles.array() + offset).matrix().eval());
  join(mesh.segments, (next.segments.array() + offset).matrix().eval());
}

/// All files in one mesh, joined where they touch; in the scene's unit and axes.
Result<Mesh> readMeshes(const ImportArguments& arguments)
{
  Mesh mesh;
  for (const std::string& file : arguments.files) {
    const Result<ImportedMesh> imported = importMesh(file, arguments.import);
    if (!imported) return imported.error();
    for (const std::string& note : imported->notes) say(file + ": " + note);
    append(mesh, imported->mesh);
  }
  if (arguments.files.size() > 1 && arguments.import.weld) weldVertices(mesh, arguments.import.weldTolerance);
  toScene(mesh, *lengthUnitFromName(arguments.unit), arguments.up == "y" ? UpAxis::Y : UpAxis::Z);
  return mesh;
}

Result<Project> projectFromMeshes(const ImportArguments& arguments)
{
  const Result<Mesh> mesh = readMeshes(arguments);
  if (!mesh) return mesh.error();
  const auto inFile = [&](const Error& error) {
    return Error{error.code, arguments.files.front() + ": " + error.detail};
  };
  Result<SpringNet> net = buildNet(*mesh);
  if (!net) return inFile(net.error());

  Project project;
  const std::filesystem::path first(arguments.files.front());
  project.name = first.stem().string();
  project.source = {first.filename().string(), arguments.unit, arguments.up,
                    arguments.import.weld ? arguments.import.weldTolerance : -1.0};
  project.net = std::move(*net);
  project.tissue = defaultTissue();
  if (!arguments.rules.empty())
    if (const Status status = takeRules(arguments.rules, project.tissue); !status) return status.error();
  if (const auto applied = applyTissue(project.tissue, project.net); !applied) return inFile(applied.error());
  return project;
}

Exit importFiles(const ImportArguments& arguments)
{
  const Result<std::string> bytes = readFile(arguments.files.front());
  if (!bytes) return fail(bytes.error());
  const bool plain = looksLikePlainNet(*bytes);
  if (plain && arguments.files.size() > 1)
    return fail({ErrorCode::Unsupported, arguments.files.front() + ": is a net, only meshes can be joined"});
  Result<Project> project =
    plain ? parseNetFormat(*bytes, arguments.files.front()) : projectFromMeshes(arguments);
  if (!project) return fail(project.error());
  if (plain && !arguments.rules.empty()) {
    if (const Status status = takeRules(arguments.rules, project->tissue); !status)
      return fail(status.error());
    say("the net keeps its own numbers; the rules take hold with esm apply");
  }
  if (!arguments.name.empty()) project->name = arguments.name;
  if (const Status saved = saveProject(*project, arguments.output); !saved) return fail(saved.error());

  const SpringNet& net = project->net;
  say(arguments.output + ": " + std::to_string(net.nodeCount()) + " nodes, " +
      std::to_string(net.springCount()) + " springs, " + std::to_string(net.triangleCount()) + " triangles");
  if (arguments.json) {
    JsonLine line;
    line.add("file", arguments.output);
    line.add("nodes", net.nodeCount());
    line.add("springs", net.springCount());
    line.add("triangles", net.triangleCount());
    line.add("parameters_from_tissue", project->parametersFromTissue);
    print(line.text());
  }
  return Exit::Done;
}

} // namespace

void addImport(CLI::App& program, Work& work)
{
  auto arguments = std::make_shared<ImportArguments>();
  CLI::App* command =
    program.add_subcommand("import", "Make a project from meshes, or from a net in the plain format");
  command
    ->add_option("MESH", arguments->files,
                 "mesh files, joined to one net, or one net.json (esm-net-1), known by its content")
    ->required();
  command->add_option("-o,--output", arguments->output, "the project: .esm (JSON) or .esmb (CBOR)")
    ->required();
  command->add_option("--unit", arguments->unit, "length unit of the meshes (default m)")
    ->check(CLI::IsMember({"mm", "cm", "m", "inch"}));
  command->add_option("--up", arguments->up, "axis of the meshes that points up (default z)")
    ->check(CLI::IsMember({"y", "z"}));
  addWeldOptions(*command, arguments->import);
  command->add_option("--rules", arguments->rules,
                      "rules in place of the default ones: a text file or a project");
  command->add_option("--name", arguments->name, "name of the project (default: from the first file)");
  addJsonFlag(*command, arguments->json);
  command->footer("Example:\n  esm import wall.stl struts.obj --unit mm --up y -o organ.esm");
  command->callback([arguments, &work] { work = [arguments] { return importFiles(*arguments); }; });
}

} // namespace esm::cli
