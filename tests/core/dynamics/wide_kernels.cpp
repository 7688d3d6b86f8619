// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The kernels once more, eight springs at a time as with AVX-512 but for plain x86-64, so that a test can see
// the order of the eight on every CPU.
#ifdef ESM_INLINE
#error "lanes.h has been read with versions for several CPUs; this file must be compiled by itself"
#endif
#define ESM_NO_CLONES
#define ESM_LANES_WITHOUT_CLONES 8
#define linearLaw wideLinearLaw
#define cubicLaw wideCubicLaw
#define exponentialLaw wideExponentialLaw
#define addDamping wideAddDamping
#include "core/forces/cubic_law.cpp"
#include "core/forces/damper_pass.cpp"
#include "core/forces/exponential_law.cpp"
#include "core/forces/linear_law.cpp"
