// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/project/json_tree.h"
#include "core/project/project.h"

/// A project as the tree that its file holds. Internal to core/project.
namespace esm::json {

Json treeOf(const Project& project);
/// All but the keys "geometry" and "net": what is small, however large the net.
Json treeWithoutNet(const Project& project);
void addNet(Json& tree, const SpringNet& net); ///< these two keys
/// Errors: as parseProject().
Result<Project> readProject(const Json& tree, const std::string& origin);
/// The same of treeWithoutNet(), for a net of so many nodes.
Result<Project> readWithoutNet(const Json& tree, Index nodes, const std::string& origin);

} // namespace esm::json
