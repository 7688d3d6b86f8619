// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/spring_ends.h"

#include <algorithm>

namespace esm::detail {

/// How many groups of springs are computed together, see passGroups(). With four lanes three are best: two
/// take 8 % longer, four 3 %. With eight lanes two and three took longer than one before springs had records,
/// and have not been measured since.
template <class Ends>
inline constexpr std::size_t kGroupsAtOnce = Ends::kCount == FourEnds::kCount ? 3 : 1;

/// The springs first .. first + Ends::kCount - 1 of a batch in a pass, by their records.
template <class Law, class Ends, bool damped, bool alike>
struct SpringGroup {
  using Values = typename Ends::Values;
  static constexpr std::size_t kRows = recordRows(Law::kLaw, damped, alike); ///< of one record
  const SpringBatch& batch;
  std::size_t first;
  const Lanes* record;
  const Lanes* shared; ///< SpringBatch::shared

  ESM_INLINE SpringGroup(const SpringBatch& of, std::size_t i) noexcept
    : batch(of), first(i), record(of.record.data() + i / 4 * kRows), shared(of.shared.data())
  {}
  ESM_INLINE Ends ends() const noexcept { return Ends(record, kRows); }
  /// The same, read once more: the compiler would keep what it has read on the stack, which has enough to do.
  ESM_INLINE Ends endsAgain() const noexcept
  {
    const Lanes* again = record;
    asm("" : "+r"(again));
    return Ends(again, kRows);
  }
  ESM_INLINE void row(std::size_t k, Values& values) const noexcept
  {
    if constexpr (Ends::kCount == 4)
      values = record[k];
    else
      joinHalves(record[k], record[kRows + k], values);
  }
  ESM_INLINE void sharedRow(std::size_t k, Values& values) const noexcept
  {
    if constexpr (Ends::kCount == 4)
      values = shared[k];
    else
      joinHalves(shared[k], shared[k], values);
  }
  ESM_INLINE void restLength(Values& values) const noexcept { row(1, values); }
  ESM_INLINE void lawRow(std::size_t k, Values& values) const noexcept
  {
    if constexpr (!alike)
      row(2 + k, values);
    else if (k == 0)
      sharedRow(0, values);
    else
      row(1 + k, values);
  }
  ESM_INLINE void viscosity(Values& values) const noexcept
  {
    if constexpr (alike)
      sharedRow(1, values);
    else
      row(kRows - 1, values);
  }
  ESM_INLINE void rootViscosity(Values& values) const noexcept
  {
    if constexpr (alike)
      sharedRow(2, values);
    else
      loadLanes(&batch.rootViscosity[first], values);
  }
};

/// What the three parts of a pass over a group of springs hand on.
template <class Values>
struct GroupInFlight {
  Values d0, d1, d2, d3; ///< x[b] - x[a], in the order of Ends
  Values dx, dy, dz;     ///< the same in lanes
  Values square;         ///< |d|^2 [m^2]
  Values slip;           ///< (v[b] - v[a]).d [m^2/s]
  Values scale;          ///< tension over length [N/m]
};

/// Where the ends are.
template <class Ends, class Values>
ESM_INLINE void readPlaces(const Ends& ends, const Lanes* x, GroupInFlight<Values>& group) noexcept
{
  ends.difference(x, group.d0, group.d1, group.d2, group.d3);
  transpose(group.d0, group.d1, group.d2, group.d3, group.dx, group.dy, group.dz);
  group.square = group.dx * group.dx + group.dy * group.dy + group.dz * group.dz;
}

/// First part: what the nodes say.
template <class Law, class Ends, bool damped, bool alike, class Values>
ESM_INLINE void readGroup(const SpringGroup<Law, Ends, damped, alike>& springs, const Lanes* x,
                          const Lanes* v, GroupInFlight<Values>& group) noexcept
{
  const Ends ends = springs.ends();
  readPlaces(ends, x, group);
  if constexpr (damped) {
    Values w0, w1, w2, w3, wx, wy, wz;
    ends.difference(v, w0, w1, w2, w3);
    transpose(w0, w1, w2, w3, wx, wy, wz);
    group.slip = wx * group.dx + wy * group.dy + wz * group.dz;
  }
}

/// Second part: how hard each spring pulls.
///
/// A spring without direction gets the reciprocal length 0: then its force, its damping and its heat vanish
/// without further tests. A NaN is not too short, and spreads. The reciprocal of the square is found beside
/// the length, not after it: the damping needs that one anyway, and no division waits for a root.
template <bool tensionOnly, bool keep, class Law, class Ends, bool damped, bool alike, class Values>
ESM_INLINE void stretchGroup(const SpringGroup<Law, Ends, damped, alike>& springs,
                             GroupInFlight<Values>& group, Lanes* damper, Lanes& heat) noexcept
{
  const Values zero = {};
  const Values one = zero + 1.0;
  const Values shortest = one * (kMinSpringLength * kMinSpringLength);
  Values length = group.square, restLength, tension;
  squareRoot(length);
  const BitsOf<Values> tooShort = group.square < shortest; // all bits set where true
  Values inverseSquare = one / group.square;
  inverseSquare = tooShort ? zero : inverseSquare;
  const Values inverse = length * inverseSquare;
  springs.restLength(restLength);
  const Values e = length - restLength;
  Law::tension(springs, e, tension);
  group.scale = tension * inverse;
  if constexpr (damped) {
    Values drag;
    springs.viscosity(drag);
    drag *= group.slip * inverseSquare;
    if constexpr (tensionOnly) drag = e <= zero ? zero : drag;
    Ends::addTo(heat, drag * group.slip);
    group.scale += drag;
    if constexpr (keep) {
      Values root;
      springs.rootViscosity(root);
      root *= inverse;
      if constexpr (tensionOnly) root = e <= zero ? zero : root;
      Ends::store(damper + springs.first / 4 * 3, group.dx * root, group.dy * root, group.dz * root);
    }
  }
  if constexpr (tensionOnly) group.scale = e <= zero ? zero : group.scale;
}

/// The pass that all laws share, over springs begin .. end-1 in steps of `groups` groups of Ends::kCount;
/// @return where it stopped, less than a step before the end. `Law::tension(group, e, f)` gives f(e) of a
/// SpringGroup. With `keep` the damping is stored as well, see DamperArray.
///
/// From reading the nodes to pulling at them a spring takes a hundred cycles, most of them waiting for the
/// root and the quotient, and a processor looks only some 250 instructions ahead: not three groups. So the
/// groups of a step go through each part together, and wait together: a quarter of the time.
template <class Law, class Ends, std::size_t groups, bool damped, bool alike, bool tensionOnly, bool keep>
ESM_INLINE std::size_t passGroups(const SpringBatch& batch, std::size_t begin, std::size_t end,
                                  const Lanes* x, const Lanes* v, Lanes* force, Lanes* damper,
                                  Lanes& heat) noexcept
{
  using Values = typename Ends::Values;
  std::size_t i = begin;
  for (; i + groups * Ends::kCount <= end; i += groups * Ends::kCount) {
    using Springs = SpringGroup<Law, Ends, damped, alike>;
    GroupInFlight<Values> group[groups];
    for (std::size_t g = 0; g < groups; ++g)
      foresee(Springs(batch, i + g * Ends::kCount).record, Ends::kCount / 4 * Springs::kRows);
    for (std::size_t g = 0; g < groups; ++g) readGroup(Springs(batch, i + g * Ends::kCount), x, v, group[g]);
    for (std::size_t g = 0; g < groups; ++g)
      stretchGroup<tensionOnly, keep>(Springs(batch, i + g * Ends::kCount), group[g], damper, heat);
    for (std::size_t g = 0; g < groups; ++g)
      Springs(batch, i + g * Ends::kCount).endsAgain().pullAlong(force, group[g]);
  }
  return i;
}

/// In the widest groups that the version of a function has, and what is left by fours.
template <class Law, class Widest, bool damped, bool alike, bool tensionOnly, bool keep>
ESM_INLINE double springPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                             Lanes* damper) noexcept
{
  const std::size_t count = batch.paddedCount();
  Lanes heat = {0, 0, 0, 0};
  const std::size_t done = passGroups<Law, Widest, kGroupsAtOnce<Widest>, damped, alike, tensionOnly, keep>(
    batch, 0, count, x, v, force, damper, heat);
  passGroups<Law, FourEnds, 1, damped, alike, tensionOnly, keep>(batch, done, count, x, v, force, damper,
                                                                 heat);
  return sumLanes(heat);
}

