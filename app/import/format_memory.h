// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/import_recipe.h"

#include <QString>

#include <optional>

namespace esm {

/// What was chosen for the last file of a format ("STL" by the ending), kept in the settings of the program.
/// Files, fingerprints and the unit are not part of it: a wrong unit would go unseen.
std::optional<ImportRecipe> rememberedRecipe(const QString& format);
void rememberRecipe(const QString& format, ImportRecipe recipe);
void forgetRecipe(const QString& format);

/// "STL" of "scan.stl"; empty without an ending.
QString formatOf(const QString& path);

} // namespace esm
