// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/methods/integrator.h"
#include "tests/support/nets.h"

#include <memory>
#include <string_view>

namespace esm::test {

/// A mass of 1 kg on a spring of 10 km, so that nothing turns, 1 m from its rest; moved by one method, which
/// is told how fast the net is.
struct OneMass {
  /// @param w,damping  of the mass [1/s]
  OneMass(std::string_view name, double w, double damping, const FastestMode& mode)
    : system(netOf(w, damping), {}), method(makeIntegrator(name))
  {
    motion.x = {Lanes{0, 0, 0, 0}, Lanes{kLength + 1.0, 0, 0, 0}};
    motion.v.assign(2, Lanes{0, 0, 0, 0});
    system.enter(motion, true);
    method->prepare(system);
    method->tune(system, mode);
  }
  StepResult run(double end, std::int64_t steps) { return method->run(system, motion, end, steps, report); }
  double displacement() const { return motion.x[1][0] - kLength; } ///< [m]

  static constexpr double kLength = 1e4;
  static SpringNet netOf(double w, double damping)
  {
    SpringNet net = chain(2, kLength, w * w);
    net.fixed[0] = 1;
    net.viscosity[0] = damping;
    return net;
  }

  System system;
  MotionState motion;
  std::unique_ptr<Integrator> method;
  StepReport report;
};

} // namespace esm::test
