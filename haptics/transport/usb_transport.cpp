// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/transport/usb_transport.h"

#include <cstddef>
#include <cstdio>

namespace esm {

bool mentionsForceFeedback(std::span<const std::uint8_t> hidDescriptor) noexcept
{
  for (std::size_t at = 0; at < hidDescriptor.size();) {
    const std::uint8_t prefix = hidDescriptor[at];
    if (prefix == 0x05 && at + 1 < hidDescriptor.size() && hidDescriptor[at + 1] == 0x0f) return true;
    at += 1u + ((prefix & 3) == 3 ? 4u : prefix & 3u);
  }
  return false;
}

std::string udevRule(std::uint16_t vendor, std::uint16_t product)
{
  char line[120];
  std::snprintf(line, sizeof line,
                R"(SUBSYSTEM=="usb", ATTR{idVendor}=="%04x", ATTR{idProduct}=="%04x", TAG+="uaccess")",
                unsigned{vendor}, unsigned{product});
  return line;
}

} // namespace esm
