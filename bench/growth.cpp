// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/runs.h"
#include "bench/sub_benches.h"
#include "core/base/text_number.h"
#include "core/forces/force_model.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace esm::bench {
namespace {

double forcePassSeconds(const Scene& scene)
{
  const ForceModel model(scene.net, scene.loads.gravity);
  NodeArray x(model.nodeCount()), v(model.nodeCount(), Lanes{0, 0, 0, 0}), force(model.nodeCount());
  copyNodes(scene.net.restPosition, x);
  const int passes = std::max(3, static_cast<int>(2e6 / scene.net.springCount()));
  double least = 1e9;
  for (int repeat = 0; repeat < 5; ++repeat) {
    const double start = cpuSeconds();
    for (int pass = 0; pass < passes; ++pass) model.computeForces(x.data(), v.data(), force.data());
    least = std::min(least, (cpuSeconds() - start) / passes);
  }
  return least;
}

void measure(const Scene& scene, int frames)
{
  SolverSettings settings;
  settings.tolerance = 1e-2;
  settings.effort = 1e13;
  const double begin = cpuSeconds();
  Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
  if (!simulation) return;
  const double setUp = cpuSeconds() - begin;
  StepReport report;
  const double start = cpuSeconds();
  for (int frame = 0; frame < frames && report.good(); ++frame)
    report.add(simulation->advance(1.0 / kFrameRate));
  const double perFrame = (cpuSeconds() - start) / frames;
  std::printf("%d,%d,%s,%s,%s,%s,%s\n", static_cast<int>(scene.net.nodeCount()),
              static_cast<int>(scene.net.springCount()), formatDouble(setUp, 4).c_str(),
              formatDouble(perFrame, 4).c_str(), formatDouble(perFrame * kFrameRate, 4).c_str(),
              formatDouble(forcePassSeconds(scene), 4).c_str(), simulation->solverName().c_str());
  std::fflush(stdout);
}

} // namespace

int runGrowth(const std::vector<std::string>& words)
{
  std::printf("nodes,springs,set_up_s,seconds_per_frame,share_of_frame,force_pass_s,solver\n");
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
