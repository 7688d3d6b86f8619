// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/forces/loads.h"
#include "core/net/spring_net.h"

#include <array>
#include <string>
#include <vector>

namespace esm::learning {

/// A place on a net: a node, or a point of a triangle or segment by shares of its corners.
struct Marker {
  std::array<Index, 3> node = {kNoIndex, kNoIndex, kNoIndex}; ///< kNoIndex from the first that is not used
  std::array<double, 3> share = {1.0, 0.0, 0.0};              ///< sum 1
  static Marker ofNode(Index node) { return {{node, kNoIndex, kNoIndex}, {1.0, 0.0, 0.0}}; }
  /// Where it is, if placeOf(node) is where a node is.
  template <class PlaceOf>
  Eigen::Vector3d at(const PlaceOf& placeOf) const
  {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < node.size() && node[k] != kNoIndex; ++k) place += share[k] * placeOf(node[k]);
    return place;
  }
};
/// The places of a net's nodes at rest, for Marker::at().
inline auto restOf(const SpringNet& net)
{
  return [&net](Index node) -> Eigen::Vector3d { return net.restPosition.col(node); };
}

/// What was seen in one experiment in balance: loads, prescribed places, and where markers went. Plain data, SI.
struct Recording {
  std::string name; ///< for messages and reports
  std::vector<Marker> markers;
  Eigen::Matrix3Xd position;       ///< 3 x markers [m], NaN = not seen
  std::vector<double> weight = {}; ///< 1/sd per marker [1/m], all > 0; empty: all alike
  Loads loads;
  double time = 0.0; ///< at which the loads hold [s]
};

/// Whether a recording can be compared with a net: nodes in range, shares that sum to 1, something seen that moved on a
/// free node, loads as checkLoads() wants them. The detail names the recording.
Status checkRecording(const Recording& recording, const SpringNet& net);

} // namespace esm::learning
