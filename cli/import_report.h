// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/json_line.h"
#include "core/geometry/mesh_report.h"
#include "core/support/material.h"
#include "core/support/net_cost.h"

/// What `esm import` and `esm inspect` tell of meshes and of what becomes of them.
namespace esm::cli {

/// The counts of a mesh under the keys of `esm inspect --json`.
void addMeshReport(JsonLine& line, const MeshReport& report);
JsonLine meshReportJson(const MeshReport& report);

/// "nodes", "springs", "shortest_spring" [m], "stable_step" [s]
void addCost(JsonLine& line, const NetCost& cost);
JsonLine costJson(const NetCost& cost);

/// {"volume", "wall_area", "modulus_scale", "measured_stiffness"}
JsonLine materialJson(const MaterialReport& report);

} // namespace esm::cli
