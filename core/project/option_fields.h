// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/repair/repair.h"
#include "core/project/import_recipe.h"

namespace esm {

/// The options of an import, each named once: for the file, the command line and whoever else goes through
/// them. A visitor has
///     flag(key, bool&, help)
///     count(key, Index&, help)                  0 or more
///     number(key, double&, unit, help)          0 or more, finite
///     choice(key, Enum&, words, help)           words[i] names Enum(i)
///     text(key, std::string&, help)
///     ellipsoid(key, Ellipsoid&, help)
/// Keys are those of the file; on the command line '_' becomes '-'. `Options` may be const.

template <class Options, class Visitor>
void visitRepairOptions(Options& options, Visitor&& visit)
{
  visit.flag("remove_useless", options.removeUseless,
             "take away degenerate and duplicate faces and unused vertices");
  visit.flag("close_t_junctions", options.closeTJunctions, "tie vertices to the edges on which they lie");
  visit.number("t_junction_tolerance", options.tJunctionTolerance, "m",
               "how near a vertex must be to an edge (0: 1e-5 of the size)");
  visit.count("drop_parts_below", options.dropPartsBelow, "take away parts with fewer elements");
  visit.number("drop_parts_share", options.dropPartsShare, "",
               "take away parts with fewer elements than this share of the largest, 0 to 1");
  visit.count("fill_holes", options.fillHolesUpTo, "close holes of at most so many edges");
  visit.number("fill_holes_length", options.fillHolesLength, "m",
               "only holes with a rim of at most this length");
  visit.flag("unify_orientation", options.unifyOrientation,
             "turn faces until neighbours agree and closed parts look outwards");
  visit.count("triangles", options.triangles, "remesh to about so many nearly equilateral triangles");
  visit.number("edge_length", options.edgeLength, "m", "remesh to about this edge length");
}

inline constexpr const char* kInteriorNames[] = {"none", "struts", "hub", "lattice", "tetrahedra", "wall"};
inline constexpr const char* kAnchorNames[] = {"none", "all", "part"};

template <class Options, class Visitor>
void visitSupportOptions(Options& options, Visitor&& visit)
{
  visit.choice("interior", options.interior, kInteriorNames, "what holds the shape from inside");
  visit.count("struts_per_node", options.strutsPerNode, "struts from each node of the surface, 1 to 16");
  visit.number("strut_lean", options.strutLean, "rad", "how far all struts but one lean, 0 to 1.4");
  visit.number("longest_strut", options.longestStrut, "m", "no longer struts (0: any length)");
  visit.count("hubs", options.hubs, "nodes in the middle (0: as many as the shape asks for)");
  visit.number("lattice_cell", options.latticeCell, "m", "edge of a lattice cube (0: from the surface)");
  visit.number("wall_thickness", options.wallThickness, "m",
               "for the wall (0: that of the material or tissue)");
  visit.count("wall_layers", options.wallLayers,
              "of cells across the wall, up to 16 (0: from the surface's edges)");
  visit.text("program", options.program, "for tetrahedra: tetgen or gmsh (default: the first that is there)");
  visit.number("time_limit", options.timeLimit, "s", "for that program");
  visit.choice("anchors", options.anchors, kAnchorNames, "nodes tied to the cavity around them");
  visit.ellipsoid("anchor_part", options.anchorPart, "for anchors part: the nodes in this ellipsoid");
  visit.number("anchor_length", options.anchorLength, "m", "length of the bands to the cavity");
  visit.number("bulk_modulus", options.bulkModulus, "Pa",
               "closed surfaces keep their volume by a pressure of this bulk modulus (0: none)");
}

inline constexpr const char* kBodyNames[] = {"wall", "solid"};
inline constexpr const char* kEdgeFormulaNames[] = {"van_gelder", "regular"};

template <class Options, class Visitor>
void visitMaterialOptions(Options& options, Visitor&& visit)
{
  visit.choice("body", options.body, kBodyNames,
               "wall: mass = density thickness area; solid: density volume of the closed surface");
  visit.number("thickness", options.thickness, "m", "of the wall (0: as the tissue says)");
  visit.number("density", options.density, "kg/m^3", "sets the rules' inputs (0: as the tissue says)");
  visit.number("youngs_modulus", options.youngsModulus, "Pa",
               "sets the rules' inputs and fits the springs to it (0: as the tissue says)");
  visit.flag("fit_modulus", options.fitModulus,
             "scale the springs until the net is as stiff as the body by the tissue's Young's modulus");
  visit.choice("edges", options.edges, kEdgeFormulaNames, "how triangles make springs stiff");
}

/// All of a recipe's groups. No key stands in two of them.
template <class Recipe, class Visitor>
void visitRecipeOptions(Recipe& recipe, Visitor&& visit)
{
  visitRepairOptions(recipe.repair, visit);
  visitSupportOptions(recipe.support, visit);
  visitMaterialOptions(recipe.material, visit);
}

} // namespace esm
