// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/grouped.h"
#include "core/base/worker_pool.h"
#include "core/forces/node_forces.h"
#include "core/forces/node_sweep.h"
#include "core/forces/pressure.h"
#include "core/forces/spring_law.h"
#include "core/net/parameter_patch.h"

#include <array>
#include <span>

namespace esm {

/// How a spring's force on its end a changes with the ends, u its direction:
///
///     dFa/dxb = axial u u^T + lateral (I - u u^T) + u shear^T,   dFa/dvb = viscous u u^T
///
/// and the same with the other sign for xa, va and for Fb. The last term of dFa/dxb comes from the damper,
/// which looks at the ends' relative velocity w along a direction that turns; it is not symmetric, and
/// vanishes at rest. All zero for a slack or zero-length spring.
struct SpringTangent {
  Eigen::Vector3d direction = Eigen::Vector3d::Zero(); ///< u [1]
  double axial = 0.0;                                  ///< df/de [N/m]
  double lateral = 0.0;                                ///< T/l [N/m], negative in a pressed spring
  double viscous = 0.0;                                ///< c [N s/m]
  Eigen::Vector3d shear = Eigen::Vector3d::Zero();     ///< c (w - u (u.w)) / l [N/m]
};

/// The law that a spring is computed by: b = 0 makes the exponential law linear, and a = 0 the cubic one; the linear
/// kernel is cheaper and does not divide by b. Below 1e-9 the two laws differ by less than rounding for strains up
/// to 1e-7/b.
SpringLaw effectiveLaw(SpringLaw law, double parameter) noexcept;

/// All forces that a net has by itself: springs, anchors, pressure, weight and mass damping, compiled from a
/// SpringNet for speed. Springs are sorted by law (see SpringBatch); what is absent costs nothing: a law
/// without springs, springs with neither stiffness nor viscosity, viscosity that is zero, gravity, mass
/// damping. Holds no state; any thread may call the const functions at the same time.
///
/// Large nets are divided (NetDivision), and where a function takes workers they do the parts:
/// with the same bits as one thread, since the parts depend on the net alone and their sums are added in
/// order.
class ForceModel {
public:
  ForceModel() = default;
  ForceModel(const SpringNet& net, const Eigen::Vector3d& gravity);

  /// Other numbers for what `patch` names: to the bit the model of the net as it is now. Springs that fall
  /// silent, wake, or take a law of another kind are sorted anew with all others; anchors likewise.
  /// @param net  with the patch.
  /// @return springs looked at: those of the patch; all of them the first time, to know where they are, and
  ///         where they are sorted anew.
  std::int64_t setParameters(const ParameterPatch& patch, const SpringNet& net,
                             const Eigen::Vector3d& gravity);

  std::size_t nodeCount() const noexcept { return m_nodeForces.nodeCount(); }
  /// Springs that one addForces() evaluates.
  std::int64_t activeSprings() const noexcept { return m_activeSprings; }
  bool isNonlinear() const noexcept { return m_nonlinear; }
  /// Time of one computeForces(), in units of a linear spring with damper (about 3 ns).
  double passCost() const noexcept { return m_passCost; }

  /// Sets `force` (N entries) to the weight plus all other forces of the net. Does not allocate.
  /// @param damper   damperSize() entries that receive the springs' damping at x, or null.
  /// @param workers  null: this thread alone.
  /// @param before   may still write x and v, and read what `force` held before.
  /// @param late     of the springs' velocities; with `damper`.
  /// @return the power that the dampers turn into heat [W].
  double computeForces(const Lanes* x, const Lanes* v, Lanes* force, Lanes* damper = nullptr,
                       WorkerPool* workers = nullptr, const NodeSweep& before = {},
                       const Lateness& late = {}) const noexcept;
  /// Adds viscous forces at velocities v to `force`: the springs' as computeForces() kept them, and those of
  /// single anchors. Where nodeViscosity() has entries, - c v of it is the caller's, who sweeps over the
  /// nodes anyway; together they are - D v.
  /// @param before  may still write v and `force`.
  void addDamping(const Lanes* damper, const Lanes* v, Lanes* force, WorkerPool* workers = nullptr,
                  const NodeSweep& before = {}) const noexcept;
  /// Whether workers find more than one part to do.
  bool isDivided() const noexcept { return nodeRanges().count() > 1; }
  /// For sweeps over the nodes that are divided as the passes are.
  const NodeRanges& nodeRanges() const noexcept { return m_nodeForces.ranges(); }
  std::size_t damperSize() const noexcept { return m_damperSize; }
  const std::vector<double>& nodeViscosity() const noexcept { return m_nodeForces.viscosity(); }

