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

struct Run {
  const char* solver;
  double step; ///< [s]
  int frames;
};
constexpr Run kRuns[] = {{"leapfrog", 6e-5, 6},     {"chebyshev", 2e-4, 6}, {"stoermer3", 1.5e-4, 6},
                         {"verlet", 4e-5, 6},       {"stoermer", 4e-5, 6},  {"rk4", 4e-5, 6},
                         {"implicit", 1.0 / 120, 3}};

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

/// The hash of the last positions and velocities, 0 if the run failed; prints a line.
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
    for (const auto& [solver, step, frames] : kRuns) {
      const std::uint64_t hash = hashAfter(scene, solver, step, frames);
      const std::string line = scene.name + "," + solver + "," + hex(hash) + "\n";
      const bool isKnown = goldenFile.empty() || golden.find(line) != std::string::npos;
      if (hash != 0 && isKnown) continue;
      if (hash == 0)
        std::fprintf(stderr, "%s with %s came to no end\n", scene.name.c_str(), solver);
      else
        std::fprintf(stderr, "%s with %s ends in state %s, which is not in %s\n", scene.name.c_str(), solver,
                     hex(hash).c_str(), goldenFile.c_str());
      ++wrong;
    }
  return wrong == 0 ? 0 : 1;
}

} // namespace esm::bench
