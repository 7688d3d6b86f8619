// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/mesh_importer.h"

namespace esm {

/// DXF as text: LINE, 3DFACE, LWPOLYLINE with its elevation, POLYLINE in the plane, in space, as a mesh or of
/// faces, open or closed, and what an INSERT places, turned and scaled (blocks in blocks to a depth of 16).
/// Entity coordinates become world ones by the arbitrary-axis rule (AutoCAD DXF reference). Arcs of polylines
/// become their chords; circles, texts and solids are passed over; both is said. Binary DXF is refused.
MeshReader dxfReader();

} // namespace esm
