// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/import_recipe.h"

#include "core/project/recipe_json.h"

#include <cmath>

namespace esm {

namespace {

constexpr const char* kRecipeFormat = "esm-recipe-1";
constexpr const char* kProjectFormat = "esm-project";

} // namespace

FileFrame frameOf(const ImportRecipe& recipe, const StatedFrame& stated)
{
  return frameOf(recipe.ignoreStated ? StatedFrame{} : stated, {recipe.unit, recipe.up, recipe.patientAxes});
}

ImportRecipe withAbsoluteNames(ImportRecipe recipe, const std::filesystem::path& folder)
{
  const std::filesystem::path base = std::filesystem::absolute(folder);
  for (SourceFile& file : recipe.files) file.name = (base / file.name).lexically_normal().generic_string();
  return recipe;
}

ImportRecipe withRelativeNames(ImportRecipe recipe, const std::filesystem::path& folder)
{
  const std::filesystem::path base = std::filesystem::absolute(folder).lexically_normal();
  for (SourceFile& file : recipe.files)
    if (const auto name = std::filesystem::path(file.name).lexically_relative(base); !name.empty())
      file.name = name.generic_string();
  return recipe;
}

std::string toRecipeJson(const ImportRecipe& recipe)
{
  json::Json tree = {{"format", kRecipeFormat}};
  const json::Json source = json::sourceOf(recipe);
  for (const auto& [key, value] : source.items())
    if (key != "file" || !recipe.files.empty()) tree[key] = value;
  return json::write(tree);
}

Result<ImportRecipe> parseRecipe(std::string_view bytes, const std::string& origin)
{
  try {
    Result<json::Json> tree = json::parseJson(bytes, origin);
    if (!tree) return tree.error();
    json::Faults faults{origin, {}};
    const json::View root(*tree, faults);
    constexpr const char* kFormats[] = {kRecipeFormat, kProjectFormat};
    const bool whole = root["format"].choice(kFormats) == 1;
    if (faults.first) return *faults.first;
    ImportRecipe recipe = whole ? json::readSource(root["source"]) : json::readSource(root, true);
    if (faults.first) return *faults.first;
    if (const Status status = checkRecipe(recipe); !status)
      return Error{status.error().code, origin + ": " + status.error().detail};
    return recipe;
  } catch (...) {
    return json::thrownWhileReading(origin);
  }
}

Status checkRecipe(const ImportRecipe& recipe)
{
  if (!std::isfinite(recipe.weldTolerance))
    return Error{ErrorCode::InvalidValue, "the weld tolerance must be a finite number"};
  return {};
}

} // namespace esm
