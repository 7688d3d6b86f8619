// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/version.h"

#define ESM_TEXT_OF(number) #number
#define ESM_TEXT(number) ESM_TEXT_OF(number)

namespace esm {

const char* version() noexcept
{
  return ESM_TEXT(ESM_VERSION_MAJOR) "." ESM_TEXT(ESM_VERSION_MINOR) "." ESM_TEXT(ESM_VERSION_PATCH);
}

} // namespace esm
