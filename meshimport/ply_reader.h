// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/mesh_importer.h"

namespace esm {

/// PLY, ASCII and binary of both byte orders, all scalar types. Read are x y z of `vertex`, the list
/// vertex_indices (or vertex_index) of `face` and vertex1 vertex2 of `edge`; other properties and
/// elements are passed over. Counts in the header are held against the file's size before memory is taken.
MeshReader plyReader();

} // namespace esm
