// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_law.h"

#include <cmath>

namespace esm {

double SpringLawKernel::energy(const SpringBatch& batch, const Lanes* x) const noexcept
{
  double energy = 0.0;
  for (std::size_t i = 0; i < batch.count; ++i) {
    const Lanes d = x[batch.b[i]] - x[batch.a[i]];
    const double e = std::sqrt(dot(d, d)) - batch.restLength[i];
    if (!(batch.tensionOnly && e <= 0.0)) energy += respond(batch, i, e).energy;
  }
  return energy;
}

const SpringLawKernel& springLawKernel(SpringLaw law) noexcept
{
  switch (law) {
  case SpringLaw::Linear:
    return linearLaw();
  case SpringLaw::Cubic:
    return cubicLaw();
  case SpringLaw::Exponential:
    return exponentialLaw();
  case SpringLaw::Table:
    return tableLaw();
  }
  return linearLaw();
}

} // namespace esm
