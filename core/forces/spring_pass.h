// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/spring_ends.h"

#include <algorithm>

namespace esm::detail {

/// How many groups of springs are computed together, see passGroups(): two take 8 % longer, four 3 %.
inline constexpr std::size_t kGroupsAtOnce = 3;

/// The springs first .. first + 3 of a batch in a pass, by their record.
template <class Law, bool damped, bool alike>
struct SpringGroup {
  static constexpr std::size_t kRows = recordRows(Law::kLaw, damped, alike); ///< of one record
  const SpringBatch& batch;
  std::size_t first;
  const Lanes* record;
  const Lanes* shared; ///< SpringBatch::shared

  ESM_INLINE SpringGroup(const SpringBatch& of, std::size_t i) noexcept
    : batch(of), first(i), record(of.record.data() + i / 4 * kRows), shared(of.shared.data())
  {}
  ESM_INLINE FourEnds ends() const noexcept { return FourEnds(record); }
  /// The same, read once more: the compiler would keep what it has read on the stack, which has enough to do.
  ESM_INLINE FourEnds endsAgain() const noexcept
  {
    const Lanes* again = record;
    asm("" : "+r"(again));
    return FourEnds(again);
  }
  ESM_INLINE void restLength(Lanes& values) const noexcept { values = record[1]; }
  ESM_INLINE void lawRow(std::size_t k, Lanes& values) const noexcept
  {
    if constexpr (!alike)
      values = record[2 + k];
    else
      values = k == 0 ? shared[0] : record[1 + k];
  }
  ESM_INLINE void viscosity(Lanes& values) const noexcept { values = alike ? shared[1] : record[kRows - 1]; }
  ESM_INLINE void rootViscosity(Lanes& values) const noexcept
  {
    if constexpr (alike)
      values = shared[2];
    else
      loadLanes(&batch.rootViscosity[first], values);
  }
};

/// See SpringLawKernel::addForces().
struct KeptDamping {
  Lanes* damper = nullptr;
  Lateness late = {};
};
enum class Keep { Nothing, Damping, DampingOfLate };

/// What the three parts of a pass over a group of springs hand on.
struct GroupInFlight {
  Lanes dx, dy, dz; ///< x[b] - x[a]
  Lanes square;     ///< |d|^2 [m^2]
  Lanes slip;       ///< (v[b] - v[a]).d [m^2/s]
  Lanes speed;      ///< |v[b] - v[a]|^2 [m^2/s^2]
  Lanes scale;      ///< tension over length [N/m]
};

/// Where the ends are.
ESM_INLINE void readPlaces(const FourEnds& ends, const Lanes* x, GroupInFlight& group) noexcept
{
  Lanes d0, d1, d2, d3;
  ends.difference(x, d0, d1, d2, d3);
  transpose(d0, d1, d2, d3, group.dx, group.dy, group.dz);
  group.square = group.dx * group.dx + group.dy * group.dy + group.dz * group.dz;
}

/// First part: what the nodes say.
template <class Law, bool damped, bool alike>
ESM_INLINE void readGroup(const SpringGroup<Law, damped, alike>& springs, const Lanes* x, const Lanes* v,
                          GroupInFlight& group) noexcept
{
  const FourEnds ends = springs.ends();
  readPlaces(ends, x, group);
  if constexpr (damped) {
    Lanes w0, w1, w2, w3, wx, wy, wz;
    ends.difference(v, w0, w1, w2, w3);
    transpose(w0, w1, w2, w3, wx, wy, wz);
    group.slip = wx * group.dx + wy * group.dy + wz * group.dz;
    group.speed = wx * wx + wy * wy + wz * wz; // only where something is late
  }
}

/// What the second part finds of a group on its way.
struct Stretch {
  Lanes inverseSquare, inverse; ///< 1/|d|^2 [1/m^2], 1/|d| [1/m]
  Lanes extension;              ///< [m]
};

/// Second part: how long each spring is.
///
/// A spring without direction gets the reciprocal length 0: then its force, its damping and its heat vanish
/// without further tests. A NaN is not too short, and spreads. The reciprocal of the square is found beside
/// the length, not after it: the damping needs that one anyway, and no division waits for a root.
template <class Law, bool damped, bool alike>
ESM_INLINE void measureGroup(const SpringGroup<Law, damped, alike>& springs, const GroupInFlight& group,
                             Stretch& stretch) noexcept
{
  const Lanes zero = {0, 0, 0, 0};
  const Lanes one = zero + 1.0;
  const Lanes shortest = one * (kMinSpringLength * kMinSpringLength);
  Lanes length = group.square, restLength;
  squareRoot(length);
  const LaneBits tooShort = group.square < shortest; // all bits set where true
  const Lanes inverseSquare = one / group.square;
  stretch.inverseSquare = tooShort ? zero : inverseSquare;
  stretch.inverse = length * stretch.inverseSquare;
  springs.restLength(restLength);
  stretch.extension = length - restLength;
}

/// The power of the damper when the ends were where their velocities have been [W].
ESM_INLINE void earlierPower(const GroupInFlight& group, double late, const Lanes& viscosity,
                             Lanes& power) noexcept
{
  const Lanes zero = {0, 0, 0, 0};
  const Lanes slip = group.slip - late * group.speed,
              square = group.square - late * (group.slip + slip); // |d - late w|^2
  power = viscosity * (slip * slip / square);
  power = square < zero + kMinSpringLength * kMinSpringLength ? zero : power;
}

/// And how hard it pulls.
template <bool tensionOnly, Keep keep, class Law, bool damped, bool alike>
ESM_INLINE void scaleGroup(const SpringGroup<Law, damped, alike>& springs, const Stretch& stretch,
                           const Lanes& tension, GroupInFlight& group, const KeptDamping& kept,
                           Lanes& heat) noexcept
{
  const Lanes zero = {0, 0, 0, 0};
  const Lanes& e = stretch.extension;
  group.scale = tension * stretch.inverse;
  if constexpr (damped) {
    Lanes viscosity;
    springs.viscosity(viscosity);
    Lanes drag = viscosity * (group.slip * stretch.inverseSquare);
    if constexpr (tensionOnly) drag = e <= zero ? zero : drag;
    group.scale += drag;
    const Lanes power = drag * group.slip;
    heat += power;
    if constexpr (keep == Keep::DampingOfLate) {
      Lanes earlier;
      earlierPower(group, kept.late.time, viscosity, earlier);
      if constexpr (tensionOnly) earlier = e <= zero ? zero : earlier;
      heat += kept.late.passes * (earlier - power);
    }
    if constexpr (keep != Keep::Nothing) {
      Lanes root;
      springs.rootViscosity(root);
      root *= stretch.inverse;
      if constexpr (tensionOnly) root = e <= zero ? zero : root;
      Lanes* const rows = kept.damper + springs.first / 4 * 3;
      rows[0] = group.dx * root;
      rows[1] = group.dy * root;
      rows[2] = group.dz * root;
    }
  }
  if constexpr (tensionOnly) group.scale = e <= zero ? zero : group.scale;
}

/// Whether a law finds the tensions of several groups in one: `Law::tensions<groups>(springs, stretch, f)`,
/// where springs(g) gives the SpringGroup g.
template <class Law>
concept TakesGroupsTogether = requires
{
  Law::kTakesGroupsTogether;
};

/// The second part of a step. Between its two halves groups wait on the stack only where the law needs it.
template <bool tensionOnly, Keep keep, std::size_t groups, class Law, class Springs>
ESM_INLINE void stretchGroups(const Springs& springs, GroupInFlight* group, const KeptDamping& kept,
                              Lanes& heat) noexcept
{
  if constexpr (TakesGroupsTogether<Law>) {
    Stretch stretch[groups];
    Lanes tension[groups];
    for (std::size_t g = 0; g < groups; ++g) measureGroup(springs(g), group[g], stretch[g]);
    Law::template tensions<groups>(springs, stretch, tension);
    for (std::size_t g = 0; g < groups; ++g)
      scaleGroup<tensionOnly, keep>(springs(g), stretch[g], tension[g], group[g], kept, heat);
  } else {
    for (std::size_t g = 0; g < groups; ++g) {
      Stretch stretch;
      Lanes tension;
      measureGroup(springs(g), group[g], stretch);
      Law::tension(springs(g), stretch.extension, tension);
      scaleGroup<tensionOnly, keep>(springs(g), stretch, tension, group[g], kept, heat);
    }
  }
}

/// The pass that all laws share, over springs begin .. end-1 in steps of `groups` groups of four; @return
/// where it stopped, less than a step before the end. `Law::tension(group, e, f)` gives f(e) of a
/// SpringGroup. The damping may be stored as well, see DamperArray.
///
/// From reading the nodes to pulling at them a spring takes a hundred cycles, most of them waiting for the
/// root and the quotient, and a processor looks only some 250 instructions ahead: not three groups. So the
/// groups of a step go through each part together, and wait together: a quarter of the time.
template <class Law, std::size_t groups, bool damped, bool alike, bool tensionOnly, Keep keep>
ESM_INLINE std::size_t passGroups(const SpringBatch& batch, std::size_t begin, std::size_t end,
                                  const Lanes* x, const Lanes* v, Lanes* force, const KeptDamping& kept,
                                  Lanes& heat) noexcept
{
  constexpr std::size_t kFour = FourEnds::kCount;
  std::size_t i = begin;
  for (; i + groups * kFour <= end; i += groups * kFour) {
    const auto springs = [&](std::size_t g) { return SpringGroup<Law, damped, alike>(batch, i + g * kFour); };
    GroupInFlight group[groups];
    for (std::size_t g = 0; g < groups; ++g) foresee(springs(g).record, springs(g).kRows);
    for (std::size_t g = 0; g < groups; ++g) readGroup(springs(g), x, v, group[g]);
    stretchGroups<tensionOnly, keep, groups, Law>(springs, group, kept, heat);
    for (std::size_t g = 0; g < groups; ++g) springs(g).endsAgain().pullAlong(force, group[g]);
  }
  return i;
}

/// As many groups at a time as is best, and what is left one by one.
template <class Law, bool damped, bool alike, bool tensionOnly, Keep keep>
ESM_INLINE double springPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                             const KeptDamping& kept) noexcept
{
  const std::size_t count = batch.paddedCount();
  Lanes heat = {0, 0, 0, 0};
  const std::size_t done = passGroups<Law, kGroupsAtOnce, damped, alike, tensionOnly, keep>(
    batch, 0, count, x, v, force, kept, heat);
  passGroups<Law, 1, damped, alike, tensionOnly, keep>(batch, done, count, x, v, force, kept, heat);
  return sumLanes(heat);
}

