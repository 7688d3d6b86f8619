// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace esm {

/// The eight bytes that open a control transfer.
struct UsbSetup {
  std::uint8_t requestType = 0, request = 0;
  std::uint16_t value = 0, index = 0, length = 0;

  bool toHost() const noexcept { return (requestType & 0x80) != 0; }
  bool operator==(const UsbSetup&) const = default;
};

} // namespace esm
