// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_pass.h"

namespace esm {

ESM_CPU_CLONES void addDamping(const SpringBatch& batch, const Lanes* damper, const Lanes* v,
                               Lanes* force) noexcept
{
  if (!batch.damped) return;
  const std::size_t count = batch.paddedCount();
  for (std::size_t i = 0; i < count; i += 4, damper += 3) {
    const detail::FourEnds ends(batch, i);
    Lanes w0, w1, w2, w3, wx, wy, wz, f0, f1, f2, f3;
    ends.difference(v, w0, w1, w2, w3);
    transpose(w0, w1, w2, w3, wx, wy, wz);
    const Lanes drag = wx * damper[0] + wy * damper[1] + wz * damper[2];
    detail::transposeBack(damper[0] * drag, damper[1] * drag, damper[2] * drag, f0, f1, f2, f3);
    ends.pull(force, f0, f1, f2, f3);
  }
}

} // namespace esm
