// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/emulator/falcon_model.h"
#include "haptics/emulator/pid_model.h"
#include "haptics/emulator/usbip_server.h"
#include "haptics/protocol/byte_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace esm {
namespace {

using Bytes = std::vector<std::uint8_t>;

void put32(Bytes& bytes, std::initializer_list<std::uint32_t> words)
{
  for (const std::uint32_t word : words) {
    bytes.resize(bytes.size() + 4);
    putBe32(&bytes[bytes.size() - 4], word);
  }
}

Bytes submit(std::uint32_t sequence, std::uint32_t direction, std::uint32_t endpoint, std::uint32_t length,
             std::array<std::uint8_t, 8> setup = {}, const Bytes& data = {})
{
  Bytes bytes;
  put32(bytes, {1, sequence, 0x10002, direction, endpoint, 0, length, 0, 0xffffffff, 0});
  bytes.insert(bytes.end(), setup.begin(), setup.end());
  bytes.insert(bytes.end(), data.begin(), data.end());
  return bytes;
}

Bytes unlink(std::uint32_t sequence, std::uint32_t wanted)
{
  Bytes bytes;
  put32(bytes, {2, sequence, 0x10002, 0, 0, wanted, 0, 0, 0, 0, 0, 0});
  return bytes;
}

/// Word of a 48-byte header.
std::uint32_t word(const Bytes& bytes, std::size_t index)
{
  return getBe32(&bytes.at(4 * index));
}

TEST(UsbIpServer, ListsAndImportsItsOneDevice)
{
  FalconModel model({});
  UsbIpServer server(model, false);
  ASSERT_TRUE(server.receive(Bytes{0x01, 0x11, 0x80, 0x05, 0, 0, 0, 0}));
  EXPECT_EQ(server.output().size(), 12u + 312u + 4u);
  EXPECT_EQ(getBe16(&server.output()[12 + 256 + 32 + 12]), 0x0403);
  server.output().clear();
  for (const char* bus : {"9-9", "1-1"}) {
    Bytes import{0x01, 0x11, 0x80, 0x03, 0, 0, 0, 0};
    const std::string_view name = bus;
    import.insert(import.end(), name.begin(), name.end());
    import.resize(8 + 32, 0);
    server.output().clear();
    for (const std::uint8_t byte : import) ASSERT_TRUE(server.receive({&byte, 1})); // in whatever pieces
    EXPECT_EQ(server.imported(), name == "1-1");
    EXPECT_EQ(server.output().size(), name == "1-1" ? 8u + 312u : 8u);
  }
}

TEST(UsbIpServer, AnswersDescriptorsAndStallsOnTheUnknown)
{
  PidModel model({});
  UsbIpServer server(model, true);
  ASSERT_TRUE(server.receive(submit(7, 1, 0, 18, {0x80, 6, 0, 1, 0, 0, 18, 0})));
  ASSERT_EQ(server.output().size(), 48u + 18u);
  EXPECT_EQ(word(server.output(), 0), 3u);
  EXPECT_EQ(word(server.output(), 1), 7u);
  EXPECT_EQ(word(server.output(), 5), 0u);
  EXPECT_EQ(word(server.output(), 6), 18u);
  EXPECT_EQ(server.output()[48], 18);
  server.output().clear();
  ASSERT_TRUE(server.receive(submit(8, 1, 0, 4, {0x80, 6, 0, 9, 0, 0, 4, 0})));
  EXPECT_EQ(static_cast<std::int32_t>(word(server.output(), 5)), -32);
}

// A host may ask for the first bytes of a report only: it gets those, and nothing is written behind them.
TEST(UsbIpServer, ShortRequestsGetTheStartOfAReport)
{
  constexpr std::uint8_t kUntouched = 0xa5;
  int reports = 0;
  for (int id = 0; id < 256; ++id) {
    const auto answer = [&](std::uint16_t length, std::array<std::uint8_t, 64>& bytes) {
      PidModel model({});
      bytes.fill(kUntouched);
      return model.control({0xa1, 1, static_cast<std::uint16_t>(0x300 | id), 0, length},
                           std::span(bytes).first(length));
    };
    std::array<std::uint8_t, 64> whole{}, part{};
    const int size = answer(64, whole);
    if (size < 0) continue;
    ++reports;
    EXPECT_EQ(answer(0, part), UsbDeviceModel::kStall);
    for (int length = 1; length < size; ++length) {
      EXPECT_EQ(answer(static_cast<std::uint16_t>(length), part), length) << "report " << id;
      EXPECT_TRUE(std::equal(part.begin(), part.begin() + length, whole.begin())) << "report " << id;
      EXPECT_EQ(std::count(part.begin() + length, part.end(), kUntouched), 64 - length) << "report " << id;
    }
  }
  EXPECT_GE(reports, 2); // block load and pool
}

// A read without an answer yet waits, in order; unlinked it is never answered, and the reply says so.
TEST(UsbIpServer, ReadsWaitUntilThereIsSomethingOrTheyAreUnlinked)
{
  FalconModel::Settings settings;
  settings.running = settings.homed = true;
  FalconModel model(settings);
  UsbIpServer server(model, true);
  server.advance(0.0);
  ASSERT_TRUE(server.receive(submit(1, 0, 0, 0, {0x40, 3, 2, 0, 0, 0, 0, 0}))); // 1.5 Mbaud
  server.output().clear();
  ASSERT_TRUE(server.receive(submit(2, 1, 1, 64)));
  ASSERT_TRUE(server.receive(submit(3, 1, 1, 64)));
  EXPECT_TRUE(server.output().empty());
  ASSERT_TRUE(server.receive(unlink(4, 2)));
  ASSERT_EQ(server.output().size(), 48u);
  EXPECT_EQ(word(server.output(), 0), 4u);
  EXPECT_EQ(static_cast<std::int32_t>(word(server.output(), 5)), -104);
  server.output().clear();
  const falcon::Packet packet = falcon::encode(falcon::Command{});
  ASSERT_TRUE(server.receive(submit(5, 0, 2, 16, {}, Bytes(packet.begin(), packet.end()))));
  ASSERT_EQ(server.output().size(), 48u + 48u + 18u);
  EXPECT_EQ(word(server.output(), 1), 5u);
  EXPECT_EQ(word(server.output(), 12 + 1), 3u); // the read that was left
  EXPECT_EQ(model.commands(), 1u);
}

TEST(UsbIpServer, ClosesOnNonsense)
{
  FalconModel model({});
  EXPECT_FALSE(UsbIpServer(model, false).receive(Bytes{'G', 'E', 'T', ' ', '/', ' ', 'H', 'T'}));
  EXPECT_FALSE(UsbIpServer(model, true).receive(Bytes(48, 0xff)));
  EXPECT_FALSE(UsbIpServer(model, true).receive(submit(1, 0, 2, 0x7fffffff))); // two gigabytes to come
  UsbIpServer greedy(model, true);
  bool open = true;
  for (std::uint32_t i = 0; open && i < 100; ++i) open = greedy.receive(submit(i, 1, 1, 64));
  EXPECT_FALSE(open); // more reads than any kernel leaves waiting
}

} // namespace
} // namespace esm
