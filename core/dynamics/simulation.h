// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/budget.h"
#include "core/base/result.h"
#include "core/dynamics/energy_report.h"
#include "core/dynamics/motion_log.h"
#include "core/dynamics/net_state.h"
#include "core/dynamics/parameter_change.h"
#include "core/dynamics/solver_settings.h"
#include "core/dynamics/step_report.h"
#include "core/forces/loads.h"
#include "core/net/spring_net.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace esm {

/// A net in motion: the one door to the dynamics for the command line, the window, the benches.
/// Owns a copy of the net. One thread at a time; nothing static is shared between two Simulations.
///
/// Parts of the net that nothing joins (findIslands()) move each under its own control, as they would alone: with its
/// own method, steps, sleep, pressure, and with the tolerance of its own displacement. What SolverSettings allow, each
/// may take; whoever keeps time shares the effort among those that are awake.
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

  // === Again
  /// From now on each call that moves or changes something adds to the log; null: no longer. Not owned. A log that is
  /// to be replayed begins with the Simulation, or with its reset().
  void record(MotionLog* log) noexcept;
  /// Does what an entry says. @return what came out otherwise than it says, in one English sentence; empty: the
  /// same to the bit. Errors: InvalidValue for an entry of another net.
  Result<std::string> replay(const LogEntry& entry);

  // === What it knows
  const SpringNet& net() const noexcept;
  const Loads& loads() const noexcept;
  /// Of one time. Parts of the net that went on when a budget ended others are shown between what they were and are.
  const NetState& state() const noexcept;
  std::size_t islandCount() const noexcept; ///< parts of the net that move each under its own control
  Eigen::Vector3d momentum() const;         ///< sum m v [kg m/s]
  Eigen::Vector3d angularMomentum() const;  ///< about the origin [kg m^2/s]
  Energies energies() const;
  /// Work done on the net since t = 0 by nodal forces, prescribed motions and tools [J] (gravity is in
  /// energies()).
  double externalWork() const;
  /// Energy turned into heat by viscosity and mass damping since t = 0 [J].
  double dissipatedEnergy() const;
  /// Where the energy has gone since t = 0. What new parameters change of it counts as initial energy.
  EnergyReport energyReport() const;
  std::vector<EnergyReport> islandEnergies() const; ///< the same of each island
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
  // Of the part that failed last, or else takes most of the work.
  const std::string& solverName() const noexcept; ///< what "auto" chose
  const std::string&
  why() const noexcept; ///< one English sentence: the choice, or what went wrong and the cure

private:
  Result<std::string> replayAdvance(const logged::Advance& former);
  struct Impl;
  explicit Simulation(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> m_impl;
};

} // namespace esm
