// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/device/driven_device.h"
#include "haptics/device/falcon_driver.h"
#include "haptics/device/pid_driver.h"
#include "haptics/device_registry.h"
#include "haptics/emulator/falcon_model.h"
#include "haptics/emulator/pid_model.h"
#include "haptics/protocol/ftdi.h"
#include "haptics/servo_clock.h"
#include "haptics/usb/libusb_transport.h"
#include "tests/haptics/umock/usb_testbed.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>

namespace esm {
namespace {

std::shared_ptr<FalconModel> runningFalcon()
{
  FalconModel::Settings settings;
  settings.running = settings.homed = true;
  return std::make_shared<FalconModel>(settings);
}

/// Generous: a busy machine may need seconds where an idle one needs milliseconds.
bool waitFor(const std::function<bool()>& done)
{
  SteadyClock clock;
  const double until = clock.now() + 20.0;
  while (!done() && clock.now() < until) clock.sleepUntil(clock.now() + 0.002);
  return done();
}

TEST(LibusbTransport, SeesDevicesComeAndGo)
{
  UsbTestbed bed(runningFalcon());
  auto usb = LibusbTransport::create();
  ASSERT_TRUE(usb) << usb.error().detail;
  EXPECT_TRUE((*usb)->list().empty());
  const auto before = (*usb)->changes();
  bed.plugIn();
  EXPECT_TRUE(waitFor([&] { return (*usb)->changes() != before; }));
  ASSERT_EQ((*usb)->list().size(), 1u);
  EXPECT_EQ((*usb)->list()[0].product, 0xcb48);
  const auto plugged = (*usb)->changes();
  bed.unplug();
  EXPECT_TRUE(waitFor([&] { return (*usb)->changes() != plugged; }));
  EXPECT_TRUE((*usb)->list().empty());
}

TEST(LibusbTransport, MovesBytesBothWaysAndCancels)
{
  UsbTestbed bed(runningFalcon());
  bed.plugIn();
  auto usb = LibusbTransport::create();
  ASSERT_TRUE(usb);
  ASSERT_EQ((*usb)->list().size(), 1u);
  Wakeup wakeup;
  auto handle = (*usb)->open((*usb)->list()[0], 0, wakeup);
  ASSERT_TRUE(handle) << handle.error().detail;
  EXPECT_TRUE(bed.claimed());
  EXPECT_EQ((*handle)->endpoints().in, 0x81);
  EXPECT_EQ((*handle)->endpoints().out, 0x02);
  EXPECT_EQ((*handle)->control(ftdi::k1500000Baud, {}).status, UsbStatus::Ok);
  std::array<std::uint8_t, 4> room{};
  EXPECT_EQ((*handle)->control({0x80, 6, 0x0500, 0, 4}, room).status,
            UsbStatus::Stalled); // no such descriptor
  const falcon::Packet packet = falcon::encode(falcon::Command{});
  ASSERT_TRUE((*handle)->submitOut(packet));
  ASSERT_TRUE((*handle)->submitIn(64));
  UsbCompletion completion;
  bool sent = false, replied = false;
  EXPECT_TRUE(waitFor([&] {
    while ((*handle)->take(0.0, completion)) {
      sent = sent || (completion.endpoint == 0x02 && completion.status == UsbStatus::Ok);
      replied = replied || completion.length == 2 + falcon::kPacketSize;
      if (completion.endpoint == 0x81) (*handle)->submitIn(64);
    }
    return sent && replied;
  }));
  handle->reset(); // with a read under way: cancelled, and nothing is left behind
  EXPECT_FALSE(bed.claimed());
}

TEST(LibusbTransport, AFalconWorksAndItsUnpluggingIsNoticedTwentyTimes)
{
  const auto model = runningFalcon();
  UsbTestbed bed(model);
  auto usb = LibusbTransport::create();
  ASSERT_TRUE(usb);
  for (int cycle = 0; cycle < 20; ++cycle) {
    bed.plugIn();
    ASSERT_TRUE(waitFor([&] { return (*usb)->list().size() == 1; })) << cycle;
    auto driver = openDriver("falcon", {}, **usb);
    ASSERT_TRUE(driver) << driver.error().detail;
    DrivenDevice device(std::move(*driver));
    SteadyClock clock;
    DeviceSample sample;
    const bool wholeWay = cycle % 4 == 0;
    if (wholeWay) {
      EXPECT_TRUE(waitFor([&] {
        device.write(Eigen::Vector3d::Zero());
        return device.read(clock.now(), sample) == DeviceLink::Ready;
      }))
        << cycle;
    }
    bed.unplug();
    EXPECT_TRUE(waitFor([&] { return device.read(clock.now(), sample) == DeviceLink::Lost; })) << cycle;
    ASSERT_TRUE(waitFor([&] { return (*usb)->list().empty(); })) << cycle;
  }
}

TEST(LibusbTransport, ASilentDeviceDoesNotReply)
{
  UsbTestbed bed(runningFalcon());
  bed.plugIn();
  auto usb = LibusbTransport::create();
  ASSERT_TRUE(usb);
  auto driver = openDriver("falcon", {}, **usb);
  ASSERT_TRUE(driver) << driver.error().detail;
  {
    DrivenDevice device(std::move(*driver));
    SteadyClock clock;
    DeviceSample sample;
    const auto link = [&] {
      device.write(Eigen::Vector3d::Zero());
      return device.read(clock.now(), sample);
    };
    ASSERT_TRUE(waitFor([&] { return link() == DeviceLink::Ready; }));
    bed.setMute(true);
    clock.sleepUntil(clock.now() + 0.05);
    EXPECT_TRUE(waitFor([&] { return link() == DeviceLink::NoReply; }));
    clock.sleepUntil(clock.now() + 0.05);
    EXPECT_EQ(link(), DeviceLink::NoReply); // and stays so
    bed.setMute(false);
  }
  EXPECT_FALSE(bed.claimed());
}

} // namespace
} // namespace esm
