// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/motion_log.h"
#include "core/dynamics/net_motion.h"
#include "core/net/net_islands.h"

#include <memory>
#include <span>
#include <vector>

namespace esm {

/// A net as its islands move it, each with a NetMotion of its own; a net that hangs together is one, and costs nothing
/// more. Gives everything of the whole net out to whom it concerns, and adds up what they answer.
///
/// Islands know nothing of each other, so that any number of threads gives the same bits. After a call that its budget
/// ended they may be at different times; the next one takes those first that are behind, and what is published is of the
/// time that all have reached.
class IslandMotions {
public:
  IslandMotions(SpringNet net, Loads loads, const SolverSettings& settings);

  std::size_t count() const noexcept { return m_islands.size(); }
  const SpringNet& net() const noexcept { return isOne() ? m_islands.front().motion->net() : m_net; }
  const Loads& loads() const noexcept { return isOne() ? m_islands.front().motion->loads() : m_loads; }

  // As Simulation has them.
  void reset();
  StepReport advance(double interval, const Budget& budget);
  /// The same, and writes into `record` what each island did.
  StepReport advance(double interval, const Budget& budget, logged::Advance& record);
  /// As `former` tells that it was, islands that the budget ended included. @param record  what they did this time
  StepReport advanceAgain(const logged::Advance& former, logged::Advance& record);
  ParameterChange setParameters(const ParameterPatch& patch); ///< @pre checkPatch()
  void setParameters(SpringNet net);                          ///< @pre checkNet(), the same topology
  void setAccuracy(double tolerance, double effort);
  void setTools(std::span<const ToolSpring> tools);
  void watchGrowth();
  void publish(NetState& state);

  template <class Value>
  double sum(Value NetMotion::*value) const
  {
    double sum = 0.0;
    for (const Island& island : m_islands) sum += (*island.motion.*value)();
    return sum;
  }
  Energies energies() const;
  std::vector<EnergyReport> energyReports() const;
  const GrowthWatch* largestGrowth() const noexcept; ///< null until watchGrowth()
  double growthPasses() const noexcept;
  double livingError() const noexcept;
  Eigen::Vector3d reaction(Index node) const;
  Eigen::Vector3d toolForce(std::size_t tool) const;
  void springTensions(std::span<double> tension) const; ///< of all springs
  void springTensions(std::span<const Index> springs, std::span<double> tension) const;
  struct Stiffest {
    double step = 0.0; ///< that explicit integration bears [s]
    Index node = kNoIndex;
  };
  Stiffest stiffest() const;
  /// Whose choice is told: the one that failed in the last advance(), or that took most of the work.
  const NetMotion& leading() const noexcept { return *m_islands[m_leading].motion; }

private:
  struct Island {
    NetIsland places; ///< empty of a net that is one
    std::unique_ptr<NetMotion> motion;
    std::vector<ToolSpring> tools;
    StepReport last;          ///< of the last advance() that moved it
    double effort = 0.0;      ///< as it was told last
    bool hasNewTools = false; ///< while they are given out
  };
  /// Where something of the whole net is.
  struct Place {
    std::size_t island = 0;
    Index place = kNoIndex;
  };

  bool isOne() const noexcept { return m_islands.size() == 1; }
  static std::size_t at(Index index) noexcept { return static_cast<std::size_t>(index); }
  Place placeOfNode(Index node) const noexcept { return isOne() ? Place{0, node} : m_nodes[at(node)]; }
  void split(const SolverSettings& settings);
  std::vector<Place> placesOf(const AnchorSet& set) const;
  using BudgetOf = std::function<Budget(std::size_t island)>;
  StepReport advanceAll(double interval, const BudgetOf& budgetOf, logged::Advance* record,
                        const logged::Advance* former);
  StepReport advanceOne(Island& island, double interval, const Budget& budget);
  StepReport sumUp(double begin);
  void shareEffort();
  std::vector<ParameterPatch> split(const ParameterPatch& patch) const;

  SpringNet m_net; ///< empty of a net that is one
  Loads m_loads;
  std::vector<Island> m_islands;
  std::vector<Place> m_nodes, m_springs, m_anchors, m_pressure; ///< empty of a net that is one
  std::vector<Place> m_tools;
  double m_time = 0.0; ///< that all have reached [s]
  double m_tolerance = 0.0, m_effort = 0.0;
  bool m_keepsTime = false;
  std::size_t m_leading = 0;
  std::unique_ptr<WorkerPool> m_workers; ///< where several islands are worth it
};

} // namespace esm
