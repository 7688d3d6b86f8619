// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/base/work_control.h"
#include "core/geometry/ellipsoid.h"
#include "core/net/spring_net.h"

#include <cstdint>
#include <string>
#include <vector>

namespace esm {

/// What a net gets so that it holds its shape. A surface alone is a skin without anything in it: pressed, it
/// gives way like a bag, whatever its stiffness (docs/IMPORT.md has figures). Everything made here is marked
/// as such (SpringKind::Strut, SpringNet::supportNode, AnchorSet::bandLength, SpringNet::pressure), so that
/// it can be taken away and made anew without touching the rest. The defaults add nothing.
struct SupportOptions {
  /// What goes inside:
  ///
  ///     Struts      from each node of the surface to the opposite wall: along the inward normal, and leaning
  ///     to
  ///                 it on all sides; for walls, tubes and everything that is rather thin
  ///     Hub         spokes from the surface to a few new nodes in the middle, these joined in a row; for fat
  ///     organs Lattice     a body-centred cubic lattice of new nodes, tied to the surface; for fat organs,
  ///     alike everywhere Tetrahedra  by a program in the PATH, tetgen or gmsh; needs a closed, clean surface
  ///     Wall        an inner surface at the wall's thickness, and cells of springs between; for hollow organs
  enum class Interior : std::uint8_t {
    None,
    Struts,
    Hub,
    Lattice,
    Tetrahedra,
    Wall
  } interior = Interior::None;
  int strutsPerNode = 5;  ///< 1 to 16: one along the normal, the others lean; fewer hold less against shear
  double strutLean = 0.6; ///< [rad], of the others against the normal, in [0, 1.4]
  double longestStrut = 0.0;  ///< [m]; longer ones are left out; 0: any length
  int hubs = 0;               ///< 0: as many as the shape asks for
  double latticeCell = 0.0;   ///< edge of a cube [m]; 0: from the surface's edge lengths
  double wallThickness = 0.0; ///< [m], above 0 for Wall (an import without it takes the tissue's)
  int wallLayers =
    0; ///< of cells across the wall, at most 16; 0: so many that cells are about as thick as wide
  std::string program;     ///< for Tetrahedra: "tetgen" or "gmsh"; empty: the first that is there
  double timeLimit = 60.0; ///< [s], for the program

  /// Which nodes of the surface are tied to the cavity around them.
  enum class Anchors : std::uint8_t { None, All, Part } anchors = Anchors::None;
  Ellipsoid anchorPart;       ///< for Part: the nodes inside
  double anchorLength = 0.02; ///< of the bands [m], > 0: k = E A / length, A the surface of the node

  /// Closed surfaces keep their volume by a pressure of this bulk modulus [Pa], see PressureBody; 0: none.
  double bulkModulus = 0.0;

  bool operator==(const SupportOptions&) const = default;
  bool isNone() const noexcept
  {
    return interior == Interior::None && anchors == Anchors::None && bulkModulus == 0.0;
  }
};

/// What was added, and what it costs.
struct SupportReport {
  Index springs = 0, nodes = 0, anchors = 0; ///< added
  Index pressureBodies = 0;                  ///< added
  double shortest = 0.0, longest = 0.0;      ///< of the added springs [m]; 0 without any
  /// Nodes of the surface that got no strut: nothing opposite, or only neighbours.
  std::vector<NodeId> unsupported;
  /// Predicted largest stable step before and after [s]; 0 if the net has no stiffness yet (tissue comes
  /// later).
  double stepBefore = 0.0, stepAfter = 0.0;
  std::vector<std::string> notes; ///< in English, a sentence each
};

/// Takes away the support layer that the net has and makes the one that the options ask for. New springs and
/// nodes have the numbers of buildNet() until tissue writes theirs; in a net that has stiffness already,
/// struts get the median stiffness times length of its springs over their own length, and the median
/// viscosity over stiffness. Springs that are there already are not made twice. Deterministic; any thread.
/// @param control may be null.
/// Errors: InvalidValue (options), EmptyResult (nothing to support, or nothing came out), Unsupported (no
/// program), Numerics (the program failed; the detail says how), Cancelled. `net` is then as before.
Result<SupportReport> addSupport(SpringNet& net, const SupportOptions& options,
                                 WorkControl* control = nullptr);

/// Takes away all that addSupport() made: topology, ids and surface are what they were before, bit for bit.
/// Volumes that setMaterial() shared among the layer's struts go too: set the material anew. @return whether
/// there was anything.
/// @param newOfOld old-to-new map of the nodes; may be null.
bool removeSupport(SpringNet& net, std::vector<Index>* newOfOld = nullptr);

} // namespace esm
