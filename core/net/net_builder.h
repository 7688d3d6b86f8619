// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/base/work_control.h"
#include "core/geometry/edge_table.h"
#include "core/geometry/mesh.h"
#include "core/net/spring_net.h"

#include <optional>

namespace esm {

/// Sizes all node arrays for n nodes and all spring arrays for s springs: mass 1, free, zero stiffness,
/// linear law, ids = indices. No anchors, no triangles.
void resizeNet(SpringNet& net, Index nodes, Index springs);

/// The paper's conversion (section 4): vertices become nodes, unique triangle edges and line segments
/// become springs. Edges come first, each with kind Edge, in the order of first appearance over the
/// triangles; then the segments that are no edge yet, with kind Line. Rest lengths are the distances;
/// mass 1 kg, stiffness 0: tissue gives them their values.
/// Degenerate and duplicate triangles add no surface twice: triangles with two equal corners or a
/// non-finite vertex, and later duplicates, are left out of `triangles`; zero-length springs are kept out.
/// Tetrahedra give their edges as springs and their boundary as the surface, if the mesh has none; sections
/// and volumes make a solid of them, see solid_net.h. Isolated and non-finite vertices are left out of the
/// net; `nodeOfVertex` says where each went.
/// @param nodeOfVertex old-to-new map, kNoIndex for a vertex that is left out; may be null.
/// @param mesh, edges who needs them no longer moves them here, and they become the net without a copy.
/// @param edges listEdges(mesh), if the caller has them already.
/// Errors: EmptyResult if no spring comes out, InvalidValue for an index out of range, Cancelled.
Result<SpringNet> buildNet(Mesh mesh, std::vector<Index>* nodeOfVertex = nullptr,
                           WorkControl* control = nullptr, std::optional<EdgeList> edges = {});

/// Whether the arrays fit together and hold possible numbers: shapes, indices in range, a != b, finite,
/// mass > 0, rest lengths > 0 where the law divides by them, tables strictly rising. The detail names the
/// first culprit
/// ("spring 12 (id 12): stiffness is -3 N/m, it must be >= 0").
Status checkNet(const SpringNet& net);

/// Area of the surface that belongs to each node: a third of each adjoining triangle. N [m^2].
Eigen::ArrayXd nodeDualAreas(const SpringNet& net);

/// For each spring the area of its adjoining triangles, each as the net's EdgeFormula counts it. S [m^2]; 0
/// for lines.
Eigen::ArrayXd edgeTriangleAreas(const SpringNet& net);

} // namespace esm
