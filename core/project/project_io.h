// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/project/project.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace esm {

/// `.esm`: one JSON document (docs/FILE_FORMAT.md, docs/project.schema.json); `.esmb`: the same as CBOR.
/// Equal projects give equal bytes; numbers round-trip bit for bit. Any thread.

std::string toJson(const Project& project);
std::string toCbor(const Project& project);

/// Reads either encoding (the content decides), or the plain net formats esm-net-1 and Xsp 3.0. All or
/// nothing, and what comes out has passed checkNet(), checkRuleBase() and the rest: it can be simulated.
/// Errors: BadFormat, InvalidValue (detail: file, JSON path, what), NewerVersion.
/// @param origin name for messages, usually the path.
Result<Project> parseProject(std::string_view bytes, const std::string& origin);

/// Whether a project is one that parseProject() would take: net, loads, rule base, inputs and regions fit
/// together. The detail names the culprit; saveProject() asks this first, so what is saved can be opened.
Status checkProject(const Project& project);

Result<Project> loadProject(const std::filesystem::path& path);
/// Atomic; the previous version stays as `.bak`. `.esmb` writes CBOR, everything else JSON.
Status saveProject(const Project& project, const std::filesystem::path& path);

} // namespace esm
