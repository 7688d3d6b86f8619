// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/emulator/emulated_falcon.h"

#include "haptics/device/driven_device.h"
#include "haptics/emulator/fake_usb_transport.h"
#include "haptics/emulator/falcon_model.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <numbers>
#include <system_error>
#include <utility>

namespace esm {

/// The hand: by mouse, along a path, or out and in. It never jumps, since real hands do not.
/// @note pose() is asked on the driver's thread, under the bus's lock: it may wait for a moment.
class EmulatedFalcon::Holder final : public Hand {
public:
  static constexpr double kHomeWay = 0.035, kHomeTime = 2.0; ///< [m], [s]

  explicit Holder(std::shared_ptr<MouseHand> mouse) : m_mouse(std::move(mouse)) {}

  void follow(HandPath path)
  {
    const std::lock_guard lock(m_mutex);
    m_path = std::move(path);
    m_fresh = true;
  }

  HandPose pose(double time) noexcept override
  {
    const HandPose mouse = m_mouse->pose(time);
    const std::lock_guard lock(m_mutex);
    if (mouse.target != m_mouseTarget) { // whoever moves the mouse has the grip
      m_mouseTarget = m_target = mouse.target;
      m_path = {};
    }
    if (!m_path.time.empty()) {
      if (m_fresh) m_start = time;
      m_fresh = false;
      m_target = m_path.at(m_path.time.front() + time - m_start);
    }
    return {m_target, Eigen::Vector3d::Zero(), 0};
  }

private:
  std::mutex m_mutex;
  std::shared_ptr<MouseHand> m_mouse;
  HandPath m_path;
  Eigen::Vector3d m_mouseTarget = Eigen::Vector3d::Zero(), m_target = Eigen::Vector3d::Zero();
  double m_start = 0.0;
  bool m_fresh = false;
};

namespace {

/// The driver's device, whose grip the mouse may take.
class HeldDevice final : public HapticDevice {
public:
  HeldDevice(std::unique_ptr<DeviceDriver> driver, std::shared_ptr<MouseHand> mouse)
    : m_device(std::move(driver)), m_mouse(std::move(mouse))
  {}
  const DeviceProfile& profile() const noexcept override { return m_device.profile(); }
  DeviceLink read(double time, DeviceSample& sample) noexcept override { return m_device.read(time, sample); }
  bool write(const Eigen::Vector3d& force) noexcept override { return m_device.write(force); }
  DeviceReport report() const noexcept override { return m_device.report(); }
  void requestHome() noexcept override { m_device.requestHome(); }
  MouseHand* mouseHand() noexcept override { return m_mouse.get(); }

private:
  DrivenDevice m_device;
  std::shared_ptr<MouseHand> m_mouse;
};

} // namespace

struct EmulatedFalcon::Parts {
  std::shared_ptr<MouseHand> mouse = std::make_shared<MouseHand>();
  Holder* holder = nullptr; ///< the model's
  std::shared_ptr<FalconModel> model;
  std::unique_ptr<FakeUsbTransport> usb;
  std::atomic<bool> unplugged{false}; ///< since it was opened last
};

EmulatedFalcon::EmulatedFalcon() : m_parts(std::make_unique<Parts>())
{
  auto holder = std::make_unique<Holder>(m_parts->mouse);
  m_parts->holder = holder.get();
  m_parts->model = std::make_shared<FalconModel>(FalconModel::Settings{}, std::move(holder));
  m_parts->usb = std::make_unique<FakeUsbTransport>(m_parts->model);
}

EmulatedFalcon::~EmulatedFalcon() = default;

std::vector<DeviceListing> EmulatedFalcon::list(const DeviceOptions& options)
{
  return listDevices(*m_parts->usb, options);
}

Result<std::unique_ptr<HapticDevice>> EmulatedFalcon::open(const DeviceOptions& options)
{
  if (m_parts->unplugged.exchange(false)) m_parts->model->powerOff(); // nobody has a handle that works
  std::error_code fault;
  const std::uintmax_t bytes = std::filesystem::file_size(options.firmware, fault);
  if (!fault) m_parts->model->setImageSize(static_cast<std::size_t>(bytes));
  Result<std::unique_ptr<DeviceDriver>> driver = openDriver("falcon", options, *m_parts->usb);
  if (!driver) return driver.error();
  return std::unique_ptr<HapticDevice>(std::make_unique<HeldDevice>(std::move(*driver), m_parts->mouse));
}

std::uint32_t EmulatedFalcon::changes() const noexcept
{
  return m_parts->usb->changes();
}

void EmulatedFalcon::setPlugged(bool plugged)
{
  if (plugged) return m_parts->usb->plugIn();
  m_parts->usb->unplug();
  m_parts->unplugged = true;
}

void EmulatedFalcon::setPermitted(bool permitted)
{
  m_parts->usb->setPermitted(permitted);
}

void EmulatedFalcon::setMute(bool mute)
{
  m_parts->usb->setMute(mute);
}

void EmulatedFalcon::pullOutAndIn()
{
  constexpr int kPoints = 101;
  HandPath path;
  path.position.setZero(3, kPoints);
  for (int i = 0; i < kPoints; ++i) {
    const double share = static_cast<double>(i) / (kPoints - 1);
    path.time.push_back(Holder::kHomeTime * share);
    path.position(2, i) = Holder::kHomeWay * std::sin(2.0 * std::numbers::pi * share);
  }
  follow(std::move(path));
}

void EmulatedFalcon::follow(HandPath path)
{
  m_parts->holder->follow(std::move(path));
}

} // namespace esm
