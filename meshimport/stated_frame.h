// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/scene_frame.h"

#include <string_view>

namespace esm {

/// What files of our own readers say of their unit and axes: $INSUNITS of a DXF, and SPACE=LPS or SPACE=RAS,
/// which 3D Slicer puts into the header of an STL, the title of a VTK, the comments of PLY and OBJ and the
/// field data of VTP.
/// @param reader the name of the reader that knows the bytes
StatedFrame statedInText(std::string_view bytes, std::string_view reader);

/// What XML scenes say: <unit> and <up_axis> of COLLADA, the unit of AMF and of a part of a 3MF, <unit> of
/// X3D.
/// @param ending of the format, such as "dae"; others say nothing
StatedFrame statedInXml(std::string_view bytes, std::string_view ending);

/// A unit that is no positive number is none.
void stateMetres(StatedFrame& stated, double metres);

} // namespace esm
