// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/contact/static_compliance.h"
#include "core/geometry/deforming_surface.h"
#include "core/geometry/edge_table.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace esm {

/// What a ball presses on around its contact point: nodes and the share of the force that each of them takes.
struct PressedArea {
  NodeCombination nodes;
  double rise = 0.0; ///< of the contact point over the nodes' mean, along its normal; all at rest [m]
};

/// Finds the area that a ball presses on: the pressure of Hertz's contact, sqrt(1 - s^2) of the area's radius,
/// shared among the nodes as each triangle shares a load on it.
///
///       \ | /      rays from the contact point over the surface, seen along its normal;
///      --(c)--     on each of them points of equal force, on a triangle each
///       / | \      (12 to 96 rays, by how fine the mesh is)
///
/// So the area is the same on every mesh. A load on triangles is wider than itself by what they are wide; by as
/// much it is taken narrower, and where one triangle is as wide as the area it is a single point, shared by the
/// three corners. A ray and its opposite end together, where the surface ends, turns away or is as far as the
/// radius: the mean of all points has the contact point above it, so that a force along the normal turns nothing.
/// All is measured on the net at rest, for a share that changes with the tissue's motion would give energy.
/// @note One thread.
class PressAreaFinder {
public:
  /// @param edges  of the net's triangles. @param position  at rest, 3 x N [m].
  PressAreaFinder(const TriangleMatrix& triangles, const Eigen::Matrix3Xd& position, const EdgeTable& edges,
                  double radius);

  double radius() const noexcept { return m_radius; } ///< [m]
  /// @param normal  of the surface at the point, at rest; unit.
  /// @param area  its first nodes are the corners of the triangle. No allocation once it is large enough.
  void find(const SurfacePoint& point, const Eigen::Vector3d& normal, PressedArea& area);

private:
  struct Corner {
    Eigen::Vector2d across; ///< from the contact point, seen along the normal [m]
    double height;          ///< over it [m]
  };
  /// Where a ray crosses a triangle: from one point of its rim to another.
  struct Piece {
    Index triangle = kNoIndex;
    double from = 0.0, to = 0.0; ///< along the ray [m]
    Eigen::Vector3d enters = Eigen::Vector3d::Zero(),
                    leaves = Eigen::Vector3d::Zero(); ///< its corners' weights
  };
  struct Ray {
    std::vector<Piece> pieces;
    double length = 0.0; ///< as far as it goes [m]
  };
  Corner corner(Index node) const;
  void walk(const SurfacePoint& point, const Eigen::Vector2d& direction, Ray& ray) const;
  template <class Visit>
  void sample(const Ray& ray, double length, const Visit& visit) const;
  double spread() const;

  TriangleMatrix m_triangles;
  Eigen::Matrix3Xd m_position;
  std::vector<Index> m_neighbour; ///< across side k of triangle t at 3 t + k, kNoIndex at the rim
  double m_radius;
  struct Ring {
    double distance; ///< of its points from the middle, of the radius [1]
    double share;    ///< of the force for each of them [1]
  };
  std::vector<Ring> m_rings;
  std::vector<Eigen::Vector2d> m_ways; ///< of the rays; one and its opposite after each other
  std::vector<Ray> m_rays;
  std::vector<double> m_share; ///< by node, zero between calls
  Eigen::Vector3d m_centre, m_normal, m_right, m_up;
};

} // namespace esm
