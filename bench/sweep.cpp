// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/sweep.h"

#include <algorithm>
#include <cmath>

namespace esm::bench {
namespace {

bool holds(const Row& row)
{
  return row.good && row.error < 0.5;
}

/// The longest that a run may take and still matter: at the errors not reached so far.
double usefulSeconds(const std::vector<Row>& rows, const Front& front, const Patience& patience)
{
  double reached = 1e30, most = 0.0;
  for (const Row& row : rows)
    if (row.good) reached = std::min(reached, row.error);
  for (std::size_t i = 0; i < kTargets.size(); ++i)
    if (reached > kTargets[i]) most = std::max(most, front.seconds[i]);
  return std::min(patience.cap, patience.factor * most);
}

} // namespace

void Front::add(const Row& row)
{
  for (std::size_t i = 0; i < kTargets.size(); ++i)
    if (row.good && row.error <= kTargets[i]) seconds[i] = std::min(seconds[i], row.seconds);
}

std::vector<Row> sweepSteps(const std::function<Row(int, double)>& run, int guess, Front& front,
                            const Patience& patience)
{
  constexpr int kMost = 1 << 20;
  std::vector<Row> rows;
  const auto tryOut = [&](int steps) {
    rows.push_back(run(steps, usefulSeconds(rows, front, patience)));
    front.add(rows.back());
    return holds(rows.back());
  };
  int good = std::clamp(guess, 1, kMost), bad = 0;
  if (tryOut(good)) {
    while (good > 1 && bad == 0) {
      const int half = std::max(1, good / 2);
      tryOut(half) ? good = half : bad = half;
    }
  } else {
    do {
      if (rows.back().note == "too slow") return rows;
      bad = good;
      good = std::min(2 * good, kMost);
      if (bad == kMost) return rows;
    } while (!tryOut(good));
  }
  while (bad > 0 && good > patience.finest * bad && good > bad + 1) {
    const int middle =
      std::clamp(static_cast<int>(std::lround(std::sqrt(1.0 * good * bad))), bad + 1, good - 1);
    (tryOut(middle) ? good : bad) = middle;
  }
  double steps = good;
  while (true) {
    steps = std::max(steps + 1.0, steps * std::pow(2.0, 0.25));
    const double useful = usefulSeconds(rows, front, patience);
    if (useful == 0.0 || steps > kMost) break;
    tryOut(static_cast<int>(std::lround(steps)));
    if (rows.back().seconds > useful) break;
  }
  return rows;
}

std::vector<Row> sweepTolerances(const std::function<Row(double, double)>& run, Front& front,
                                 const Patience& patience, double ratio)
{
  std::vector<Row> rows;
  for (double tolerance = 0.1; tolerance > 1e-10; tolerance /= ratio) {
    const double useful = usefulSeconds(rows, front, patience);
    if (useful == 0.0) break;
    rows.push_back(run(tolerance, useful));
    front.add(rows.back());
    if (rows.back().seconds > useful) break;
  }
  return rows;
}

void refineWinners(std::vector<Row>& rows, const std::function<Row(const Row& like, int steps)>& run)
{
  for (const double target : kTargets) {
    const auto reaches = [&](const Row& row) { return row.good && row.error <= target; };
    Row best;
    for (const Row& row : rows)
      if (reaches(row) && (best.method.empty() || row.seconds < best.seconds)) best = row;
    if (best.method.empty() || !best.fixed) continue;
    double tooFew = 0.0;
    for (const Row& row : rows)
      if (row.method == best.method && row.fixed && row.setting < best.setting && !reaches(row))
        tooFew = std::max(tooFew, row.setting);
    while (tooFew > 0.0 && best.setting > 1.04 * tooFew && best.setting > tooFew + 1.5) {
      rows.push_back(run(best, static_cast<int>(std::lround(std::sqrt(best.setting * tooFew)))));
      if (reaches(rows.back()))
        best = rows.back();
      else
        tooFew = rows.back().setting;
    }
  }
}

} // namespace esm::bench
