// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/net_state.h"
#include "core/dynamics/planner/growth_watch.h"
#include "core/dynamics/rest/region_driver.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace esm {

/// A net in motion under one control: method, step, error, sleep and pressure are of all its nodes together.
/// Simulation has one for each island of a net. Who calls has checked net, loads, settings and patches.
/// @note One thread at a time.
class NetMotion {
public:
  /// @param names  the nodes' places in the whole net, by which why() calls them; empty: it is the whole net.
  NetMotion(SpringNet net, Loads loads, const SolverSettings& settings, std::vector<Index> names = {});
  NetMotion(const NetMotion&) = delete;
  NetMotion& operator=(const NetMotion&) = delete;

  // As Simulation has them.
  void reset();
  StepReport advance(double interval, const Budget& budget);
  ParameterChange setParameters(const ParameterPatch& patch);
  void setParameters(SpringNet net); ///< @pre the same topology
  void setAccuracy(double tolerance, double effort) { m_driver.setAccuracy(tolerance, effort); }
  void setTools(std::span<const ToolSpring> tools);
  void watchGrowth();
  /// What advance() keeps is added to it, until the next call; null: nothing is written down.
  void record(std::vector<Stretch>* stretches) noexcept { m_driver.record(stretches); }

  /// Writes what has moved since the last call.
  /// @param places  of the nodes in `state`; empty: the same as here.
  void publish(NetState& state, std::span<const Index> places);
  /// Of a motion that is ahead of `time`: cubics through the places and velocities that `state` has, at its own time, and
  /// those of now. Centres of bodies that fall or are pushed evenly go along such. The next publish() writes all.
  void publishBetween(NetState& state, std::span<const Index> places, double time);

  const SpringNet& net() const noexcept { return m_body.net; }
  const Loads& loads() const noexcept { return m_body.loads; }
  double time() const noexcept { return m_body.motion.time; }
  Energies energies() const;
  double externalWork() const;
  double dissipatedEnergy() const noexcept { return m_body.motion.heat; }
  EnergyReport energyReport();
  const GrowthWatch* growth() const noexcept { return m_growth.get(); } ///< null until watchGrowth()
  double livingError() const noexcept { return m_driver.livingError(); }
  Eigen::Vector3d reaction(Index node);
  Eigen::Vector3d toolForce(std::size_t tool) const;
  void springTensions(std::span<double> tension) const; ///< of all springs
  void springTensions(std::span<const Index> springs, std::span<double> tension) const;
  FastestMode fastestMode() { return m_driver.fastestMode(); }
  double explicitStep(const FastestMode& mode) const noexcept { return m_driver.explicitStep(mode); }
  const std::string& solverName() const noexcept { return m_driver.solverName(); }
  const std::string& why() const noexcept { return m_driver.why(); }

private:
  Energies storedNow() const;
  double ledToolEnergy() const noexcept;
  Energies energiesOf(const ParameterPatch& patch) const;
  void lookAtGrowth(const StepReport& report);
  void engageWorkers();

  Body m_body;
  RegionDriver m_driver;
  int m_threads;                         ///< that may be used
  std::unique_ptr<WorkerPool> m_workers; ///< null until a net asks for them
  std::vector<ToolSpring> m_formerTools;
  std::unique_ptr<GrowthWatch> m_growth; ///< null until somebody asks
  Energies m_initial;                    ///< at t = 0, and what new parameters have changed since
  NodeArray m_force;                     ///< at the state, when asked for
  bool m_forceIsCurrent = false;
  bool m_isBetween = false; ///< what was published last
};

} // namespace esm
