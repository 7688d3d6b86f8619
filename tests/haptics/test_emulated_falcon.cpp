// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/emulator/emulated_falcon.h"

#include "core/base/file_io.h"
#include "haptics/haptic_session.h"
#include "haptics/placed_device.h"
#include "haptics/simulated_device.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <thread>

namespace esm {

namespace {

/// On the wall clock: driver and servo have threads of their own. Only what comes to pass is asserted.
class EmulatedFalconTest : public testing::Test {
protected:
  void SetUp() override
  {
    ASSERT_TRUE(writeFileAtomically(image, std::string(500, 'f')));
    options.firmware = image;
  }
  ~EmulatedFalconTest() override { std::filesystem::remove(image); }

  std::unique_ptr<HapticSession> connect()
  {
    auto device = falcon.open(options);
    EXPECT_TRUE(device) << device.error().detail;
    auto session = HapticSession::start(std::move(*device), tool, contact);
    EXPECT_TRUE(session);
    return std::move(*session);
  }
  static bool comes(const std::function<bool()>& condition)
  {
    for (int i = 0; i < 3000; ++i) {
      if (condition()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  std::filesystem::path image =
    std::filesystem::temp_directory_path() /
    (std::string("esm_falcon_") + testing::UnitTest::GetInstance()->current_test_info()->name() + ".bin");
  DeviceOptions options;
  TripleBuffer<ToolState> tool;
  TripleBuffer<ContactModel> contact;
  EmulatedFalcon falcon;
};

/// One tick after the other at a fixed place.
struct StillDevice final : HapticDevice {
  const DeviceProfile& profile() const noexcept override { return own; }
  DeviceLink read(double, DeviceSample& sample) noexcept override
  {
    if (link == DeviceLink::Ready) sample.position = at;
    return link;
  }
  bool write(const Eigen::Vector3d&) noexcept override { return true; }
  DeviceProfile own;
  DeviceLink link = DeviceLink::Ready;
  Eigen::Vector3d at{0.01, 0.0, 0.0};
};

} // namespace

// The whole way of a new owner: upload, home by hand, force allowed; then somebody pulls the cable.
TEST_F(EmulatedFalconTest, GoesFromFirmwareOverHomeToAPulledCable)
{
  auto session = connect();
  ASSERT_TRUE(comes([&] { return session->report().phase == DevicePhase::NeedsHome; }));
  EXPECT_EQ(session->report().unhomed, 7); // all three axes
  session->arm();
  EXPECT_FALSE(session->profile().name.empty());
  EXPECT_EQ(session->status().force.norm(), 0.0);
  falcon.pullOutAndIn();
  ASSERT_TRUE(comes([&] { return session->report().phase == DevicePhase::Running; }));
  EXPECT_EQ(session->report().unhomed, 0);
  falcon.setPlugged(false);
  ASSERT_TRUE(comes([&] { return session->status().state == DeviceState::Absent; }));
  EXPECT_EQ(session->report().phase, DevicePhase::Lost);
  EXPECT_NE(session->status().reason.find("unplugged"), std::string::npos);
}

TEST_F(EmulatedFalconTest, ListsWhatStandsInTheWay)
{
  const auto falconOf = [&] {
    for (const DeviceListing& listing : falcon.list(options))
      if (listing.name == "falcon") return listing;
    return DeviceListing{};
  };
  EXPECT_TRUE(falconOf().usable);
  EXPECT_NE(falconOf().details.find("SHA-256"), std::string::npos);
  const std::uint32_t before = falcon.changes();
  falcon.setPlugged(false);
  EXPECT_NE(falcon.changes(), before);
  EXPECT_EQ(falconOf().reason, "Not plugged in");
  falcon.setPlugged(true);
  falcon.setPermitted(false);
  EXPECT_FALSE(falconOf().usable);
  EXPECT_NE(falconOf().udevRule.find("0403"), std::string::npos);
  EXPECT_FALSE(falcon.open(options));
}

// Another place is a jump of the coordinates (another epoch), and a tick without reply leaves the position.
TEST(PlacedDevice, MovesTheWorkspaceAsAJump)
{
  auto own = std::make_unique<StillDevice>();
  StillDevice* still = own.get();
  PlacedDevice device(std::move(own));
  DeviceSample sample;
  ASSERT_EQ(device.read(0.0, sample), DeviceLink::Ready);
  EXPECT_EQ(sample.position, Eigen::Vector3d(0.01, 0.0, 0.0));
  const std::uint32_t epoch = sample.epoch;
  device.place({0.0, 0.02, 0.0});
  device.place({std::nan(""), 0.0, 0.0}); // no place
  device.read(0.001, sample);
  EXPECT_EQ(sample.position, Eigen::Vector3d(0.01, 0.02, 0.0));
  EXPECT_NE(sample.epoch, epoch);
  const std::uint32_t placed = sample.epoch;
  still->link = DeviceLink::NoReply;
  device.read(0.002, sample);
  EXPECT_EQ(sample.position, Eigen::Vector3d(0.01, 0.02, 0.0));
  EXPECT_EQ(sample.epoch, placed);
}

} // namespace esm
