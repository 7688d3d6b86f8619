// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/geometry/repair/repair.h"
#include "core/geometry/scene_frame.h"
#include "core/structure/material.h"
#include "core/structure/support.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// A mesh file of a recipe.
struct SourceFile {
  std::string name; ///< relative to the project's folder, or absolute; '/' between its parts
  std::uint64_t fingerprint =
    0; ///< fingerprintOf() (core/base/hash.h) its bytes when it was read; 0 = not known
  bool operator==(const SourceFile&) const = default;
};

/// What becomes of polygons with more than three corners. Their surface is cut into triangles either way.
enum class PolygonSprings {
  Triangulated, ///< the cuts are springs too: stiff against shear
  EdgesOnly     ///< only the polygon's own edges are springs
};

/// How the geometry of a project came in, with every choice, so that the same can be done again when the
/// files have changed. Plain data; saved in the project and, by itself, as a recipe file. What each stage
/// does stands with its options; importNet() of meshimport goes through all of them.
struct ImportRecipe {
  std::vector<SourceFile> files;       ///< joined to one mesh in this order; none: made elsewhere
  LengthUnit unit = LengthUnit::Metre; ///< this and the axes: of files that state none themselves
  UpAxis up = UpAxis::Z;
  PatientAxes patientAxes = PatientAxes::None; ///< not None: `up` does not count
  bool ignoreStated = false;                   ///< they hold for all files, whatever these state
  double weldTolerance = 0.0;                  ///< [file unit]; < 0 = not welded
  PolygonSprings polygons = PolygonSprings::Triangulated;
  RepairOptions repair; ///< in the scene's unit [m]
  SupportOptions support;
  MaterialOptions material;
  bool operator==(const ImportRecipe&) const = default;
};

/// The unit and axes of a file that states these.
FileFrame frameOf(const ImportRecipe& recipe, const StatedFrame& stated);

/// Names relative to `folder` become absolute, which they are while a document may still be saved anywhere.
ImportRecipe withAbsoluteNames(ImportRecipe recipe, const std::filesystem::path& folder);
/// Names become relative to `folder`, as a project saved there holds them. @pre absolute names
ImportRecipe withRelativeNames(ImportRecipe recipe, const std::filesystem::path& folder);

/// A recipe file: JSON with "format": "esm-recipe-1" and the keys of a project's "source"; "file" may be
/// absent.
std::string toRecipeJson(const ImportRecipe& recipe);
/// Errors: BadFormat, InvalidValue; detail names `origin` and the JSON path. A project's own "source" is a
/// recipe too: the text of a whole project is taken as well.
Result<ImportRecipe> parseRecipe(std::string_view bytes, const std::string& origin);

/// Errors: InvalidValue, naming the option. What saveProject() and importNet() ask first.
Status checkRecipe(const ImportRecipe& recipe);

} // namespace esm
