// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_pass.h"

namespace esm {

ESM_CPU_CLONES void addDamping(const SpringBatch& batch, const Lanes* damper, const Lanes* v,
                               Lanes* force) noexcept
{
  if (!batch.damped) return;
  const Index* endA = batch.a.data();
  const Index* endB = batch.b.data();
  const std::size_t count = batch.paddedCount();
  for (std::size_t i = 0; i < count; i += 4, damper += 3) {
    const Index a0 = endA[i], a1 = endA[i + 1], a2 = endA[i + 2], a3 = endA[i + 3];
    const Index b0 = endB[i], b1 = endB[i + 1], b2 = endB[i + 2], b3 = endB[i + 3];
    const Lanes w0 = v[b0] - v[a0], w1 = v[b1] - v[a1], w2 = v[b2] - v[a2], w3 = v[b3] - v[a3];
    Lanes wx, wy, wz, f0, f1, f2, f3;
    detail::transpose(w0, w1, w2, w3, wx, wy, wz);
    const Lanes drag = wx * damper[0] + wy * damper[1] + wz * damper[2];
    detail::transposeBack(damper[0] * drag, damper[1] * drag, damper[2] * drag, f0, f1, f2, f3);
    force[a0] += f0;
    force[b0] -= f0;
    force[a1] += f1;
    force[b1] -= f1;
    force[a2] += f2;
    force[b2] -= f2;
    force[a3] += f3;
    force[b3] -= f3;
  }
}

} // namespace esm
