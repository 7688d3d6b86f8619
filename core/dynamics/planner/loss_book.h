// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/planner/energy_guard.h"
#include "core/dynamics/system/step_loss.h"

namespace esm {

/// Books what a method loses into MotionState::loss: by a quadrature over some stretches at a time where the method
/// does not find it by itself.
class LossBook {
public:
  explicit LossBook(const Policy& policy) noexcept : m_policy(&policy) {}

  /// Another net.
  void prepare(const System& system);
  void drop() noexcept
  {
    m_unseen.isOpen = false;
  } ///< what is not booked yet, as other forces act from now on
  /// After a stretch of steps of this length [s] from `start` to `state`. A look costs a fiftieth of the work since the
  /// last one, whatever stretches lie between.
  void book(const System& system, const MotionState& start, MotionState& state, Integrator& integrator,
            double step, EnergyGuard& energy, double tolerance);
  /// What has been lost up to `state` and not booked yet [J]; from now on it is.
  double close(const System& system, const MotionState& state, double tolerance);

private:
  void bookLoan(const System& system, const MotionState& start, MotionState& state, EnergyGuard& energy);

  const Policy* m_policy;
  StepLoss m_loss;
  /// Stretches of which nobody has looked yet what they have lost.
  struct Unseen {
    MotionState start;
    double passes = 0.0; ///< their work [force passes]
    bool isOpen = false; ///< there are some
  };
  Unseen m_unseen;
};

} // namespace esm
