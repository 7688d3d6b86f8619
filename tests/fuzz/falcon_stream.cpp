// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/protocol/falcon_packet.h"

#include <cstddef>
#include <cstdint>

/// Whatever comes, what the parser passes is a packet as the device could have sent it, and the next good one
/// gets through.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace esm::falcon;
  StreamParser parser;
  for (std::size_t i = 0; i < size; ++i) {
    if (!parser.push(data[i])) continue;
    const Packet again = encode(parser.reply());
    for (std::size_t k = 0; k < kPacketSize; ++k)
      if (k != 14 && again[k] != parser.packet()[k]) __builtin_trap();
  }
  const Packet good = encode(Reply{{1, -2, 3}, kHomedAll, kCentre});
  bool complete = false;
  for (const std::uint8_t byte : good) complete = parser.push(byte);
  if (!complete || parser.reply().encoder[1] != -2) __builtin_trap();
  return 0;
}
