// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/mesh.h"
#include "core/project/project.h"

namespace esm::test {

/// A flat sheet of n x n vertices, 10 mm apart, in the xy plane [m].
Mesh sheetMesh(Index n);

/// The sheet with the default tissue applied: what a fresh import saves.
Project sheetProject(Index n = 8);

} // namespace esm::test
