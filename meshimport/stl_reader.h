// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/mesh_importer.h"

namespace esm {

/// STL, binary and ASCII, told apart by content: the bare word `solid` at the start proves nothing, but
/// 84 + 50 n bytes do. ASCII in upper or lower case, several solids, faces of more than three corners.
/// A file that ends early is an error; bytes behind the last binary facet are noted. Three vertices of its
/// own per facet: weld afterwards.
MeshReader stlReader();

} // namespace esm
