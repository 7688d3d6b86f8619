// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/device/device_driver.h"
#include "haptics/device/driver_profile.h"
#include "haptics/kinematics/delta3.h"
#include "haptics/protocol/falcon_packet.h"
#include "haptics/protocol/falcon_upload.h"
#include "haptics/transport/usb_transport.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace esm {

/// Motor words for a force [N] at this pose. Whatever the force is, the words are within full scale, and keep
/// its direction to half a word; what is not a number gives zero.
std::array<std::int16_t, 3> falconMotors(const Delta3& mechanism, const Eigen::Vector3d& position,
                                         const Eigen::Vector3d& angles,
                                         const Eigen::Vector3d& force) noexcept;

/// The Novint Falcon.
///
///     Opening: is it running already? -- yes --> NeedsHome;  no --> Upload (the user's image) --> Opening
///     NeedsHome: the user pulls the grip out and pushes it in; at all three axes homed the coordinates jump,
///                and 100 ms later --> Running
///
/// One command per force, one reply per command; the next leaves when the reply is there, so the force
/// computed from a position leaves in the exchange after it. Each carries the homing bit, or the device
/// forgets its home.
class FalconDriver final : public DeviceDriver {
public:
  static constexpr double kSettleTime = 0.1;  ///< after the jump [s]
  static constexpr double kKeepAlive = 0.005; ///< without a new force the last is sent again after this [s]

  /// @param image firmware; empty: only a device that runs already can be used.
  FalconDriver(DriverProfile profile, std::unique_ptr<Wakeup> wakeup, std::unique_ptr<UsbHandle> handle,
               std::vector<std::uint8_t> image);

  const DeviceProfile& profile() const noexcept override { return m_profile.device; }
  void step(double now, const Eigen::Vector3d& force, bool fresh) noexcept override;
  void close(double now) noexcept override;
  void sendLastZero() noexcept override;
  std::uint64_t exchanges() const noexcept { return m_exchanges; }
  std::uint64_t protocolErrors() const noexcept { return m_parser.dropped(); }

private:
  void drain(double now) noexcept;
  void startProbe(double now) noexcept;
  void probe(double now) noexcept;
  void upload(double now) noexcept;
  void exchange(double now, const Eigen::Vector3d& force, bool fresh) noexcept;
  void take(const falcon::Reply& reply, double now) noexcept;
  bool plausible(const falcon::Reply& reply) noexcept;
  void keepListening() noexcept;
  bool request(const UsbSetup& setup) noexcept;
  bool send(const falcon::Command& command, double now) noexcept;
  void enter(DevicePhase phase) noexcept;
  void fail(const char* reason) noexcept;
  void lose() noexcept;

  DriverProfile m_profile;
  std::unique_ptr<UsbHandle> m_handle;
  std::vector<std::uint8_t> m_image;
  Delta3 m_mechanism;
  falcon::StreamParser m_parser;
  std::optional<falcon::UploadFsm> m_upload;
  UsbCompletion m_completion;
  Eigen::Vector3d m_angles = Eigen::Vector3d::Zero(), m_pose = Delta3::centre();
  falcon::Reply m_reply;
  bool m_started = false, m_hasReply = false, m_doubted = false;
  bool m_awaiting = false, m_pending = false;
  bool m_uploaded = false;
  int m_listening = 0, m_homeChange = 0; ///< replies in a row that say another home than m_homed
  bool m_homed = false;
  double m_sentAt = 0.0, m_probeUntil = 0.0, m_homedAt = 0.0;
  std::uint64_t m_exchanges = 0;
};

} // namespace esm
