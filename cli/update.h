// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/messages.h"
#include "cli/recipe_arguments.h"

namespace esm::cli {

struct UpdateArguments {
  std::string project, output;    ///< output empty: the project itself
  std::vector<std::string> files; ///< in place of the recipe's; empty: those
  RecipeArguments choices;        ///< over the recipe's
  bool json = false;
};

/// `esm import --update`: carries a project's recipe out again and keeps what is the user's. Whatever fails,
/// the project stays as it was.
Exit updateProject(const UpdateArguments& arguments);

} // namespace esm::cli
