// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/import/format_memory.h"

#include <QFileInfo>
#include <QSettings>

namespace esm {

namespace {

QString keyOf(const QString& format)
{
  return QStringLiteral("importRecipe/") + format;
}

} // namespace

std::optional<ImportRecipe> rememberedRecipe(const QString& format)
{
  const QString text = QSettings().value(keyOf(format)).toString();
  if (text.isEmpty()) return std::nullopt;
  auto recipe = parseRecipe(text.toStdString(), "settings");
  if (!recipe) return std::nullopt; // of another version of the program, or edited by hand
  recipe->files.clear();
  return *std::move(recipe);
}

void rememberRecipe(const QString& format, ImportRecipe recipe)
{
  recipe.files.clear();
  recipe.unit = ImportRecipe().unit;
  QSettings().setValue(keyOf(format), QString::fromStdString(toRecipeJson(recipe)));
}

void forgetRecipe(const QString& format)
{
  QSettings().remove(keyOf(format));
}

QString formatOf(const QString& path)
{
  return QFileInfo(path).suffix().toUpper();
}

} // namespace esm
