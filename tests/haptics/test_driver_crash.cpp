// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// A crash in a driver's own thread: nobody else speaks to its device, so the dying thread itself has to take
// the force from the hand.
#include "haptics/device/driven_device.h"
#include "haptics/device/driver_profile.h"
#include "haptics/device/falcon_driver.h"
#include "haptics/device/pid_driver.h"
#include "haptics/device/wooden_driver.h"
#include "haptics/emulator/fake_usb_transport.h"
#include "haptics/emulator/falcon_model.h"
#include "haptics/emulator/pid_model.h"
#include "haptics/emulator/wooden_model.h"
#include "haptics/exit_guard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <utility>

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace esm {

namespace {

/// What a device's motors did, in memory that outlives the process that drove them.
struct Motors {
  std::atomic<double> largest{0.0}, last{0.0}; ///< [N]
};

/// An emulated device's handle whose driver crashes in the middle of its work once it is told to.
class CrashingHandle final : public UsbHandle {
public:
  CrashingHandle(std::unique_ptr<UsbHandle> inner, Motors& motors, std::function<double(double)> force)
    : m_inner(std::move(inner)), m_motors(motors), m_force(std::move(force))
  {}
  UsbOutcome control(const UsbSetup& setup, std::span<std::uint8_t> data) noexcept override
  {
    return m_inner->control(setup, data);
  }
  bool submitOut(std::span<const std::uint8_t> bytes) noexcept override
  {
    const bool sent = m_inner->submitOut(bytes);
    note();
    return sent;
  }
  bool submitIn(std::size_t bytes) noexcept override { return m_inner->submitIn(bytes); }
  bool take(double now, UsbCompletion& completion) noexcept override
  {
    if (crash) {
#ifdef ESM_SANITIZED // which has handlers of its own for most signals
      std::terminate();
#else
      raise(SIGSEGV);
#endif
    }
    m_now = now;
    const bool taken = m_inner->take(now, completion);
    note();
    return taken;
  }
  bool sendAtLast(const UsbSetup& setup, std::span<const std::uint8_t> bytes) noexcept override
  {
    const bool sent = m_inner->sendAtLast(setup, bytes);
    m_now += 0.001;
    note();
    return sent;
  }
  UsbEndpoints endpoints() const noexcept override
  {
    return m_inner->endpoints();
  }
  bool lost() const noexcept override
  {
    return m_inner->lost();
  }

  std::atomic<bool> crash{false};

private:
  void note() noexcept
  {
    m_motors.last = m_force(m_now);
    m_motors.largest = std::max(m_motors.largest.load(), m_motors.last.load());
  }

  std::unique_ptr<UsbHandle> m_inner;
  Motors& m_motors;
  std::function<double(double)> m_force; ///< of the motors at a time [N]
  double m_now = 0.0;
};

class DriverCrash : public testing::Test {
protected:
  using MakeDriver =
    std::function<std::unique_ptr<DeviceDriver>(std::unique_ptr<Wakeup>, std::unique_ptr<UsbHandle>)>;

  DriverCrash()
    : motors(new (mmap(nullptr, sizeof(Motors), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))
               Motors)
  {}
  ~DriverCrash() override { munmap(motors, sizeof(Motors)); }

  /// Drives the device with 1 N, then crashes its driver.
  template <class Model>
  [[noreturn]] void runProgram(std::shared_ptr<Model> model, const MakeDriver& make)
  {
    const ExitGuard guard;
    FakeUsbTransport usb(model);
    auto wakeup = std::make_unique<Wakeup>();
    auto handle = std::make_unique<CrashingHandle>(*usb.open(usb.list().front(), 0, *wakeup), *motors,
                                                   [model](double now) {
                                                     model->advance(now);
                                                     return model->force().norm();
                                                   });
    std::atomic<bool>& crash = handle->crash;
    DrivenDevice device(make(std::move(wakeup), std::move(handle)));
    device.requestHome();
    SteadyClock clock;
    DeviceSample sample;
    for (int i = 0; i < 10000; ++i) { // and on, as a servo that has noticed nothing
      device.read(clock.now(), sample);
      device.write({1.0, 0.0, 0.0});
      if (motors->largest > 0.5) crash = true;
      usleep(1000);
    }
    _exit(7);
  }

  template <class Model>
  void expectZeroAtLast(std::shared_ptr<Model> model, const MakeDriver& make)
  {
    const pid_t child = fork();
    if (child == 0) runProgram(std::move(model), make);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << WEXITSTATUS(status);
    EXPECT_GT(motors->largest, 0.5); // there was force in the hand
    EXPECT_EQ(motors->last, 0.0);
  }

  static DriverProfile profileOf(const char* name) { return *parseProfile(builtInProfile(name), {}, name); }

  Motors* motors;
};

} // namespace

TEST_F(DriverCrash, AFalconLetsGo)
{
  FalconModel::Settings settings;
  settings.running = settings.homed = true;
  expectZeroAtLast(std::make_shared<FalconModel>(settings), [](auto wakeup, auto handle) {
    return std::make_unique<FalconDriver>(profileOf("falcon"), std::move(wakeup), std::move(handle),
                                          std::vector<std::uint8_t>{});
  });
}

TEST_F(DriverCrash, AStickLetsGo)
{
  expectZeroAtLast(std::make_shared<PidModel>(PidModel::Settings{}), [](auto wakeup, auto handle) {
    return std::make_unique<PidDriver>(profileOf("pid"), std::move(wakeup), std::move(handle), 0);
  });
}

TEST_F(DriverCrash, AStickThatIsSpokenToByControlOnlyLetsGo)
{
  PidModel::Settings settings;
  settings.noOutEndpoint = true;
  expectZeroAtLast(std::make_shared<PidModel>(settings), [](auto wakeup, auto handle) {
    return std::make_unique<PidDriver>(profileOf("pid"), std::move(wakeup), std::move(handle), 0);
  });
}

TEST_F(DriverCrash, AWoodenArmLetsGo)
{
  expectZeroAtLast(std::make_shared<WoodenModel>(), [](auto wakeup, auto handle) {
    return std::make_unique<WoodenDriver>(profileOf("wooden"), std::move(wakeup), std::move(handle));
  });
}

} // namespace esm
