// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/stl_reader.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::string format;
  std::vector<std::string> notes;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto mesh = esm::stlReader().read(bytes, "fuzz.stl", format, notes, nullptr);
  if (!mesh && mesh.error().detail.empty()) __builtin_trap(); // a refusal must say why
  return 0;
}
