// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/version.h"

#include "core/base/eigen_memory.h"

#define ESM_TEXT_OF(number) #number
#define ESM_TEXT(number) ESM_TEXT_OF(number)

namespace esm {

const char* version() noexcept
{
  return ESM_TEXT(ESM_VERSION_MAJOR) "." ESM_TEXT(ESM_VERSION_MINOR) "." ESM_TEXT(ESM_VERSION_PATCH);
}

template <>
const bool detail::EigenMemory<EIGEN_DEFAULT_ALIGN_BYTES, EIGEN_MALLOC_ALREADY_ALIGNED>::isThatOfTheLibrary =
  true;

} // namespace esm
