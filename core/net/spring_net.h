// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/types.h"
#include "core/geometry/mesh.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace esm {

/// How a spring answers its extension e [m] at rest length L [m] with the tension f [N]:
///
///     Linear       f = k e
///     Cubic        f = k e (1 + a (e/L)^2)
///     Exponential  f = k L/b (exp(b e/L) - 1)        stiffening of tissue, as in Fung's law
///     Table        f = k L g(e/L)                    g piecewise linear, see ForceTable
///
/// a, b [1] are SpringNet::lawParameter. b = 0 is the linear law, the limit of the exponential one.
enum class SpringLaw : std::uint8_t { Linear, Cubic, Exponential, Table };

/// A measured curve g(strain): strictly rising strains, at least two points. Beyond the ends the end
/// slopes go on. Scaled by k L, so one curve serves springs of every length and stiffness.
struct ForceTable {
  std::vector<double> strain; ///< e/L [1]
  std::vector<double> force;  ///< f/(k L) [1]
  bool operator==(const ForceTable&) const = default;
};

/// Where a spring comes from; tissue gives each kind its stiffness in its own way. From Strut on they belong to
/// the support layer (core/structure/support.h): nothing else makes them, so that they can be taken away again.
///
///     Strut         from wall to wall, to a hub, of a lattice or of tetrahedra
///     WallEdge      of a wall: edge of an inner sheet
///     WallDiagonal  second diagonal of two triangles that make a quad, in the surface or an inner sheet
///     WallAcross    from a node to that below it
///     WallBrace     from a node to those below its neighbours
enum class SpringKind : std::uint8_t { Edge, Line, Strut, WallEdge, WallDiagonal, WallAcross, WallBrace };
inline constexpr int kSpringKindCount = 7;
inline constexpr bool isOfSupport(SpringKind kind) noexcept
{
  return kind >= SpringKind::Strut;
}

/// How the area of a triangle of side lengths L counts for the stiffness of its edges:
///
///     VanGelder  its own area (Van Gelder 1998)
///     Regular    that of an equilateral triangle over the edge, sqrt(3)/4 L^2 (Lloyd, Szekely and Harders
///     2007)
enum class EdgeFormula : std::uint8_t { VanGelder, Regular };

/// How geometry makes springs from a tissue's Young's modulus, see core/structure/material.h.
struct NetMaterial {
  EdgeFormula edges = EdgeFormula::VanGelder;
  double modulusScale = 1.0; ///< every spring's stiffness is multiplied by it [1], > 0
  bool operator==(const NetMaterial&) const = default;
};

/// Springs that hold nodes to fixed points in space (the cavity), alike in all directions:
/// force on the node = -k (p - p0) - c v. A node may have none or several.
struct AnchorSet {
  std::vector<Index> node;             ///< A
  Eigen::Matrix3Xd point;              ///< 3 x A, p0 [m]
  Eigen::ArrayXd stiffness, viscosity; ///< A [N/m], A [N s/m]; all >= 0
  /// A [m]; size 0: all 0. Above 0 the anchor belongs to the support layer, and stands for bands of that
  /// length between the node's share of the surface and the cavity; 0: tissue's own bed.
  Eigen::ArrayXd bandLength = {};
  bool isBand(Index anchor) const noexcept { return bandLength.size() > 0 && bandLength[anchor] > 0.0; }
  Index count() const noexcept { return static_cast<Index>(node.size()); }
};

/// A closed surface that keeps its volume V: a change of it meets the pressure
///
///     p = - K (V/V0 - 1)
///
/// on all its nodes, V0 the volume at rest. For organs that are filled, and for tissue, which is mostly
/// water. Made by the support layer, and taken away with it.
struct PressureBody {
  TriangleMatrix triangles; ///< normals outwards; each edge has two triangles, one to either side
  double bulkModulus = 0.0; ///< K [Pa], > 0
  bool operator==(const PressureBody& other) const
  {
    return bulkModulus == other.bulkModulus && triangles.cols() == other.triangles.cols() &&
           triangles == other.triangles;
  }
};

struct SpringNet;
/// Of the springs' rest lengths [m]; 0 without springs.
double medianRestLength(const SpringNet& net);

/// The most nodes that a net may have: passes tell their places in bytes, with 32 bits.
inline constexpr Index kMostNetNodes = 1 << 27;

/// Topology and parameters of a spring-mass net, one array per property (struct of arrays).
/// Plain data: copyable, no pointers, no locks. While a simulation runs it works on its own copy.
/// checkNet() says whether the arrays fit together; everything downstream may assume that they do.
struct SpringNet {
  // === Nodes (N)
  Eigen::Matrix3Xd restPosition;    ///< 3 x N, position at t = 0 [m]
  Eigen::Matrix3Xd initialVelocity; ///< 3 x N [m/s]; 3 x 0 means all at rest
  Eigen::ArrayXd mass;              ///< N [kg], > 0
  Eigen::ArrayXd massDamping;       ///< N [1/s], force -alpha m v; size 0 means none
  std::vector<std::uint8_t> fixed;  ///< N, 1 = does not move
  std::vector<NodeId> nodeId;       ///< N, distinct
  /// N [m^3], the tissue that a node carries if that is not the wall around it; 0 or size 0: the wall's.
  Eigen::ArrayXd volume;
  std::vector<std::uint8_t> supportNode; ///< N, 1 = made by the support layer; size 0 means none

  // === Springs (S)
  SegmentMatrix ends;                    ///< 2 x S, node indices (a, b), a != b
  Eigen::ArrayXd restLength;             ///< S [m], >= 0 (the nonlinear laws need > 0)
  Eigen::ArrayXd stiffness, viscosity;   ///< S [N/m], S [N s/m]; all >= 0
  std::vector<SpringLaw> law;            ///< S
  Eigen::ArrayXd lawParameter;           ///< S, a or b [1]; for Table the index into `tables`
  std::vector<std::uint8_t> tensionOnly; ///< S, 1 = slack while e <= 0: neither elastic nor viscous force
  std::vector<SpringKind> kind;          ///< S
  std::vector<SpringId> springId;        ///< S, distinct
  /// S [m^2], of the tissue that a spring stands for: k = E section / length; 0 or size 0: by applyTissue()'s
  /// formula for its kind.
  Eigen::ArrayXd section;
  std::vector<ForceTable> tables;

  AnchorSet anchors;
  TriangleMatrix triangles; ///< 3 x F, the surface: for shading, dual areas and contact
  NetMaterial material;
  std::vector<PressureBody> pressure; ///< empty: nothing keeps its volume

  Index nodeCount() const noexcept { return static_cast<Index>(restPosition.cols()); }
  Index springCount() const noexcept { return static_cast<Index>(ends.cols()); }
  Index triangleCount() const noexcept { return static_cast<Index>(triangles.cols()); }
  bool isSupportNode(Index node) const noexcept
  {
    return !supportNode.empty() && supportNode[static_cast<std::size_t>(node)] != 0;
  }
  double sectionOf(Index spring) const noexcept { return section.size() > 0 ? section[spring] : 0.0; }
  double volumeOf(Index node) const noexcept { return volume.size() > 0 ? volume[node] : 0.0; }
  /// Of a spring at rest [m]: where it is, for regions and questions.
  Eigen::Vector3d middleOf(Index spring) const
  {
    return 0.5 * (restPosition.col(ends(0, spring)) + restPosition.col(ends(1, spring)));
  }
};

} // namespace esm
