// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

// The pieces of addSupport().

#include "core/geometry/pair_key.h"
#include "core/net/outward_surface.h"
#include "core/structure/support.h"

#include <cstdint>
#include <unordered_set>
#include <vector>

namespace esm::support {

/// A spring to be made, between nodes of the net or new ones (numbered on from the net's).
struct Strut {
  Index a = kNoIndex, b = kNoIndex;
  double section = 0.0; ///< [m^2]
  double weight = 1.0;  ///< against the other struts of a node, see shareSections()
  SpringKind kind = SpringKind::Strut;
};

/// What an interior consists of.
struct Layer {
  Eigen::Matrix3Xd nodes{3, 0}; ///< new nodes [m]
  Eigen::ArrayXd volume;        ///< that they carry [m^3], one per new node
  std::vector<Strut> struts;
  TetrahedronMatrix tetrahedra{
    4, 0}; ///< over the net's nodes and the new ones; sections and volumes come from them
  /// What the layer gives to the surface's own springs [m^2] and nodes [m^3]; size 0: nothing.
  Eigen::ArrayXd surfaceSection, surfaceVolume;
  std::vector<Index> unsupported; ///< nodes of the surface that got nothing
  std::vector<std::string> notes;
};

/// The pairs of nodes that a spring joins already; grows with each new one.
class JoinedPairs {
public:
  explicit JoinedPairs(const SpringNet& net);
  /// Whether the pair was apart until now.
  bool join(Index a, Index b) { return a != b && m_pairs.insert(pairKey(a, b)).second; }
  bool has(Index a, Index b) const { return m_pairs.count(pairKey(a, b)) > 0; }

private:
  std::unordered_set<std::uint64_t> m_pairs; ///< asked only, never walked through
};

Result<Layer> makeStruts(const SpringNet& net, const SupportOptions& options, WorkControl* control);
Result<Layer> makeHubs(const SpringNet& net, const SupportOptions& options, WorkControl* control);
Result<Layer> makeTetrahedra(const SpringNet& net, const SupportOptions& options, WorkControl* control);
Result<Layer> makeLattice(const SpringNet& net, const SupportOptions& options, WorkControl* control);
Result<Layer> makeWall(const SpringNet& net, const SupportOptions& options, WorkControl* control);

/// Appends bands to `net` for the nodes that the options name. @return how many.
Index addBands(SpringNet& net, const SupportOptions& options);

/// Appends a pressure body for each closed part of the surface; a cavity belongs to the part that it lies in,
/// since what keeps its volume is the tissue between. @return how many; 0 also if cancelled.
Index addPressure(SpringNet& net, double bulkModulus, WorkControl* control);

/// The mean of two nodes' surface, each shared among its struts by their weight, which makes all struts
/// together as wide as the surface; of a strut with one end off the surface the other's share.
void shareSections(const SpringNet& net, std::vector<Strut>& struts);

} // namespace esm::support
