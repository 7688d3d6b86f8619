// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/update.h"

#include "cli/arguments.h"
#include "cli/import_report.h"
#include "core/base/json_line.h"
#include "core/project/project_io.h"
#include "core/project/reimport.h"
#include "meshimport/net_import.h"

namespace esm::cli {

namespace {

/// The project's recipe with what the command line says, names relative to the project's folder.
Result<ImportRecipe> newRecipe(const UpdateArguments& arguments, const Project& project,
                               const std::filesystem::path& folder)
{
  Result<ImportRecipe> recipe = arguments.choices.recipe(project.source);
  if (!recipe) return recipe.error();
  recipe->files = project.source.files;
  if (!arguments.files.empty()) {
    recipe->files.clear();
    for (const std::string& file : arguments.files) recipe->files.push_back({file, 0});
    recipe = withRelativeNames(withAbsoluteNames(std::move(*recipe), "."), folder);
  }
  if (recipe->files.empty())
    return Error{ErrorCode::InvalidValue, arguments.project +
                                            ": the net of this project did not come from mesh "
                                            "files"};
  return recipe;
}

void printJson(const UpdateArguments& arguments, const Reimported& result, bool changed)
{
  JsonLine line;
  line.add("file", arguments.output);
  line.add("changed", changed);
  line.add("nodes", result.project.net.nodeCount());
  line.add("springs", result.project.net.springCount());
  line.add("triangles", result.project.net.triangleCount());
  line.add("unchanged_nodes", result.unchanged);
  line.add("new_nodes", result.added);
  line.add("gone_nodes", result.gone);
  line.add("notes", result.notes);
  print(line.text());
}

Exit save(const UpdateArguments& arguments, Reimported& result, const std::filesystem::path& folder)
{
  Project& project = result.project;
  project.source =
    withRelativeNames(withAbsoluteNames(std::move(project.source), folder), folderOf(arguments.output));
  if (const Status saved = saveProject(project, arguments.output); !saved) return fail(saved.error());
  for (const std::string& note : result.notes) say(arguments.output + ": " + note);
  say(arguments.output + ": " + std::to_string(project.net.nodeCount()) + " nodes (" +
      std::to_string(result.unchanged) + " as before, " + std::to_string(result.added) + " new, " +
      std::to_string(result.gone) + " gone), " + std::to_string(project.net.springCount()) + " springs, " +
      sizeInMillimetres(sizesOf(project.net)));
  if (arguments.json) printJson(arguments, result, true);
  return Exit::Done;
}

} // namespace

Exit updateProject(const UpdateArguments& given)
{
  UpdateArguments arguments = given;
  if (arguments.output.empty()) arguments.output = arguments.project;
  const Result<Project> project = loadProject(arguments.project);
  if (!project) return fail(project.error());
  const std::filesystem::path folder = folderOf(arguments.project);
  const Result<ImportRecipe> recipe = newRecipe(arguments, *project, folder);
  if (!recipe) return fail(recipe.error());
  const Result<std::vector<std::string>> changed = changedFiles(*recipe, folder);
  if (!changed) return fail(changed.error());
  if (changed->empty() && *recipe == project->source && arguments.output == arguments.project) {
    say(arguments.project + ": up to date, its mesh files have not changed");
    const Index nodes = project->net.nodeCount();
    if (arguments.json) printJson(arguments, {*project, nodes, 0, 0, {}}, false);
    return Exit::Done;
  }
  Project before = *project; // tissue edited since the import stays, unless the command line speaks of it
  if (recipe->material != project->source.material) {
    Result<TissueModel> wished = tissueOf(recipe->material, std::move(before.tissue));
    if (!wished) return fail({wished.error().code, arguments.project + ": " + wished.error().detail});
    before.tissue = std::move(*wished);
  }
  Result<ImportedNet> imported = importNet(*recipe, folder, before.tissue.thickness);
  if (!imported) return fail(imported.error());
  for (const std::string& note : imported->notes) say(arguments.project + ": " + note);
  warnOfSize(arguments.project, *imported);
  Result<Reimported> result = reimport(before, std::move(imported->net), std::move(imported->recipe));
  if (!result) return fail({result.error().code, arguments.project + ": " + result.error().detail});
  return save(arguments, *result, folder);
}

} // namespace esm::cli
