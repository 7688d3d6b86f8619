// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/mesh_importer.h"

namespace esm {

/// Wavefront OBJ: `v`, `f` (v, v/t, v//n, v/t/n; any number of corners) and `l` polylines, with negative
/// indices, comments after statements, lines joined by a backslash, a byte-order mark and any line end.
/// A corner may name a vertex that comes later. `f` with two corners is read as a line. Vertices keep the
/// order of the file. Points, curves and free-form surfaces are passed over and noted.
MeshReader objReader();

} // namespace esm
