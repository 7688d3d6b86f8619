// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/runs.h"
#include "bench/sub_benches.h"
#include "core/base/text_number.h"
#include "core/base/worker_pool.h"
#include "core/forces/force_model.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace esm::bench {
namespace {

/// One thread is timed by the processor, so that other programs do not count; two only the clock can time.
double wallSeconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct ForcePass {
  double seconds = 0.0;      ///< of processor time, one thread
  double gainOfSecond = 1.0; ///< time by the clock on one thread over that on two
};

ForcePass measureForcePass(const Scene& scene)
{
  const ForceModel model(scene.net, scene.loads.gravity);
  NodeArray x(model.nodeCount()), v(model.nodeCount(), Lanes{0, 0, 0, 0}), force(model.nodeCount());
  copyNodes(scene.net.restPosition, x);
  WorkerPool pool(2);
  const int passes = std::max(3, static_cast<int>(2e6 / scene.net.springCount()));
  double least = 1e9, leastWall[2] = {1e9, 1e9};
  for (int repeat = 0; repeat < 5; ++repeat)
    for (WorkerPool* workers : {static_cast<WorkerPool*>(nullptr), &pool}) {
      const double start = cpuSeconds(), wallStart = wallSeconds();
      for (int pass = 0; pass < passes; ++pass)
        model.computeForces(x.data(), v.data(), force.data(), nullptr, workers);
      if (!workers) least = std::min(least, (cpuSeconds() - start) / passes);
      double& wall = leastWall[workers ? 1 : 0];
      wall = std::min(wall, wallSeconds() - wallStart);
    }
  return {least, model.isDivided() ? leastWall[0] / leastWall[1] : 1.0};
}

/// Time by the clock of the same frames on one thread over that on two; frames take turns.
double frameGainOfSecond(const Scene& scene, SolverSettings settings, int frames)
{
  if (!ForceModel(scene.net, scene.loads.gravity).isDivided()) return 1.0; // never more than one
  std::vector<Simulation> simulations;
  for (const int threads : {1, 2}) {
    settings.threads = threads;
    Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
    if (!simulation) return 0.0;
    simulations.push_back(std::move(simulation).value());
  }
  double seconds[2] = {};
  for (int frame = 0; frame < frames; ++frame)
    for (std::size_t i = 0; i < 2; ++i) {
      const double start = wallSeconds();
      simulations[i].advance(1.0 / kFrameRate);
      seconds[i] += wallSeconds() - start;
    }
  return seconds[0] / seconds[1];
}

void measure(const Scene& scene, int frames)
{
  SolverSettings settings;
  settings.tolerance = 1e-2;
  settings.effort = 1e13;
  settings.workLimit = 0.0;
  const double begin = cpuSeconds();
  Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
  if (!simulation) return;
  const double setUp = cpuSeconds() - begin;
  StepReport report;
  const double start = cpuSeconds();
  for (int frame = 0; frame < frames && report.good(); ++frame)
    report.add(simulation->advance(1.0 / kFrameRate));
  const double perFrame = (cpuSeconds() - start) / frames;
  const ForcePass pass = measureForcePass(scene);
  std::printf("%d,%d,%s,%s,%s,%s,%s,%s,%s\n", static_cast<int>(scene.net.nodeCount()),
              static_cast<int>(scene.net.springCount()), formatDouble(setUp, 4).c_str(),
              formatDouble(perFrame, 4).c_str(), formatDouble(perFrame * kFrameRate, 4).c_str(),
              formatDouble(pass.seconds, 4).c_str(), simulation->solverName().c_str(),
              formatDouble(pass.gainOfSecond, 3).c_str(),
              formatDouble(frameGainOfSecond(scene, settings, frames), 3).c_str());
  std::fflush(stdout);
}

} // namespace

int runGrowth(const std::vector<std::string>& words)
{
  std::printf("nodes,springs,set_up_s,seconds_per_frame,share_of_frame,force_pass_s,solver,force_pass_2_"
              "threads,frame_2_threads\n");
  const double most = isQuick(words) ? 30'000 : 1'000'000;
  for (const double nodes : {100.0, 300.0, 1e3, 3e3, 1e4, 3e4, 1e5, 3e5, 1e6}) {
    if (nodes > most) break;
    SceneOptions options;
    options.size = nodes / 100'002;
    measure(organ100k(options), nodes > 2e5 ? 2 : (nodes > 2e4 ? 4 : 12));
  }
  return 0;
}

} // namespace esm::bench
