// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/json_line.h"
#include "core/geometry/mesh_defects.h"
#include "core/geometry/self_intersections.h"

namespace esm::cli {

/// All lists, with places: vertices and triangles by number, coordinates in the file's unit.
JsonLine jsonOfDefects(const MeshDefects& defects, const SelfIntersections& crossings, const Mesh& mesh);

/// For people: a line per defect with its place, the first twenty of each kind.
void printDefects(const MeshDefects& defects, const SelfIntersections& crossings, const Mesh& mesh);

} // namespace esm::cli
