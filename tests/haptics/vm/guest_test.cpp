// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
// Runs as root in a guest with a real kernel: emulated devices come to its USB bus through vhci-hcd, and our
// own drivers work them through libusb. Prints a line per fact; the last one says whether all hold.
#include "haptics/device/driven_device.h"
#include "haptics/device/falcon_driver.h"
#include "haptics/device_registry.h"
#include "haptics/servo_clock.h"
#include "haptics/usb/libusb_transport.h"

#include <chrono>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace esm;

int failures = 0;

void check(bool holds, const char* format, ...)
{
  va_list arguments;
  va_start(arguments, format);
  std::printf(holds ? "ok   " : "FAIL ");
  std::vprintf(format, arguments);
  std::printf("\n");
  std::fflush(stdout);
  va_end(arguments);
  if (!holds) ++failures;
}

void nap(int milliseconds)
{
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

/// An emulated device in a process of its own, plugged in for as long as this lives.
class Plugged {
public:
  explicit Plugged(std::vector<const char*> words)
  {
    words.insert(words.begin(), "/bin/esm-usbip-device");
    words.insert(words.end(), {"--vhci", "0", nullptr});
    std::fflush(stdout);
    m_child = fork();
    if (m_child == 0) {
      if (!std::freopen("/tmp/device.out", "w", stdout)) _exit(126);
      execv(words[0], const_cast<char* const*>(words.data()));
      _exit(127);
    }
  }
  ~Plugged() { pullOut(); }
  Plugged(const Plugged&) = delete;
  Plugged& operator=(const Plugged&) = delete;

  void pullOut() ///< at once, as a hand does
  {
    if (m_child <= 0) return;
    kill(m_child, SIGKILL);
    waitpid(m_child, nullptr, 0);
    m_child = -1;
  }

  std::string detach() ///< and what it has to say in the end
  {
    std::ofstream("/sys/devices/platform/vhci_hcd.0/detach") << 0 << std::flush;
    waitpid(m_child, nullptr, 0);
    m_child = -1;
    std::ifstream file("/tmp/device.out");
    std::string line;
    std::getline(file, line);
    return line;
  }

private:
  pid_t m_child = -1;
};

bool waitFor(int milliseconds, const std::function<bool()>& done)
{
  for (int i = 0; i < milliseconds; ++i) {
    if (done()) return true;
    nap(1);
  }
  return done();
}

/// A fresh look at the bus each time: without udevd nobody tells libusb of changes.
std::unique_ptr<LibusbTransport> busWith(std::uint16_t vendor)
{
  for (int i = 0; i < 100; ++i) {
    auto usb = LibusbTransport::create();
    if (!usb) return nullptr;
    for (const UsbDeviceInfo& info : (*usb)->list())
      if (info.vendor == vendor) return std::move(*usb);
    nap(100);
  }
  return nullptr;
}

bool busWithout(std::uint16_t vendor)
{
  return waitFor(5000, [vendor] {
    const auto usb = LibusbTransport::create();
    if (!usb) return false;
    for (const UsbDeviceInfo& info : (*usb)->list())
      if (info.vendor == vendor) return false;
    return true;
  });
}

constexpr std::uint16_t kFalconVendor = 0x0403, kPidVendor = 0x1209;

DeviceOptions withFirmware()
{
  std::ofstream("/tmp/image", std::ios::binary) << std::string(3000, 'x');
  DeviceOptions options;
  options.firmware = "/tmp/image";
  return options;
}

void cycles()
{
  Plugged device({"falcon", "--homed"});
  const auto usb = busWith(kFalconVendor);
  check(usb != nullptr, "the Falcon is enumerated");
  if (!usb) return;
  auto opened = openDriver("falcon", {}, *usb);
  check(bool(opened), "the Falcon is opened and claimed%s", opened ? "" : opened.error().detail.c_str());
  if (!opened) return;
  auto* driver = dynamic_cast<FalconDriver*>(opened->get());
  SteadyClock clock;
  const auto step = [&](const Eigen::Vector3d& force) {
    driver->wakeup().wait(0.001);
    driver->step(clock.now(), force, true);
  };
  const double started = clock.now();
  while (driver->state().report.phase != DevicePhase::Running && clock.now() - started < 20.0)
    step(Eigen::Vector3d::Zero());
  check(driver->state().report.phase == DevicePhase::Running, "the Falcon works after %.0f ms",
        1000.0 * (clock.now() - started));
  const auto errors = driver->protocolErrors(), before = driver->exchanges();
  const double begin = clock.now();
  while (driver->exchanges() - before < 2000 && clock.now() - begin < 30.0) step({0.0, 0.0, 1.0});
  const double rate = static_cast<double>(driver->exchanges() - before) / (clock.now() - begin);
  check(driver->exchanges() - before >= 2000, "2000 force cycles");
  // A figure, and only far below it a fault: how busy the machine around the guest is cannot be known here.
  check(rate >= 50.0, "force cycles per second: %.0f (500 wanted on an idle machine)", rate);
  check(driver->protocolErrors() == errors, "no protocol error");
  driver->close(clock.now());
  const std::string last = device.detach();
  int zeros = 0;
  check(std::sscanf(last.c_str(), "falcon commands %*u zeros %d", &zeros) == 1 && zeros >= 3,
        "closing left zero force: %s", last.c_str());
}

void unplugIn(DevicePhase phase, std::vector<const char*> words, const DeviceOptions& options,
              const char* name)
{
  Plugged device(std::move(words));
  const auto usb = busWith(kFalconVendor);
  auto driver = usb ? openDriver("falcon", options, *usb) : Result<std::unique_ptr<DeviceDriver>>(Error{});
  if (!driver) return check(false, "unplugged while %s: cannot be opened", name);
  DrivenDevice held(std::move(*driver));
  const bool reached = waitFor(20000, [&] {
    held.write(Eigen::Vector3d::Zero());
    return held.report().phase == phase;
  });
  device.pullOut();
  const auto begin = std::chrono::steady_clock::now();
  DeviceSample sample;
  SteadyClock clock;
  waitFor(3000, [&] { return held.read(clock.now(), sample) == DeviceLink::Lost; });
  const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  check(reached && took <= 1.0, "unplugged while %s: noticed after %.0f ms (250 wanted)", name,
        1000.0 * took);
}

void replugs()
{
  int good = 0;
  for (int i = 0; i < 20; ++i) {
    Plugged device({"falcon", "--homed"});
    const auto usb = busWith(kFalconVendor);
    auto driver = usb ? openDriver("falcon", {}, *usb) : Result<std::unique_ptr<DeviceDriver>>(Error{});
    if (!driver) break;
    DrivenDevice held(std::move(*driver));
    DeviceSample sample;
    SteadyClock clock;
    const bool works = waitFor(20000, [&] {
      held.write(Eigen::Vector3d::Zero());
      return held.read(clock.now(), sample) == DeviceLink::Ready;
    });
    device.pullOut();
    const bool lost = waitFor(2000, [&] { return held.read(clock.now(), sample) == DeviceLink::Lost; });
    if (works && lost && busWithout(kFalconVendor)) ++good;
  }
  check(good == 20, "replugged %d of 20 times", good);
}

std::string driverOfStick()
{
  for (const auto& entry : std::filesystem::directory_iterator("/sys/bus/usb/devices")) {
    const std::string name = entry.path().filename();
    std::string vendor;
    std::ifstream(entry.path().parent_path() / name.substr(0, name.find(':')) / "idVendor") >> vendor;
    if (vendor != "1209" || name.find(':') == std::string::npos) continue;
    std::error_code none;
    const auto link = std::filesystem::read_symlink(entry.path() / "driver", none);
    return none ? "none" : link.filename().string();
  }
  return "absent";
}

void stick()
{
  Plugged device({"pid"});
  const auto usb = busWith(kPidVendor);
  check(usb != nullptr, "the stick is enumerated");
  if (!usb) return;
  check(waitFor(5000, [] { return driverOfStick() == "usbhid"; }), "the kernel's driver has the stick");
  {
    auto driver = openDriver("pid", {}, *usb);
    check(bool(driver), "the stick is found by its reports and taken from the kernel%s",
          driver ? "" : driver.error().detail.c_str());
    if (!driver) return;
    check(driverOfStick() == "usbfs", "it is ours now: %s", driverOfStick().c_str());
    DrivenDevice held(std::move(*driver));
    DeviceSample sample;
    SteadyClock clock;
    check(waitFor(5000, [&] { return held.report().phase == DevicePhase::Running; }), "the stick works: %s",
          held.report().reason);
    int ready = 0;
    for (int i = 0; i < 500; ++i) {
      ready += held.read(clock.now(), sample) == DeviceLink::Ready ? 1 : 0;
      held.write({i % 2 ? 1.0 : 0.5, 0.0, 0.0});
      nap(4);
    }
    check(ready > 250, "500 ticks of force, %d with a device that takes it", ready);
  }
  check(waitFor(5000, [] { return driverOfStick() == "usbhid"; }), "the kernel's driver has it back");
  const std::string last = device.detach();
  unsigned long long reports = 0;
  int zeros = 0, effects = -1;
  const int read =
    std::sscanf(last.c_str(), "pid reports %llu zeros %d effects %d", &reports, &zeros, &effects);
  check(read == 3 && reports > 200 && zeros >= 3, "its last reports were zero force: %s", last.c_str());
}

void asStranger()
{
  Plugged device({"falcon", "--homed"});
  check(busWith(kFalconVendor) != nullptr, "the Falcon is there for the stranger too");
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    if (setgid(65534) != 0 || setuid(65534) != 0) _exit(2);
    const auto usb = LibusbTransport::create();
    if (!usb) _exit(3);
    const auto driver = openDriver("falcon", {}, **usb);
    if (driver) _exit(4);
    std::printf("     %s\n", driver.error().detail.c_str());
    std::fflush(stdout);
    for (const DeviceListing& listing : listDevices(**usb))
      if (listing.name == "falcon" && listing.udevRule.empty()) _exit(5);
    _exit(driver.error().detail.find("uaccess") != std::string::npos ? 0 : 6);
  }
  int status = -1;
  waitpid(child, &status, 0);
  check(status == 0, "without permission it is refused, with the rule that permits it");
}

} // namespace

int main()
{
  setenv("HOME", "/tmp", 1);
  cycles();
  busWithout(kFalconVendor);
  const DeviceOptions image = withFirmware();
  unplugIn(DevicePhase::Opening, {"falcon"}, image, "opening");
  unplugIn(DevicePhase::Upload, {"falcon"}, image, "uploading");
  unplugIn(DevicePhase::NeedsHome, {"falcon"}, image, "waiting for home");
  unplugIn(DevicePhase::Running, {"falcon", "--homed"}, {}, "running");
  replugs();
  stick();
  asStranger();
  std::printf(failures == 0 ? "GUEST: ALL HOLDS\n" : "GUEST: %d FAILED\n", failures);
  std::fflush(stdout);
  return failures;
}
