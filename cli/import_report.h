// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/json_line.h"
#include "core/geometry/mesh_report.h"
#include "core/structure/net_cost.h"
#include "meshimport/net_import.h"

/// What `esm import` and `esm inspect` tell of meshes and of what becomes of them.
namespace esm::cli {

/// The counts of a mesh under the keys of `esm inspect --json`.
JsonLine meshReportJson(const MeshReport& report);

/// "nodes", "springs", "shortest_spring" [m], "stable_step" [s]
void addCost(JsonLine& line, const NetCost& cost);

/// "before" and "after" of the mesh, "material" if it concerned the net, "cost" (with "memory_bytes" at the peak of
/// `esm simulate`) and "notes".
void addImported(JsonLine& line, const ImportedNet& imported, const NetCost& cost);

/// "80 x 42 x 40 mm"
std::string sizeInMillimetres(const Eigen::Vector3d& extent);

/// Of the box around the nodes [m].
Eigen::Vector3d sizesOf(const SpringNet& net);

/// Says so if a net has not the size of what hands and instruments work on: most often the unit is another
/// one.
void warnOfSize(const std::string& file, const ImportedNet& imported);

} // namespace esm::cli
