// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/grouped.h"
#include "core/tissue/tissue_model.h"

#include <cstdint>
#include <vector>

namespace esm {

/// Where tissue is asked for, and what the net's geometry makes of it. A place is a spring's midpoint (0 to
/// S - 1) or a node (S to S + N - 1), at rest.
struct DerivationPlaces {
  explicit DerivationPlaces(const SpringNet& net);
  /// Sections depend on the wall's thickness, which can be edited.
  void setThickness(double thickness, const SpringNet& net);

  Index springs = 0, nodes = 0;
  Eigen::Matrix3Xd point;         ///< 3 x (S + N) [m]
  Eigen::ArrayXd dualArea;        ///< per node [m^2]
  Eigen::ArrayXd edgeArea;        ///< per spring [m^2]
  Eigen::ArrayXd perModulus;      ///< per spring, k / E [m]
  Eigen::ArrayXd section;         ///< per spring of those that carry mass, else 0 [m^2]
  std::vector<Index> loose;       ///< nodes off the surface, ascending
  Grouped<Index> looseSprings;    ///< by place in `loose`: the springs whose mass they share
  std::vector<Index> looseOfNode; ///< place in `loose`, kNoIndex on the surface; empty without loose nodes
};

/// The places that a region's weight is above 0 at, ascending.
struct Reach {
  std::vector<Index> place;
  std::vector<double> weight; ///< in (0, 1]
};
Reach reachOf(const RegionShape& shape, const Eigen::Matrix3Xd& points);

/// Marks for an edit of the region list: `touched` is 1 where what lies below has changed (the base tissue:
/// everywhere or nowhere); afterwards where the blend of all has changed. Call for regions from the bottom
/// up.
void markAll(const Reach& reach, std::vector<std::uint8_t>& touched);
/// A region as it was: it hides changes below where its weight is 1.
void hideUnder(const Reach& reach, std::vector<std::uint8_t>& touched);
/// A region that has moved but kept its parameters.
void markMoved(const Reach& before, const Reach& after, std::vector<std::uint8_t>& touched);

} // namespace esm
