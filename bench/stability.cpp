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

constexpr int kFrames = 20;

/// The tube with stiffness x 10^k, masses spread log-uniformly over 10^m around the tube's own (within 1e-9
/// to 1e3 kg), viscosity x 10^c (none below -8).
Scene variant(double k, double m, double c)
{
  Scene scene = tube();
  SpringNet& net = scene.net;
  std::mt19937 random(11);
  net.stiffness *= powerOfTen(k);
  net.viscosity *= c < -8.0 ? 0.0 : powerOfTen(c);
  for (Index i = 0; i < net.nodeCount(); ++i)
    net.mass[i] = std::clamp(net.mass[i] * powerOfTen(uniform(random, -m / 3, 2 * m / 3)), 1e-9, 1e3);
  scene.loads.motions[0].displacement = curve({0.0, 0.2}, {{0, 0, 0}, {0, 0.02, 0}});
  scene.duration = kFrames / kFrameRate;
  return scene;
}

/// Bounded: finite and never more than ten lengths of the tube away.
bool isNear(const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& start)
{
  return (x - start).cwiseAbs().maxCoeff() < 1.0;
}

bool runOurs(const Scene& scene, const std::string& solver, std::string& note)
{
  SolverSettings settings;
  settings.solver = solver;
  settings.tolerance = 1e-2;
  if (solver == "auto")
    settings.effort = 2e6; // what a frame of a display can bear
  else
    settings.fixedStep = 1.0 / kFrameRate;
  Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
  if (!simulation) return false;
  for (long frame = 0; frame < scene.frames(); ++frame) {
    const StepReport report = simulation->advance(1.0 / kFrameRate);
    const bool near = isNear(simulation->state().position, scene.net.restPosition);
    if (report.good() && near) continue;
    note = near ? simulation->why() : "left its place";
    std::replace(note.begin(), note.end(), ',', ';');
    return false;
  }
  return true;
}

bool runTheirs(const Scene& scene, const MethodEntry& entry)
{
  FastNet net(scene.net, scene.loads);
  const std::unique_ptr<Method> method = entry.make();
  method->prepare(net, 1, {});
  Nodes x, v;
  Eigen::Matrix3Xd positions;
  net.start(x, v);
  for (long frame = 0; frame < scene.frames(); ++frame) {
    const double t0 = static_cast<double>(frame) / kFrameRate,
                 t1 = static_cast<double>(frame + 1) / kFrameRate;
    const bool changed = net.beginFrame(t0, x, v);
    if (!method->frame(net, t0, t1, changed, x, v)) return false;
    net.positions(x, positions);
    if (!isNear(positions, scene.net.restPosition)) return false;
  }
  return true;
}

using Names = std::vector<std::string>;

bool contains(const Names& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Ours, and the competitors that take fixed steps.
Names allMethods()
{
  Names names = {"auto"};
  for (const SolverInfo& solver : solverNames()) names.push_back(solver.name);
  for (const MethodEntry& entry : competitors())
    if (!entry.adaptive) names.emplace_back(entry.name);
  return names;
}

void sweep(const char* axis, double k, double m, double c, double second, const Names& wanted)
{
  const Scene scene = variant(k, m, c);
  const auto tell = [&](const std::string& method, bool ours, bool bounded, double seconds,
                        const std::string& note) {
    std::printf("%s,%d,%s,%s,%s,%d,%s,%s\n", method.c_str(), ours ? 1 : 0, axis, formatDouble(k, 3).c_str(),
                formatDouble(second, 3).c_str(), bounded ? 1 : 0, formatDouble(seconds / kFrames, 4).c_str(),
                note.c_str());
    std::fflush(stdout);
  };
  Names solvers = {"auto"};
  for (const SolverInfo& solver : solverNames()) solvers.push_back(solver.name);
  for (const std::string& solver : solvers) {
    if (!contains(wanted, solver)) continue;
    const double start = cpuSeconds();
    std::string note;
    const bool bounded = runOurs(scene, solver, note);
    tell(solver, true, bounded, cpuSeconds() - start, note);
  }
  for (const MethodEntry& entry : competitors()) {
    if (!contains(wanted, entry.name)) continue;
    const double start = cpuSeconds();
    const bool bounded = runTheirs(scene, entry);
    tell(entry.name, false, bounded, cpuSeconds() - start, "");
  }
}

} // namespace

int runStability(const std::vector<std::string>& words)
{
  const bool quick = isQuick(words);
  const Names all = allMethods();
  Names wanted;
  for (const std::string& word : words) {
    if (word == "--quick") continue;
    if (!contains(all, word)) {
      std::fprintf(stderr, "esm_bench: there is no method \"%s\" that takes fixed steps\n", word.c_str());
      return 2;
    }
    wanted.push_back(word);
  }
  if (wanted.empty()) wanted = all;
  std::printf("method,ours,axis,stiffness_decades,second_decades,bounded,seconds_per_frame,note\n");
  for (double k = 0.0; k <= 9.0; k += quick ? 3.0 : 1.0) {
    for (double m = 0.0; m <= 12.0; m += quick ? 6.0 : 3.0) sweep("mass", k, m, 0.0, m, wanted);
    for (const double c : {-9.0, -3.0, 3.0, 6.0}) // -9 stands for no viscosity at all
      if (!quick || c == -9.0 || c == 6.0) sweep("viscosity", k, 0.0, c, c, wanted);
  }
  return 0;
}

} // namespace esm::bench
