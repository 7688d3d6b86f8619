// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/mesh_importer.h"

namespace esm {

/// RAW triangles: text with the nine coordinates of a triangle in each line, in no unit and without any
/// header. With twelve numbers a line is a quad (as Blender writes it) or a colour and a triangle (as
/// POV-Ray's tools do). Names of objects may stand between, names of textures behind.
MeshReader rawReader();

} // namespace esm
