// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The kernels once more, for plain x86-64 only and under other names, so that a test can compare the bits.
#ifdef ESM_INLINE
#error "lanes.h has been read with versions for several CPUs; this file must be compiled by itself"
#endif
#define ESM_NO_CLONES
#define linearLaw plainLinearLaw
#define cubicLaw plainCubicLaw
#define exponentialLaw plainExponentialLaw
#define tableLaw plainTableLaw
#define addDamping plainAddDamping
#define Pressure PlainPressure
#include "core/forces/cubic_law.cpp"
#include "core/forces/damper_pass.cpp"
#include "core/forces/exponential_law.cpp"
#include "core/forces/linear_law.cpp"
#include "core/forces/pressure.cpp"
#include "core/forces/table_law.cpp"

namespace esm {

/// The volume within the net's first body, whose gradient is added.
double plainVolume(const SpringNet& net, const Lanes* x, Lanes* gradient)
{
  const PlainPressure pressure(net);
  pressure.addGradient(0, x, gradient);
  return pressure.volume(0, x);
}

} // namespace esm
