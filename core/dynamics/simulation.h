// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/dynamics/budget.h"
#include "core/dynamics/energy_report.h"
#include "core/dynamics/parameter_change.h"
#include "core/dynamics/step_report.h"
#include "core/forces/loads.h"
#include "core/net/spring_net.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace esm {

/// Positions and velocities at one instant. Plain data.
struct NetState {
  Eigen::Matrix3Xd position; ///< 3 x N [m]
  Eigen::Matrix3Xd velocity; ///< 3 x N [m/s]
  double time = 0.0;         ///< [s]
};

struct SolverSettings {
  std::string solver = "auto"; ///< a name of solverNames(), or "auto"
  double tolerance = 1e-3;     ///< wanted error, metric of docs/FILE_FORMAT.md (relative, RMS), > 0
  double fixedStep = 0.0; ///< [s]; > 0 takes this substep without error control (for convergence studies)
  /// Threads that may share the work, the caller's included; more than there are processors do not help, and
  /// nets of less than 30,000 springs are left to one. The motion is the same bit for bit on any number.
  int threads = 1;
  /// Spring evaluations (about 8 ns each) that `auto` may spend on a sixtieth of a second of motion. Where
  /// the tolerance asks for more, it is given up, the net stays bounded by implicit steps of up to 1/60 s,
  /// and why() says so. The default is half a second of one core; whoever keeps time with a clock asks for
  /// less.
  double effort = 1e8;
  /// Most force passes over the net for each sixtieth of a second of a run, in the mean up to the end of
  /// advance() or of `duration`, whichever is later; a step counts as one at least. At the limit advance()
  /// ends before its time (StepReport::stepLimit). `auto` plans to stay below. 0: none, for whoever keeps
  /// time with a clock and asks for little effort.
  double workLimit = 2e5;
  /// For whoever keeps time with a clock: where plain steps would cost more than the effort, `auto` moves a net
  /// of some hundreds of nodes or more by one step of `block-descent` for each sixtieth of a second, before it
  /// has tried and failed. Its error is some per cent of a hand's way, which the report calls rough.
  bool keepsTime = false;
  /// How long the motion will be looked at, from t = 0 [s]; 0 = unknown, as in a window that runs on. Errors
  /// of a short run have less time to add up, so each step may err more; beyond it the tolerance is kept as
  /// if it had never been known.
  double duration = 0.0;
  /// Nodes at rest sleep until something moves them, and cost nothing; what they miss stays within the
  /// tolerance. Without effect on fixed steps.
  bool skipResting = true;
};

/// A net in motion: the one door to the dynamics for the command line, the window, the benches.
/// Owns a copy of the net. One thread at a time; nothing static is shared between two Simulations.
///
///     auto simulation = Simulation::create(net, loads, {});
///     while (time < 2) simulation->advance(1.0 / 60.0);
class Simulation {
public:
  /// Errors: InvalidValue for a net that checkNet() refuses, loads on absent nodes, an unknown solver name.
  static Result<Simulation> create(SpringNet net, Loads loads, SolverSettings settings);
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  /// Moves the net `interval` [s] ahead in as many substeps as stability and tolerance need. On trouble
  /// (see StepReport::good()) the state is the last good one and why() says what happened and what helps.
  /// Where the budget does not last, StepReport::stepLimit says so and simulatedTime how far it came.
  StepReport advance(double interval, const Budget& budget = {});

  /// Back to t = 0: rest positions and initial velocities; work and tools are cleared.
  void reset();

  // === Between steps
  /// New numbers for what the patch names; the motion goes on, to the bit as if the net with these numbers had
  /// been given as a whole. Costs what is named, but that method and step are chosen anew for what is awake.
  /// Errors: InvalidValue if checkPatch() refuses; the old parameters stay.
  Result<ParameterChange> setParameters(const ParameterPatch& patch);
  /// New stiffness, viscosity, mass, law, anchors, rest lengths and fixed nodes for the same topology: for a net
  /// of which nobody knows what has changed. Looks at all of it and compiles the forces anew.
  /// Errors: InvalidValue if the topology differs or checkNet() refuses; the old parameters stay.
  Status setParameters(SpringNet net);
  /// Another tolerance and effort (see SolverSettings), both > 0, from the next advance() on. The motion goes
  /// on, nothing is prepared anew: whoever keeps time with a clock may call it between any two frames.
  /// Errors: InvalidValue; the former values stay.
  Status setAccuracy(double tolerance, double effort);
  void setTools(std::span<const ToolSpring> tools); ///< @pre nodes in range; replaces the former tools

  // === What it knows
  const SpringNet& net() const noexcept;
  const Loads& loads() const noexcept;
  const NetState& state() const noexcept;
  Eigen::Vector3d momentum() const;        ///< sum m v [kg m/s]
  Eigen::Vector3d angularMomentum() const; ///< about the origin [kg m^2/s]
  Energies energies() const;
  /// Work done on the net since t = 0 by nodal forces, prescribed motions and tools [J] (gravity is in
  /// energies()).
  double externalWork() const;
  /// Energy turned into heat by viscosity and mass damping since t = 0 [J].
  double dissipatedEnergy() const;
  /// Where the energy has gone since t = 0. What new parameters change of it counts as initial energy.
  EnergyReport energyReport() const;
  /// From now on looks whether the motion multiplies small errors, for some hundredths of the work where it
  /// does not. The motion stays the same.
  void watchGrowth();
  /// By how much it has multiplied them, as far as the watch has seen; 1 where it has seen nothing.
  double errorGrowth() const noexcept;
  double errorGrowthTime() const noexcept;   ///< by when [s]
  double errorGrowthPasses() const noexcept; ///< what it took to see that [force passes]
  /// Estimate of the error that the motion carries now, RMS over the nodes [m]: what its stretches have erred as
  /// their checks tell, up to the tolerance where it was kept, less what has faded since.
  double livingError() const noexcept;
  /// The force that a fixed or prescribed node's support exerts on the net [N]; zero for free nodes.
  Eigen::Vector3d reaction(Index node) const;
  Eigen::Vector3d toolForce(std::size_t tool) const;             ///< force of the tool on its node [N]
  void springTensions(Eigen::Ref<Eigen::ArrayXd> tension) const; ///< S [N], elastic + viscous, > 0 pulls
  /// Of these springs alone, each at its place in `tension` (S).
  void springTensions(std::span<const Index> springs, Eigen::Ref<Eigen::ArrayXd> tension) const;
  /// Largest substep [s] that explicit integration bears now, and the node that sets it.
  double stableStep() const;
  Index stiffestNode() const;
  const std::string& solverName() const noexcept; ///< what "auto" chose
  const std::string&
  why() const noexcept; ///< one English sentence: the choice, or what went wrong and the cure

private:
  struct Impl;
  explicit Simulation(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> m_impl;
};

/// The names that SolverSettings::solver takes, "auto" excluded; with one line on each.
struct SolverInfo {
  std::string name;
  std::string description;
};
std::vector<SolverInfo> solverNames();

} // namespace esm
