// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/lanes.h"
#include "core/dynamics/methods/chebyshev_damping.h"
#include "core/dynamics/methods/past_forces.h"

#include <cstddef>

// What a kick of leapfrog does at the nodes, between two passes over the springs: plain, or in the stages of
// ChebyshevDamping. As wide as the processor allows. Held nodes have inverse mass 0: no kick.

namespace esm {

/// v += s F/m, x += h v
void kickAndDrift(std::size_t count, double s, double h, const Lanes* force, const double* inverseMass,
                  Lanes* v, Lanes* x) noexcept;

/// The arrays of a staged kick, N entries each; `viscosity` of single nodes, or null.
struct StagedKick {
  std::size_t count;
  double s; ///< length of the kick [s]
  const double *inverseMass, *viscosity;
  Lanes* force;          ///< F(x, v), then the viscous forces at the stage
  Lanes* a;              ///< s F/m
  Lanes *past, *older;   ///< F before, or null where none is asked for
  PastWeights push;      ///< what drives the kick
  PastWeights next;      ///< what will have been a step before
  bool remembers = true; ///< F for the next steps
};

/// d_1 = a
void firstStage(const StagedKick& kick) noexcept;
/// d_{j-2} <- d_j
void middleStage(const StagedKick& kick, const ChebyshevDamping::Stage& stage, int j, const Lanes* d,
                 Lanes* before) noexcept;
/// v += d_j, x += h v
void lastStage(const StagedKick& kick, const ChebyshevDamping::Stage& stage, int j, double h, const Lanes* d,
               const Lanes* before, Lanes* v, Lanes* x) noexcept;

} // namespace esm
