// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/device_registry.h"
#include "haptics/hand_path.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <vector>

namespace esm {

/// A Falcon that is plugged into nothing, with the hand that holds it and the hand on its cable: whoever has
/// no device can go the whole way with it, from firmware and homing to a pulled cable. Only the wire is
/// missing; driver, threads and servo are those of a real one.
/// @note Threads: list() and open() any, one at a time; the rest any.
class EmulatedFalcon {
public:
  EmulatedFalcon();
  ~EmulatedFalcon();

  /// As the registry's, with this one for the Falcon.
  std::vector<DeviceListing> list(const DeviceOptions& options);
  /// It takes any firmware file: it waits for as many bytes as the file has.
  Result<std::unique_ptr<HapticDevice>> open(const DeviceOptions& options);
  std::uint32_t changes() const noexcept;

  // === What people do to a device
  void setPlugged(bool plugged);
  void setPermitted(bool permitted);
  void setMute(bool mute); ///< a cable with a loose contact
  void pullOutAndIn();     ///< homes it: the hand goes 35 mm out, 35 mm in and back, in 2 s
  void follow(HandPath path);

private:
  class Holder;
  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

} // namespace esm
