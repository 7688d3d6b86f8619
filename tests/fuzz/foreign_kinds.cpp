// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/foreign_kinds.h"

#include <cstddef>
#include <cstdint>

/// Whatever the bytes are, there is something to say.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const char* ending : {"", "sldprt"})
    if (esm::describeForeign(bytes, ending).rfind("this is ", 0) != 0) __builtin_trap();
  return 0;
}
