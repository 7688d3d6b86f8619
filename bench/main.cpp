// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// esm_bench: work against precision, as CSV on stdout.
//
//   esm_bench [SCENE...]                          all methods against a tight reference, minutes
//   esm_bench --quick [--validate-hash FILE]      fixed steps, seconds; with a file of golden hashes exit 1
//   if
//                                                 any state differs by a bit
//   esm_bench --kernel                            nanoseconds per spring of the force pass
#include "bench/work_precision.h"
#include "core/base/file_io.h"
#include "core/base/text_number.h"
#include "core/forces/force_model.h"

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <ctime>

namespace esm::bench {
namespace {

const char* const kHeader = "scene,solver,tolerance,step_s,seconds,error,springs_evaluated,hash\n";

std::string hex(std::uint64_t value)
{
  char text[17];
  std::snprintf(text, sizeof text, "%016" PRIx64, value);
  return text;
}

void print(const Row& row)
{
  const std::string error = row.good ? formatDouble(row.error, 3) : "failed";
  std::printf("%s,%s,%s,%s,%s,%s,%" PRId64 ",%s\n", row.scene.c_str(), row.solver.c_str(),
              formatDouble(row.tolerance, 3).c_str(), formatDouble(row.step, 4).c_str(),
              formatDouble(row.seconds, 4).c_str(), error.c_str(), row.springs, hex(row.hash).c_str());
  std::fflush(stdout);
}

int workPrecision(const std::vector<std::string>& wanted)
{
  std::printf("%s", kHeader);
  for (const Scene& scene : allScenes()) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), scene.name) == wanted.end()) continue;
    // Two references of the textbook Runge-Kutta: their distance says how far the finer one can be trusted.
    const int finest =
      static_cast<int>(std::ceil(1.0 / 60.0 / scene.finestStep / 12.0)) * 12; // events on steps
    Trajectory coarse, reference, other;
    Row row = runPlain(scene, "plain_rk4", finest / 2, &coarse);
    Row fine = runPlain(scene, "plain_rk4", finest, &reference);
    row.error = trajectoryError(reference, coarse);
    print(row);
    for (const int steps : {96, 192, 384, 768}) {
      row = runPlain(scene, "plain_euler", steps, &other);
      row.error = row.good ? trajectoryError(reference, other) : std::nan("");
      print(row);
    }
    for (const char* solver : {"auto", "verlet", "rk4", "implicit"})
      for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
        if (std::string(solver) == "implicit" && tolerance < 1e-3) continue; // half an hour
        row = runEngine(scene, solver, tolerance, 0.0, scene.duration, &other);
        row.error = row.good ? trajectoryError(reference, other) : std::nan("");
        print(row);
      }
  }
  return 0;
}

/// Fixed steps only, so that the bits depend on the arithmetic alone.
std::vector<Row> quickRows()
{
  std::vector<Row> rows;
  for (const Scene& scene : {tube(), uterus(), smallSheet()})
    for (const char* solver : {"verlet", "rk4", "implicit"}) {
      const bool implicit = std::string(solver) == "implicit";
      rows.push_back(
        runEngine(scene, solver, 0.0, implicit ? 1.0 / 120 : 4e-5, implicit ? 0.05 : 0.1, nullptr));
    }
  return rows;
}

int quick(const std::string& goldenFile)
{
  const std::vector<Row> rows = quickRows();
  std::printf("%s", kHeader);
  for (const Row& row : rows) print(row);
  if (goldenFile.empty()) return 0;
  const Result<std::string> golden = readFile(goldenFile);
  if (!golden) {
    std::fprintf(stderr, "%s\n", golden.error().detail.c_str());
    return 1;
  }
  int wrong = 0;
  for (const Row& row : rows)
    if (golden->find(row.scene + "," + row.solver + "," + hex(row.hash) + "\n") == std::string::npos) {
      std::fprintf(stderr, "%s with %s ends in state %s, which is not in %s\n", row.scene.c_str(),
                   row.solver.c_str(), hex(row.hash).c_str(), goldenFile.c_str());
      ++wrong;
    }
  return wrong == 0 ? 0 : 1;
}

int kernel()
{
  std::printf("scene,springs,ns_per_spring\n");
  for (const Scene& scene : {tube(), uterus(), smallSheet()}) {
    const ForceModel model(scene.net, scene.loads.gravity);
    NodeArray x(model.nodeCount()), v(model.nodeCount(), Lanes{0, 0, 0, 0}), force(model.nodeCount());
    copyNodes(scene.net.restPosition, x);
    double best = 1e9;
    for (int repeat = 0; repeat < 20; ++repeat) {
      const std::clock_t start = std::clock();
      const int passes = 500;
      for (int pass = 0; pass < passes; ++pass) model.computeForces(x.data(), v.data(), force.data());
      const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / passes;
      best = std::min(best, seconds / static_cast<double>(model.activeSprings()));
    }
    std::printf("%s,%" PRId64 ",%s\n", scene.name.c_str(), model.activeSprings(),
                formatDouble(best * 1e9, 3).c_str());
  }
  return 0;
}

int run(const std::vector<std::string>& words)
{
  bool isQuick = false;
  std::string golden;
  std::vector<std::string> scenes;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--kernel") return kernel();
    if (words[i] == "--quick") {
      isQuick = true;
    } else if (words[i] == "--validate-hash" && i + 1 < words.size()) {
      golden = words[++i];
    } else if (words[i].starts_with("-") && words[i] != "work_precision") {
      std::fprintf(stderr, "usage: esm_bench [--quick [--validate-hash FILE] | --kernel | SCENE...]\n");
      return 2;
    } else if (words[i] != "work_precision") {
      scenes.push_back(words[i]);
    }
  }
  return isQuick ? quick(golden) : workPrecision(scenes);
}

} // namespace
} // namespace esm::bench

int main(int argc, char** argv)
{
  return esm::bench::run({argv + 1, argv + argc});
}
