// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/staged_kick.h"

namespace esm {
namespace {

/// The viscous forces of single nodes open the next pass over the springs.
template <bool bedded>
ESM_INLINE void setDrag(const StagedKick& kick, std::size_t i, const Lanes& d) noexcept
{
  const Lanes zero = {0, 0, 0, 0};
  if constexpr (bedded)
    kick.force[i] = d * -kick.viscosity[i];
  else
    kick.force[i] = zero;
}

template <bool bedded>
ESM_INLINE void firstSweep(const StagedKick& kick) noexcept
{
  for (std::size_t i = 0; i < kick.count; ++i) {
    kick.a[i] = kick.force[i] * (kick.s * kick.inverseMass[i]);
    setDrag<bedded>(kick, i, kick.a[i]);
  }
}

/// The same with forces of the past. F takes the place of the oldest, which becomes the newest.
template <bool bedded, bool remembers>
ESM_INLINE void firstSweepInPhase(const StagedKick& kick) noexcept
{
  for (std::size_t i = 0; i < kick.count; ++i) {
    const Lanes f = kick.force[i], p = kick.past[i], o = kick.older[i];
    Lanes push, before;
    kick.push.mean(f, p, o, push);
    kick.a[i] = push * (kick.s * kick.inverseMass[i]);
    if constexpr (remembers) {
      kick.next.mean(f, p, o, before);
      kick.past[i] = before;
      kick.older[i] = f;
    }
    setDrag<bedded>(kick, i, kick.a[i]);
  }
}

template <bool bedded>
ESM_INLINE void firstOf(const StagedKick& kick) noexcept
{
  if (kick.past == nullptr || kick.older == nullptr)
    firstSweep<bedded>(kick);
  else if (kick.remembers)
    firstSweepInPhase<bedded, true>(kick);
  else
    firstSweepInPhase<bedded, false>(kick);
}

/// d_j at a node; `known` of the differences before it are in d and before: none for stage 2, d_2 for
/// stage 3.
template <int known>
ESM_INLINE void stageAt(const StagedKick& kick, const ChebyshevDamping::Stage& stage, std::size_t i,
                        const Lanes* d, const Lanes* before, Lanes& next) noexcept
{
  next = kick.a[i] * stage.push + kick.force[i] * (stage.kick * kick.s * kick.inverseMass[i]);
  if constexpr (known > 0) next += d[i] * stage.mu;
  if constexpr (known > 1) next += before[i] * stage.nu;
}

template <int known, bool bedded>
ESM_INLINE void middleSweep(const StagedKick& kick, const ChebyshevDamping::Stage& stage, const Lanes* d,
                            Lanes* before) noexcept
{
  for (std::size_t i = 0; i < kick.count; ++i) {
    Lanes next;
    stageAt<known>(kick, stage, i, d, before, next);
    before[i] = next;
    setDrag<bedded>(kick, i, next);
  }
}

template <int known>
ESM_INLINE void lastSweep(const StagedKick& kick, const ChebyshevDamping::Stage& stage, double h,
                          const Lanes* d, const Lanes* before, Lanes* v, Lanes* x) noexcept
{
  for (std::size_t i = 0; i < kick.count; ++i) {
    Lanes next;
    stageAt<known>(kick, stage, i, d, before, next);
    v[i] += next;
    x[i] += v[i] * h;
  }
}

template <int known>
ESM_INLINE void middleOf(const StagedKick& kick, const ChebyshevDamping::Stage& stage, const Lanes* d,
                         Lanes* before) noexcept
{
  kick.viscosity ? middleSweep<known, true>(kick, stage, d, before)
                 : middleSweep<known, false>(kick, stage, d, before);
}

} // namespace

ESM_CPU_CLONES void kickAndDrift(std::size_t count, double s, double h, const Lanes* force,
                                 const double* inverseMass, Lanes* v, Lanes* x) noexcept
{
  for (std::size_t i = 0; i < count; ++i) {
    v[i] += force[i] * (s * inverseMass[i]);
    x[i] += v[i] * h;
  }
}

ESM_CPU_CLONES void firstStage(const StagedKick& given) noexcept
{
  const StagedKick kick = given; // as ESM_CPU_CLONES says, here and below
  kick.viscosity ? firstOf<true>(kick) : firstOf<false>(kick);
}

ESM_CPU_CLONES void middleStage(const StagedKick& given, const ChebyshevDamping::Stage& asked, int j,
                                const Lanes* d, Lanes* before) noexcept
{
  const StagedKick kick = given;
  const ChebyshevDamping::Stage stage = asked;
  if (j == 2)
    middleOf<0>(kick, stage, d, before);
  else if (j == 3)
    middleOf<1>(kick, stage, d, before);
  else
    middleOf<2>(kick, stage, d, before);
}

ESM_CPU_CLONES void lastStage(const StagedKick& given, const ChebyshevDamping::Stage& asked, int j, double h,
                              const Lanes* d, const Lanes* before, Lanes* v, Lanes* x) noexcept
{
  const StagedKick kick = given;
  const ChebyshevDamping::Stage stage = asked;
  if (j == 2)
    lastSweep<0>(kick, stage, h, d, before, v, x);
  else if (j == 3)
    lastSweep<1>(kick, stage, h, d, before, v, x);
  else
    lastSweep<2>(kick, stage, h, d, before, v, x);
}

} // namespace esm
