// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/mesh_importer.h"

namespace esm {

/// VTK's older format (.vtk), ASCII and binary, versions 1 to 5: POLYDATA and UNSTRUCTURED_GRID. Data on
/// points and cells is passed over; grids, images and rectilinear data are refused by name.
MeshReader vtkReader();

} // namespace esm
