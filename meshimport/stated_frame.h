// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/scene_frame.h"

#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// What files of our own readers say of their unit and axes: $INSUNITS of a DXF, and SPACE=LPS or SPACE=RAS,
/// which 3D Slicer puts into the header of an STL, the title of a VTK and the comments of PLY and OBJ. The
/// readers of VTK and VTP find it in the field data.
/// @param reader the name of the reader that knows the bytes
StatedFrame statedInText(std::string_view bytes, std::string_view reader);

/// What XML scenes say: <unit> and <up_axis> of COLLADA, the unit of AMF and of a part of a 3MF, <unit> of
/// X3D.
/// @param ending of the format, such as "dae"; others say nothing
/// @param notes get a sentence about a unit that is no length
StatedFrame statedInXml(std::string_view bytes, std::string_view ending, std::vector<std::string>& notes);

/// A unit that is no positive number is none.
void stateMetres(StatedFrame& stated, double metres);

/// The array of field data in which 3D Slicer names the axes.
constexpr std::string_view kAxesArray = "SPACE";
void stateAxes(StatedFrame& stated, std::string_view name); ///< "LPS", "RAS"; others say nothing
std::string unreadAxes(const std::string& why);             ///< a note

} // namespace esm
