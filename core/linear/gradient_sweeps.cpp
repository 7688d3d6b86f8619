// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/linear/gradient_sweeps.h"

#include "core/forces/spring_pass.h"

namespace esm {

ESM_CPU_CLONES double addDiagonal(std::size_t count, const double* diagonal, const Lanes* p,
                                  Lanes* product) noexcept
{
  Lanes sum = {0, 0, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    product[i] += p[i] * diagonal[i];
    sum += p[i] * product[i];
  }
  return sumLanes(sum);
}

ESM_CPU_CLONES double takeStep(std::size_t count, double step, const Lanes* p, const Lanes* product,
                               const NodeBlock* inverse, Lanes* x, Lanes* r, Lanes* z) noexcept
{
  Lanes sum = {0, 0, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    x[i] += p[i] * step;
    r[i] -= product[i] * step;
    z[i] = times(inverse[i], r[i]);
    sum += r[i] * z[i];
  }
  return sumLanes(sum);
}

} // namespace esm
