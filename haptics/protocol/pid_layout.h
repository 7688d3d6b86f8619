// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/protocol/hid_report_descriptor.h"

#include <array>
#include <cstdint>
#include <span>

/// USB Physical Interface Devices: force feedback over HID (usage page 0x0F), as sticks and wheels speak it.
namespace esm::pid {

constexpr hid::Usage usage(std::uint32_t id) noexcept
{
  return 0x0f0000u | id;
}

/// A value that names one of several things (effect type, operation, status): what number stands for which.
struct Choice {
  static constexpr std::size_t kMost = 32;
  hid::Slot slot;
  std::array<hid::Usage, kMost> usages{};
  std::size_t count = 0;
  bool bits = false; ///< each usage is a bit of its own instead of a number
  std::array<hid::Slot, kMost> bitSlots{};

  bool has(hid::Usage usage) const noexcept;
  /// @param fromOne numbers start at one although the descriptor says zero (some devices).
  bool put(std::span<std::uint8_t> report, hid::Usage usage, bool fromOne = false) const noexcept;
  hid::Usage get(std::span<const std::uint8_t> report) const noexcept; ///< 0: none
};

/// Where a device keeps what a constant force needs, found by usages: report ids differ from maker to maker.
struct Layout {
  struct SetEffect {
    hid::Slot block, duration, samplePeriod, gain, triggerButton, triggerRepeat, startDelay, directionEnable;
    Choice type;
    std::array<hid::Slot, 2> axisEnable, direction;
  } effect;
  struct Constant {
    hid::Slot block, magnitude;
  } constant;
  struct Operation {
    hid::Slot block, loops;
    Choice what;
  } operation;
  hid::Slot blockFree, deviceGain;
  Choice control;
  struct Create {
    hid::Slot bytes;
    Choice type;
  } create;
  struct BlockLoad {
    hid::Slot block;
    Choice status;
  } blockLoad;
  std::array<hid::Slot, 2> axes; ///< of the input report: X or the wheel, Y
  std::array<hid::Slot, 16> buttons;
  bool numbered = false;

  /// Sizes with the id byte.
  std::size_t effectBytes = 0, constantBytes = 0, operationBytes = 0, blockFreeBytes = 0, deviceGainBytes = 0,
              controlBytes = 0, createBytes = 0, blockLoadBytes = 0;

  /// @return null, or what the device lacks for a constant force (a static text).
  const char* find(const hid::ReportDescriptor& descriptor) noexcept;
};

} // namespace esm::pid
