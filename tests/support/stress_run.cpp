// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/support/stress_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace esm::test {
namespace {

bool isFinite(const Simulation& simulation)
{
  return simulation.state().position.allFinite() && simulation.state().velocity.allFinite() &&
         std::isfinite(simulation.energies().total()) && std::isfinite(simulation.externalWork()) &&
         std::isfinite(simulation.dissipatedEnergy());
}

/// Books energy from frame to frame.
class EnergyBook {
public:
  explicit EnergyBook(const Simulation& simulation) { open(simulation); }

  /// What has happened since the last call has changed the energy by right: parameters.
  void open(const Simulation& simulation)
  {
    m_before = simulation.energies();
    m_work = simulation.externalWork();
    m_scale = std::max(m_scale, m_before.kinetic + std::abs(m_before.elastic));
  }
  /// @return energy that has appeared in the frame, over the scale.
  double close(const Simulation& simulation)
  {
    const Energies now = simulation.energies();
    const double work = simulation.externalWork() - m_work;
    m_worked += std::abs(work);
    m_fallen += std::abs(now.gravity - m_before.gravity);
    m_scale = std::max(m_scale, now.kinetic + std::abs(now.elastic));
    const double gained = now.total() - m_before.total() - work;
    m_gained += gained;
    m_before = now;
    m_work = simulation.externalWork();
    return gained / scale();
  }
  double balance() const { return m_gained / scale(); }

private:
  double scale() const { return std::max(m_scale + m_worked + m_fallen, 1e-300); }

  Energies m_before;
  double m_work = 0.0, m_scale = 0.0, m_worked = 0.0, m_fallen = 0.0, m_gained = 0.0;
};

} // namespace

StressResult runStress(const StressCase& story, const SolverSettings& settings)
{
  StressResult result;
  Result<Simulation> created = Simulation::create(story.net, story.loads, settings);
  if (!created) {
    result.broken = created.error().detail;
    return result;
  }
  result.created = true;
  Simulation simulation = std::move(created).value();
  EnergyBook book(simulation);
  auto change = story.changes.begin();
  for (int frame = 0; frame < story.frames && result.badFrames == 0; ++frame) {
    for (; change != story.changes.end() && change->frame == frame; ++change) {
      if (change->tools) simulation.setTools(*change->tools);
      if (!change->net) continue;
      book.close(simulation);
      if (const Status status = simulation.setParameters(*change->net); !status)
        result.broken = status.error().detail;
      book.open(simulation);
    }
    const double before = simulation.state().time;
    const StepReport report = simulation.advance(1.0 / 60.0);
    result.sum.add(report);
    result.frameCost =
      std::max(result.frameCost, static_cast<double>(report.springsEvaluated) / settings.effort);
    result.finite = isFinite(simulation);
    result.frameGrowth = std::max(result.frameGrowth, book.close(simulation));
    result.balance = std::max(result.balance, book.balance());
    if (!result.finite) break;
    if (report.good()) {
      if (!(std::abs(simulation.state().time - before - 1.0 / 60.0) < 1e-9)) result.broken = "time is lost";
    } else {
      ++result.badFrames;
      result.limited = report.stepLimit;
      if (simulation.state().time - before >= 1.0 / 60.0)
        result.broken = "a bad report with the whole frame done";
    }
  }
  result.solver = simulation.solverName();
  result.why = simulation.why();
  return result;
}

StressSummary sweepStress(std::uint32_t first, std::uint32_t last, const SolverSettings& settings,
                          double growth, double cost)
{
  StressSummary summary;
  for (std::uint32_t seed = first; seed < last; ++seed) {
    const StressResult result = runStress(stressCase(seed), settings);
    EXPECT_TRUE(result.finite) << "seed " << seed << ": " << result.why;
    EXPECT_EQ(result.badFrames, 0) << "seed " << seed << ": " << result.why;
    EXPECT_EQ(result.broken, "") << "seed " << seed;
    EXPECT_LE(result.balance, growth) << "seed " << seed << ": " << result.why;
    EXPECT_LE(result.frameGrowth, growth) << "seed " << seed << ": " << result.why;
    EXPECT_LE(result.frameCost, cost) << "seed " << seed << ": " << result.why;
    ++summary.cases;
    summary.badFrames += result.badFrames;
    summary.growth = std::max({summary.growth, result.balance, result.frameGrowth});
    summary.frameCost = std::max(summary.frameCost, result.frameCost);
    ++summary.solvers[result.solver];
  }
  return summary;
}

} // namespace esm::test
