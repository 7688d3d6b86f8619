// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/simulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace esm::test {

/// Creation that must succeed.
inline Simulation simulate(SpringNet net, Loads loads = {}, SolverSettings settings = {})
{
  Result<Simulation> simulation = Simulation::create(std::move(net), std::move(loads), std::move(settings));
  if (!simulation) ADD_FAILURE() << simulation.error().detail;
  return std::move(simulation).value();
}

inline SolverSettings fixedSteps(const std::string& solver, double step)
{
  SolverSettings settings;
  settings.solver = solver;
  settings.fixedStep = step;
  return settings;
}

/// kinetic + elastic + gravity + heat - work: constant in time, whatever happens.
inline double balance(const Simulation& simulation)
{
  return simulation.energies().total() + simulation.dissipatedEnergy() - simulation.externalWork();
}

inline void advanceWell(Simulation& simulation, double time)
{
  const StepReport report = simulation.advance(time);
  ASSERT_TRUE(report.good()) << simulation.why();
}

} // namespace esm::test
