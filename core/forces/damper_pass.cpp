// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_ends.h"

namespace esm {

ESM_CPU_CLONES void addDamping(const SpringBatch& batch, const Lanes* damper, const Lanes* v,
                               Lanes* force) noexcept
{
  if (!batch.damped) return;
  for (std::size_t i = 0; i < batch.paddedCount(); i += detail::FourEnds::kCount) {
    const Lanes* const kept = damper + i / 4 * 3;
    detail::foresee(kept, 3);
    const detail::FourEnds ends(&batch.ends[i / 4]);
    Lanes w0, w1, w2, w3, wx, wy, wz, f0, f1, f2, f3;
    ends.difference(v, w0, w1, w2, w3);
    transpose(w0, w1, w2, w3, wx, wy, wz);
    const Lanes qx = kept[0], qy = kept[1], qz = kept[2];
    const Lanes drag = wx * qx + wy * qy + wz * qz;
    detail::transposeBack(qx * drag, qy * drag, qz * drag, f0, f1, f2, f3);
    ends.pull(force, f0, f1, f2, f3);
  }
}

} // namespace esm
