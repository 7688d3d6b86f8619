// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/mesh_importer.h"

namespace esm {

/// Open Inventor (.iv) and VRML (.wrl) through the Coin library in the worker process; a build without Coin
/// recognises them and says what to do.
MeshReader inventorReader();

} // namespace esm
