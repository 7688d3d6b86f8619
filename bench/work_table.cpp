// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/work_precision.h"
#include "core/base/text_number.h"

#include <algorithm>
#include <cmath>

namespace esm::bench {
namespace {

std::string seconds(const Row& row)
{
  return formatDouble(row.seconds, 3);
}

std::string named(const Row& row)
{
  if (row.method.empty()) return "-";
  std::string text = seconds(row) + " " + row.method;
  text +=
    row.fixed ? " " + std::to_string(static_cast<int>(row.setting)) : " tol " + formatDouble(row.setting, 2);
  return text;
}

std::string ratio(const Row& ours, const Row& other)
{
  if (!ours.good || ours.method.empty() || other.method.empty()) return "-";
  return formatDouble(ours.seconds / other.seconds, 2);
}

std::string automatic(const Row& row)
{
  if (!row.good) return row.note + " after " + seconds(row);
  return seconds(row) + " " + row.note + ", error " + formatDouble(row.error, 2);
}

} // namespace

bool isSameTolerance(double one, double other)
{
  return std::abs(one - other) <= 1e-6 * other;
}

bool keepsTolerance(const Row& row, double tolerance)
{
  const bool isSetSo = !row.fixed && isSameTolerance(row.setting, tolerance);
  return row.ours && row.good && isSetSo && row.error <= tolerance;
}

std::vector<Cell> cellsOf(const std::string& scene, const std::vector<Row>& timed, double agreement)
{
  std::vector<Cell> cells;
  for (const double target : kTargets) {
    Cell cell;
    cell.scene = scene;
    cell.target = target;
    cell.meaningful = agreement * 10.0 <= target;
    for (const Row& row : timed) {
      const bool isAuto = row.method == "auto";
      if (isAuto && row.setting == target) cell.automatic = row;
      if (!row.good || row.error > target) continue;
      const auto offer = [&row](Row& best) {
        if (best.method.empty() || row.seconds < best.seconds) best = row;
      };
      offer(isAuto ? cell.swept : row.ours ? cell.ours : cell.competitor);
      if (!isAuto && keepsTolerance(row, target)) offer(cell.named);
    }
    cells.push_back(cell);
  }
  return cells;
}

std::string tableOf(const std::vector<Cell>& cells)
{
  std::string text =
    "| scene | error | best competitor [s] | best of ours [s] | auto [s] | auto / competitor | "
    "auto / best of ours | auto / best named with that tolerance | auto at any tolerance / competitor | "
    "auto at any tolerance / best of ours |\n|---|---|---|---|---|---|---|---|---|---|\n";
  std::string missed;
  for (const Cell& cell : cells) {
    text += "| " + cell.scene + " | " + formatDouble(cell.target, 1) + " | ";
    if (!cell.meaningful) {
      text += "- | - | the references do not agree well enough | - | - | - | - | - |\n";
      continue;
    }
    text += named(cell.competitor) + " | " + named(cell.ours) + " | " + automatic(cell.automatic) + " | " +
            ratio(cell.automatic, cell.competitor) + " | " + ratio(cell.automatic, cell.ours) + " | " +
            (cell.named.method.empty() ? "-" : ratio(cell.automatic, cell.named) + " " + cell.named.method) +
            " | " + ratio(cell.swept, cell.competitor) + " | " + ratio(cell.swept, cell.ours) + " |\n";
    if (!cell.automatic.good || !(cell.automatic.error <= cell.target))
      missed +=
        "- " + cell.scene + " with --tolerance " + formatDouble(cell.target, 1) + ": " +
        (cell.automatic.good ? "error " + formatDouble(cell.automatic.error, 2) : cell.automatic.note) + "\n";
  }
  text += "\nA number behind a method is its steps per frame (1/60 s). The others' settings are the fastest "
          "whose error came out below;\n"
          "auto was given that error as its tolerance, and in the last two columns what the others were "
          "given: any tolerance.\n";
  text += missed.empty() ? "Every run of auto kept its tolerance.\n"
                         : "Runs of auto that missed their tolerance:\n\n" + missed;
  return text;
}

} // namespace esm::bench
