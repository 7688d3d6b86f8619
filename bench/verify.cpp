// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// What `esm simulate --verify` finds, against the reference: does it see a tolerance that is missed, does it
// mend that, and what does it cost?
#include "bench/runs.h"
#include "bench/sub_benches.h"
#include "bench/trajectory.h"
#include "core/base/text_number.h"
#include "core/dynamics/tolerance_check.h"

#include <cmath>
#include <cstdio>

namespace esm::bench {
namespace {

struct Outcome {
  double first = 0.0, result = 0.0; ///< measured against the reference
  std::int64_t firstSprings = 0, springs = 0;
};

Outcome verify(const Scene& scene, const Reference& reference, ToleranceCheck& check)
{
  Outcome outcome;
  double former = 0.0, latest = 0.0;
  ToleranceCheck::Next next = ToleranceCheck::Next::RunAgain;
  for (int runs = 0; ToleranceCheck::isOpen(next); ++runs) {
    Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, check.settings());
    StepReport report;
    ErrorMeter meter(reference);
    check.start(simulation->state());
    for (long frame = 0; frame < scene.frames(); ++frame) {
      const StepReport step = simulation->advance(1.0 / kFrameRate);
      report.add(step);
      check.add(simulation->state(), step);
      meter.add(static_cast<std::size_t>(frame + 1), simulation->state().position);
    }
    if (next == ToleranceCheck::Next::RunAgain) former = latest;
    latest = meter.error();
    outcome.springs += report.springsEvaluated;
    if (runs == 0) {
      outcome.first = latest;
      outcome.firstSprings = report.springsEvaluated;
    }
    next = check.endRun(report);
  }
  outcome.result = next == ToleranceCheck::Next::TakeFormer ? former : latest;
  return outcome;
}

struct Counts {
  int runs = 0, missed = 0, seen = 0, mended = 0, notKept = 0, keptInVain = 0;
};

void measure(const Scene& scene, const Reference& reference, double tolerance, Counts& counts)
{
  ToleranceCheck check(settingsOf(scene, tolerance));
  const Outcome outcome = verify(scene, reference, check);
  const bool missed = outcome.first > tolerance, refined = check.resultTolerance() < tolerance;
  ++counts.runs;
  counts.missed += missed ? 1 : 0;
  counts.seen += missed && refined ? 1 : 0;
  counts.mended += missed && outcome.result <= tolerance && check.kept() ? 1 : 0;
  counts.notKept += check.kept() ? 0 : 1;
  counts.keptInVain += check.kept() && outcome.result > tolerance ? 1 : 0;
  std::printf(
    "\"%s\",%s,%s,%s,%s,%s,%s,%s\n", scene.name.c_str(), formatDouble(tolerance).c_str(),
    formatDouble(outcome.first, 3).c_str(), check.kept() ? "kept" : "not kept",
    formatDouble(check.resultTolerance(), 3).c_str(),
    formatDouble(check.measuredError().value_or(std::nan("")), 3).c_str(),
    formatDouble(outcome.result, 3).c_str(),
    formatDouble(static_cast<double>(outcome.springs) / static_cast<double>(outcome.firstSprings), 3)
      .c_str());
  std::fflush(stdout);
}

} // namespace

int runVerify(const std::vector<std::string>& words)
{
  std::vector<std::string> names;
  std::vector<double> tolerances;
  for (const std::string& word : words)
    if (const std::optional<double> tolerance = parseDouble(word))
      tolerances.push_back(*tolerance);
    else if (word != "--quick")
      names.push_back(word);
  if (tolerances.empty()) tolerances = {1e-1, 1e-2, 1e-3, 1e-4};
  if (names.empty())
    names = {"tube:seed=16,size=0.5", "sheet:seed=1,size=0.1,time=6", "organ100k:seed=1,size=0.02"};
  std::printf("scene,tolerance,error,verdict,tolerance_used,measured_error,error_of_result,cost\n");
  Counts counts;
  for (const std::string& name : names) {
    const Result<Scene> scene = makeScene(name);
    if (!scene) {
      std::fprintf(stderr, "%s\n", scene.error().detail.c_str());
      return 2;
    }
    const Reference reference = referenceOf(*scene);
    for (const double tolerance : tolerances) measure(*scene, reference, tolerance, counts);
  }
  std::fprintf(
    stderr,
    "%d runs, %d miss the tolerance, %d of these are seen, %d mended; %d are said not to keep it, %d to keep "
    "it that do not\n",
    counts.runs, counts.missed, counts.seen, counts.mended, counts.notKept, counts.keptInVain);
  return 0;
}

} // namespace esm::bench
