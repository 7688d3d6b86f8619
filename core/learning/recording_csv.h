// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/learning/recording.h"

#include <string>
#include <string_view>

namespace esm::learning {

/// What numbers of a file are in.
struct RecordingUnits {
  double length = 1.0; ///< m in one unit of length
  double force = 1.0;  ///< N in one unit of force
};

/// Reads one recording from a table (CsvReader says which dialects):
///
///     what      node   x   y   z     vx   vy   vz   sd
///     marker    12                   0.01 0.02 0.03          node 12 was seen there
///     marker           0.0 0.1 0.2   0.01 0.1  0.2  0.001    so was what is at (x, y, z) at rest, sd 1 mm
///     force     3                    0    0    -0.2          on node 3
///     move      7                    0    0    0.01          node 7 is held there, that far from its rest
///     gravity                        0    0    -9.81
///
/// Columns may stand in any order; node or x, y, z may be missing altogether, sd too. Both given are held against each
/// other. Empty vx, vy, vz of a marker: not seen. Markers off the nodes are tied to the nearest point of the surface.
///
/// Named before anything is learned: places in another unit, mirrored or exchanged axes, another origin, exchanged ids,
/// markers further than half an edge off the net, the same node twice.
/// Errors: BadFormat, InvalidValue; "file:line: ..." where a line is at fault.
Result<Recording> readRecordingCsv(std::string_view bytes, const std::string& fileName, const SpringNet& net,
                                   const RecordingUnits& units = {});

/// The same as text, markers by node id; what was not seen is left out.
std::string recordingCsv(const Recording& recording, const SpringNet& net);

/// Whether forces have the unit that they are taken for: if the net, pushed softly, would have to be a hundred and more
/// times softer or stiffer to move as was seen, the forces are in another. Errors: InvalidValue.
Status checkForceUnit(const Recording& recording, const SpringNet& net);

} // namespace esm::learning
