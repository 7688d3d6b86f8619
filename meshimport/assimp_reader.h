// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/mesh_importer.h"

namespace esm {

/// Every other format that the assimp library reads: glTF, FBX, COLLADA, 3DS, DXF, X3D, ... No
/// post-processing of assimp's (its joining has a tolerance of its own and its triangulation makes hubs):
/// node transforms, polygons and ranges are done here. Coordinates are float32 by nature of the library.
/// `origin` must be the file's path: companions (.bin, .mtl) are looked for in its folder and nowhere else.
MeshReader assimpReader();

} // namespace esm
