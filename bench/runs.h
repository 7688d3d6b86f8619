// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/trajectory.h"
#include "core/base/result.h"
#include "core/dynamics/simulation.h"

#include <filesystem>
#include <string>
#include <vector>

namespace esm::bench {

/// Processor time, with pauses for what does not belong to the run.
class CpuClock {
public:
  CpuClock() { resume(); }
  void pause();
  void resume();
  double seconds() const; ///< @pre paused

private:
  double m_start = 0.0, m_sum = 0.0;
};
double cpuSeconds();
double medianTime(std::vector<double> times);

/// One run, one point of a work-precision diagram.
struct Row {
  std::string scene, method;
  bool ours = false;
  bool fixed = false; ///< setting = steps per frame, else tolerance
  double setting = 0.0;
  double seconds = 0.0;     ///< processor, set-up included
  double error = 0.0;       ///< measured; NaN if lost
  std::int64_t springs = 0; ///< evaluated
  bool good = true;
  std::string note; ///< what auto chose, or what went wrong
};

/// Of a run that keeps the tolerance, whatever it takes.
SolverSettings settingsOf(const Scene& scene, double tolerance);

/// @param cap  processor seconds after which the run is given up.
Row runEngine(const Scene& scene, const std::string& solver, double tolerance, int stepsPerFrame,
              const Reference& reference, double cap);
Row runCompetitor(const Scene& scene, const MethodEntry& entry, double setting, const Reference& reference,
                  double cap);
/// The same run again.
Row runAgain(const Scene& scene, const Row& row, const Reference& reference, double cap);

const char* csvHeader();
std::string csvLine(const Row& row);
std::string csvText(const std::vector<Row>& rows); ///< header and lines
/// What csvText() wrote, in order. Errors: FileUnreadable; BadFormat, which names the line.
Result<std::vector<Row>> readCsv(const std::filesystem::path& file);

} // namespace esm::bench
