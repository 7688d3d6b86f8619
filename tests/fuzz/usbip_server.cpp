// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/emulator/usbip_server.h"
#include "haptics/emulator/falcon_model.h"
#include "haptics/emulator/pid_model.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>

/// The other end of a connection may send anything, in any pieces. The first byte says which device, and
/// whether the import has happened; the rest is the stream.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace esm;
  if (size < 1) return 0;
  std::unique_ptr<UsbDeviceModel> device;
  if (data[0] & 1)
    device = std::make_unique<PidModel>(PidModel::Settings{});
  else
    device = std::make_unique<FalconModel>(FalconModel::Settings{});
  UsbIpServer server(*device, (data[0] & 2) != 0);
  const std::size_t piece = 1 + (data[0] >> 2);
  double now = 0.0;
  for (std::size_t at = 1; at < size; at += piece) {
    if (!server.receive({data + at, std::min(piece, size - at)})) break;
    server.advance(now += 0.001);
    server.output().clear();
  }
  return 0;
}
