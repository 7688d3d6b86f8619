// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/energy_report.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

constexpr double kSummed = 1e-12; // rounding of sums over many nodes and steps

} // namespace

double EnergyReport::residual() const noexcept
{
  const double stored = (atStart.elastic - atEnd.elastic) + (atStart.gravity - atEnd.gravity);
  return (atStart.kinetic - atEnd.kinetic) + stored + work + restored - heat - loss;
}

double EnergyReport::appeared() const noexcept
{
  return -residual() - heat - loss;
}

double EnergyReport::largestTerm() const noexcept
{
  double largest = std::max({std::abs(work), std::abs(heat), std::abs(loss), std::abs(restored)});
  for (const Energies& energies : {atStart, atEnd})
    largest = std::max({largest, energies.kinetic, std::abs(energies.elastic), std::abs(energies.gravity)});
  return largest;
}

/// Twice the tolerance, as energies go by the square of what swings. Where dampers are strong a method may sum
/// their heat half a step beside the motion, but not to more than twice what has gone.
bool EnergyReport::hasAdded(double tolerance) const noexcept
{
  constexpr double kOfHeat = 0.5;
  EnergyReport others = *this;
  others.heat = others.loss = 0.0;
  const double share = std::max(tolerance, kSummed);
  return !(-loss <= kOfHeat * std::abs(heat) + 2.0 * share * others.largestTerm() &&
           appeared() <= share * largestTerm());
}

bool EnergyReport::hasLost() const noexcept
{
  constexpr double kMostLost = 0.5;
  EnergyReport others = *this;
  others.loss = 0.0;
  return loss > kMostLost * others.largestTerm();
}

bool EnergyReport::isKept(double tolerance) const noexcept
{
  return std::abs(residual()) <= std::max(tolerance, kSummed) * largestTerm() && !hasAdded(tolerance);
}

} // namespace esm
