// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
// Runs as root in a guest with a real kernel: emulated devices come to its USB bus through vhci-hcd, and our
// own drivers work them through libusb. Prints a line per fact; the last one says whether all hold.
#include "haptics/device/driven_device.h"
#include "haptics/device/falcon_driver.h"
#include "haptics/device_registry.h"
#include "haptics/exit_guard.h"
#include "haptics/servo_clock.h"
#include "haptics/usb/libusb_transport.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
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

/// How long a round trip takes [s], from its repetitions.
struct RoundTrips {
  std::vector<double> took;
  double perSecond() const
  {
    return static_cast<double>(took.size()) / std::accumulate(took.begin(), took.end(), 1e-9);
  }
  double half()
  {
    if (took.empty()) return 0.0;
    std::nth_element(took.begin(), took.begin() + std::ssize(took) / 2, took.end());
    return took[took.size() / 2];
  }
};

/// What an exchange costs this guest when nobody works on it: one system call to the emulated device's
/// process and back, without libusb and its threads, 18 bytes.
RoundTrips bareRoundTrips()
{
  std::string path;
  for (const auto& entry : std::filesystem::recursive_directory_iterator("/dev/bus/usb"))
    if (entry.is_character_file() && entry.path().filename() != "001") path = entry.path(); // 001: the hub
  const int file = open(path.c_str(), O_RDWR | O_CLOEXEC);
  RoundTrips trips;
  SteadyClock clock;
  for (int i = 0; i < 1000 && file >= 0; ++i) {
    const double begin = clock.now();
    std::array<std::uint8_t, 18> descriptor{};
    usbdevfs_ctrltransfer get{0x80, 6, 0x0100, 0, descriptor.size(), 1000, descriptor.data()};
    if (ioctl(file, USBDEVFS_CONTROL, &get) == 18) trips.took.push_back(clock.now() - begin);
  }
  if (file >= 0) close(file);
  return trips;
}

void cycles()
{
  Plugged device({"falcon", "--homed"});
  const auto usb = busWith(kFalconVendor);
  check(usb != nullptr, "the Falcon is enumerated");
  if (!usb) return;
  RoundTrips bare = bareRoundTrips();
  check(bare.took.size() == 1000, "bare round trips per second: %.0f, half of them within %.2f ms",
        bare.perSecond(), 1000.0 * bare.half());
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
  RoundTrips force;
  double last = begin;
  for (auto seen = before; seen - before < 2000 && last - begin < 30.0;) {
    step({0.0, 0.0, 1.0});
    if (driver->exchanges() == seen) continue;
    const double now = clock.now();
    for (; seen < driver->exchanges(); ++seen) force.took.push_back(now - last);
    last = now;
  }
  const double rate = static_cast<double>(driver->exchanges() - before) / (clock.now() - begin);
  check(driver->exchanges() - before >= 2000, "2000 force cycles");
  // A figure, and only far below it a fault: how busy the machine around the guest is cannot be known here.
  check(rate >= 50.0,
        "force cycles per second: %.0f (500 wanted on an idle machine), half of them within %.2f ms", rate,
        1000.0 * force.half());
  check(driver->protocolErrors() == errors, "no protocol error");
  driver->close(clock.now());
  const std::string heard = device.detach();
  int zeros = 0;
  check(std::sscanf(heard.c_str(), "falcon commands %*u zeros %d", &zeros) == 1 && zeros >= 3,
        "closing left zero force: %s", heard.c_str());
}

/// Works as the driver within does, until it dies in the middle of it.
class DyingDriver final : public DeviceDriver {
public:
  explicit DyingDriver(std::unique_ptr<DeviceDriver> inner) : m_inner(std::move(inner)) {}
  const DeviceProfile& profile() const noexcept override { return m_inner->profile(); }
  void step(double now, const Eigen::Vector3d& force, bool fresh) noexcept override
  {
    m_inner->step(now, force, fresh);
    m_state = m_inner->state();
    if (m_state.report.phase == DevicePhase::Running && !force.isZero(0.0) && ++m_steps == 200)
      raise(SIGSEGV);
  }
  void close(double now) noexcept override { m_inner->close(now); }
  void sendLastZero() noexcept override { m_inner->sendLastZero(); }

private:
  std::unique_ptr<DeviceDriver> m_inner;
  int m_steps = 0;
};

/// A16 where nobody is left to speak to the device: the driver's own thread crashes under force.
void crash(const char* name, std::uint16_t vendor, std::vector<const char*> words)
{
  Plugged device(std::move(words));
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    const ExitGuard guard;
    const auto usb = busWith(vendor);
    auto driver = usb ? openDriver(name, {}, *usb) : Result<std::unique_ptr<DeviceDriver>>(Error{});
    if (!driver) _exit(2);
    DrivenDevice held(std::make_unique<DyingDriver>(std::move(*driver)));
    for (int i = 0; i < 20000; ++i) {
      held.write({i % 2 ? 1.0 : 0.5, 0.0, 0.0});
      nap(1);
    }
    _exit(3);
  }
  int status = 0;
  waitpid(child, &status, 0);
  check(WIFSIGNALED(status) && WTERMSIG(status) == SIGSEGV, "the driver of the %s crashes (%x)", name,
        static_cast<unsigned>(status));
  const std::string last = device.detach();
  const auto at = last.find("zeros ");
  check(at != std::string::npos && last[at + 6] != '0', "and the last that it heard is zero force: %s",
        last.c_str());
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
  crash("falcon", kFalconVendor, {"falcon", "--homed"});
  busWithout(kFalconVendor);
  replugs();
  stick();
  crash("pid", kPidVendor, {"pid"});
  asStranger();
  std::printf(failures == 0 ? "GUEST: ALL HOLDS\n" : "GUEST: %d FAILED\n", failures);
  std::fflush(stdout);
  return failures;
}
