// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/emulator/usbip_server.h"

#include "haptics/protocol/byte_order.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace esm {

namespace {

constexpr std::uint16_t kVersion = 0x0111;
constexpr std::uint16_t kListRequest = 0x8005, kListReply = 0x0005, kImportRequest = 0x8003,
                        kImportReply = 0x0003;
constexpr std::uint32_t kSubmit = 1, kUnlink = 2, kSubmitReply = 3, kUnlinkReply = 4;
constexpr std::size_t kRequestSize = 8, kBusIdSize = 32, kPathSize = 256, kHeaderSize = 48;
constexpr std::uint32_t kBus = 1, kNumber = 2, kFullSpeed = 2;
constexpr std::string_view kBusId = "1-1", kPath = "/sys/devices/esm/usb1/1-1";
constexpr std::int32_t kStalled = -32, kUnlinked = -104; ///< EPIPE, ECONNRESET as Linux numbers them
constexpr std::uint32_t kNoPackets = 0xffffffff;
constexpr std::size_t kMostOutput = 1 << 20; ///< a peer that sends and never reads

} // namespace

void UsbIpServer::put16(std::uint16_t value)
{
  m_out.resize(m_out.size() + 2);
  putBe16(&m_out[m_out.size() - 2], value);
}

void UsbIpServer::put32(std::uint32_t value)
{
  m_out.resize(m_out.size() + 4);
  putBe32(&m_out[m_out.size() - 4], value);
}

void UsbIpServer::putDevice(bool withInterfaces)
{
  const auto putText = [this](std::string_view text, std::size_t size) {
    m_out.insert(m_out.end(), text.begin(), text.end());
    m_out.resize(m_out.size() + size - text.size(), 0);
  };
  putText(kPath, kPathSize);
  putText(kBusId, kBusIdSize);
  put32(kBus);
  put32(kNumber);
  put32(kFullSpeed);
  put16(m_device.identity().vendor);
  put16(m_device.identity().product);
  put16(0x0100);
  const std::uint8_t kind = m_device.identity().hidDescriptor.empty() ? 0xff : 3;
  for (const int byte : {0, 0, 0, 1, 1, 1})
    m_out.push_back(static_cast<std::uint8_t>(byte)); // class, configuration, counts
  if (withInterfaces)
    for (const std::uint8_t byte : {kind, std::uint8_t{0}, std::uint8_t{0}, std::uint8_t{0}})
      m_out.push_back(byte);
}

bool UsbIpServer::receive(std::span<const std::uint8_t> bytes)
{
  m_in.insert(m_in.end(), bytes.begin(), bytes.end());
  std::size_t used = 0;
  for (;;) {
    const auto rest = std::span<const std::uint8_t>(m_in).subspan(used);
    const std::ptrdiff_t taken = m_imported ? takeCommand(rest) : takeRequest(rest);
    if (taken < 0 || m_out.size() > kMostOutput) return false;
    if (taken == 0) break;
    used += static_cast<std::size_t>(taken);
  }
  m_in.erase(m_in.begin(), m_in.begin() + static_cast<std::ptrdiff_t>(used));
  return true;
}

std::ptrdiff_t UsbIpServer::takeRequest(std::span<const std::uint8_t> bytes)
{
  if (bytes.size() < kRequestSize) return 0;
  const std::uint16_t code = getBe16(&bytes[2]);
  if (code == kListRequest) {
    put16(kVersion);
    put16(kListReply);
    put32(0);
    put32(1);
    putDevice(true);
    return kRequestSize;
  }
  if (code != kImportRequest) return -1;
  if (bytes.size() < kRequestSize + kBusIdSize) return 0;
  const auto asked = bytes.subspan(kRequestSize, kBusIdSize);
  const bool ours = std::equal(kBusId.begin(), kBusId.end(), asked.begin()) && asked[kBusId.size()] == 0;
  put16(kVersion);
  put16(kImportReply);
  put32(ours ? 0 : 1);
  if (ours) {
    putDevice(false);
    m_imported = true;
  }
  return kRequestSize + kBusIdSize;
}

