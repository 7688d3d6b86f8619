// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/project/import_recipe.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace esm::cli {

/// The choices of an import as arguments: a recipe file, if there is one, and what stands on the command line
/// over it.
struct RecipeArguments {
  std::string recipeFile; ///< empty: start from the defaults
  std::vector<std::function<void(ImportRecipe&)>> changes;

  /// @param usual where the choices start if there is no recipe file
  /// Errors: of the recipe file.
  Result<ImportRecipe> recipe(ImportRecipe usual = {}) const;
};

/// --recipe, --unit, --up, ... and one flag for each option of core/project/option_fields.h.
void addRecipeOptions(CLI::App& command, RecipeArguments& arguments);

} // namespace esm::cli