/// Chooses among the kinds of batch, once per batch.
template <class Law, class Widest, bool damped, bool alike>
ESM_INLINE double springPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                             Lanes* damper) noexcept
{
  if constexpr (damped)
    if (damper != nullptr)
      return batch.tensionOnly
               ? springPass<Law, Widest, true, alike, true, true>(batch, x, v, force, damper)
               : springPass<Law, Widest, true, alike, false, true>(batch, x, v, force, damper);
  return batch.tensionOnly
           ? springPass<Law, Widest, damped, alike, true, false>(batch, x, v, force, nullptr)
           : springPass<Law, Widest, damped, alike, false, false>(batch, x, v, force, nullptr);
}

template <class Law, class Widest>
ESM_INLINE double springPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                             Lanes* damper) noexcept
{
  if constexpr (canBeAlike(Law::kLaw))
    if (batch.alike)
      return batch.damped ? springPass<Law, Widest, true, true>(batch, x, v, force, damper)
                          : springPass<Law, Widest, false, true>(batch, x, v, force, damper);
  return batch.damped ? springPass<Law, Widest, true, false>(batch, x, v, force, damper)
                      : springPass<Law, Widest, false, false>(batch, x, v, force, damper);
}

/// The energy of a batch [J], four springs at a time on every CPU: sums in another order have other bits.
/// `Law::energy(group, e, result)` gives that of a SpringGroup at extensions e; what only fills up has no
/// stiffness or no extension, and none.
template <class Law, bool damped, bool alike>
ESM_INLINE double energyPass(const SpringBatch& batch, const Lanes* x) noexcept
{
  const Lanes zero = {0, 0, 0, 0};
  Lanes sum = zero;
  for (std::size_t i = 0; i < batch.paddedCount(); i += FourEnds::kCount) {
    const SpringGroup<Law, FourEnds, damped, alike> springs(batch, i);
    GroupInFlight<Lanes> group;
    readPlaces(springs.ends(), x, group);
    Lanes length = group.square, restLength, energy;
    squareRoot(length);
    springs.restLength(restLength);
    const Lanes e = length - restLength;
    Law::energy(springs, e, energy);
    if (batch.tensionOnly) energy = e <= zero ? zero : energy;
    sum += energy;
  }
  return sumLanes(sum);
}

