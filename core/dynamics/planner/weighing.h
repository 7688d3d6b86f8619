// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/knowledge.h"

namespace esm {

/// What a plan is made from besides what is known of the methods: numbers, read off the net, the motion and what
/// was asked for.
struct Observation {
  bool isAuto = true;
  double tolerance = 1e-3;
  double effort = std::numeric_limits<double>::infinity(); ///< asked for [spring evaluations a frame]
  double affordable = std::numeric_limits<
    double>::infinity();    ///< of that, what the work limit bears [spring evaluations a frame]
  bool asksForLess = false; ///< than at first, because the clock could not be kept
  double springs = 0.0;     ///< that are active: a force pass [spring evaluations]
  bool isDamped = false;    ///< dampers brake the fastest waves more than springs throw them
  bool fewHoldAll = false;  ///< a few nodes ask for the small steps, see StiffNodes
  bool isByBlocks = false;  ///< the clock wants them now
  double calm = 0.0;        ///< since the start or the last event [s]
  bool isOnset = false;     ///< the first moments after an event are cut into short stretches
  double timeLeft =
    std::numeric_limits<double>::infinity();     ///< until the end of the run, if that is known [s]
  double lastingShare = 1.0, typicalShare = 1.0; ///< see ErrorGauge
  double leastCost = 0.0;                        ///< of a frame, whatever the tolerance [spring evaluations]
};

/// The method that runs, and for how long nobody may change it.
struct Choice {
  Method method = 0;
  int settled = 0;                 ///< stretches before the method may change again
  bool isToleranceGivenUp = false; ///< steps have to stay bounded only
  double floorStep = 0.0;          ///< smallest implicit step then [s]
};

/// What steps cost and what they may err, by what is known; and so which method should run. Of a net it knows only
/// facts and observations. To ask for the cost of a local or implicit method may lay that out.
class Weighing {
public:
  Weighing(const Policy& policy, const Observation& observation, Knowledge& known,
           MethodFacts& facts) noexcept
    : m_policy(policy), m_now(observation), m_known(known), m_facts(facts)
  {}

  double stableStep(Method method) const noexcept; ///< with the margin [s]
  double explicitLimit() const noexcept
  {
    return m_facts.limit(m_facts.plain());
  }                                    ///< that one pass can take [s]
  bool isHeldUp() const noexcept;      ///< explicit steps are so many that other ways are worth weighing
  double checkLength() const noexcept; ///< of a stretch that is done twice, if that is many steps [s]

  double cost(Method method);
  double costAtLimit(Method method);
  double caution() const noexcept;
  double spendable(Method method) const noexcept;
  bool isPayable(Method method);
  bool paysOff(double saving, double price) const noexcept;
  bool isOutdone(Method method) const noexcept;
  double plainCost(); ///< of a frame of plain steps at their limit [spring evaluations]
  double leastCost(); ///< the same, or of one implicit step where these are many
  bool isToleranceTooDear();
  double affordableStep(Method method);

  /// Among those that compete.
  /// @param present  the method that runs; its cost counts as a share `patience` of it: a change must pay
  Method cheapestExplicit(Method present, double patience);
  /// Before anything has been measured.
  Choice first();
  /// After a check: would another method have done it for less?
  /// @param proven  one that has been probed and found good
  Choice reconsider(Choice choice, std::optional<Method> proven);
  /// The tolerance is given up, or kept again.
  void giveUpTolerance(Choice& choice, bool isGivenUp);
  Expectation expectation() const noexcept { return {m_now.tolerance, m_now.typicalShare, m_now.isDamped}; }
  /// Accuracy is not pursued below it [s]; 0: it always is.
  double floorStep(const Choice& choice) const noexcept;
  /// The step that is stable, accurate, and not larger than is cheap; at most `length` [s].
  double controlledStep(const Choice& choice, double length) const noexcept;

  /// The method that would be cheapest at its stability limit, and cheap enough to change to, of those whose turn it
  /// is and whose errors, by what is known or guessed, leave a hope.
  struct Proposal {
    Method method = 0;
    double step = 0.0; ///< the smallest with which it would be cheap enough [s]
  };
  std::optional<Proposal> worthAProbe(Method present);

private:
  bool isLoose() const noexcept { return m_now.tolerance >= m_policy.choice.looseTolerance; }

  const Policy& m_policy;
  const Observation& m_now;
  Knowledge& m_known;
  MethodFacts& m_facts;
};

} // namespace esm
