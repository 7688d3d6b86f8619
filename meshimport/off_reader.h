// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/mesh_importer.h"

namespace esm {

/// OFF as text, with its variants for colours and normals (COFF, NOFF, STOFF, ...). Faces with two
/// corners are lines. Counts are held against the file's size before memory is taken.
MeshReader offReader();

} // namespace esm