std::ptrdiff_t UsbIpServer::takeCommand(std::span<const std::uint8_t> bytes)
{
  if (bytes.size() < kHeaderSize) return 0;
  const auto header = bytes.first(kHeaderSize);
  const std::uint32_t command = getBe32(&header[0]);
  if (command == kUnlink) {
    unlink(header);
    return kHeaderSize;
  }
  if (command != kSubmit) return -1;
  const std::uint32_t direction = getBe32(&header[12]), length = getBe32(&header[24]),
                      packets = getBe32(&header[32]);
  if (direction > 1 || length > kLongestTransfer || (packets != 0 && packets != kNoPackets)) return -1;
  const std::size_t whole = kHeaderSize + (direction == 0 ? length : 0);
  if (bytes.size() < whole) return 0;
  if (!submit(header, bytes.subspan(kHeaderSize, whole - kHeaderSize))) return -1;
  return static_cast<std::ptrdiff_t>(whole);
}

void UsbIpServer::reply(std::uint32_t command, std::uint32_t sequence, std::int32_t status,
                        std::size_t length)
{
  put32(command);
  put32(sequence);
  for (int i = 0; i < 3; ++i) put32(0); // device, direction, endpoint: of requests only
  put32(static_cast<std::uint32_t>(status));
  put32(static_cast<std::uint32_t>(length));
  put32(0); // start frame
  put32(command == kSubmitReply ? kNoPackets : 0);
  for (int i = 0; i < 3; ++i) put32(0); // errors, padding
}

bool UsbIpServer::submit(std::span<const std::uint8_t> header, std::span<const std::uint8_t> data)
{
  ++m_transfers;
  const std::uint32_t sequence = getBe32(&header[4]), direction = getBe32(&header[12]),
                      endpoint = getBe32(&header[16]);
  const std::size_t length = getBe32(&header[24]);
  if (endpoint == 0) {
    const std::uint8_t* s = &header[40];
    const UsbSetup setup{s[0], s[1], getLe16(s + 2), getLe16(s + 4), getLe16(s + 6)};
    if (setup.toHost() != (direction == 1)) {
      reply(kSubmitReply, sequence, kStalled, 0);
      return true;
    }
    std::vector<std::uint8_t> bytes(data.begin(), data.end());
    bytes.resize(length);
    const int moved = m_device.control(setup, bytes);
    const std::size_t count = moved < 0 ? 0 : static_cast<std::size_t>(moved);
    reply(kSubmitReply, sequence, moved < 0 ? kStalled : 0, setup.toHost() ? count : data.size());
    if (setup.toHost())
      m_out.insert(m_out.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
    return true;
  }
  const UsbDeviceModel::Identity& id = m_device.identity();
  if (direction == 1 && endpoint == (id.endpointIn & 0xfu)) {
    if (m_reads.size() == kMostWaiting) return false;
    m_reads.push_back({sequence, length});
    serveReads();
  } else if (direction == 0 && !id.noOutEndpoint && endpoint == id.endpointOut) {
    const bool taken = m_device.out(data);
    reply(kSubmitReply, sequence, taken ? 0 : kStalled, taken ? data.size() : 0);
    serveReads();
  } else {
    reply(kSubmitReply, sequence, kStalled, 0);
  }
  return true;
}

void UsbIpServer::unlink(std::span<const std::uint8_t> header)
{
  const std::uint32_t wanted = getBe32(&header[20]);
  const auto found = std::find_if(m_reads.begin(), m_reads.end(),
                                  [wanted](const Read& read) { return read.sequence == wanted; });
  const bool waiting = found != m_reads.end();
  if (waiting) m_reads.erase(found);
  reply(kUnlinkReply, getBe32(&header[4]), waiting ? kUnlinked : 0, 0);
}

void UsbIpServer::serveReads()
{
  std::array<std::uint8_t, 512> bytes{};
  while (!m_reads.empty()) {
    const Read read = m_reads.front();
    const int moved = m_device.in(std::span(bytes).first(std::min(bytes.size(), read.size)));
    if (moved == UsbDeviceModel::kNothingYet) return;
    m_reads.pop_front();
    const std::size_t count = moved < 0 ? 0 : static_cast<std::size_t>(moved);
    reply(kSubmitReply, read.sequence, moved < 0 ? kStalled : 0, count);
    m_out.insert(m_out.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
  }
}

void UsbIpServer::advance(double now)
{
  m_device.advance(now);
  serveReads();
}

} // namespace esm