/// Chooses among the kinds of batch, once per batch.
template <class Law, bool damped, bool alike, Keep keep>
ESM_INLINE double springPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                             const KeptDamping& kept) noexcept
{
  return batch.tensionOnly ? springPass<Law, damped, alike, true, keep>(batch, x, v, force, kept)
                           : springPass<Law, damped, alike, false, keep>(batch, x, v, force, kept);
}

template <class Law, bool damped, bool alike>
ESM_INLINE double springPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                             const KeptDamping& kept) noexcept
{
  if constexpr (damped) {
    if (kept.damper != nullptr && kept.late.time != 0.0)
      return springPass<Law, true, alike, Keep::DampingOfLate>(batch, x, v, force, kept);
    if (kept.damper != nullptr) return springPass<Law, true, alike, Keep::Damping>(batch, x, v, force, kept);
  }
  return springPass<Law, damped, alike, Keep::Nothing>(batch, x, v, force, kept);
}

template <class Law>
ESM_INLINE double springPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                             const KeptDamping& kept) noexcept
{
  if constexpr (canBeAlike(Law::kLaw))
    if (batch.alike)
      return batch.damped ? springPass<Law, true, true>(batch, x, v, force, kept)
                          : springPass<Law, false, true>(batch, x, v, force, kept);
  return batch.damped ? springPass<Law, true, false>(batch, x, v, force, kept)
                      : springPass<Law, false, false>(batch, x, v, force, kept);
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
    const SpringGroup<Law, damped, alike> springs(batch, i);
    GroupInFlight group;
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
    const SpringGroup<Law, damped, alike> springs(batch, i);
    GroupInFlight group;
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

/// SpringLawKernel::tangents(). `Law::tangent(group, e, f, slope)` gives f(e) and df/de of a SpringGroup.
template <class Law, bool damped, bool alike>
ESM_INLINE void tangentPass(const SpringBatch& batch, const Lanes* x, const Lanes* v,
                            const TangentShares& shares, Lanes* rows) noexcept
{
  const Lanes zero = {0, 0, 0, 0};
  for (std::size_t i = 0; i < batch.paddedCount(); i += FourEnds::kCount, rows += kTangentRows) {
    const SpringGroup<Law, damped, alike> springs(batch, i);
    GroupInFlight group;
    Stretch stretch;
    readGroup(springs, x, v, group);
    measureGroup(springs, group, stretch);
    Lanes tension, axial, drag = zero;
    Law::tangent(springs, stretch.extension, tension, axial);
    axial = axial > zero ? axial * shares.stiffness : zero;
    Lanes lateral = tension * stretch.inverse;
    if constexpr (damped) {
      springs.viscosity(drag);
      lateral += drag * group.slip * stretch.inverseSquare;
    }
    lateral = lateral > zero ? lateral * shares.stiffness : zero;
    axial += drag * shares.viscosity;
    LaneBits isSlack = stretch.inverse == zero;
    if (batch.tensionOnly) isSlack |= stretch.extension <= zero;
    rows[0] = group.dx * stretch.inverse;
    rows[1] = group.dy * stretch.inverse;
    rows[2] = group.dz * stretch.inverse;
    rows[3] = isSlack ? zero : axial - lateral;
    rows[4] = isSlack ? zero : lateral;
  }
}

template <class Law>
ESM_INLINE void tangentPass(const SpringBatch& batch, const Lanes* x, const Lanes* v,
                            const TangentShares& shares, Lanes* rows) noexcept
{
  if constexpr (canBeAlike(Law::kLaw))
    if (batch.alike)
      return batch.damped ? tangentPass<Law, true, true>(batch, x, v, shares, rows)
                          : tangentPass<Law, false, true>(batch, x, v, shares, rows);
  return batch.damped ? tangentPass<Law, true, false>(batch, x, v, shares, rows)
                      : tangentPass<Law, false, false>(batch, x, v, shares, rows);
}

} // namespace esm::detail
