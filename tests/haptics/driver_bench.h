// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/device/driven_device.h"
#include "haptics/device/driver_profile.h"
#include "haptics/device_registry.h"
#include "haptics/emulator/fake_usb_transport.h"
#include "haptics/servo_loop.h"
#include "tests/haptics/servo_bench.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace esm {

/// An emulated device with its real driver under a servo loop, all on one thread in virtual time.
template <class Model>
struct DriverBench {
  DriverBench(std::string_view kind, std::shared_ptr<Model> emulated, const DeviceOptions& options)
    : model(std::move(emulated)),
      usb(model),
      loop(open(kind, options), std::make_unique<VirtualClock>(), tool, contact)
  {}

  void tick(int count = 1)
  {
    for (int i = 0; i < count; ++i) {
      loop.runTicks(1);
      ++ticks;
    }
  }
  double now() { return ticks * loop.device().profile().period; }
  const ServoStatus& status() { return loop.core().status(); }
  void order(ForceOrder what) { loop.core().orders().give(what); }
  DevicePhase phase() { return loop.device().report().phase; }
  void send(ContactModel contactModel)
  {
    contactModel.sequence = ++sequence;
    contact.back() = contactModel;
    contact.publish();
  }
  /// Ticks until `done`; the count, or `most` if it never is.
  int tickUntil(const std::function<bool()>& done, int most)
  {
    int count = 0;
    while (count < most && !done()) {
      tick();
      ++count;
    }
    return count;
  }

  std::shared_ptr<Model> model;
  FakeUsbTransport usb;
  TripleBuffer<ToolState> tool;
  TripleBuffer<ContactModel> contact;
  std::uint64_t sequence = 0;
  int ticks = 0;
  ServoLoop loop;

private:
  std::unique_ptr<HapticDevice> open(std::string_view kind, const DeviceOptions& options)
  {
    auto driver = openDriver(kind, options, usb);
    if (!driver) throw std::runtime_error(driver.error().detail);
    return std::make_unique<DrivenDevice>(std::move(*driver), DrivenDevice::Drive::Inline);
  }
};

/// A wall of 300 N/m at z = 0 that pushes the grip out, made anew for each frame.
inline ContactModel wallAt(double z, double stiffness)
{
  ContactModel model;
  model.active = true;
  model.position = Eigen::Vector3d(0.0, 0.0, z);
  model.stiffness = stiffness * Eigen::Vector3d::UnitZ() * Eigen::Vector3d::UnitZ().transpose();
  return model;
}

} // namespace esm
