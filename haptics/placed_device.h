// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/triple_buffer.h"
#include "haptics/haptic_device.h"

#include <memory>
#include <utility>

namespace esm {

/// A device whose workspace lies where the user wants it in the scene, so that its hand reaches the organ.
/// Another place counts as a jump of the coordinates, not as a motion.
/// @note Threads: place() on one thread, the rest as HapticDevice.
class PlacedDevice final : public HapticDevice {
public:
  explicit PlacedDevice(std::unique_ptr<HapticDevice> device) : m_device(std::move(device)) {}

  /// @param offset where the device's zero lies in the scene [m]; non-finite: no change.
  void place(const Eigen::Vector3d& offset)
  {
    if (!offset.allFinite()) return;
    m_offset.back() = {offset, ++m_count};
    m_offset.publish();
  }

  const DeviceProfile& profile() const noexcept override { return m_device->profile(); }
  DeviceLink read(double time, DeviceSample& sample) noexcept override
  {
    const Place& place = m_offset.latest();
    const DeviceLink link = m_device->read(time, m_own);
    sample = m_own;
    sample.position += place.offset;
    sample.epoch += place.count;
    return link;
  }
  bool write(const Eigen::Vector3d& force) noexcept override { return m_device->write(force); }
  DeviceReport report() const noexcept override { return m_device->report(); }
  void requestHome() noexcept override { m_device->requestHome(); }
  MouseHand* mouseHand() noexcept override { return m_device->mouseHand(); }

private:
  struct Place {
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    std::uint32_t count = 0;
  };
  std::unique_ptr<HapticDevice> m_device;
  DeviceSample m_own; ///< in the device's coordinates: a tick without reply leaves it as it was
  TripleBuffer<Place> m_offset;
  std::uint32_t m_count = 0;
};

} // namespace esm