template <class Law>
ESM_INLINE double energyPass(const SpringBatch& batch, const Lanes* x) noexcept
{
  if constexpr (canBeAlike(Law::kLaw))
    if (batch.alike)
      return batch.damped ? energyPass<Law, true, true>(batch, x) : energyPass<Law, false, true>(batch, x);
  return batch.damped ? energyPass<Law, true, false>(batch, x) : energyPass<Law, false, false>(batch, x);
}

/// SpringLawKernel::tensions(), four springs at a time; what only fills up has none.
template <class Law, bool damped, bool alike>
ESM_INLINE double tensionPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, double* each) noexcept
{
  const Lanes zero = {0, 0, 0, 0};
  Lanes largest = zero;
  for (std::size_t i = 0; i < batch.paddedCount(); i += FourEnds::kCount) {
    const SpringGroup<Law, FourEnds, damped, alike> springs(batch, i);
    GroupInFlight<Lanes> group;
    readGroup(springs, x, v, group);
    Lanes length = group.square, restLength, tension;
    squareRoot(length);
    springs.restLength(restLength);
    const Lanes e = length - restLength;
    Law::tension(springs, e, tension);
    if constexpr (damped) {
      Lanes viscosity;
      springs.viscosity(viscosity);
      tension += viscosity * (group.slip / length);
    }
    if (batch.tensionOnly) tension = e <= zero ? zero : tension;
    tension = length < zero + kMinSpringLength ? zero : tension;
    if (each != nullptr)
      for (std::size_t s = i; s < std::min(i + FourEnds::kCount, batch.count); ++s)
        each[batch.spring[s]] = tension[s - i];
    tension = tension < zero ? -tension : tension;
    largest = tension > largest ? tension : largest;
  }
  return std::max(std::max(largest[0], largest[1]), std::max(largest[2], largest[3]));
}

template <class Law>
ESM_INLINE double tensionPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, double* each) noexcept
{
  if constexpr (canBeAlike(Law::kLaw))
    if (batch.alike)
      return batch.damped ? tensionPass<Law, true, true>(batch, x, v, each)
                          : tensionPass<Law, false, true>(batch, x, v, each);
  return batch.damped ? tensionPass<Law, true, false>(batch, x, v, each)
                      : tensionPass<Law, false, false>(batch, x, v, each);
}

} // namespace esm::detail
