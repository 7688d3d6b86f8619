// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/sweep.h"

#include <string>
#include <vector>

namespace esm::bench {

struct WorkOptions {
  std::vector<std::string> scenes;
  std::vector<std::string> solvers;     ///< of ours besides auto; empty = all
  std::vector<std::string> competitors; ///< empty = those that have been on the front
  bool allCompetitors = false;          ///< also those that never were on the front
  bool fixedSteps = true;               ///< ours with hand-tuned steps, too
  bool retune = false;                  ///< do not believe cached sweeps of the competitors
  std::string candidatesFile;           ///< times auto and what this CSV names, without a search
  int runs = 5;                         ///< the median of so many
  double budget = 60.0; ///< processor seconds per scene for the repetitions; one round at least
  Patience patience;
  std::string csvFile, tableFile; ///< "" = stdout only
};

/// What one line of the table says: least seconds at an error, by whom.
struct Cell {
  std::string scene;
  double target = 0.0;
  bool meaningful = true;          ///< the references agree well enough
  Row competitor, ours, automatic; ///< method "" = nobody came so far; automatic has tolerance = target
  Row named;                       ///< the best of ours that was named and given the same tolerance
  Row swept;                       ///< the best of auto at any tolerance, as the others have any setting
};

/// But for the rounding of a sweep.
bool isSameTolerance(double one, double other);
/// Whether the row is one of a method of ours that was given this tolerance, and kept it.
bool keepsTolerance(const Row& row, double tolerance);
std::vector<Cell> cellsOf(const std::string& scene, const std::vector<Row>& timed, double agreement);
/// Markdown, with the list of the runs of auto that missed their tolerance.
std::string tableOf(const std::vector<Cell>& cells);

/// esm_bench work_precision; see usage in main.cpp. @return exit code
int runWorkPrecision(const std::vector<std::string>& words);

} // namespace esm::bench
