// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/integrator.h"

#include <array>

namespace esm {

std::span<const IntegratorEntry> integratorTable() noexcept
{
  static constexpr std::array<IntegratorEntry, 3> table{{
    {"verlet", "velocity Verlet: second order, explicit, one force pass per step; soft to medium nets",
     &makeVerlet},
    {"rk4", "classical Runge-Kutta: fourth order, explicit, four force passes per step; small errors",
     &makeRungeKutta4},
    {"implicit", "TR-BDF2: second order, implicit with sparse Cholesky, stable at any step; stiff nets",
     &makeImplicit},
  }};
  return table;
}

std::unique_ptr<Integrator> makeIntegrator(std::string_view name)
{
  for (const IntegratorEntry& entry : integratorTable())
    if (entry.name == name) return entry.make();
  return nullptr;
}

bool allFinite(const NodeArray& x, const NodeArray& v) noexcept
{
  Lanes probe = {0, 0, 0, 0}; // a - a is 0, or NaN where a is not finite
  for (std::size_t i = 0; i < x.size(); ++i) probe += (x[i] - x[i]) + (v[i] - v[i]);
  return sumLanes(probe) == 0.0;
}

} // namespace esm
