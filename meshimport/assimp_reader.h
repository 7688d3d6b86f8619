// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/mesh_importer.h"

namespace esm {

/// Every other format that the assimp library reads: glTF, FBX, COLLADA, 3DS, X3D, ... The library works in a
/// process of its own (worker/worker_process.h), since it crashes and hangs on damaged files and heeds no
/// wish to stop. `origin` must be the file's path: the worker reads it, and companions (.bin, .mtl) in its
/// folder.
MeshReader assimpReader();

} // namespace esm
