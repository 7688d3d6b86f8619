// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/import_report.h"
#include "cli/output_files.h"
#include "cli/recipe_arguments.h"
#include "cli/rules_file.h"
#include "cli/update.h"
#include "core/base/file_io.h"
#include "core/base/json_line.h"
#include "core/project/net_format.h"
#include "core/project/project_io.h"
#include "core/project/xsp_format.h"
#include "meshimport/net_import.h"

namespace esm::cli {

namespace {

struct ImportArguments {
  std::vector<std::string> files;
  std::string output, rules, name, saveRecipe, update;
  RecipeArguments choices;
  bool json = false;
};

/// What came out, for the last line with --json.
struct Outcome {
  Project project;
  std::optional<ImportedNet> imported; ///< none for a plain net
};

/// Whether the bytes claim to be a net with its own numbers; a mesh may be JSON too (glTF).
bool looksLikePlainNet(std::string_view bytes)
{
  if (looksLikeXsp(bytes)) return true;
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  return start != std::string_view::npos && bytes[start] == '{' &&
         bytes.find("\"esm-net-1\"") != std::string_view::npos;
}

/// The recipe of the arguments for the given files, their names as a project in `folder` holds them.
Result<ImportRecipe> recipeOf(const ImportArguments& arguments, const std::filesystem::path& folder)
{
  Result<ImportRecipe> recipe = arguments.choices.recipe();
  if (!recipe) return recipe.error();
  recipe->files.clear();
  for (const std::string& file : arguments.files) recipe->files.push_back({file, 0});
  return withRelativeNames(withAbsoluteNames(std::move(*recipe), "."), folder);
}

/// Tissue over a net that has come in, and a name.
Status finishProject(const ImportArguments& arguments, Outcome& outcome)
{
  const std::filesystem::path first(arguments.files.front());
  Project& project = outcome.project;
  project.name = first.stem().string();
  project.source = outcome.imported->recipe;
  project.net = outcome.imported->net;
  if (const auto applied = applyTissue(project.tissue, project.net); !applied)
    return Error{applied.error().code, arguments.files.front() + ": " + applied.error().detail};
  return {};
}

Result<Outcome> importMeshes(const ImportArguments& arguments)
{
  const std::filesystem::path folder = folderOf(arguments.output);
  const Result<ImportRecipe> recipe = recipeOf(arguments, folder);
  if (!recipe) return recipe.error();
  TissueModel tissue = defaultTissue();
  if (!arguments.rules.empty())
    if (const Status status = takeRules(arguments.rules, tissue); !status) return status.error();
  Result<TissueModel> wished = tissueOf(recipe->material, std::move(tissue));
  if (!wished) return wished.error();
  Result<ImportedNet> imported = importNet(*recipe, folder, wished->thickness);
  if (!imported) return imported.error();
  for (const std::string& note : imported->notes)
    say(arguments.files.size() > 1 ? note : arguments.files.front() + ": " + note);
  Outcome outcome{{}, std::move(*imported)};
  outcome.project.tissue = std::move(*wished);
  if (const Status status = finishProject(arguments, outcome); !status) return status.error();
  return outcome;
}

Result<Outcome> importPlainNet(const ImportArguments& arguments, const std::string& bytes)
{
  if (arguments.files.size() > 1)
    return Error{ErrorCode::Unsupported, arguments.files.front() + ": is a net, only meshes can be joined"};
  std::vector<std::string> notes;
  Result<Project> project = looksLikeXsp(bytes) ? parseXsp(bytes, arguments.files.front(), &notes)
                                                : parseNetFormat(bytes, arguments.files.front());
  if (!project) return project.error();
  for (const std::string& note : notes) say(arguments.files.front() + ": " + note);
  if (!arguments.rules.empty()) {
    if (const Status status = takeRules(arguments.rules, project->tissue); !status) return status.error();
    say("the net keeps its own numbers; the rules take hold with esm apply");
  }
  return Outcome{std::move(*project), {}};
}

JsonLine jsonOf(const ImportArguments& arguments, const Outcome& outcome)
{
  const SpringNet& net = outcome.project.net;
  JsonLine line;
  line.add("file", arguments.output);
  line.add("nodes", net.nodeCount());
  line.add("springs", net.springCount());
  line.add("triangles", net.triangleCount());
  line.add("parameters_from_tissue", outcome.project.parametersFromTissue);
  if (!outcome.imported) return line;
  addImported(line, *outcome.imported, predictCost(net));
  return line;
}

Exit importFiles(const ImportArguments& arguments)
{
  if (!arguments.update.empty())
    return updateProject(
      {arguments.update, arguments.output, arguments.files, arguments.choices, arguments.json});
  const Result<std::string> bytes = readFile(arguments.files.front());
  if (!bytes) return fail(bytes.error());
  Result<Outcome> outcome =
    looksLikePlainNet(*bytes) ? importPlainNet(arguments, *bytes) : importMeshes(arguments);
  if (!outcome) return fail(outcome.error());
  Project& project = outcome->project;
  if (!arguments.name.empty()) project.name = arguments.name;
  if (const Status saved = saveProject(project, arguments.output); !saved) return fail(saved.error());
  if (!arguments.saveRecipe.empty()) {
    ImportRecipe recipe = project.source;
    recipe.files.clear(); // the choices are what is used again
    if (const Status saved = writeFileAtomically(arguments.saveRecipe, toRecipeJson(recipe)); !saved)
      return fail(saved.error());
  }
  const SpringNet& net = project.net;
  say(arguments.output + ": " + std::to_string(net.nodeCount()) + " nodes, " +
      std::to_string(net.springCount()) + " springs, " + std::to_string(net.triangleCount()) +
      " triangles, " + sizeInMillimetres(sizesOf(net)));
  if (outcome->imported) warnOfSize(arguments.output, *outcome->imported);
  if (arguments.json) print(jsonOf(arguments, *outcome).text());
  return Exit::Done;
}

} // namespace

void addImport(CLI::App& program, Work& work)
{
  auto arguments = std::make_shared<ImportArguments>();
  CLI::App* command =
    program.add_subcommand("import", "Make a project from meshes, or from a net in the plain format");
  CLI::Option* meshes = command->add_option("MESH", arguments->files,
                                            "mesh files, joined to one net, or one net: net.json (esm-net-1) "
                                            "or net.xsp (Xsp 3.0), known by its content");
  CLI::Option* output =
    command->add_option("-o,--output", arguments->output, "the project: .esm (JSON) or .esmb (CBOR)");
  CLI::Option* update =
    command->add_option("--update", arguments->update,
                        "import the meshes of this project again, as its recipe and the flags say; tissue, "
                        "regions, loads and fixed "
                        "nodes stay; without -o in place, and only if a file has changed");
  addRecipeOptions(*command, arguments->choices);
  command->add_option("--save-recipe", arguments->saveRecipe,
                      "write the choices made here to this file, for --recipe");
  command
    ->add_option("--rules", arguments->rules, "rules in place of the default ones: a text file or a project")
    ->excludes(update);
  command->add_option("--name", arguments->name, "name of the project (default: from the first file)")
    ->excludes(update);
  addJsonFlag(*command, arguments->json);
  command->footer("Examples:\n"
                  "  esm import wall.stl struts.obj --unit mm --up y -o organ.esm\n"
                  "  esm import scan.ply --unit mm --patient-axes lps --remove-useless --fill-holes 200 \\\n"
                  "    --unify-orientation --triangles 10000 --interior struts -o organ.esm \\\n"
                  "    --save-recipe scans.json\n"
                  "  esm import next.ply --recipe scans.json -o next.esm\n"
                  "  esm import --update organ.esm");
  command->callback([arguments, meshes, output, update, &work] {
    if (update->count() == 0)
      for (const CLI::Option* needed : {meshes, output})
        if (needed->count() == 0) throw CLI::RequiredError(needed->get_name());
    std::vector<std::string> read = arguments->files;
    read.insert(read.end(), {arguments->rules, arguments->choices.recipeFile});
    const bool isInPlace = arguments->output.empty();
    keepFilesApart(read, {isInPlace ? arguments->update : arguments->output, arguments->saveRecipe});
    work = [arguments] { return importFiles(*arguments); };
  });
}

} // namespace esm::cli
