// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "haptics/haptic_device.h"
#include "haptics/protocol/pid_session.h"

#include <Eigen/Core>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

struct UsbId {
  std::uint16_t vendor = 0, product = 0;
  bool operator==(const UsbId&) const = default;
};

/// What the user says about a device beside its name. Empty: as the profile says.
struct DeviceOptions {
  std::filesystem::path profile;  ///< JSON laid over the built-in profile
  std::filesystem::path firmware; ///< Falcon: the image to upload
  bool optIn = false;             ///< "yes, what carries these unregistered USB numbers is that device"
};

/// All that a driver wants to know of its device. A file of it is JSON in SI units, the unit in each key; the
/// user's own is laid over the one built in (RFC 7396), so it holds only what differs:
///
///     {"limits": {"force_N": 4.5}, "newtons_at_full": 3.1}
struct DriverProfile {
  DeviceProfile device;
  std::vector<UsbId> usb;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< where the scene's zero lies in the device [m]
  double newtonsAtFull = 1.0;                       ///< PID: force at 100 % [N]; measured by the user
  Eigen::Vector2d stroke{0.1, 0.1};                 ///< PID: of the grip [m]
  pid::Quirks quirks;
  std::filesystem::path firmware;
  bool needsOptIn = false, optIn = false;
};

/// The JSON text built in for a kind of device; empty if there is none.
std::string_view builtInProfile(std::string_view kind) noexcept;

/// Where the user's own profiles lie: $XDG_CONFIG_HOME/esm/haptics/KIND.json.
std::filesystem::path userProfilePath(std::string_view kind);

/// Built-in, then the user's own if there is one, then the options. Errors: FileUnreadable, BadFormat (not
/// JSON), InvalidValue (which key, what it may be).
Result<DriverProfile> loadProfile(std::string_view kind, const DeviceOptions& options);

/// The same from texts. @param origin names the text in errors.
Result<DriverProfile> parseProfile(std::string_view builtIn, std::string_view patch,
                                   const std::string& origin);

} // namespace esm