  /// Springs, anchors and pressure [J].
  double elasticEnergy(const Lanes* x, WorkerPool* workers = nullptr) const noexcept;
  double gravityEnergy(const Lanes* x) const noexcept; ///< - sum m g.p [J]
  /// Elastic + viscous tension of every spring of the net [N]; `tension` has S entries.
  void springTensions(const Lanes* x, const Lanes* v, double* tension,
                      WorkerPool* workers = nullptr) const noexcept;
  /// Absolute [N].
  double largestTension(const Lanes* x, const Lanes* v, WorkerPool* workers = nullptr) const noexcept;

  /// The tangents of the active springs, in their order here; ends by springEnds().
  void springTangents(const Lanes* x, const Lanes* v, std::vector<SpringTangent>& tangents) const;
  struct Ends {
    Index a, b;
  };
  const std::vector<Ends>& springEnds() const noexcept { return m_ends; }

  /// The active springs in that order, for methods that step parts of them.
  const std::vector<SpringBatch>& batches() const noexcept { return m_batches; }
  /// Calls work(b) for every batch, those that share nodes in their order.
  template <class Work>
  void forEachBatch(WorkerPool* workers, const Work& work) const noexcept
  {
    forEachSpringPart(workers, [&](std::size_t p) noexcept {
      for (std::size_t b = m_parts[p].firstBatch; b < m_parts[p].endBatch; ++b) work(b);
    });
  }

  const Pressure& pressure() const noexcept { return m_pressure; }

  // What acts on single nodes, as the implicit solver and the step bound need it.
  using Anchor = esm::Anchor;
  const std::vector<Anchor>& anchors() const noexcept { return m_anchors; }
  Lanes weight(std::size_t node) const noexcept { return m_nodeForces.weight(node); } ///< m g [N]
  /// alpha m of every node [kg/s]; empty without mass damping.
  const std::vector<double>& massDrag() const noexcept { return m_massDrag; }

private:
  struct Part {
    std::size_t firstBatch, endBatch;
    std::size_t damper; ///< where its damping begins
  };

  /// Where a spring of the net is.
  struct Place {
    static constexpr std::uint32_t kIdle = ~std::uint32_t{0};
    std::uint32_t batch = kIdle, spring = 0;
  };
  bool isInItsKind(const ParameterPatch::Spring& spring, Place place) const noexcept;
  bool findPlaces(const SpringNet& net);
  void findAnchors(const SpringNet& net);
  bool setSprings(const ParameterPatch& patch, std::int64_t& looked);
  bool setNodes(const ParameterPatch& patch, const SpringNet& net);
  void compileNodes(const SpringNet& net, const Eigen::Vector3d& gravity, const NodeRanges& ranges);
  void addBatches(const SpringNet& net, const SharedTables& tables, std::span<const Index> springs);
  /// work(p) for all parts, phase by phase.
  template <class Work>
  void forEachSpringPart(WorkerPool* workers, const Work& work) const noexcept
  {
    for (std::size_t phase = 0; phase + 1 < m_firstPart.size(); ++phase) {
      const std::size_t first = m_firstPart[phase];
      forEachPart(workers, m_firstPart[phase + 1] - first, [&](std::size_t i) noexcept { work(first + i); });
    }
  }
  void sweepOwn(const NodeSweep& sweep, std::size_t part) const noexcept;

  std::vector<SpringBatch> m_batches;          ///< part by part
  std::vector<Part> m_parts;                   ///< the first ones belong to the ranges of nodes
  std::array<std::size_t, 4> m_firstPart = {}; ///< of each phase, see NetDivision
  std::vector<Ends> m_ends;
  std::int64_t m_activeSprings = 0;
  std::size_t m_damperSize = 0;
  double m_passCost = 0.0;
  std::size_t m_springCount = 0; ///< of the net, idle ones included
  bool m_nonlinear = false;
  NodeForces m_nodeForces;
  std::vector<Anchor> m_anchors;
  std::vector<double> m_massDrag;
  Pressure m_pressure;
  // For patches, from the first one on.
  std::vector<Place> m_placeOf;   ///< of each spring of the net
  std::vector<Index> m_anchorAt;  ///< place in m_anchors of each of the net's, kNoIndex
  Grouped<Index> m_anchorsOfNode; ///< places in m_anchors
  bool m_knowsAnchors = false;    ///< the two above are those of now
};

} // namespace esm
