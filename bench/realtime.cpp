// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/runs.h"
#include "bench/scene_shapes.h"
#include "bench/sub_benches.h"
#include "core/base/text_number.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace esm::bench {
namespace {

/// The uterus, a patch of 1 cm pulled out by 10 mm in 0.2 s and let go; 1 s.
Scene pulledUterus(double size)
{
  SceneOptions options;
  options.size = size;
  Scene scene = uterus(options);
  PrescribedMotion pull;
  pull.nodes = scene.loads.forces[0].nodes;
  pull.displacement = curve({0.0, 0.2}, {{0, 0, 0}, {0, 0, 0.01}});
  pull.release = 0.2;
  scene.loads.forces.clear();
  scene.loads.motions.push_back(pull);
  scene.name = "pulled uterus";
  return scene;
}

struct Shares { ///< of the frame time
  double mean = 0.0, largest = 0.0;
  double moving = 0.0; ///< the mean over frames in which something moved
  double error = std::nan("");
  std::string solver;
};

Shares measure(const Scene& scene, const Reference* reference)
{
  Shares shares;
  SolverSettings settings;
  settings.tolerance = 1e-2;
  Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
  if (!simulation) return shares;
  std::optional<ErrorMeter> meter;
  if (reference) meter.emplace(*reference);
  double sum = 0.0, moving = 0.0;
  for (long frame = 0; frame < scene.frames(); ++frame) {
    const double start = cpuSeconds();
    const StepReport report = simulation->advance(1.0 / kFrameRate);
    const double share = (cpuSeconds() - start) * kFrameRate;
    sum += share;
    moving += report.nothingMoved() ? 0.0 : 1.0;
    shares.largest = std::max(shares.largest, share);
    if (meter) meter->add(static_cast<std::size_t>(frame + 1), simulation->state().position);
  }
  shares.mean = sum / static_cast<double>(scene.frames());
  shares.moving = sum / std::max(moving, 1.0);
  if (meter) shares.error = meter->error();
  shares.solver = simulation->solverName();
  return shares;
}

double print(const Scene& scene, const Reference* reference)
{
  std::vector<Shares> runs;
  for (int repeat = 0; repeat < 5; ++repeat) runs.push_back(measure(scene, reference));
  std::sort(runs.begin(), runs.end(), [](const Shares& a, const Shares& b) { return a.mean < b.mean; });
  const Shares& median = runs[runs.size() / 2];
  std::printf("%d,%d,%s,%s,%s,%s,%s\n", static_cast<int>(scene.net.nodeCount()),
              static_cast<int>(scene.net.springCount()), formatDouble(median.mean, 4).c_str(),
              formatDouble(median.moving, 4).c_str(), formatDouble(median.largest, 4).c_str(),
              reference ? formatDouble(median.error, 3).c_str() : "", median.solver.c_str());
  std::fflush(stdout);
  return median.mean;
}

} // namespace

int runRealTime(const std::vector<std::string>& words)
{
  std::printf("nodes,springs,mean_share,moving_share,largest_share,error,solver\n");
  const Scene scene = pulledUterus(1.0);
  const Reference reference = referenceOf(scene);
  double share = print(scene, &reference);
  double size = 1.0;
  while (share > 0.0 && share < 1.0 && size < 200.0) { // the last line is the first that does not keep up
    size *= isQuick(words) ? 2.0 : 1.4;
    share = print(pulledUterus(size), nullptr);
  }
  return 0;
}

bool isQuick(const std::vector<std::string>& words)
{
  return std::find(words.begin(), words.end(), "--quick") != words.end();
}

} // namespace esm::bench
