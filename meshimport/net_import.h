// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/net/spring_net.h"
#include "core/project/import_recipe.h"
#include "meshimport/mesh_importer.h"

namespace esm {

/// The way from mesh files to a net, as a recipe says it:
///
///     files -> one mesh -> weld -> metres, z up -> repair -> net -> support -> material
///
/// readMeshes() goes as far as the weld, which is what takes long and what changes least; makeNet() goes the
/// rest of the way, so that a dialog reads once and shows what each choice makes of it.

/// One file of a recipe, as it was read.
struct ReadFile {
  std::string name;                ///< as in the recipe
  std::string format;              ///< "OBJ", "STL (binary)", ...
  StatedFrame stated;              ///< unit and axes, as far as the file states them
  std::vector<Index> vertexOfFile; ///< vertex of the file -> vertex of MeshSource::mesh
};

/// All files of a recipe in one mesh, in the files' unit and axes. Files of which one states another frame
/// than the next are brought into the scene's before they are joined.
struct MeshSource {
  ImportRecipe recipe;    ///< with the fingerprints of what was read
  Mesh mesh;              ///< welded if the recipe says so
  MeshReport report;      ///< of `mesh`
  EdgeList edges;         ///< of `mesh`
  StatedFrame stated;     ///< by the files about `mesh`
  bool isInScene = false; ///< `mesh` is, with the frame of `recipe`
  std::vector<ReadFile> files;
  std::vector<std::string> notes; ///< one sentence each; with several files each names its own

  /// The frame of `mesh` if this recipe is followed.
  FileFrame frame(const ImportRecipe& other) const;
  /// Whether makeNet() can follow the frame of this recipe without reading again.
  bool serves(const ImportRecipe& other) const;
};

/// A net with its story. Tissue has still to give it its numbers (applyTissue()).
struct ImportedNet {
  ImportRecipe recipe; ///< with fingerprints
  SpringNet net;
  MeshReport before, after; ///< of the mesh in the scene [m], before and after repair
  RepairReport repair;
  SupportReport support;
  MaterialReport material; ///< nothing in it unless the recipe's material concerns the net
  std::vector<ReadFile> files;
  std::vector<std::vector<Index>> nodeOfFile; ///< for each file: its vertex -> node, or kNoIndex
  std::vector<std::string> notes;
};

/// One sentence of what a file states and what the recipe makes of it; empty if it states nothing.
std::string frameNote(const StatedFrame& stated, const ImportRecipe& recipe);

/// @param folder where relative names of the recipe start.
/// Thread: any. Errors: as importMesh(), and InvalidValue for an impossible recipe; Cancelled within 100 ms.
Result<MeshSource> readMeshes(const ImportRecipe& recipe, const std::filesystem::path& folder,
                              WorkControl* control = nullptr);

/// @param source is moved here by who needs it no longer.
/// @param recipe tells unit, axes, repair and what follows; its files and weld are those of `source`.
/// @param thickness of the wall [m], which the fit of the material takes: that of tissueOf(recipe.material).
/// Errors: as repairMesh(), buildNet(), addSupport() and setMaterial(), with the name of the first file;
/// Cancelled.
Result<ImportedNet> makeNet(MeshSource source, const ImportRecipe& recipe, double thickness,
                            WorkControl* control = nullptr);

/// Both. The same recipe and files give the same net, bit for bit.
Result<ImportedNet> importNet(const ImportRecipe& recipe, const std::filesystem::path& folder,
                              double thickness, WorkControl* control = nullptr);

/// The names of the files whose bytes are not those that the recipe knows, and of those without a
/// fingerprint. Errors: FileUnreadable.
Result<std::vector<std::string>> changedFiles(const ImportRecipe& recipe,
                                              const std::filesystem::path& folder);

} // namespace esm
