// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/project/project.h"

#include <string>
#include <vector>

namespace esm {

/// A project whose net came in anew, with what could be carried over.
struct Reimported {
  Project project;
  Index unchanged = 0, added = 0, gone = 0; ///< nodes
  std::vector<std::string> notes;           ///< what could not be carried over, one sentence each
};

/// Puts a net that its mesh files gave anew in the place of a project's. Tissue, regions, simulation and view
/// stay and the tissue is applied; fixed nodes, loads, velocities, mass damping and tension-only flags go to
/// the nodes and springs that they had, which keep their ids. A node is the same if it lies at the same
/// place, bit for bit; or if it has the same number, where both nets have the same springs and triangles in
/// the same order, or as many nodes of which most have kept place and number: the mesh was then only
/// deformed. New nodes and springs get ids that were never used. Errors: InvalidValue if the project's net
/// did not come from mesh files, or as applyTissue().
Result<Reimported> reimport(const Project& before, SpringNet net, ImportRecipe recipe);

} // namespace esm
