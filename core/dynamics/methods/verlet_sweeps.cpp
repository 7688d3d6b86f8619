// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/verlet_sweeps.h"

#include "core/forces/spring_pass.h"

#include <algorithm>

namespace esm {
namespace {

/// One node from v and a on.
ESM_INLINE void predictNode(const Prediction& how, const Lanes& v, const Lanes& a, Lanes& x, Lanes& half,
                            Lanes& p) noexcept
{
  half = v + a * (0.5 * how.h);
  x += half * how.h;
  p = v + (p - v) * how.carry + a * how.h;
}

} // namespace

double leastCarry(double stiffness, double damping, double h) noexcept
{
  const double left = 1.0 - 0.25 * stiffness * h * h, needed = damping * h / left - 1.0;
  return left > 0.0 && needed < kMostCarry ? std::max(needed, 0.0) : kMostCarry;
}

ESM_CPU_CLONES void predictNodes(const Prediction& given, std::size_t count, const Lanes* a, Lanes* x,
                                 Lanes* half, Lanes* p) noexcept
{
  const Prediction how = given; // as ESM_CPU_CLONES says
  for (std::size_t i = 0; i < count; ++i) {
    const Lanes v = half[i];
    predictNode(how, v, a[i], x[i], half[i], p[i]);
  }
}

ESM_CPU_CLONES void correctAndPredictNodes(const Prediction& given, std::size_t count,
                                           const double* inverseMass, const Lanes* force, Lanes* x,
                                           Lanes* half, Lanes* p) noexcept
{
  const Prediction how = given; // as ESM_CPU_CLONES says
  for (std::size_t i = 0; i < count; ++i) {
    const Lanes a = force[i] * inverseMass[i], v = half[i] + a * (0.5 * how.h);
    predictNode(how, v, a, x[i], half[i], p[i]);
  }
}

ESM_CPU_CLONES void correctNodes(double h, std::size_t count, const double* inverseMass, const Lanes* force,
                                 Lanes* a, Lanes* half) noexcept
{
  for (std::size_t i = 0; i < count; ++i) {
    a[i] = force[i] * inverseMass[i];
    half[i] += a[i] * (0.5 * h);
  }
}

} // namespace esm
