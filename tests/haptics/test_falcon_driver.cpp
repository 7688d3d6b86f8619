// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/device/falcon_driver.h"
#include "haptics/emulator/falcon_model.h"
#include "tests/haptics/driver_bench.h"

#include "tests/support/allocation_counter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include <unistd.h>

namespace esm {
namespace {

class FalconDriverTest : public ::testing::Test {
protected:
  void SetUp() override
  {
    m_image =
      std::filesystem::temp_directory_path() / ("esm-falcon-image-" + std::to_string(::getpid()) + ".bin");
    std::ofstream(m_image, std::ios::binary) << std::string(3000, 'x');
    options.firmware = m_image;
  }
  void TearDown() override { std::filesystem::remove(m_image); }

  static std::shared_ptr<FalconModel> running(std::unique_ptr<Hand> hand = nullptr)
  {
    FalconModel::Settings settings;
    settings.running = settings.homed = true;
    settings.mechanics.coulomb = 0.0;
    return std::make_shared<FalconModel>(settings, std::move(hand));
  }

  DeviceOptions options;
  std::filesystem::path m_image;
};

using FalconBench = DriverBench<FalconModel>;

// From switch-on to work: upload, the user's homing, no force before it is done.
TEST_F(FalconDriverTest, UploadsThenWaitsForHomeThenWorks)
{
  double start = 1e9;
  FalconModel::Settings settings;
  auto hand = handAlong([&start](double t) -> Eigen::Vector3d {
    const double s = t - start;
    if (s < 0.0) return Eigen::Vector3d::Zero();
    return {0.0, 0.0, s < 0.5 ? 0.045 : s < 1.0 ? -0.04 : 0.0};
  });
  FalconBench bench("falcon", std::make_shared<FalconModel>(settings, std::move(hand)), options);
  bench.tick(10);
  EXPECT_EQ(bench.phase(), DevicePhase::Opening);
  EXPECT_LT(bench.tickUntil([&] { return bench.phase() == DevicePhase::Upload; }, 2000), 2000);
  EXPECT_LT(bench.tickUntil([&] { return bench.phase() == DevicePhase::NeedsHome; }, 10000), 10000);
  EXPECT_TRUE(bench.model->running());
  bench.order(ForceOrder::Arm);
  bench.tick(200);
  EXPECT_EQ(bench.phase(), DevicePhase::NeedsHome);
  EXPECT_TRUE(bench.model->lastCommand().homing); // or it would forget
  EXPECT_TRUE(bench.model->force().isZero(0.0));
  start = bench.now();
  const auto forceBefore = bench.model->zerosInRow();
  EXPECT_LT(bench.tickUntil([&] { return bench.phase() == DevicePhase::Running; }, 3000), 3000);
  EXPECT_GE(bench.model->zerosInRow(), forceBefore + 100); // 100 ms after the jump at the least
  bench.tick(1500);
  EXPECT_NEAR(bench.status().position.z(), bench.model->grip().position().z(), 1e-3);
  EXPECT_EQ(bench.status().reason, ServoReason::Plain);
}

TEST_F(FalconDriverTest, WithoutFirmwareItSaysWhatIsMissing)
{
  FalconBench bench("falcon", std::make_shared<FalconModel>(FalconModel::Settings{}), {});
  bench.tick(1000);
  EXPECT_EQ(bench.phase(), DevicePhase::Fault);
  EXPECT_NE(std::string(bench.loop.device().report().reason).find("firmware"), std::string::npos);
}

// The position is read through encoders of 0.02 to 0.09 mm, the force written in words of 1e-4 N m.
TEST_F(FalconDriverTest, ForceAtTheGripIsTheForceComputed)
{
  FalconBench bench("falcon", running(handAlong([](double t) {
                      return Eigen::Vector3d(0.0, 0.0, -0.02 * std::clamp(t - 1.0, 0.0, 1.0));
                    })),
                    options);
  bench.tickUntil([&] { return bench.phase() == DevicePhase::Running; }, 1000);
  bench.order(ForceOrder::Arm);
  double worst = 0.0;
  for (int i = 0; i < 6000; ++i) {
    if (i % 16 == 0) bench.send(wallAt(0.0, 100.0));
    bench.tick();
    if (i > 3000) worst = std::max(worst, (bench.model->force() - bench.status().force).norm());
  }
  EXPECT_GT(bench.status().force.z(), 0.5); // pushes the hand out
  EXPECT_LT(worst, 0.02);
}

// A12: a silent device is a fault after 20 ms of silence; counted from the first tick without a reply.
TEST_F(FalconDriverTest, SilenceIsAFault)
{
  FalconBench bench("falcon", running(), options);
  bench.tickUntil([&] { return bench.phase() == DevicePhase::Running; }, 1000);
  bench.tick(50);
  EXPECT_EQ(bench.status().reason, ServoReason::Plain);
  bench.model->setDead(true);
  const int ticks = bench.tickUntil([&] { return bench.status().reason == ServoReason::NoReply; }, 500);
  EXPECT_GE(ticks, 15);
  EXPECT_LE(ticks, 26);
  EXPECT_TRUE(bench.status().force.isZero(0.0));
}

TEST_F(FalconDriverTest, UnpluggedInAnyStateIsLostAtOnceAndComesBackTwentyTimes)
{
  const auto model = running();
  for (int cycle = 0; cycle < 20; ++cycle) {
    FalconBench bench("falcon", cycle % 2 ? model : std::make_shared<FalconModel>(FalconModel::Settings{}),
                      options);
    bench.tick(1 + cycle * 60); // opening, upload, homed
    const DevicePhase before = bench.phase();
    bench.usb.unplug();
    bench.tick(2);
    EXPECT_EQ(bench.phase(), DevicePhase::Lost) << "from " << static_cast<int>(before);
    EXPECT_EQ(bench.status().reason, ServoReason::DeviceLost);
    EXPECT_EQ(bench.status().state, DeviceState::Absent);
  }
}

TEST_F(FalconDriverTest, ABadByteMovesNothing)
{
  FalconBench bench("falcon", running(), options);
  bench.tickUntil([&] { return bench.phase() == DevicePhase::Running; }, 1000);
  bench.tick(50);
  const Eigen::Vector3d rest = bench.status().position;
  for (std::size_t byte = 2; byte < 18; ++byte) {
    bench.usb.corruptNext(byte);
    for (int i = 0; i < 10; ++i) {
      bench.tick();
      // The lowest nibbles are as good as the truth: 15 x 16 counts at most pass for motion.
      ASSERT_LT((bench.status().position - rest).norm(), 0.03) << byte;
    }
    ASSERT_LT((bench.status().position - rest).norm(), 1e-12) << byte;
  }
  EXPECT_EQ(bench.phase(), DevicePhase::Running);
}

// A16, the device's part: the last things it hears are at least three packets without force.
TEST_F(FalconDriverTest, ClosingLeavesZeroForce)
{
  const auto model = running(
    handAlong([](double t) { return Eigen::Vector3d(0.0, 0.0, -0.02 * std::clamp(t - 1.0, 0.0, 1.0)); }));
  {
    FalconBench bench("falcon", model, options);
    bench.tickUntil([&] { return bench.phase() == DevicePhase::Running; }, 1000);
    bench.order(ForceOrder::Arm);
    for (int i = 0; i < 4000; ++i) {
      if (i % 16 == 0) bench.send(wallAt(0.0, 100.0));
      bench.tick();
    }
    ASSERT_GT(model->force().norm(), 0.3);
  }
  EXPECT_GE(model->zerosInRow(), 3);
  EXPECT_TRUE(model->force().isZero(0.0));
}

TEST_F(FalconDriverTest, TheTickNeverAllocates)
{
  FalconBench bench("falcon", running(), options);
  bench.tickUntil([&] { return bench.phase() == DevicePhase::Running; }, 1000);
  DeviceSample sample;
  HapticDevice& device = bench.loop.device();
  bench.tick(100);
  // The model is not the device: its own queue may allocate, so the same is measured on its thread below.
  FakeUsbTransport usb(running());
  auto driver = openDriver("falcon", options, usb);
  ASSERT_TRUE(driver);
  DrivenDevice threaded(std::move(*driver));
  SteadyClock clock;
  const auto before = test::allocationsOfThisThread();
  for (int i = 0; i < 300; ++i) {
    threaded.read(clock.now(), sample);
    threaded.write(Eigen::Vector3d::Zero());
  }
  EXPECT_EQ(test::allocationsOfThisThread(), before);
  EXPECT_EQ(device.profile().name, "Novint Falcon");
}

// With a thread of its own and the wall clock: no figures, only that it gets there and stops.
TEST_F(FalconDriverTest, RunsOnItsOwnThread)
{
  const auto model = running();
  {
    FakeUsbTransport usb(model);
    auto driver = openDriver("falcon", options, usb);
    ASSERT_TRUE(driver);
    DrivenDevice device(std::move(*driver));
    SteadyClock clock;
    DeviceSample sample;
    for (int i = 0; i < 5000 && device.report().phase != DevicePhase::Running; ++i) {
      clock.sleepUntil(clock.now() + 0.001);
      device.read(clock.now(), sample);
      device.write(Eigen::Vector3d::Zero());
    }
    EXPECT_EQ(device.report().phase, DevicePhase::Running);
    usb.unplug();
    for (int i = 0; i < 1000 && device.read(clock.now(), sample) != DeviceLink::Lost; ++i)
      clock.sleepUntil(clock.now() + 0.001);
    EXPECT_EQ(device.read(clock.now(), sample), DeviceLink::Lost);
    EXPECT_FALSE(device.write(Eigen::Vector3d::Zero()));
  }
}

TEST_F(FalconDriverTest, APermissionErrorNamesTheRule)
{
  FakeUsbTransport usb(running());
  usb.setPermitted(false);
  const auto driver = openDriver("falcon", options, usb);
  ASSERT_FALSE(driver);
  EXPECT_EQ(driver.error().code, ErrorCode::NoDevice);
  EXPECT_NE(driver.error().detail.find("uaccess"), std::string::npos);
  bool found = false;
  for (const DeviceListing& listing : listDevices(usb))
    if (listing.name == "falcon") {
      found = true;
      EXPECT_FALSE(listing.usable);
      EXPECT_EQ(listing.udevRule, udevRule(0x0403, 0xcb48));
    }
  EXPECT_TRUE(found);
}

} // namespace
} // namespace esm
