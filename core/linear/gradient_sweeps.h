// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/linear/block_cholesky.h"

#include <cstddef>

namespace esm {

// What all conjugate gradients over nodes do between two products with their matrix.

ESM_INLINE Lanes times(const NodeBlock& block, const Lanes& value) noexcept
{
  return block.column[0] * value[0] + block.column[1] * value[1] + block.column[2] * value[2];
}

/// product += diagonal p. @return p.product
double addDiagonal(std::size_t count, const double* diagonal, const Lanes* p, Lanes* product) noexcept;

/// x += step p, r -= step product, z = inverse r. @return r.z
double takeStep(std::size_t count, double step, const Lanes* p, const Lanes* product,
                const NodeBlock* inverse, Lanes* x, Lanes* r, Lanes* z) noexcept;

} // namespace esm
