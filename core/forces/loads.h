// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/types.h"

#include <Eigen/Core>

#include <optional>
#include <utility>
#include <vector>

namespace esm {

/// A vector over time, piecewise linear; before the first and after the last time the end value holds.
struct VectorCurve {
  std::vector<double> time; ///< [s], rising (equal neighbours make a jump: the later value holds)
  Eigen::Matrix3Xd value;   ///< 3 x time.size()

  Eigen::Vector3d at(double t) const;
  /// Slope d value/dt at t, from the right at a corner; 0 outside the times.
  Eigen::Vector3d slopeAt(double t) const;
};

/// The same force [N] on each of the listed nodes.
struct NodalForce {
  std::vector<Index> nodes;
  VectorCurve force; ///< [N]
};

/// The listed nodes are at initial position + displacement(t) until `release`; at that instant they become
/// free with the position and velocity they have. No release: moved to the end.
struct PrescribedMotion {
  std::vector<Index> nodes;
  VectorCurve displacement;      ///< [m]
  std::optional<double> release; ///< [s]
};

/// All that acts on a net from outside, besides anchors and tools.
struct Loads {
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero(); ///< [m/s^2]
  std::vector<NodalForce> forces;
  std::vector<PrescribedMotion> motions;
};

/// What acts on a part of a net. @param placeOf(node)  where a node is in it, kNoIndex if it is not.
template <class PlaceOf>
Loads loadsOnPart(const Loads& loads, const PlaceOf& placeOf)
{
  const auto placesOf = [&placeOf](const std::vector<Index>& nodes) {
    std::vector<Index> places;
    for (const Index node : nodes)
      if (const Index place = placeOf(node); place != kNoIndex) places.push_back(place);
    return places;
  };
  Loads part;
  part.gravity = loads.gravity;
  for (const NodalForce& force : loads.forces)
    if (std::vector<Index> places = placesOf(force.nodes); !places.empty())
      part.forces.push_back({std::move(places), force.force});
  for (const PrescribedMotion& motion : loads.motions)
    if (std::vector<Index> places = placesOf(motion.nodes); !places.empty())
      part.motions.push_back({std::move(places), motion.displacement, motion.release});
  return part;
}

/// A spring-damper between a node and a hand-held point: the pull tool. Not part of the net; may come,
/// move and go between steps. Force on the node = k (target - p) + c (targetVelocity - v).
struct ToolSpring {
  Index node = kNoIndex;
  Eigen::Vector3d target = Eigen::Vector3d::Zero();         ///< [m]
  Eigen::Vector3d targetVelocity = Eigen::Vector3d::Zero(); ///< [m/s]
  double stiffness = 0.0;                                   ///< [N/m]
  double viscosity = 0.0;                                   ///< [N s/m]
  /// Whether the target itself goes on with its velocity, from Simulation::setTools() to the next one. Else it stays,
  /// and the velocity is the damper's alone.
  bool moves = false;

  bool isLed() const noexcept { return moves && !targetVelocity.isZero(0.0); }
  bool operator==(const ToolSpring&) const = default;
};

} // namespace esm
