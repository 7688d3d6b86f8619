// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/parameter_change.h"
#include "core/dynamics/planner/step_driver.h"
#include "core/dynamics/rest/load_watch.h"
#include "core/dynamics/rest/rest_watch.h"
#include "core/dynamics/rest/settling.h"
#include "core/dynamics/rest/sleeping_tensions.h"
#include "core/dynamics/rest/sub_net.h"

namespace esm {

/// The moving net as its owner holds it: everything about all nodes.
struct Body {
  SpringNet net;
  Loads loads;
  System system;
  MotionState motion;
};

/// Lets StepDriver work on what moves, and leaves out what rests. Three modes:
///
///     Whole   everything is awake: StepDriver works on the body itself, nothing is copied
///     Part    the awake nodes, closed by their sleeping neighbours as held nodes, are a net of their own
///     Rest    everything sleeps: only time goes on
///
/// **Waking.** Tools, loads and parameters that change wake the nodes that they touch with a few layers of
/// springs around. From then on the awake part watches its own edge. A sleeper that should have moved shows
/// in the awake nodes next to it: their displacement since the part was closed, squared and summed over the
/// outer quarter of the layers, is about the square of what the sleepers miss (for a displacement that dies
/// out with the distance, whatever its decay length: the part has to be some four of these lengths deep to
/// meet a tolerance, so that the outer quarter is one of them). If the sum is above the budget, the stretch
/// is taken back and done again with a larger part; above a quarter of it, the part grows for the next
/// stretch. It grows only where the sum comes from, by many layers at once.
///
/// **Budget.** Half of the tolerance goes to sleepers: sum of squares of missed displacements <=
/// (tolerance/2)^2 times the sum of squares of all displacements, as it is now or has been on average, the
/// larger; with a floor of a millionth of the net's extent.
///
/// **Sleeping.** RestWatch says who is slow: within a quarter of the budget in all. Slow nodes that are some
/// layers away from faster ones fall asleep, if they are enough to make the change worth while. Their
/// kinetic energy, which is negligible, counts as heat. What moves is moved to its goal when it is near there
/// (Settling), which ends its motion long before each of its nodes is slow. Nets of less than two thousand
/// nodes sleep as a whole or not at all: there a part would hardly be cheaper. So do nets with pressure,
/// which acts on all at once.
///
/// **Free bodies.** What is awake of a part that nothing holds falls asleep as one, and not while it moves as
/// one or is pushed: no look at its nodes tells that such a motion would go on for good.
class RegionDriver {
public:
  /// @param body   not owned, outlives this.
  /// @param names  by which why() calls its nodes; empty: their places.
  RegionDriver(SolverSettings settings, Body& body, std::vector<Index> names);

  void begin(); ///< after creation and reset of the body
  /// The body has other parameters now. Costs what the change touches, and a choice of method and step for what is awake.
  void parametersChanged(const ParameterChange& change);
  /// The body has other tools than in `before`.
  void toolsChanged(const std::vector<ToolSpring>& before);
  /// Another accuracy from the next stretch on; see Simulation.
  void setAccuracy(double tolerance, double effort);
  StepReport advance(double interval, const Budget& budget);
  /// See NetMotion.
  void record(std::vector<Stretch>* stretches) noexcept { m_driver.record(stretches); }

  /// Books all that the method has lost up to now.
  void closeLoss();

  /// Nodes that advance() and the changes above have moved since the last clearMoved(); empty and all = true
  /// for everybody.
  const std::vector<Index>& moved() const noexcept { return m_moved; }
  bool allMoved() const noexcept { return m_allMoved; }
  void clearMoved() noexcept;

  /// Where the whole net is stiffest now, and the largest explicit step there. Not cheap while nodes sleep.
  FastestMode fastestMode();
  double explicitStep(const FastestMode& mode) const noexcept { return m_driver.explicitStep(mode); }
  double livingError() const noexcept; ///< see Simulation [m]
  const std::string& solverName() const noexcept { return m_driver.solverName(); }
  const std::string& why() const noexcept { return m_limitText.empty() ? m_driver.why() : m_limitText; }

private:
  enum class Mode { Whole, Part, Rest };
  static constexpr int kFirstLayers = 8; ///< that wake around what is touched

  // Steps
  double stretchEnd(double end, double interval) const noexcept;
  bool stretch(double target, const Budget& budget, StepReport& report);
  void pass(double target);
  bool stretchWhole(double target, std::int64_t maxSteps, StepReport& report);
  bool stretchPart(double target, std::int64_t maxSteps, StepReport& report);
  void takeOver(double target);
  void look(StepReport& report);
  bool settles(StepReport& report);
  bool isMoved() const;
  bool settleWithin(const SettlingBudget& missable, StepReport& report);
  double undisturbed() const;
  double workLeft(double end) const noexcept;

  // Who is awake (region_change.cpp)
  bool isDivisible() const noexcept; ///< into a part that moves and one that rests
  std::vector<Index> unbalancedNodes();
  void wakeForLoads(bool eventIsReached);
  FreeBodies& bodies();
  bool movesAsOne(std::size_t body);
  void keepBodiesAwake();
  std::vector<Index> wholeBodies(std::vector<Index> sleepers);
  void wake(std::span<const Index> seeds, int layers);
  void applyChange();
  void enterWhole();
  void enterPart();
  void gather();
  void scatter();
  void letSleep(const std::vector<Index>& nodes);
  void keepTensions();
  double largestTension(double awake);
  void watchLoads();
  double missedMotion(std::vector<Index>* restless) const;
  bool grow(bool late);
  int edgeDepth() const noexcept;
  double meanSquare() const noexcept;
  double budget() const noexcept;
  double settlingBudget() const noexcept;

  SolverSettings m_settings;
  Body& m_body;
  StepDriver m_driver;
  const Policy& m_policy; ///< of the driver
  ErrorLedger m_ledger{m_policy.shares};
  bool m_on = false;
  Mode m_mode = Mode::Whole;
  ActiveRegion m_region;
  RestWatch m_watch{m_policy};
  LoadWatch m_loads;
  SleepingTensions m_tensions;
  Settling m_settling{m_policy};
  SubNetCutter m_cutter;
  FreeBodies m_bodies; ///< of the whole net, see bodies()
  bool m_bodiesAreKnown = false;

  SubNet m_part; ///< of mode Part
  System m_partSystem;
  MotionState m_partMotion;

  bool m_driverHasWhole = true;      ///< what the driver was told last
  bool m_changed = false;            ///< the region is not what the mode and the part say
  NodeArray m_origin;                ///< positions at t = 0 [m]
  NodeArray m_still;                 ///< where an awake node was when the sleepers near it fell asleep [m]
  std::vector<std::uint8_t> m_fresh; ///< N, has just fallen asleep
  std::vector<Index> m_freshList;
  std::vector<std::uint8_t> m_played; ///< N, has been awake since the start
  double m_playedCount = 0.0;
  double m_squareAsleep = 0.0; ///< sum of squared displacements of sleepers [m^2]
  double m_extent = 1.0;       ///< [m]
  double m_work = 0.0;         ///< since begin() [spring evaluations]
  double m_stirred = 0.0;      ///< when parameters or tools changed last, or the whole net woke [s]
  std::vector<Index> m_moved;
  bool m_allMoved = true;
  std::string m_limitText;
  Interruption m_interruption; ///< of this advance()
};

} // namespace esm
