// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// esm_bench SUBCOMMAND: run time against error, stability, growth, the kernel, the clock. See usage below and
// docs/BENCHMARKS.md.
#include "bench/quick.h"
#include "bench/skip.h"
#include "bench/sub_benches.h"
#include "bench/work_precision.h"

#include <cstdio>

namespace esm::bench {
namespace {

int usage()
{
  std::fprintf(
    stderr,
    "usage: esm_bench work_precision [SCENE...]   run time against error, competitors beside\n"
    "       esm_bench counts [SCENE...] [CONSTANT...]   steps and spring evaluations of auto, the same on "
    "every "
    "machine, without these constants\n"
    "       esm_bench verify [SCENE...] [TOLERANCE...]   what finer runs find of missed tolerances\n"
    "       esm_bench hand [--thread] PROJECT...   how soon a pulled organ answers, and whether it keeps "
    "time\n"
    "       esm_bench hand_beside PROJECT...   the same pull beside what keeps time elsewhere\n"
    "       esm_bench watch [SCENE...]   whether the watch over growing errors is right; with scenes: its "
    "cost\n"
    "       esm_bench fit|holdout [CONSTANT...]   what a constant of the planner is worth, on tuned scenes "
    "and "
    "on others\n"
    "       esm_bench fem [tube|block|NET] [--cases] [--data=FOLDER]   errors of imported nets against "
    "finite elements\n"
    "       esm_bench stability [--quick] [METHOD...]   what stays bounded at one step a frame\n"
    "       esm_bench kernel|growth|skip|realtime|fuzzy|tissue_edit|remesh|import [--quick]\n"
    "       esm_bench --quick [--validate-hash FILE]   seconds; exit 1 if a bit differs\n");
  return 2;
}

int quick(const std::vector<std::string>& words)
{
  if (words.empty()) return runQuick("");
  if (words.size() == 2 && words[0] == "--validate-hash") return runQuick(words[1]);
  return usage();
}

int run(const std::vector<std::string>& words)
{
  if (words.empty()) return usage();
  const std::vector<std::string> rest(words.begin() + 1, words.end());
  if (words[0] == "--quick") return quick(rest);
  if (words[0] == "work_precision") return runWorkPrecision(rest);
  if (words[0] == "stability") return runStability(rest);
  if (words[0] == "growth") return runGrowth(rest);
  if (words[0] == "realtime") return runRealTime(rest);
  if (words[0] == "hand") return runHand(rest);
  if (words[0] == "hand_beside") return runHandBeside(rest);
  if (words[0] == "verify") return runVerify(rest);
  if (words[0] == "counts") return runCounts(rest);
  if (words[0] == "watch") return runWatch(rest);
  if (words[0] == "fit") return runFit(rest);
  if (words[0] == "holdout") return runHoldout(rest);
  if (words[0] == "fuzzy") return runFuzzy(rest);
  if (words[0] == "remesh") return runRemesh(rest);
  if (words[0] == "tissue_edit") return runTissueEdit(rest);
  if (words[0] == "fem") return runFem(rest);
  if (words[0] == "import") return runImport(rest);
#if defined(ESM_BENCH_KERNEL)
  if (words[0] == "kernel") return runKernel(rest);
#endif
  if (words[0] == "skip") return runSkip(rest);
  return usage();
}

} // namespace
} // namespace esm::bench

int main(int argc, char** argv)
{
  return esm::bench::run({argv + 1, argv + argc});
}
