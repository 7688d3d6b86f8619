// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/spring_law.h"

namespace esm {

/// Some springs of a net by themselves, to ask for their energy and tensions without a pass over all.
class FewSprings {
public:
  FewSprings(const SpringNet& net, std::span<const Index> springs);

  double energy(const Lanes* x) const noexcept; ///< [J]
  /// Elastic + viscous [N], each at its spring's place in `tension`, which has room for all of the net.
  void tensions(const Lanes* x, const Lanes* v, double* tension) const noexcept;

private:
  std::vector<SpringBatch> m_batches;
};

} // namespace esm
