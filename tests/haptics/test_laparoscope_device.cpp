// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/device/laparoscope_device.h"
#include "haptics/simulated_device.h"

#include <gtest/gtest.h>

#include <memory>

namespace esm {
namespace {

const Laparoscope4 kInstrument(Eigen::Vector3d(0.0, 0.0, 0.15), 0.30);

// The mouse leads the tip, though what moves is the handle on the other side of the trocar.
TEST(LaparoscopeDevice, TheTipFollowsTheMouse)
{
  const auto device = LaparoscopeDevice::simulated(kInstrument);
  const Eigen::Vector3d target(0.02, -0.01, 0.01);
  ASSERT_NE(device->mouseHand(), nullptr);
  device->mouseHand()->moveTo(target);
  DeviceSample sample;
  for (int i = 0; i < 3000; ++i) {
    ASSERT_EQ(device->read(0.001 * i, sample), DeviceLink::Ready);
    device->write(Eigen::Vector3d::Zero());
  }
  // The hand stops where its spring no longer overcomes 0.3 N of dry friction: 1 mm at 300 N/m, times the
  // lever.
  EXPECT_LT((sample.position - target).norm(), 1.5e-3);
}

// Handle and tip do the same work, and close to the trocar the hand is not torn at by the lever.
TEST(LaparoscopeDevice, TheHandFeelsTheForceOverTheLeverAndNeverMoreThanTheLimit)
{
  auto owned = std::make_unique<SimulatedDevice>(SimulatedDeviceSettings{});
  SimulatedDevice& base = *owned;
  const Eigen::Vector3d handle(0.0, 0.0, 0.25); // 0.1 m outside, 0.2 m inside: lever 2
  base.setMotion(handle, Eigen::Vector3d::Zero());
  LaparoscopeDevice device(std::move(owned), kInstrument);
  DeviceSample sample;
  device.read(0.0, sample);
  EXPECT_LT((sample.position - Eigen::Vector3d(0.0, 0.0, -0.05)).norm(), 1e-12);
  device.write({1.0, 0.0, 0.5});
  EXPECT_LT((base.force() - Eigen::Vector3d(-2.0, 0.0, 0.5)).norm(), 1e-12);
  device.write({100.0, 0.0, 0.0});
  EXPECT_NEAR(base.force().norm(), device.profile().maxForce, 1e-9);
}

} // namespace
} // namespace esm
