// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_law.h"

namespace esm {

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
