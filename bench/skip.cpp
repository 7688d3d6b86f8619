// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/skip.h"

#include "bench/skip_scenes.h"
#include "bench/trajectory.h"
#include "core/base/text_number.h"
#include "core/dynamics/simulation.h"

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <ctime>

namespace esm::bench {
namespace {

constexpr double kFrame = 1.0 / 60.0;

struct Run {
  double seconds = 0.0;                ///< processor time, set-up included
  double setUp = 0.0;                  ///< of it, before the first step
  std::int64_t springs = 0, awake = 0; ///< evaluated in all; awake on average
  std::vector<StepReport> reports;     ///< per frame
  Trajectory trajectory;
  std::string solver;
};

double processorTime()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Run runScene(const SkipScene& scene, const SolverSettings& settings, bool keepFrames)
{
  Run run;
  const double begin = processorTime();
  auto simulation = Simulation::create(scene.net, scene.loads, settings);
  if (!simulation) {
    std::fprintf(stderr, "%s\n", simulation.error().detail.c_str());
    return run;
  }
  run.setUp = processorTime() - begin;
  double copying = 0.0;
  const auto frames = static_cast<int>(std::lround(scene.duration / kFrame));
  for (int frame = 0; frame <= frames; ++frame) {
    if (frame > 0) run.reports.push_back(simulation->advance(kFrame));
    if (!keepFrames) continue;
    const double start = processorTime();
    run.trajectory.push_back(simulation->state().position);
    copying += processorTime() - start;
  }
  run.seconds = processorTime() - begin - copying;
  for (const StepReport& report : run.reports) {
    run.springs += report.springsEvaluated;
    run.awake += report.nodesAwake;
  }
  run.awake /= std::max(frames, 1);
  run.solver = simulation->solverName();
  return run;
}

/// Median in time of a few runs, which agree in all else.
Run medianRun(const SkipScene& scene, const SolverSettings& settings, int repeats)
{
  std::vector<Run> runs;
  for (int i = 0; i < repeats; ++i) runs.push_back(runScene(scene, settings, i == 0));
  runs[0].trajectory.swap(runs.back().trajectory); // so that sorting moves no frames about
  Trajectory frames = std::move(runs.back().trajectory);
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.seconds < b.seconds; });
  Run median = std::move(runs[runs.size() / 2]);
  median.trajectory = std::move(frames);
  return median;
}

const char* const kHeader =
  "part,scene,nodes,springs,solver,tolerance,skip,seconds,set_up_s,error,springs_evaluated,nodes_awake\n";

void print(const char* part, const SkipScene& scene, const SolverSettings& settings, const Run& run,
           double error)
{
  std::printf("%s,%s,%d,%d,%s,%s,%s,%s,%s,%s,%" PRId64 ",%" PRId64 "\n", part, scene.name.c_str(),
              scene.net.nodeCount(), scene.net.springCount(), run.solver.c_str(),
              formatDouble(settings.tolerance, 3).c_str(), settings.skipResting ? "on" : "off",
              formatDouble(run.seconds, 4).c_str(), formatDouble(run.setUp, 3).c_str(),
              formatDouble(error, 3).c_str(), run.springs, run.awake);
  std::fflush(stdout);
}

SolverSettings settingsOf(const std::string& solver, double tolerance, bool skip)
{
  SolverSettings settings;
  settings.solver = solver;
  settings.tolerance = tolerance;
  settings.skipResting = skip;
  settings.effort = 1e12; // accuracy, whatever it costs
  settings.workLimit = 0.0;
  return settings;
}

Trajectory fineRun(const SkipScene& scene)
{
  SolverSettings settings = settingsOf(scene.reference, 1e-6, false);
  settings.fixedStep = scene.finestStep;
  return runScene(scene, settings, true).trajectory;
}

/// The same scene in full and without its resting nodes.
void compare(const char* part, const SkipScene& scene)
{
  const Trajectory reference = fineRun(scene);
  for (const double tolerance : {1e-2, 1e-3})
    for (const bool skip : {false, true}) {
      if (!skip && tolerance < 1e-2) continue; // minutes
      const SolverSettings settings = settingsOf("auto", tolerance, skip);
      const Run run = medianRun(scene, settings, skip ? 5 : 3);
      print(part, scene, settings, run, trajectoryError(reference, run.trajectory));
    }
}

/// Rings, settles, rests, and is touched once more.
void struck()
{
  SkipScene scene = struckOrgan(10000, 0.3);
  compare("struck", scene);
  scene.duration = 3.0;
  const SolverSettings settings = settingsOf("auto", 1e-2, true);
  auto simulation = Simulation::create(scene.net, scene.loads, settings);
  std::printf("part,frame,springs_evaluated,nodes_awake\n");
  for (int frame = 1; frame <= 180; ++frame) {
    const ToolSpring tool{
      scene.touched, scene.net.restPosition.col(scene.touched) * 0.9, {0, 0, 0}, 50.0, 0.0};
    if (frame == 150) simulation->setTools({&tool, 1});
    const StepReport report = simulation->advance(kFrame);
    if (frame % 10 == 0 || frame >= 148)
      std::printf("rest,%d,%" PRId64 ",%" PRId64 "\n", frame, report.springsEvaluated, report.nodesAwake);
  }
}

/// Seconds of a frame once the poke is under way: the net's size must not count, the poke's must.
void growth()
{
  const SolverSettings settings = settingsOf("auto", 1e-2, true);
  const auto tell = [&](const SkipScene& scene) {
    Run run = medianRun(scene, settings, 5);
    run.seconds -= run.setUp;
    print("growth", scene, settings, run, std::nan(""));
    return run;
  };
  double first = 0.0, last = 0.0;
  for (const Index nodes : {10000, 30000, 100000, 300000}) {
    last = tell(pressedOrgan(nodes, 4.5, 0.2)).seconds;
    if (nodes == 10000) first = last;
  }
  std::printf("slope_over_nodes,%s\n", formatDouble(std::log(last / first) / std::log(30.0), 3).c_str());
  std::vector<Run> runs;
  for (const double radius : {3.0, 10.0, 30.0, 60.0}) runs.push_back(tell(pressedOrgan(100000, radius, 0.2)));
  const double moving = static_cast<double>(runs.back().springs) / static_cast<double>(runs.front().springs);
  std::printf(
    "slope_over_springs,%s\n",
    formatDouble(std::log(runs.back().seconds / runs.front().seconds) / std::log(moving), 3).c_str());
}

} // namespace

int runSkip(const std::vector<std::string>& words)
{
  const auto wants = [&](const char* part) {
    return words.empty() || std::find(words.begin(), words.end(), part) != words.end();
  };
  for (const std::string& word : words)
    if (word != "local" && word != "struck" && word != "growth") {
      std::fprintf(stderr, "the parts are local, struck and growth, not '%s'\n", word.c_str());
      return 2;
    }
  std::printf("%s", kHeader);
  if (wants("local")) compare("local", pressedOrgan(100000, 4.5, 0.5));
  if (wants("growth")) growth();
  if (wants("struck")) struck();
  return 0;
}

} // namespace esm::bench
