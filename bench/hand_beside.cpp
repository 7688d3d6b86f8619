// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// What keeps time elsewhere, beside what keeps time here, on the same led patch: extended position based dynamics
// and fast mass springs, each with the fewest steps a frame at which it errs no more.
#include "bench/runs.h"
#include "bench/scene_shapes.h"
#include "bench/sub_benches.h"
#include "core/base/hand_over.h"
#include "core/base/text_number.h"
#include "core/contact/tool_grip.h"
#include "core/project/project_io.h"
#include "core/runtime/quality_ladder.h"

#include <cmath>
#include <cstdio>

namespace esm::bench {
namespace {

constexpr int kMostSteps = 512;        ///< of a competitor in a frame
constexpr double kMostPatience = 50.0; ///< times our run

/// The patch of 8 mm around the outermost node in x, led 10 mm in 0.3 s as a prescribed motion, and held; 1 s.
Scene ledPatch(const Project& project)
{
  Scene scene;
  scene.name = project.name;
  scene.net = project.net;
  scene.loads.gravity = project.loads.gravity;
  Eigen::Index middle = 0;
  scene.net.restPosition.row(0).maxCoeff(&middle);
  PrescribedMotion pull;
  for (Index i = 0; i < scene.net.nodeCount(); ++i)
    if ((scene.net.restPosition.col(i) - scene.net.restPosition.col(middle)).norm() < kGripRadius)
      pull.nodes.push_back(i);
  pull.displacement = curve({0.0, 0.3}, {{0, 0, 0}, {0.01, 0, 0}});
  scene.loads.motions.push_back(pull);
  return scene;
}

SolverSettings windowsSettings()
{
  const QualityPlan plan;
  SolverSettings settings;
  settings.tolerance = plan.finest;
  settings.effort = plan.effort;
  settings.keepsTime = true;
  settings.workLimit = 0.0;
  return settings;
}

/// Ours at a tolerance of 1e-3.
Reference exactly(const Scene& scene)
{
  Reference reference;
  SolverSettings settings;
  settings.effort = 1e13;
  settings.workLimit = 0.0;
  settings.duration = scene.duration;
  Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
  reference.agreement = settings.tolerance;
  reference.frames.push_back(scene.net.restPosition);
  for (long frame = 0; simulation && frame < scene.frames(); ++frame) {
    simulation->advance(1.0 / kFrameRate);
    reference.frames.push_back(simulation->state().position);
  }
  return reference;
}

struct Beside {
  double seconds = std::nan(""), error = std::nan("");
  int steps = 0;
};

Beside ours(const Scene& scene, const Reference& reference)
{
  ErrorMeter meter(reference);
  CpuClock clock;
  Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, windowsSettings());
  for (long frame = 0; simulation && frame < scene.frames(); ++frame) {
    simulation->advance(1.0 / kFrameRate);
    clock.pause();
    meter.add(static_cast<std::size_t>(frame + 1), simulation->state().position);
    clock.resume();
  }
  clock.pause();
  return {clock.seconds(), meter.error(), 0};
}

/// With the fewest steps at which it errs no more; or as exactly as patience allows.
Beside theirs(const std::string& name, const Scene& scene, const Reference& reference, const Beside& own)
{
  Beside best;
  for (const MethodEntry& entry : competitors()) {
    if (entry.name != name) continue;
    for (int steps = 1; steps <= kMostSteps; steps *= 2) {
      const Row row = runCompetitor(scene, entry, steps, reference, kMostPatience * own.seconds);
      if (row.good) best = {row.seconds, row.error, steps};
      if (row.good ? row.error <= own.error : row.seconds >= kMostPatience * own.seconds) break;
    }
  }
  return best;
}

} // namespace

int runHandBeside(const std::vector<std::string>& words)
{
  std::printf("project,nodes,springs,seconds,error");
  const char* const names[] = {"ref-xpbd", "ref-fast-mass-springs"};
  for (const char* name : names) std::printf(",%s_times,%s_error,%s_steps", name, name, name);
  std::printf("\n");
  for (const std::string& word : words) {
    const Result<Project> project = loadProject(word);
    if (!project) {
      std::fprintf(stderr, "%s\n", project.error().detail.c_str());
      return 1;
    }
    const Scene scene = ledPatch(*project);
    const Reference reference = exactly(scene);
    const Beside own = ours(scene, reference);
    std::printf("%s,%d,%d,%s,%s", scene.name.c_str(), static_cast<int>(scene.net.nodeCount()),
                static_cast<int>(scene.net.springCount()), formatDouble(own.seconds, 3).c_str(),
                formatDouble(own.error, 2).c_str());
    for (const char* name : names) {
      const Beside other = theirs(name, scene, reference, own);
      std::printf(",%s,%s,%d", formatDouble(other.seconds / own.seconds, 3).c_str(),
                  formatDouble(other.error, 2).c_str(), other.steps);
      std::fflush(stdout);
    }
    std::printf("\n");
  }
  return 0;
}

} // namespace esm::bench
