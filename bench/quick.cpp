// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/quick.h"

#include "bench/runs.h"
#include "core/base/file_io.h"
#include "core/base/hash.h"
#include "core/base/text_number.h"

#include <cinttypes>
#include <cstdio>

namespace esm::bench {
namespace {

std::string hex(std::uint64_t value)
{
  char text[17];
  std::snprintf(text, sizeof text, "%016" PRIx64, value);
  return text;
}

std::uint64_t hashArray(const Eigen::Matrix3Xd& x, std::uint64_t seed)
{
  return hashBytes(x.data(), sizeof(double) * static_cast<std::size_t>(x.size()), seed);
}

/// The hash of the last positions and velocities; prints a line.
std::uint64_t hashAfter(const Scene& scene, const std::string& solver, double step, int frames)
{
  SolverSettings settings;
  settings.solver = solver;
  settings.fixedStep = step;
  const double start = cpuSeconds();
  Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
  if (!simulation) return 0;
  StepReport report;
  for (int frame = 0; frame < frames && report.good(); ++frame)
    report.add(simulation->advance(1.0 / kFrameRate));
  const NetState& state = simulation->state();
  const std::uint64_t hash = report.good() ? hashArray(state.velocity, hashArray(state.position, 0)) : 0;
  std::printf("%s,%s,%s,%s,%" PRId64 ",%s\n", scene.name.c_str(), solver.c_str(),
              formatDouble(step, 4).c_str(), formatDouble(cpuSeconds() - start, 4).c_str(),
              report.springsEvaluated, hex(hash).c_str());
  std::fflush(stdout);
  return hash;
}

} // namespace

int runQuick(const std::string& goldenFile)
{
  std::string golden;
  if (!goldenFile.empty()) {
    const Result<std::string> text = readFile(goldenFile);
    if (!text) {
      std::fprintf(stderr, "%s\n", text.error().detail.c_str());
      return 1;
    }
    golden = *text;
  }
  int wrong = 0;
  std::printf("scene,solver,step_s,seconds,springs_evaluated,hash\n");
  for (const Scene& scene : {tube(), uterus(), smallSheet()})
    for (const char* solver : {"verlet", "stoermer", "rk4", "implicit"}) {
      const bool implicit = std::string(solver) == "implicit";
      const std::string hash = hex(hashAfter(scene, solver, implicit ? 1.0 / 120 : 4e-5, implicit ? 3 : 6));
      const std::string line = scene.name + "," + solver + "," + hash + "\n";
      if (goldenFile.empty() || golden.find(line) != std::string::npos) continue;
      std::fprintf(stderr, "%s with %s ends in state %s, which is not in %s\n", scene.name.c_str(), solver,
                   hash.c_str(), goldenFile.c_str());
      ++wrong;
    }
  return wrong == 0 ? 0 : 1;
}

} // namespace esm::bench
