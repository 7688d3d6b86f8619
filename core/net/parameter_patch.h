// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/net/spring_net.h"

#include <optional>
#include <vector>

namespace esm {

/// New numbers for some springs, nodes and anchors of a net whose topology and rest shape stay: what an edit of
/// the tissue changes, and all that it costs. Who derives numbers writes one; the document's net, the
/// simulation's and what shows them take it each, so that none of them copies a net or searches it for changes.
///
///     TissueDerivation --patch--> document's net
///                        |------> view: colours
///                        '------> SimThread --> Simulation::setParameters()
///
/// Plain data. Lists rise by index and name nobody twice; what is not named keeps its numbers. Numbers that a
/// spring has already do no harm.
struct ParameterPatch {
  struct Spring {
    Index spring = kNoIndex;
    SpringLaw law = SpringLaw::Linear;
    double stiffness = 0.0, viscosity = 0.0; ///< [N/m] [N s/m]
    double lawParameter = 0.0;               ///< as SpringNet::lawParameter [1]
  };
  struct Node {
    Index node = kNoIndex;
    double mass = 0.0;        ///< [kg]
    double massDamping = 0.0; ///< [1/s]
  };
  struct Anchor {
    Index anchor = kNoIndex;                 ///< place in SpringNet::anchors
    double stiffness = 0.0, viscosity = 0.0; ///< [N/m] [N s/m]
  };

  std::vector<Spring> springs;
  std::vector<Node> nodes;
  std::optional<AnchorSet> anchorSet; ///< where other nodes are held than before: all anchors anew
  std::vector<Anchor> anchors;        ///< of `anchorSet`, if there is one
  std::vector<double> bulkModuli;     ///< of each pressure body [Pa]; empty: they stay

  bool isEmpty() const noexcept
  {
    return springs.empty() && nodes.empty() && !anchorSet && anchors.empty() && bulkModuli.empty();
  }
  /// @pre checkPatch(). O(patch).
  void applyTo(SpringNet& net) const;
  /// One patch that does what this one and then `later` does. O(both).
  void append(const ParameterPatch& later);
};

/// What checkNet() would say of a good net after applyTo(), looking at nothing but what the patch names; and
/// whether there are such springs, nodes and anchors.
Status checkPatch(const ParameterPatch& patch, const SpringNet& net);

} // namespace esm
