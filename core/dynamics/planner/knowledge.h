// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/method_facts.h"
#include "core/dynamics/planner/policy.h"

#include <limits>
#include <vector>

namespace esm {

/// What checks have told of a method's steps, or a guess before the first one.
struct KnownSteps {
  double accurateStep = 0.0;                                  ///< by the last check, or a guess [s]
  double estimate = 0.0;                                      ///< the same without the hysteresis [s]
  bool isMeasured = false;                                    ///< since it was chosen
  double cheapStep = std::numeric_limits<double>::infinity(); ///< larger ones would cost more [s]
};

/// What is known of one method.
struct MethodKnowledge : KnownSteps {
  double affordableStep = 0.0; ///< smaller ones would cost more than the effort [s]
  int untilProbe = 0;          ///< checks until it may be probed; long gaps count as several
  int probeGap = 1;
  double probedStep = 0.0; ///< in the present check; 0: in none [s]
};

/// The largest stable step, with the planner's margin [s].
double stableStep(const Policy& policy, const MethodFacts& facts, Method method) noexcept;

/// What a guess is made from.
struct Expectation {
  double tolerance = 1e-3;
  double typicalShare = 1.0; ///< of what the same steps err in a small net, see ErrorGauge
  bool isDamped = false;     ///< dampers brake the fastest waves more than springs throw them
};

/// A check of a method.
struct Finding {
  double share = 0.0; ///< of the budget, that steps of this length spend
  double step = 0.0;  ///< [s]
};

/// What is known of all methods. Knows no net: what it needs of one are MethodFacts.
/// @note Does not allocate but in resize() and when it is copied.
class Knowledge {
public:
  explicit Knowledge(const Policy& policy) noexcept : m_policy(&policy) {}
  void resize(std::size_t methods) { m_methods.resize(methods); }

  MethodKnowledge& of(Method method) noexcept { return m_methods[method]; }
  const MethodKnowledge& of(Method method) const noexcept { return m_methods[method]; }

  /// Nothing has been measured.
  void guessAll(const MethodFacts& facts, const Expectation& expected);
  void guess(Method method, const MethodFacts& facts, const Expectation& expected);
  /// The guess, unless more is known to do.
  void guessAtLeast(Method method, const MethodFacts& facts, const Expectation& expected);
  /// Another tolerance: what the error's order says, until the next check.
  void rescale(const MethodFacts& facts, double change);

  /// A check has told the method's own step.
  void learnOwn(Method method, const MethodFacts& facts, const Finding& found);
  /// The same for those like it: motion that is easier or harder for this method is so for the others.
  void learnOthers(Method method, const MethodFacts& facts, const Finding& found);
  /// A probe has told.
  void learnProbe(Method method, const MethodFacts& facts, const Finding& found);
  /// Larger implicit steps are not always cheaper: a check has run with `step` and with finer ones.
  void learnCost(Method method, const MethodFacts& facts, double step, double coarseWork,
                 double finerWork) noexcept;
  /// A run has failed with a step of this length [s].
  void learnFailure(Method method, const MethodFacts& facts, double step) noexcept;

  /// After a check that passed: how many others of it have gone by for those that wait for a probe.
  void passCheck(double waited) noexcept;
  void endProbe(Method method, bool isProven) noexcept; ///< unless it is, the next one comes later

  /// Of a frame, whatever the tolerance [spring evaluations].
  double leastCost() const noexcept { return m_leastCost; }
  void setLeastCost(double cost) noexcept { m_leastCost = cost; }

private:
  void tellTwins(Method measured, const MethodFacts& facts) noexcept;
  double mostGrowth(double order) const noexcept;

  std::vector<MethodKnowledge> m_methods;
  const Policy* m_policy;
  double m_leastCost = 0.0;
};

} // namespace esm
