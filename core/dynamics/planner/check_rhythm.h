// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/policy.h"

namespace esm {

/// When a stretch is done twice, and what the last time has told of those in between.
class CheckRhythm {
public:
  explicit CheckRhythm(const Policy& policy) noexcept : m_policy(&policy) {}

  void reset(double time) noexcept;                ///< nothing has been measured
  void atOnce() noexcept { m_until = 0; }          ///< the next stretch
  void anew() noexcept { m_until = 0, m_gap = 1; } ///< and often from then on
  void oftenFromNow() noexcept { m_gap = 1; }
  void afterProof() noexcept { m_until = m_gap = m_policy->probes.gapAfterProof; }
  void pass() noexcept { --m_until; } ///< a stretch without a check
  bool isDue() const noexcept { return m_until <= 0; }

  /// Longest stretch in the first moments after an event [s]; 0: there is no onset.
  double onset() const noexcept { return m_onset; }
  void setOnset(double longest) noexcept { m_onset = longest; }

  /// What the present stretch's steps err by themselves, see Integrator::takeLocalError() [m].
  void setLocalError(double error) noexcept { m_localError = error; }
  /// Error that a stretch of this length [s] has added if what its steps err by themselves tells what has changed
  /// since the last check, or the dampers' power [W] where no method of next order is at hand [m].
  double expectedError(double length, double power) const noexcept;
  /// Error of the first run of a check [m] over such a stretch [s], beside its local error.
  void learnOverLocal(double error, double length) noexcept;

  /// What a check has found, and so when the next one comes.
  struct Found {
    double share = 0.0;    ///< of the budget
    double error = 0.0;    ///< that the next steps will not exceed [m]
    double length = 0.0;   ///< of the stretch [s]
    double power = 0.0;    ///< of the dampers in it [W]
    bool isHeld = false;   ///< the step cannot shrink as the error asks
    bool grows = false;    ///< the step does
    double timeLeft = 0.0; ///< until the known end [s]
  };
  void learn(const Found& found) noexcept;
  double share() const noexcept { return m_share; } ///< of the budget, that the last check found
  /// A check that began then [s] is kept. @return how many of it the stretches since the one before make, for those
  /// that wait for a probe
  double passCheck(double time) noexcept;

  bool isRough() const noexcept
  {
    return m_isRough;
  } ///< the last check found more than wanted, and left it at that
  void setRough(bool isRough) noexcept { m_isRough = isRough; }
  double growing() const noexcept { return m_growing; } ///< part of an error that goes on to grow
  void setGrowing(double share) noexcept { m_growing = share; }

private:
  const Policy* m_policy;
  int m_until = 0; ///< stretches until the next one
  int m_gap = 1;
  bool m_isRough = false;
  double m_onset = 0.0;
  double m_localError = 0.0;
  double m_errorOverLocal = 0.0; ///< error of a stretch over that [1]; 0: not known
  double m_error = 0.0;          ///< that the present steps add, by the last check [m/s]
  double m_power = 0.0;          ///< of the dampers then [W]
  double m_share = 0.0, m_time = 0.0;
  double m_growing = 1.0;
};

} // namespace esm
