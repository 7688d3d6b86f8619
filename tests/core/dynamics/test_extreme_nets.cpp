// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Nets that no tissue is like: whatever becomes of their tolerance, numbers stay finite, what nothing holds
// falls and flies as it must, the work has a limit, and a run that says that it is good has its energy.
#include "tests/support/extreme_nets.h"
#include "tests/support/free_centres.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace esm::test {
namespace {

constexpr double kDuration = 0.2; // [s]
/// Of the work limit; what one stretch may cost beyond it is checked when it is done.
constexpr double kOverdrawn = 1.5;

struct Outcome {
  bool isFinite = true, isGood = true, isRough = false, isLimited = false;
  EnergyReport report;
  double centres = 0.0; ///< see FreeCentres
  double energy = 0.0;  ///< what has appeared without work, over the largest entry in the books
  double passes = 0.0;  ///< over what the limit allows
  std::string why, solver;
};

bool isFinite(const Simulation& simulation)
{
  return simulation.state().position.allFinite() && simulation.state().velocity.allFinite();
}

/// Releases fall on multiples of a third of a frame; there the flight of a part begins.
Outcome play(const ExtremeCase& story, SolverSettings settings)
{
  Outcome outcome;
  settings.duration = kDuration;
  Result<Simulation> created = Simulation::create(story.net, story.loads, settings);
  if (!created) {
    ADD_FAILURE() << created.error().detail;
    return outcome;
  }
  Simulation& simulation = *created;
  FreeCentres centres(simulation.net(), simulation.loads(), simulation.state());
  const int parts = story.loads.motions.empty() ? 1 : 3,
            frames = static_cast<int>(std::lround(60 * kDuration));
  const double start = simulation.energies().total();
  double largest = std::max(simulation.energies().kinetic, simulation.energies().elastic);
  StepReport sum;
  for (int i = 1; i <= frames * parts && sum.good(); ++i) {
    sum.add(simulation.advance(i / (60.0 * parts) - simulation.state().time));
    outcome.isFinite = outcome.isFinite && isFinite(simulation);
    if (!outcome.isFinite) break;
    outcome.centres = std::max(outcome.centres, centres.look(simulation.state()));
    const Energies now = simulation.energies();
    for (const double entry : {now.kinetic, now.elastic, std::abs(now.gravity),
                               std::abs(simulation.externalWork()), simulation.dissipatedEnergy()})
      largest = std::max(largest, entry);
  }
  const double appeared = simulation.energies().total() - start - simulation.externalWork();
  outcome.energy = appeared / std::max(largest, 1e-300);
  outcome.report = simulation.energyReport();
  outcome.isGood = sum.good();
  outcome.isRough = sum.rough;
  outcome.isLimited = sum.stepLimit;
  const double springs = std::max<double>(simulation.net().springCount(), 1.0);
  const double steps =
    static_cast<double>(sum.steps) / static_cast<double>(simulation.islandCount()); // each has its limit
  outcome.passes =
    std::max(static_cast<double>(sum.springsEvaluated) / springs, steps) / (settings.workLimit * frames);
  outcome.why = simulation.why();
  outcome.solver = simulation.solverName();
  return outcome;
}

/// Thirty cases from the seed on.
void expectKept(ExtremeCase (*caseOf)(std::uint32_t), std::uint32_t first)
{
  const char* more = std::getenv("ESM_EXTREME_SEEDS"); // added to the seeds: to try others
  if (more != nullptr) first += static_cast<std::uint32_t>(std::atoi(more));
  int kept = 0, given = 0, limited = 0;
  std::vector<std::uint32_t> unkept;
  for (std::uint32_t seed = first; seed < first + 30; ++seed) {
    SolverSettings settings;
    settings.workLimit = 2e4; // that a pass costs as much as it does is none of the matter
    const Outcome outcome = play(caseOf(seed), settings);
    EXPECT_TRUE(outcome.isFinite) << "seed " << seed << ": " << outcome.why;
    EXPECT_LE(outcome.centres, 1.0) << "seed " << seed << ": " << outcome.why;
    EXPECT_LE(outcome.passes, kOverdrawn) << "seed " << seed << ": " << outcome.why;
    if (outcome.isGood && !outcome.isRough) {
      if (outcome.report.isKept(settings.tolerance))
        EXPECT_LE(outcome.energy, settings.tolerance) << "seed " << seed << ": " << outcome.why;
      else
        unkept.push_back(seed); // `esm simulate` says so, with exit code 3
    }
    kept += outcome.isGood && !outcome.isRough;
    given += outcome.isGood && outcome.isRough;
    limited += outcome.isLimited;
  }
  // Where nodes pass through each other in one step the quadrature of the loss may give up.
  EXPECT_LE(unkept.size(), 1u) << ::testing::PrintToString(unkept);
  ::testing::Test::RecordProperty("kept", kept);
  std::cout << "kept " << kept << ", given up " << given << ", limited " << limited << '\n';
}

} // namespace

class ExtremeNets : public ::testing::TestWithParam<std::uint32_t> {};
class UnevenNets : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(ExtremeNets, KeepWhatNobodyMayGiveUp)
{
  expectKept(extremeCase, GetParam());
}

TEST_P(UnevenNets, KeepWhatNobodyMayGiveUp)
{
  expectKept(unevenCase, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Seeds, ExtremeNets, ::testing::Range(0u, 300u, 30u));
// Nets of which one was left a few per cent beyond the line of momentum: what trembles runs far and comes
// nowhere, and the line is about where it comes; of others energy had appeared and nothing was said.
INSTANTIATE_TEST_SUITE_P(FurtherSeeds, ExtremeNets, ::testing::Values(300150u, 350140u, 8100000u, 8100150u));
// Among these: a pair that drifts after it has been shaken, and four nodes whose springs stiffen between two
// of few steps and made seven times their energy.
INSTANTIATE_TEST_SUITE_P(OtherSeeds, ExtremeNets, ::testing::Values(50140u, 110040u, 110210u));
INSTANTIATE_TEST_SUITE_P(Seeds, UnevenNets, ::testing::Range(0u, 300u, 30u));

} // namespace esm::test
