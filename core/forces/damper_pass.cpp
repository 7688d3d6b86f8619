// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_ends.h"

namespace esm {
namespace {

template <class Ends>
ESM_INLINE void dampGroups(const SpringBatch& batch, std::size_t begin, std::size_t end, const Lanes* damper,
                           const Lanes* v, Lanes* force) noexcept
{
  for (std::size_t i = begin; i < end; i += Ends::kCount) {
    const Lanes* const kept = damper + i / 4 * 3;
    detail::foresee(kept, Ends::kCount / 4 * 3);
    const Ends ends(&batch.ends[i / 4], 1);
    typename Ends::Values w0, w1, w2, w3, wx, wy, wz, qx, qy, qz, f0, f1, f2, f3;
    ends.difference(v, w0, w1, w2, w3);
    transpose(w0, w1, w2, w3, wx, wy, wz);
    Ends::load(kept, qx, qy, qz);
    const auto drag = wx * qx + wy * qy + wz * qz;
    detail::transposeBack(qx * drag, qy * drag, qz * drag, f0, f1, f2, f3);
    ends.pull(force, f0, f1, f2, f3);
  }
}

template <class Widest>
ESM_INLINE void dampAll(const SpringBatch& batch, const Lanes* damper, const Lanes* v, Lanes* force) noexcept
{
  if (!batch.damped) return;
  const std::size_t whole = batch.paddedCount() / Widest::kCount * Widest::kCount;
  dampGroups<Widest>(batch, 0, whole, damper, v, force);
  dampGroups<detail::FourEnds>(batch, whole, batch.paddedCount(), damper, v, force);
}

ESM_WIDE_CLONES(void addDampingHere(const SpringBatch& batch, const Lanes* damper, const Lanes* v,
                                    Lanes* force) noexcept,
                dampAll<detail::EndsOf<kLanes>>(batch, damper, v, force))

} // namespace

void addDamping(const SpringBatch& batch, const Lanes* damper, const Lanes* v, Lanes* force) noexcept
{
  addDampingHere(batch, damper, v, force);
}

} // namespace esm
