// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/mesh_importer.h"

namespace esm {

/// Gmsh .msh, format 2.2 and 4.1, text and binary of either byte order: lines, triangles, quads and
/// tetrahedra with their tags in any order; see cells.h for the rest. Format 1 and 4.0 are refused with the
/// way out.
MeshReader mshReader();

} // namespace esm
