// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/emulator/usb_device_model.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace esm {

namespace {

constexpr std::uint8_t kGetStatus = 0, kClearFeature = 1, kGetDescriptor = 6, kGetConfiguration = 8,
                       kSetConfiguration = 9, kGetInterface = 10, kSetInterface = 11;
constexpr std::uint8_t kDeviceType = 1, kConfigurationType = 2, kStringType = 3, kHidReportType = 0x22;

std::uint8_t low(std::size_t value) noexcept
{
  return static_cast<std::uint8_t>(value);
}
std::uint8_t high(std::size_t value) noexcept
{
  return static_cast<std::uint8_t>(value >> 8);
}

std::vector<std::uint8_t> describeDevice(const UsbDeviceModel::Identity& id)
{
  return {18,
          kDeviceType,
          0x00,
          0x02,
          0,
          0,
          0,
          64,
          low(id.vendor),
          high(id.vendor),
          low(id.product),
          high(id.product),
          0x00,
          0x01,
          0,
          0,
          0,
          1};
}

std::vector<std::uint8_t> describeConfiguration(const UsbDeviceModel::Identity& id)
{
  const bool hid = !id.hidDescriptor.empty();
  const std::uint8_t endpoints = id.noOutEndpoint ? 1 : 2;
  std::vector<std::uint8_t> all;
  const auto add = [&all](std::initializer_list<std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) all.push_back(byte);
  };
  add({9, kConfigurationType, 0, 0, 1, 1, 0, 0x80, 50});
  const std::uint8_t kind = hid ? 3 : 0xff;
  add({9, 4, 0, 0, endpoints, kind, 0, 0, 0});
  if (hid)
    add({9, 0x21, 0x11, 0x01, 0, 1, kHidReportType, low(id.hidDescriptor.size()),
         high(id.hidDescriptor.size())});
  const std::uint8_t attributes = id.interrupt ? 3 : 2, interval = id.interrupt ? 1 : 0;
  add({7, 5, id.endpointIn, attributes, 64, 0, interval});
  if (!id.noOutEndpoint) add({7, 5, id.endpointOut, attributes, 64, 0, interval});
  all[2] = low(all.size());
  all[3] = high(all.size());
  return all;
}

int answer(std::span<const std::uint8_t> bytes, std::span<std::uint8_t> room)
{
  const std::size_t count = std::min(bytes.size(), room.size());
  std::copy_n(bytes.begin(), count, room.begin());
  return static_cast<int>(count);
}

} // namespace

UsbDeviceModel::UsbDeviceModel(Identity identity)
  : m_identity(std::move(identity)),
    m_device(describeDevice(m_identity)),
    m_configuration(describeConfiguration(m_identity))
{}

int UsbDeviceModel::control(const UsbSetup& setup, std::span<std::uint8_t> data)
{
  data = data.first(std::min<std::size_t>(data.size(), setup.length));
  const bool standard = (setup.requestType & 0x60) == 0;
  if (!standard) return ownControl(setup, data);
  switch (setup.request) {
  case kGetDescriptor:
    switch (setup.value >> 8) {
    case kDeviceType:
      return answer(m_device, data);
    case kConfigurationType:
      return answer(m_configuration, data);
    case kHidReportType:
      return m_identity.hidDescriptor.empty() ? kStall : answer(m_identity.hidDescriptor, data);
    case kStringType: // none but the list of languages
      return setup.value == 0x0300 ? answer(std::vector<std::uint8_t>{4, kStringType, 9, 4}, data) : kStall;
    default:
      return kStall;
    }
  case kGetStatus:
    return answer(std::vector<std::uint8_t>{0, 0}, data);
  case kGetConfiguration:
    return answer(std::vector<std::uint8_t>{1}, data);
  case kGetInterface:
    return answer(std::vector<std::uint8_t>{0}, data);
  case kClearFeature:
  case kSetConfiguration:
  case kSetInterface:
    return 0;
  default:
    return kStall;
  }
}

} // namespace esm
