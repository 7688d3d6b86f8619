// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The watch that says whether a motion multiplies errors: what it costs, and whether it is right on scenes
// that it was not made with.
#include "bench/held_out_scenes.h"
#include "bench/scene_shapes.h"
#include "bench/sub_benches.h"
#include "core/base/text_number.h"
#include "core/dynamics/simulation.h"
#include "core/geometry/extent.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <random>

namespace esm::bench {
namespace {

constexpr double kTold = 100.0; // as `esm simulate` tells it

/// The scene with other velocities at the start, by a millionth of a millionth of its extent in a frame.
Scene disturbed(const Scene& scene)
{
  Scene other = scene;
  SpringNet& net = other.net;
  std::mt19937 random(2026);
  const double size = 1e-9 * extentOf(net.restPosition) * kFrameRate;
  if (net.initialVelocity.cols() == 0) net.initialVelocity = Eigen::Matrix3Xd::Zero(3, net.nodeCount());
  for (Index i = 0; i < net.nodeCount(); ++i)
    for (int axis = 0; axis < 3; ++axis) net.initialVelocity(axis, i) += uniform(random, -size, size);
  return other;
}

/// By steps far below their limit, the same for both.
Simulation exactly(const Scene& scene, double share)
{
  SolverSettings settings;
  settings.workLimit = 0.0;
  settings.solver = "rk4";
  settings.fixedStep = share * Simulation::create(scene.net, scene.loads, settings)->stableStep();
  return std::move(*Simulation::create(scene.net, scene.loads, settings));
}

double apart(const NetState& a, const NetState& b)
{
  return std::sqrt(((a.position - b.position).squaredNorm() +
                    (a.velocity - b.velocity).squaredNorm() / (kFrameRate * kFrameRate)) /
                   static_cast<double>(a.position.cols()));
}

struct Finding {
  double truth = 1.0;   ///< by how much a small difference has grown from any frame to any later one
  double watched = 1.0; ///< the same as the watch has it
  double missed = 0.0;  ///< error of the watched run over its tolerance
  double passes = 0.0, watchPasses = 0.0;
};

/// @param scene, tolerance  of the run that is watched
void watch(const Scene& scene, double tolerance, bool isJudged, Finding& finding)
{
  SolverSettings settings;
  settings.tolerance = tolerance;
  settings.duration = scene.duration;
  settings.workLimit = 0.0;
  settings.effort = 1e13;
  Result<Simulation> watched = Simulation::create(scene.net, scene.loads, settings);
  watched->watchGrowth();
  std::optional<Simulation> exact, beside;
  if (isJudged) {
    constexpr double kShare = 0.3;
    exact.emplace(exactly(scene, kShare));
    beside.emplace(exactly(disturbed(scene), kShare));
  }
  const Eigen::Matrix3Xd start = watched->state().position;
  double least = INFINITY, error = 0.0, displacement = 0.0;
  std::int64_t springs = 0;
  for (long frame = 1; frame <= scene.frames(); ++frame) {
    springs += watched->advance(1.0 / kFrameRate).springsEvaluated;
    if (!isJudged) continue;
    exact->advance(1.0 / kFrameRate);
    beside->advance(1.0 / kFrameRate);
    const double now = apart(exact->state(), beside->state());
    const double rounding = 1e-14 * extentOf(scene.net.restPosition); // below it no growth is to be told
    least = std::max(std::min(least, now), rounding);
    finding.truth = std::max(finding.truth, now / least);
    error += (watched->state().position - exact->state().position).squaredNorm();
    displacement += (exact->state().position - start).squaredNorm();
  }
  finding.watched = watched->errorGrowth();
  finding.missed = std::sqrt(error / std::max(displacement, 1e-300)) / tolerance;
  finding.passes = static_cast<double>(springs) / static_cast<double>(scene.net.springCount());
  finding.watchPasses = watched->errorGrowthPasses();
}

const char* verdictOf(const Finding& finding)
{
  const bool grows = finding.truth >= kTold, told = finding.watched >= kTold;
  return grows == told ? "right" : told ? "false alarm" : "miss";
}

std::string costOf(const Finding& finding)
{
  return formatDouble(std::round(finding.passes)) + "," + formatDouble(std::round(finding.watchPasses)) +
         "," + formatDouble(finding.watchPasses / std::max(finding.passes, 1.0), 3);
}

void judge(bool isQuick)
{
  std::printf("scene,fresh,foretold,growth,watched,verdict,error_over_tolerance,passes,watch_passes,share\n");
  int alarms = 0, misses = 0, foretold = 0, count = 0;
  for (const HeldOutScene& scene : heldOutScenes()) {
    if (isQuick && scene.net.springCount() > 2000) continue;
    Finding finding;
    watch(scene, 1e-3, true, finding);
    const std::string verdict = verdictOf(finding);
    ++count;
    alarms += verdict == "false alarm" ? 1 : 0;
    misses += verdict == "miss" ? 1 : 0;
    foretold += scene.foretold == (finding.truth >= kTold) ? 1 : 0;
    std::printf("%s,%s,%s,%s,%s,%s,%s,%s\n", scene.name.c_str(), scene.isFresh ? "yes" : "no",
                scene.foretold ? "grows" : "tame", formatDouble(finding.truth, 3).c_str(),
                formatDouble(finding.watched, 3).c_str(), verdict.c_str(),
                formatDouble(finding.missed, 3).c_str(), costOf(finding).c_str());
    std::fflush(stdout);
  }
  std::fprintf(stderr, "%d scenes, %d foretold rightly; %d false alarms, %d misses\n", count, foretold,
               alarms, misses);
}

int price(const std::vector<std::string>& names)
{
  std::printf("scene,tolerance,growth,passes,watch_passes,share\n");
  for (const std::string& name : names) {
    const Result<Scene> scene = makeScene(name);
    if (!scene) {
      std::fprintf(stderr, "%s\n", scene.error().detail.c_str());
      return 2;
    }
    for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4}) {
      Finding finding;
      watch(*scene, tolerance, false, finding);
      std::printf("\"%s\",%s,%s,%s\n", name.c_str(), formatDouble(tolerance).c_str(),
                  formatDouble(finding.watched, 3).c_str(), costOf(finding).c_str());
      std::fflush(stdout);
    }
  }
  return 0;
}

} // namespace

int runWatch(const std::vector<std::string>& words)
{
  std::vector<std::string> names = words;
  std::erase(names, "--quick");
  if (!names.empty()) return price(names);
  judge(isQuick(words));
  return 0;
}

} // namespace esm::bench
