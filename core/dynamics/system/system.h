// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/budget.h"
#include "core/dynamics/system/energy_sums.h"
#include "core/forces/force_model.h"
#include "core/forces/load_schedule.h"

#include <limits>
#include <numeric>
#include <span>

namespace esm {

/// What changes with each step.
struct MotionState : EnergySums {
  NodeArray x, v; ///< N [m], N [m/s]
  double time = 0.0;

  /// The end of a step: positions and velocities change places with these, which are left to be overwritten.
  void advanceTo(double end, NodeArray& nextX, NodeArray& nextV, double workDone, double heatMade,
                 double lost = 0.0) noexcept
  {
    x.swap(nextX);
    v.swap(nextV);
    work += workDone;
    heat += heatMade;
    loss += lost;
    time = end;
  }
};

/// Powers at one instant [W].
struct Rates {
  double work = 0.0, heat = 0.0;
  double loads = 0.0; ///< part of `work` by nodal forces and tools
};

/// The equations of motion m a = f(t, x, v): the net's own forces, the loads and the tools, and who is free.
/// A node that is fixed or prescribed has inverse mass 0; its entry in the force array is what the net and
/// the loads do to it, and the support answers with the opposite.
class System {
public:
  System() = default;
  System(const SpringNet& net, const Loads& loads);
  /// New parameters for the same nodes; loads, tools and constraints stay.
  void setParameters(const SpringNet& net, const Eigen::Vector3d& gravity);
  /// The same where only what `patch` names has changed, to the bit. @param net  with the patch.
  /// @return springs looked at, see ForceModel::setParameters().
  std::int64_t setParameters(const ParameterPatch& patch, const SpringNet& net,
                             const Eigen::Vector3d& gravity);
  /// Threads that share the passes over a large net, with the same bits as one; null: none. Not owned.
  void setWorkers(WorkerPool* workers) noexcept { m_workers = workers; }
  WorkerPool* workers() const noexcept { return m_workers; }
  /// Calls sweep(first, count) for ranges of nodes that cover all; by the workers, if the net is divided.
  /// Sweeps must not throw, and a node's result must depend on no other node's.
  template <class Sweep>
  void sweepNodes(const Sweep& sweep) const noexcept
  {
    const NodeRanges& ranges = m_forces.nodeRanges();
    forEachPart(m_workers, ranges.count(),
                [&](std::size_t i) noexcept { sweep(ranges.first(i), ranges.size(i)); });
  }
  /// The same for sums: the parts, which sweep(first, count) returns, are added in their order.
  template <class Sweep>
  double sumNodes(const Sweep& sweep) const noexcept
  {
    const NodeRanges& ranges = m_forces.nodeRanges();
    double parts[NetDivision::kMostParts];
    forEachPart(m_workers, ranges.count(),
                [&](std::size_t i) noexcept { parts[i] = sweep(ranges.first(i), ranges.size(i)); });
    return std::accumulate(parts, parts + ranges.count(), 0.0);
  }
  /// Springs towards where the targets are at `time`. What a target moves beyond that is a force that grows with
  /// time: a load, so that all energies are those of springs that stay, whatever the method.
  /// @return the energy that the exchange adds to the tool springs at positions x [J].
  double setTools(std::span<const ToolSpring> tools, const NodeArray& x, double time);
  double toolsSetAt() const noexcept { return m_toolsSetAt; } ///< [s]
  /// Adds the forces that depend on time alone, of loads and of tools that move. @return their power [W].
  double addLoads(double t, const NodeArray& v, NodeArray& force) const noexcept;

  std::size_t nodeCount() const noexcept { return m_mass.size(); }
  /// Nodes of a net from which on room for what may never be done is not made beforehand, nor kept in between: its
  /// allocation is little beside one pass over it.
  static constexpr std::size_t kLarge = 20'000;
  /// What a method's sweeps over the nodes cost, from that of one node [spring evaluations] where its arrays
  /// are in the caches and where they are not. Measured before sweeps went on the way through a pass; with
  /// what they take now (the near ones) an organ of 100,000 nodes takes a quarter more passes at 1e-6.
  double sweepCost(double near, double far) const noexcept
  {
    constexpr std::size_t kMostNear = 20'000; // eight arrays of 32 bytes each: 5 MB
    return (nodeCount() > kMostNear ? far : near) * static_cast<double>(nodeCount());
  }
  const ForceModel& forces() const noexcept { return m_forces; }
  const std::vector<ToolSpring>& tools() const noexcept { return m_tools; }
  const std::vector<double>& mass() const noexcept { return m_mass; }
  double totalMass() const noexcept { return m_totalMass; }                         ///< [kg]
  const std::vector<double>& inverseMass() const noexcept { return m_inverseMass; } ///< [1/kg]
  bool isFree(std::size_t node) const noexcept { return m_inverseMass[node] > 0.0; }
  const LoadSchedule& schedule() const noexcept { return m_schedule; }
  double nextEvent(double t) const noexcept { return m_schedule.nextEvent(t); }

  /// Takes the loads' lines and the constraints that hold from state.time on; puts prescribed nodes where
  /// they belong. Work done by a jump goes to state.work unless `silent` (the start).
  /// @return whether nodes have become free or held.
  bool enter(MotionState& state, bool silent);

