// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/energy_report.h"

#include <algorithm>
#include <cmath>

namespace esm {

double EnergyReport::residual() const noexcept
{
  const double stored = (atStart.elastic - atEnd.elastic) + (atStart.gravity - atEnd.gravity);
  return (atStart.kinetic - atEnd.kinetic) + stored + work + restored - heat - loss;
}

double EnergyReport::largestTerm() const noexcept
{
  double largest = std::max({std::abs(work), std::abs(heat), std::abs(loss), std::abs(restored)});
  for (const Energies& energies : {atStart, atEnd})
    largest = std::max({largest, energies.kinetic, std::abs(energies.elastic), std::abs(energies.gravity)});
  return largest;
}

bool EnergyReport::isKept(double tolerance) const noexcept
{
  constexpr double kRounding = 1e-12; // of sums over many nodes and steps
  return std::abs(residual()) <= std::max(tolerance, kRounding) * largestTerm();
}

} // namespace esm
