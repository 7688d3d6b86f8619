// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/loads.h"
#include "core/net/parameter_patch.h"
#include "core/net/spring_net.h"

#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace esm {

/// A piece of a motion as it was kept: equal steps of one method.
struct Stretch {
  double begin = 0.0, end = 0.0; ///< [s]
  std::int64_t steps = 0;
  std::string method; ///< a name of solverNames()
  bool operator==(const Stretch&) const = default;
};

/// What a Simulation was asked, and what it did: see MotionLog.
namespace logged {

struct Tools {
  std::vector<ToolSpring> springs;
};
struct Patch {
  ParameterPatch patch;
};
struct Net {
  SpringNet net;
};
struct Accuracy {
  double tolerance = 0.0, effort = 0.0;
};
struct Reset {};
struct GrowthWatch {};

struct Advance {
  static constexpr std::int64_t kAll = std::numeric_limits<std::int64_t>::max();
  /// Of the net, that moves on its own (see Simulation).
  struct Part {
    bool isMoved = false; ///< the budget lasted until its turn
    std::int64_t grants =
      kAll; ///< questions of the budget that were answered with "go on" before the first "stop"
    std::vector<Stretch> stretches = {};
  };
  double interval = 0.0;  ///< asked for [s]
  std::int64_t steps = 0; ///< Budget::steps
  bool isAsked = false;   ///< there was a Budget::isSpent
  std::vector<Part> parts = {};
  double time = 0.0;       ///< at the end [s]
  std::uint64_t state = 0; ///< hash over positions and velocities then
};

} // namespace logged

using LogEntry = std::variant<logged::Tools, logged::Patch, logged::Net, logged::Accuracy, logged::Reset,
                              logged::GrowthWatch, logged::Advance>;

/// A run as Simulation::record() writes it down: enough to do it again to the bit with Simulation::replay(), from
/// a Simulation of the same net, loads and settings, on any number of threads. Calls that a clock ended are among
/// that: the log counts the questions that it had answered.
using MotionLog = std::vector<LogEntry>;

} // namespace esm
