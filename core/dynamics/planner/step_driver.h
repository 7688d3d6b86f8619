// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/motion_log.h"
#include "core/dynamics/planner/error_gauge.h"
#include "core/dynamics/planner/free_bodies.h"
#include "core/dynamics/solver_settings.h"
#include "core/dynamics/step_report.h"
#include "core/dynamics/system/frame.h"
#include "core/dynamics/system/step_loss.h"

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace esm {

/// Says that a System is a part of a net whose other nodes rest: errors are still measured over the whole.
struct NetPart {
  std::vector<Index> nodes;     ///< place of each node in the whole net; empty: the system is the whole net
  NodeArray rest;               ///< their positions at t = 0 [m]
  std::size_t wholeCount = 0;   ///< nodes of the whole net
  double squareElsewhere = 0.0; ///< sum of squared displacements of the nodes outside [m^2]
};

/// Chooses method and step, and takes the steps.
///
/// Time is cut at the loads' events, and between them into stretches of at most a frame (1/60 s) with equal
/// steps. The step is the smaller of what is stable (StepBound) and what is accurate. Accuracy is measured,
/// not estimated from single steps: now and then a stretch is done twice, the second time with two thirds of
/// the step, and the distance of the two ends tells the error. Single steps say much about fast modes whose
/// error dies out before the next frame; whole stretches say what a frame shows. The second result is kept.
/// How much error a stretch may add is told by ErrorGauge, which also takes a look at the two runs early in
/// the stretch: it tells whether errors add up. After a check other methods that could be far cheaper are
/// probed: each takes the stretch once, and its distance from the kept end tells its error.
///
/// Where loads jump, fast waves start that die out soon. If the first stretch errs far too much, it is cut
/// into short ones that double (Onset), so that their small steps are not taken any longer than these waves
/// live.
///
/// `auto` compares costs: explicit steps at their limit against implicit ones at the accurate step. If even
/// explicit steps would be too many, it goes implicit with a smallest step and says that the tolerance may
/// not hold: bounded rather than exact. Where implicit steps find no solution either, gain energy, or the
/// attempts have cost some times the effort, a few steps of descent take the stretch: they cannot fail. After
/// a failure the next one, two, four, ... stretches go the same way, so that failing is not paid for every
/// time.
class StepDriver {
public:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  /// @param names  by which why() calls the nodes of the whole net; empty: their places.
  explicit StepDriver(SolverSettings settings, std::vector<Index> names = {});

  /// After creation and reset.
  void begin(System& system, const MotionState& state);
  /// Parameters or masses have changed.
  void parametersChanged(System& system, const MotionState& state);
  /// Tools have come, moved or gone.
  void toolsChanged(System& system, const MotionState& state, bool sameNodes);
  /// The state has been changed from outside.
  void restart(const System& system, const MotionState& state);
  /// The next calls are about this part of the net, in motion as before: what was learned stays.
  void partChanged(System& system, const MotionState& state, NetPart part);
  /// Another accuracy from the next stretch on. The motion, what was learned and what was prepared stay.
  void setAccuracy(const System& system, double tolerance, double effort);
  /// For a caller that takes an advance() back.
  const ErrorScale& errorScale() const noexcept { return m_gauge.scale(); }
  double knownEnd(double time) const noexcept { return m_gauge.knownEnd(time); } ///< see ErrorGauge
  void setErrorScale(const ErrorScale& scale) noexcept { m_gauge.setScale(scale); }

  /// @param mostWork  that may be done [spring evaluations]; the report's stepLimit says that it was
  StepReport advance(System& system, MotionState& state, double interval, std::int64_t maxSteps,
                     double mostWork = kInfinity);
  /// What advance() keeps is added to it, until the next call; null: nothing is written down.
  void record(std::vector<Stretch>* stretches) noexcept { m_stretches = stretches; }
  /// Of the last advance() [spring evaluations]; a step is a force pass at least.
  double workDone(const System& system, const StepReport& report) const noexcept;

  /// What the method has lost up to `state` and not booked yet [J]; from now on it is booked. To be called
  /// before the net changes.
  double closeLoss(const System& system, const MotionState& state);

  /// Where the net is stiffest now, and the largest explicit step there.
  FastestMode fastestMode(const System& system, const MotionState& state);
  double explicitStep(const FastestMode& mode) const noexcept;
  bool asksForDecay() const noexcept;

  /// Whether a stretch is one step now, however short.
  bool takesBlocks() const noexcept { return m_byBlocks || m_descents > 0; }
  /// Whether the last check has found more error than the tolerance allows.
  bool isRough() const noexcept { return m_roughAtCheck || m_toleranceGivenUp; }
  const std::string& solverName() const noexcept { return m_name; }
  const std::string& why() const noexcept { return m_limitText.empty() ? m_why : m_limitText; }

private:
  using Method = std::size_t; ///< place in integratorTable()
  /// Energy may grow by this much in a stretch without cause: explicit steps stir up the fastest modes a
  /// little at their limit.
  static constexpr double kCoarseGrowth = 0.05;
  /// Of an accurate step at a time: errors beyond, and runs that fail, tell of waves out of control, not of
  /// accuracy.
  static constexpr double kMostShrinking = 1.0 / 64.0;
  /// After an event, in which an onset may begin [s]: in any stretch of the first frame.
  static constexpr double kLatestOnset = 0.9 * kFrame;
  static constexpr double kLooseTolerance = 1e-2; ///< see caution() and isPayable()
  static constexpr int kLongestDescent = 64;      ///< stretches before something else is tried again
  static constexpr int kSettling = 2; ///< checks before a method that has just been chosen may be left
  static constexpr double kGuessedRough = 0.1; ///< see m_roughOverLocal, before the first check
  static constexpr int kSecondBlock = 2;       ///< the first one has a hand that has just come
  static constexpr int kRoughCheckGap = 16, kLeastRoughGap = 6, kMostRoughGap = 256;
  static constexpr double kFiner = 1.5; ///< steps of the second run of a check, in those of the first
  /// Of a stretch that is done twice, if that is many steps [s]. Where the end is known a third of the frame
  /// saves 3 % of all passes; a quarter is too short to tell: errors of uteri and organs came out up to five
  /// times too large. Where it is not, a third was too short for a blow: a struck organ ended at 1.3 and 1.9
  /// times a tolerance of 1e-2.
  double checkLength() const noexcept
  {
    return std::isfinite(knownEnd(m_start.time)) ? kFrame / 3.0 : kFrame / 2.0;
  }
  /// What is known of a method's errors.
  struct Knowledge {
    double accurateStep = 0.0;    ///< by the last check, or a guess [s]
    double estimate = 0.0;        ///< the same without the hysteresis [s]
    bool isMeasured = false;      ///< since it was chosen
    double cheapStep = kInfinity; ///< larger ones would cost more [s]
  };
  struct Candidate : Knowledge {
    std::unique_ptr<Integrator> integrator;
    MethodRole role = MethodRole::ByName;
    double typicalError = 0.0, offset = 0.0, typicalErrorOfWaves = 0.0; ///< see IntegratorEntry
    double affordableStep = 0.0; ///< smaller ones would cost more than the effort [s]
    bool prepared = false;
    std::optional<Method> sharper = std::nullopt; ///< its twin, see IntegratorEntry
    int untilProbe = 0; ///< checks until it may be probed; long gaps count as several
    int probeGap = 1;
    double probedStep = 0.0; ///< in the present check; 0: in none [s]
  };
  /// The first moments after an event, while stretches are shorter than usual.
  struct Onset {
    double longest = 0.0;         ///< stretch now [s]; 0: there is no onset
    Method method = 0;            ///< before it
    double affordable = 0.0;      ///< what is left of the first stretch's work [spring evaluations]
    std::vector<Knowledge> known; ///< of each candidate before it: what is learned in it holds in it
  };

  static bool competes(const Candidate& candidate) noexcept
  {
    return candidate.role == MethodRole::Explicit || candidate.role == MethodRole::Local;
  }
  static bool isExplicit(const Candidate& candidate) noexcept
  {
    return competes(candidate) || candidate.role == MethodRole::ExplicitByName;
  }
  /// The largest stable step [s]. The bound is exact only for a frozen net; stiffening springs get a margin
  /// until the next look.
  double stableStep(const Candidate& candidate) const noexcept
  {
    return 0.95 * candidate.integrator->stableStep(m_mode);
  }
  Integrator& current() noexcept { return *m_candidates[m_method].integrator; }
  void use(Method method);
  void layOut(Method method, const System& system);
  void guessSteps();
  void guessStep(Candidate& candidate) const noexcept;
  void guessStepAtLeast(Candidate& candidate) const noexcept;
  void choose(System& system, const MotionState& state);
  void reconsider(System& system, std::optional<Method> proven = std::nullopt);
  double cost(Method method, const System& system);
  double costAtLimit(Method method, const System& system);
  bool isPayable(Method method, const System& system);
  double caution() const noexcept;
  double effort(const System& system) const noexcept; ///< [spring evaluations]
  double spendable(const Candidate& candidate) const noexcept;
  bool isHeldUp() const noexcept;
  bool isDamped() const noexcept;
  void setBound(const System& system, const MotionState& state);
  void replaceBound(const System& system, const MotionState& state, bool now);
  bool boundMatters(const System& system) const noexcept;
  void weighSteps(const System& system);
  void weighEffort(const System& system, Candidate& candidate) const;
  void refreshBound(const System& system, const MotionState& state);
  double passesOf(const System& system, double step);
  bool mayTakeBlocks(const System& system) const noexcept;
  bool areBlocksWithin() const noexcept;
  bool isLedByBlocks() const noexcept { return m_handLeads && m_blocksSuffice; }
  void followHand(const System& system);
  bool wantsBlocks(const System& system, double plainCost) const noexcept;
  void weighLeastCost(const System& system);
  double explicitLimit() const noexcept;
  Method cheapestExplicit(const System& system, double patience);
  bool isOutdone(Method method) const noexcept;
  void tellTwins(Method measured) noexcept;
  double patience() const noexcept;
  std::optional<Method> worthAProbe(System& system, double& step);
  std::optional<Method> probeOthers(System& system, const MotionState& state, double allowed,
                                    StepReport& report);
  std::optional<Method> probe(System& system, const MotionState& state, double allowed, StepReport& report);
  std::optional<Method> probeNext(System& system, const MotionState& state, double allowed,
                                  StepReport& report);
  StepResult runProbe(Integrator& integrator, System& system, const MotionState& state, std::int64_t steps,
                      double& early, StepReport& report);
  bool tryOut(Method method, double step, System& system, const MotionState& state, double allowed,
              StepReport& report);
  bool paysOff(double saving, double price) const noexcept;
  bool toleranceIsTooDear(const System& system);

  bool stretchFixed(System& system, MotionState& state, double end, StepReport& report);
  bool stretchControlled(System& system, MotionState& state, double end, StepReport& report);
  enum class Run { Done, Limit, NonFinite, NotConverged };
  Run run(System& system, MotionState& state, double end, std::int64_t steps, StepReport& report);
  static StepResult runInPieces(Integrator& method, System& system, MotionState& state, double end,
                                std::int64_t steps, StepReport& report);
  StepResult runInFrames(System& system, MotionState& state, double end, std::int64_t steps,
                         StepReport& report);
  void note(double begin, double end, std::int64_t steps);
  std::int64_t stepsLeft(const System& system, double step, const StepReport& report);
  Run runWithLook(System& system, MotionState& state, double end, std::int64_t steps, StepReport& report);
  Run runAgain(System& system, MotionState& state, double end, std::int64_t steps, StepReport& report);
  bool fallBackToLeapfrog(System& system, double length);
  bool stretchRoughly(System& system, MotionState& state, double end, StepReport& report);
  Run stretchByDescent(System& system, MotionState& state, double end, StepReport& report);
  Run stretchByBlocks(System& system, MotionState& state, double end, StepReport& report);
  void learnRough(double error, double local) noexcept;
  double roughError() const noexcept;
  Run runRoughly(Method method, System& system, MotionState& state, double end, std::int64_t steps,
                 StepReport& report);
  /// Since the start of the stretch [J].
  struct EnergyBalance {
    double gained = 0.0;     ///< without work; what dampers have taken counts as a loss
    double heat = 0.0;       ///< that they have taken
    double turnedOver = 0.0; ///< was there, has been worked and has fallen
    double high = 0.0;       ///< size of that of weight at the start, for the rounding of its differences
  };
  EnergyBalance energyBalance(const System& system, const MotionState& state);
  bool energyAppeared(const System& system, const EnergyBalance& balance, double share) noexcept;
  bool hasQuickened(const System& system, const MotionState& state) const noexcept;
  bool accept(System& system, const MotionState& state, std::int64_t steps, std::int64_t finer,
              StepReport& report);
  void bookLoss(const System& system, MotionState& state, Method method, double step);
  double errorOfFirst(System& system, const MotionState& state, double ratio);
  static double lostWaves(const System& system, const EnergyBalance& balance, double step) noexcept;
  double swing(System& system, double distance, const NodeArray& otherV, const MotionState& state);
  double addingUp(const Candidate& candidate, const System& system, const NodeArray& otherX,
                  const NodeArray& otherV, const MotionState& state) const noexcept;
  bool isTooDear(const System& system, double work) const noexcept;
  void stopAtLimit(const System& system, MotionState& state, StepReport& report);
  void retreat(System& system, MotionState& state, int attempt, double length, StepReport& report);
  bool checkDue(const MotionState& state) const noexcept;
  void learn(const MotionState& state, double error, double budget, double step);
  void learnOverLocal(double error, double length) noexcept;
  void learnCost(double step) noexcept;
  double controlledStep(double length) noexcept;
  double longestCheck() noexcept;
  bool hasRoomAbove(double step) const noexcept;
  void giveToleranceUp(const System& system, bool yes);
  void rememberBeforeOnset();
  double beginOnset(double length, double count) noexcept;
  void continueOnset();
  double budget(const MotionState& state, double length) const noexcept;
  double expectedError(const MotionState& state) const noexcept;
  double floorStep() const noexcept; ///< accuracy is not pursued below it [s]; 0 = always pursued
  void sayToleranceGivenUp();
  void sayRough(Method method, const char* why);
  void keep(const System& system, const MotionState& state, double error, double beyond = 0.0) noexcept;
  Index nameOf(Index node) const noexcept; ///< its place in the whole net
  void giveUp(const System& system, Run failure, StepReport& report);
  void comeDown() noexcept;
  void findBodies(const System& system, const MotionState& state);
  void forget() noexcept;
  void explain();

  SolverSettings m_settings;
  double m_firstTolerance, m_firstEffort; ///< as wanted, see isPayable()
  bool m_auto = false;
  Method m_leapfrog = 0, m_implicit = 0; ///< the planner's first explicit choice and its refuge
  Method m_descent = 0;                  ///< where that fails, too
  Method m_blocks = 0;                   ///< for whoever keeps time with a clock
  Method m_method = 0;
  std::string m_name, m_why;
  std::string m_limitText;             ///< of the last advance(), if its work limit ended it
  std::vector<Candidate> m_candidates; ///< in the table's order
  FreeBodies m_bodies;
  StepBound m_bound;
  FastestMode m_mode;
  struct Stiffest {
    Index node = kNoIndex; ///< in the whole net
    double mass = 0.0;     ///< [kg]
  };
  Stiffest m_stiffest; ///< as m_mode was found; its node is a place in a part that may have changed since
  double m_sinceBound = 0.0;    ///< work since m_mode was found, see refreshBound() [force passes]
  double m_boundPatience = 1.0; ///< how much longer than usual it may be
  bool m_boundIsOld = false;    ///< of another part of the net, or before other tools; blocks need none
  bool m_fewHoldAll = false;    ///< a few nodes ask for the small steps, see StiffNodes
  bool m_toleranceGivenUp = false;
  bool m_roughAtCheck = false;          ///< the last check found more error than wanted, and left it at that
  bool m_byBlocks = false;              ///< the clock wants them now
  bool m_handLeads = false;             ///< tools that move hold the net, see ToolSpring
  bool m_blocksSuffice = true;          ///< for their motion, as far as checks have told
  double m_leastCost = 0.0;             ///< of a frame, whatever the tolerance [spring evaluations]
  double m_floorStep = 0.0;             ///< smallest implicit step while the tolerance is given up [s]
  double m_grown = 0.0, m_growth = 0.0; ///< energy that appeared up to the present stretch, up to its end [J]
  int m_settled = 0;                    ///< stretches before the method may change again
  int m_descents = 0;                   ///< stretches of descent still to come
  int m_descentTerm = 0;                ///< how many there were after the last failure
  int m_untilCheck = 0;                 ///< stretches until the next one that is done twice
  int m_checkGap = 1;
  double m_checkedError = 0.0;             ///< that the present steps add, by the last check [m/s]
  double m_checkedPower = 0.0;             ///< of the dampers then [W]
  double m_localError = 0.0;               ///< of the present stretch's first run, see Integrator [m]
  double m_roughLocal = 0.0;               ///< the same of the last rough stretch
  double m_roughOverLocal = kGuessedRough; ///< its error over that [1]
  std::int64_t m_checkedSteps = 0;         ///< of a stretch, by the last check
  double m_unsweptOverLocal = 0.0, m_unswept = 0.0; ///< what the last check found beyond [1], [m]
  int m_untilRoughCheck = kSecondBlock;             ///< stretches by blocks
  int m_roughCheckGap = kRoughCheckGap;             ///< longer where the last check was broken off
  double m_errorOverLocal = 0.0;                    ///< error of a stretch over that [1]; 0: not known
  double m_growing = 1.0;                           ///< part of it that goes on to grow
  double m_coarseWork = 0.0, m_finerWork = 0.0;     ///< of the two runs of a check [spring evaluations]
  double m_checkedShare = 0.0;                      ///< of the budget, that the last check found
  double m_checkedTime = 0.0;                       ///< when the last check that passed began [s]
  Onset m_onset;
  std::int64_t m_maxSteps = 0;   ///< of this advance(); 0: any number
  double m_mostWork = kInfinity; ///< of this advance() [spring evaluations]

  std::vector<Stretch>* m_stretches = nullptr; ///< where they are written down; not owned

  std::vector<Index> m_names;  ///< of the whole net's nodes; empty: their places
  std::vector<Index> m_places; ///< of the system's nodes in the whole net; empty: it is the whole net
  ErrorGauge m_gauge;
  MotionState m_start; ///< of the present stretch
  MotionState m_probe; ///< the same stretch by another method
  struct Energies {
    double kinetic = 0.0, elastic = 0.0, height = 0.0; ///< [J]
  };
  std::optional<Energies> m_startEnergies; ///< of m_start, once somebody asked
  NodeArray m_coarse, m_coarseV;           ///< end of the first of two runs
  StepLoss m_loss;
  /// Stretches of which nobody has looked yet what they have lost.
  struct Unseen {
    MotionState start;
    double passes = 0.0; ///< their work [force passes]
    bool isOpen = false; ///< there are some
  };
  Unseen m_unseen;
  /// Of the present check, early in the stretch. No steps: none was taken.
  struct Look {
    NodeArray x;            ///< of the first run
    std::int64_t steps = 0; ///< of it up to here, an even number
    double time = 0.0;
    double share = 1.0; ///< of the stretch
    double error = 0.0; ///< how far the second run was from it [m]
  };
  Look m_look;
  bool m_checksFromAbove = false; ///< the kept run of a check takes the present step, see hasRoomAbove()
};

} // namespace esm
