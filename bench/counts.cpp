// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The work of `auto` in units that no machine changes: to be held against the same of another state of the sources.
#include "bench/policy_table.h"
#include "bench/runs.h"
#include "bench/sub_benches.h"
#include "core/base/text_number.h"
#include "core/dynamics/simulation.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <memory>

namespace esm::bench {
namespace {

/// As `esm simulate` runs it: the tolerance is kept, whatever it takes.
bool count(const Scene& scene, double tolerance, const std::shared_ptr<const Policy>& policy)
{
  SolverSettings settings = settingsOf(scene, tolerance);
  settings.policy = policy;
  Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
  if (!simulation) return false;
  StepReport sum;
  for (long frame = 0; frame < scene.frames() && sum.good(); ++frame)
    sum.add(simulation->advance(1.0 / kFrameRate));
  std::printf("\"%s\",%s,%s,%" PRId64 ",%" PRId64 ",%" PRId64 ",%" PRId64 "\n", scene.name.c_str(),
              formatDouble(tolerance).c_str(), simulation->solverName().c_str(), sum.steps, sum.rejectedSteps,
              sum.springsEvaluated, sum.factorizations);
  std::fflush(stdout);
  return sum.good();
}

} // namespace

int runCounts(const std::vector<std::string>& words)
{
  const auto policy = std::make_shared<Policy>();
  std::vector<std::string> names;
  for (const std::string& word : words)
    if (const auto constant = std::ranges::find(constants(), word, &Constant::name);
        constant != constants().end())
      constant->leaveOut(*policy);
    else
      names.push_back(word);
  if (names.empty()) names = {"tube", "uterus", "sheet", "stiff", "organ100k", "organ100k:time=1"};
  std::printf("scene,tolerance,method,steps,rejected,springs,factors\n");
  for (const std::string& name : names) {
    const Result<Scene> scene = makeScene(name);
    if (!scene) {
      std::fprintf(stderr, "%s\n", scene.error().detail.c_str());
      return 2;
    }
    for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4, 1e-6})
      if (!count(*scene, tolerance, policy)) return 1;
  }
  return 0;
}

} // namespace esm::bench