  /// Forces at t into `force` (N entries). Prescribed nodes are first put to their place in x and v.
  /// Does not allocate.
  /// @param damper  forces().damperSize() entries that receive the springs' damping at x, or null.
  /// @param before  writes x and v of a range of nodes; may read what `force` held before.
  /// @param late  of the velocities of springs; with `damper`.
  Rates evaluate(double t, NodeArray& x, NodeArray& v, NodeArray& force, Lanes* damper = nullptr,
                 const NodeSweep& before = {}, const Lateness& late = {}) noexcept;
  /// Forces to accelerations; 0 where a support holds.
  void toAccelerations(NodeArray& force) const noexcept;
  /// The power of nodal forces and tools at other velocities [W].
  double loadPower(double t, const NodeArray& v) const noexcept;
  /// Adds the viscous forces at velocities v to `force`, but for - c v of forces().nodeViscosity(); the
  /// springs' with the damping that evaluate() kept. Half the cost of evaluate().
  /// @param before  writes v and `force` of a range of nodes.
  void addDamping(const Lanes* damper, const NodeArray& v, NodeArray& force,
                  const NodeSweep& before = {}) noexcept;
  /// Prescribed nodes to their place.
  void place(double t, NodeArray& x, NodeArray& v) const noexcept { m_schedule.place(t, x.data(), v.data()); }

  /// Forces of an accelerating frame of reference on the nodes [N], a part of evaluate() and storedEnergy()
  /// as a weight would be; null: none. Not owned.
  void setFrame(const Lanes* forces) noexcept { m_frame = forces; }

  double kineticEnergy(const NodeArray& v) const noexcept;
  double elasticEnergy(const NodeArray& x) const noexcept; ///< springs, anchors, tools [J]
  double weightEnergy(const NodeArray& x) const noexcept;  ///< and of the frame's forces [J]
  double storedEnergy(const NodeArray& x) const noexcept;  ///< both [J]
  /// Of a tool as it was set; what it has moved since is a load.
  Eigen::Vector3d toolForce(std::size_t tool, const NodeArray& x, const NodeArray& v) const noexcept;
  Eigen::Vector3d toolForce(std::size_t tool, double t, const NodeArray& x,
                            const NodeArray& v) const noexcept; ///< all of it
  /// Of the springs to where the targets are at t, beyond what elasticEnergy() counts [J].
  double ledToolEnergy(double t, const NodeArray& x) const noexcept;

  std::int64_t springsEvaluated = 0; ///< since the caller set it to 0
  /// Work of implicit solvers besides force passes, in spring evaluations; and how much of both there may be.
  double solverWork = 0.0, workLimit = std::numeric_limits<double>::infinity();
  double workDone() const noexcept { return static_cast<double>(springsEvaluated) + solverWork; }
  /// The limit for the next of so many equal pieces of work that share what `limit` leaves.
  double shareOfWork(double limit, std::int64_t pieces) const noexcept
  {
    return workDone() + (limit - workDone()) / static_cast<double>(pieces);
  }
  bool isExhausted() const noexcept { return workDone() > workLimit || isInterrupted(); }
  /// By the clock or somebody else, during a call that lends its budget's question; null: none. Not owned.
  Interruption* interruption = nullptr;
  bool mayBeInterrupted() const noexcept { return interruption != nullptr && interruption->isPossible(); }
  bool isInterrupted() const noexcept { return interruption != nullptr && interruption->isDue(); }

private:
  double toolEnergy(const NodeArray& x) const noexcept;
  /// Of the spring, for what the target has moved [N].
  Eigen::Vector3d leadOf(const ToolSpring& tool, double t) const noexcept
  {
    return tool.stiffness * (t - m_toolsSetAt) * tool.targetVelocity;
  }
  bool updateConstraints() noexcept; ///< whether anything changed

  ForceModel m_forces;
  WorkerPool* m_workers = nullptr;
  const Lanes* m_frame = nullptr;
  LoadSchedule m_schedule;
  std::vector<ToolSpring> m_tools;
  double m_toolsSetAt = 0.0;
  std::vector<double> m_mass, m_inverseMass;
  double m_totalMass = 0.0;
  std::vector<std::uint8_t> m_fixed;
};

/// Of all lanes of the nodes, and of the differences of two arrays.
double sumOfSquares(const NodeArray& a) noexcept;
double sumOfSquares(const NodeArray& a, const NodeArray& b) noexcept; ///< @pre of one size

double sumOfProducts(const NodeArray& a, const NodeArray& b) noexcept; ///< @pre of one size

/// y -= factor x, over `count` nodes. @return y.z, of the new y.
double takeOff(std::size_t count, double factor, const Lanes* x, Lanes* y, const Lanes* z) noexcept;

/// to = from + s rate; `to` may be either of the arrays.
void advanceNodes(std::size_t count, double s, const Lanes* from, const Lanes* rate, Lanes* to) noexcept;

/// slope = rate (to - from); 0 where a support holds. `slope` may be either of the arrays.
void slopesTo(std::size_t count, double rate, const double* inverseMass, const Lanes* from, const Lanes* to,
              Lanes* slope) noexcept;

/// to = factor from, node by node; both may be the same array.
void scaleNodes(std::size_t count, const double* factor, const Lanes* from, Lanes* to) noexcept;

} // namespace esm
