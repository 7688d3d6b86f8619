// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/mesh_importer.h"

namespace esm {

/// VTK's XML formats UnstructuredGrid (.vtu) and PolyData (.vtp): arrays as text, base64 or appended (raw,
/// base64), packed by zlib or not, of either byte order; several pieces become one mesh. Other compressors
/// and data sets are refused.
MeshReader vtuReader();

} // namespace esm
