// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/project/import_recipe.h"
#include "core/project/json_view.h"

namespace esm::json {

/// The block "source" of a project. What is as it is by default is left out, but for the four keys that files
/// have always had: older programs read them, and equal recipes give equal bytes.
Json sourceOf(const ImportRecipe& recipe);
/// Shapes and ranges only; checkRecipe() has still to look at the result.
/// @param alone a recipe file: "format" stands beside the keys, and each of them may be absent
ImportRecipe readSource(const View& object, bool alone = false);

} // namespace esm::json
