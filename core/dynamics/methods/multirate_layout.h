// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/grouped.h"
#include "core/dynamics/system/system.h"

#include <vector>

namespace esm {

/// Springs, anchors and tools that step together, every base step / 2^class.
struct RateClass {
  std::vector<SpringBatch> batches;
  std::vector<Anchor> anchors;    ///< mass damping of a node is one without stiffness
  std::vector<std::size_t> tools; ///< places in System::tools()
  std::vector<Index> nodes;       ///< that feel this class and move; the first `own` feel no faster one
  std::size_t own = 0;
  std::vector<Index> driven; ///< prescribed nodes among the ends
  std::int64_t springs = 0;
};

/// Who steps how often. A spring must step at the rate of its own pair of nodes (reduced mass, stiffness,
/// viscosity, together with the springs of its class and of the slower ones at both ends), and at no less
/// than half the rate of the fastest spring at either end. Without the second rule slow springs knock light
/// nodes on stiff springs at their resonance: half as many evaluations, but ten times the error.
class MultirateLayout {
public:
  /// Base step [s] and spring evaluations in it, guessed from the parameters alone, without positions. Beyond
  /// that base step less than a tenth could be saved.
  struct Plan {
    double step = 0.0;
    double cost = 0.0;
    bool pays = false; ///< cheaper than one rate for all
  };
  static Plan plan(const System& system);

  /// Sorts all springs into classes for base steps of `step` [s], stable at the positions x. Allocates.
  void build(const System& system, const NodeArray& x, const NodeArray& v, double step);
  /// Whether springs or tools have become too stiff for their class since build().
  bool isOutgrown(const System& system, const NodeArray& x, const NodeArray& v);

  double step() const noexcept { return m_step; }
  const std::vector<RateClass>& classes() const noexcept { return m_classes; } ///< slowest first

private:
  void measure(const System& system, const NodeArray& x, const NodeArray& v);
  bool fits(const System& system, std::size_t link, int level) const;
  void assignLevels(const System& system);
  void fillClasses(const System& system);

  double m_step = 0.0;
  std::vector<RateClass> m_classes;
  // A link is what may need a rate of its own: springs, then anchors, then mass damping, then tools.
  struct Link {
    Index a = kNoIndex, b = kNoIndex; ///< b = kNoIndex for what acts on one node
    double axial = 0.0, lateral = 0.0, viscosity = 0.0;
    Eigen::Vector3d direction = Eigen::Vector3d::Zero(); ///< zero: in all directions
  };
  std::vector<Link> m_links;
  std::vector<int> m_level; ///< class of each link
  std::vector<SpringTangent> m_tangents;
  Grouped<std::uint32_t> m_linksOf; ///< by node
};

} // namespace esm
