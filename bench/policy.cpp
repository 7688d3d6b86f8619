// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// What the constants of the planner's policy are worth: each is left out in turn, and `auto` runs over scenes by which
// it was never tuned (`holdout`), or over those by which it was (`fit`).
#include "bench/held_out_scenes.h"
#include "bench/policy_table.h"
#include "bench/runs.h"
#include "bench/sub_benches.h"
#include "bench/trajectory.h"
#include "core/base/text_number.h"
#include "core/dynamics/simulation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>

namespace esm::bench {
namespace {

struct PolicyRun {
  double work = 0.0;  ///< force passes and what solvers took besides [spring evaluations]
  double error = 0.0; ///< over the tolerance
  bool isGood = false;
};

struct JudgedScene {
  Scene scene;
  Reference reference;
};

constexpr double kTolerances[] = {1e-1, 1e-2, 1e-3, 1e-4};

PolicyRun run(const JudgedScene& one, double tolerance, const std::shared_ptr<const Policy>& policy)
{
  SolverSettings settings = settingsOf(one.scene, tolerance);
  settings.policy = policy;
  Result<Simulation> simulation = Simulation::create(one.scene.net, one.scene.loads, settings);
  PolicyRun outcome;
  if (!simulation) return outcome;
  ErrorMeter meter(one.reference);
  StepReport report;
  for (long frame = 0; frame < one.scene.frames() && report.good() && !meter.lost(); ++frame) {
    report.add(simulation->advance(1.0 / kFrameRate));
    meter.add(static_cast<std::size_t>(frame + 1), simulation->state().position);
  }
  outcome.work = static_cast<double>(report.springsEvaluated);
  outcome.error = meter.error() / tolerance;
  outcome.isGood = report.good() && !meter.lost();
  return outcome;
}

/// Of the scenes by which the engine is tuned: the bench's own, drawn anew and smaller.
std::vector<Scene> trainScenes()
{
  std::vector<Scene> scenes;
  for (const unsigned seed : {3U, 4U}) {
    scenes.push_back(tube({seed, 1.0, 1.0}));
    scenes.push_back(uterus({seed, 0.5, 0.6}));
    scenes.push_back(sheet({seed, 0.1, 1.0}));
    scenes.push_back(stiff({seed, 0.3, 0.1}));
  }
  scenes.push_back(organ100k({3, 0.02, 0.2}));
  return scenes;
}

/// A thousand times as stiff, pulled as before.
Scene hard(Scene scene)
{
  scene.name = "hard " + scene.name;
  scene.net.stiffness *= 1e3;
  return scene;
}

/// Its dampers are a hundredth.
Scene undamped(Scene scene)
{
  scene.name = "undamped " + scene.name;
  scene.net.viscosity *= 0.01;
  return scene;
}

/// Other shapes, sizes, seeds and loads. Scenes whose motion multiplies errors are no measure of a step's control.
std::vector<Scene> heldOut()
{
  std::vector<Scene> scenes;
  for (HeldOutScene& scene : heldOutScenes())
    if (!scene.foretold && scene.net.nodeCount() <= 2500) scenes.push_back(std::move(scene));
  scenes.push_back(tube({57, 0.6, 1.2}));
  scenes.push_back(uterus({58, 0.3, 0.8}));
  scenes.push_back(sheet({59, 0.05, 1.2}));
  for (const unsigned seed : {60U, 61U, 62U, 63U, 64U, 65U}) scenes.push_back(stiff({seed, 0.2, 0.1}));
  scenes.push_back(hard(tube({66, 0.3, 0.2})));
  scenes.push_back(undamped(sheet({67, 0.04, 1.0})));
  scenes.push_back(sheet({68, 0.6, 0.5}));
  scenes.push_back(organ100k({69, 0.06, 0.2}));
  for (Scene& scene : scenes) scene.duration = std::min(scene.duration, 1.2);
  return scenes;
}

Trajectory follow(const Scene& scene, const char* solver, double tolerance)
{
  SolverSettings settings = settingsOf(scene, tolerance);
  settings.solver = solver;
  Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
  Trajectory frames{simulation->state().position};
  for (long frame = 0; frame < scene.frames(); ++frame) {
    simulation->advance(1.0 / kFrameRate);
    frames.push_back(simulation->state().position);
  }
  return frames;
}

/// The engine's own motion at 1e-6, and how far another method is away from it: textbook references take hours for so
/// many scenes, and are what the other benches measure by.
Reference ownReference(const Scene& scene)
{
  Reference reference;
  reference.frames = follow(scene, "auto", 1e-6);
  reference.agreement = trajectoryError(reference.frames, follow(scene, "dopri5", 1e-5));
  return reference;
}

std::vector<JudgedScene> withReferences(std::vector<Scene> scenes)
{
  std::vector<JudgedScene> cases;
  for (Scene& scene : scenes) {
    Reference reference = ownReference(scene);
    if (!(reference.agreement < 1e-4)) {
      std::fprintf(stderr, "%s: two exact methods differ by %.2g; left out\n", scene.name.c_str(),
                   reference.agreement);
      continue;
    }
    cases.push_back({std::move(scene), std::move(reference)});
  }
  return cases;
}

struct PolicySum {
  double logarithms = 0.0; ///< of the work over what it is with the constant
  double most = 0.0, least = std::numeric_limits<double>::infinity(); ///< of those ratios
  int runs = 0, changed = 0, missed = 0;
};

void print(std::string_view name, const PolicySum& sum, int missedBefore)
{
  std::printf("%s,%d,%d,%s,%s,%s,%d,%d\n", std::string(name).c_str(), sum.runs, sum.changed,
              formatDouble(std::exp(sum.logarithms / std::max(sum.runs, 1)), 4).c_str(),
              formatDouble(sum.least, 4).c_str(), formatDouble(sum.most, 4).c_str(), missedBefore,
              sum.missed);
  std::fflush(stdout);
}

PolicySum compare(const std::vector<JudgedScene>& cases, const std::shared_ptr<const Policy>& policy,
                  std::vector<PolicyRun>& before)
{
  const bool isFirst = before.empty();
  PolicySum sum;
  std::size_t place = 0;
  for (const JudgedScene& one : cases)
    for (const double tolerance : kTolerances) {
      const PolicyRun outcome = run(one, tolerance, policy);
      if (isFirst) before.push_back(outcome);
      const double ratio = outcome.work / before[place].work;
      ++sum.runs;
      sum.changed += outcome.work != before[place].work || outcome.error != before[place].error ? 1 : 0;
      sum.missed += !outcome.isGood || !(outcome.error <= 1.0) ? 1 : 0;
      sum.logarithms += std::log(ratio);
      sum.most = std::max(sum.most, ratio);
      sum.least = std::min(sum.least, ratio);
      ++place;
    }
  return sum;
}

int runPolicy(std::vector<Scene> scenes, const std::vector<std::string>& names)
{
  for (const std::string& name : names)
    if (std::ranges::find(constants(), name, &Constant::name) == constants().end()) {
      std::fprintf(stderr, "there is no constant '%s'; see bench/policy_table.cpp\n", name.c_str());
      return 2;
    }
  const std::vector<JudgedScene> cases = withReferences(std::move(scenes));
  std::printf("left_out,runs,changed,work_ratio,least_ratio,most_ratio,missed_with_it,missed_without\n");
  std::vector<PolicyRun> before;
  const PolicySum all = compare(cases, nullptr, before);
  print("nothing", all, all.missed);
  for (const Constant& constant : constants()) {
    if (!names.empty() && std::ranges::find(names, constant.name) == names.end()) continue;
    const auto policy = std::make_shared<Policy>();
    constant.leaveOut(*policy);
    print(constant.name, compare(cases, policy, before), all.missed);
  }
  return 0;
}

} // namespace

int runFit(const std::vector<std::string>& words)
{
  return runPolicy(trainScenes(), words);
}

int runHoldout(const std::vector<std::string>& words)
{
  return runPolicy(heldOut(), words);
}

} // namespace esm::bench
