// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/version.h"

#include <Eigen/Core>

namespace esm::detail {

/// Eigen takes and frees memory in another way where a file is compiled for AVX, or with AddressSanitizer: a matrix
/// that goes from such a file to another kind of file, or back, ends the program. So the library defines this for
/// its own way alone, and a file of another way does not link (docs/EMBEDDING.md has the ways out).
template <int alignment, int isThatOfMalloc>
struct EigenMemory {
  static const bool isThatOfTheLibrary;
};

template <>
const bool EigenMemory<EIGEN_DEFAULT_ALIGN_BYTES, EIGEN_MALLOC_ALREADY_ALIGNED>::isThatOfTheLibrary;

[[gnu::used]] static const bool* const eigenMemory =
  &EigenMemory<EIGEN_DEFAULT_ALIGN_BYTES, EIGEN_MALLOC_ALREADY_ALIGNED>::isThatOfTheLibrary;

} // namespace esm::detail
