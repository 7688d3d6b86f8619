// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/emulator/usb_device_model.h"
#include "haptics/kinematics/delta3.h"
#include "haptics/protocol/falcon_packet.h"
#include "haptics/simulated_device.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

namespace esm {

/// A Falcon in the computer: FTDI bridge, boot loader, run mode, homing, and a grip with mass and friction
/// that a hand holds. What its motors get moves the grip, what its encoders say is where the grip is.
///
/// Boot loader: at 9600 baud it answers the hello, at 142857 it echoes what comes; that many bytes as the
/// image has, and at 1.5 Mbaud it runs. Each motor unit is 1e-4 N m at the arm.
class FalconModel final : public UsbDeviceModel {
public:
  struct Settings {
    SimulatedDeviceSettings mechanics;
    std::size_t imageSize = 3000;
    bool running = false; ///< firmware is there already
    bool homed = false;   ///< and the grip has been out and in
    int wrongEchoes = 0;  ///< so many uploads go wrong
    bool dead = false;    ///< does not answer at all
    Eigen::Vector3d origin{0.0, 0.0, 0.11};
    int unhomedOffset = 400; ///< counts that the encoders are off before homing
  };

  explicit FalconModel(const Settings& settings, std::unique_ptr<Hand> hand = nullptr);

  bool out(std::span<const std::uint8_t> bytes) override;
  int in(std::span<std::uint8_t> bytes) override;
  void advance(double now) override;

  void home() noexcept { m_out = m_in = true; } ///< as if the grip had been out and in
  void setButtons(std::uint8_t buttons) noexcept { m_buttons = buttons; }
  void setDead(bool dead) noexcept { m_settings.dead = dead; }
  void powerOff() noexcept { m_running = m_out = m_in = false; } ///< forgets firmware and home
  void setImageSize(std::size_t bytes) noexcept { m_settings.imageSize = bytes; } ///< what it will wait for
  const falcon::Command& lastCommand() const noexcept { return m_command; }
  std::uint64_t commands() const noexcept { return m_commands; }
  int zerosInRow() const noexcept { return m_zeros; } ///< commands without force since the last with one
  Eigen::Vector3d force() const noexcept { return m_force; } ///< of the motors on the grip [N]
  const SimulatedDevice& grip() const noexcept { return m_grip; }
  bool running() const noexcept { return m_running; }

protected:
  int ownControl(const UsbSetup& setup, std::span<std::uint8_t> data) override;

private:
  void boot(std::uint8_t byte);
  void obey();
  void answer(std::span<const std::uint8_t> bytes)
  {
    m_queue.insert(m_queue.end(), bytes.begin(), bytes.end());
  }

  Settings m_settings;
  Delta3 m_mechanism;
  SimulatedDevice m_grip;
  falcon::StreamParser m_parser;
  falcon::Command m_command;
  std::deque<std::uint8_t> m_queue; ///< to the host
  std::vector<std::uint8_t> m_hello;
  Eigen::Vector3d m_force = Eigen::Vector3d::Zero(), m_angles = Eigen::Vector3d::Zero(), m_pose;
  std::uint16_t m_divisor = 0;
  std::uint8_t m_buttons = 0;
  double m_latency = 0.016, m_now = 0.0, m_statusAt = 0.0;
  std::size_t m_uploaded = 0;
  std::uint64_t m_commands = 0;
  int m_zeros = 0;
  bool m_running = false, m_ready = false, m_out = false, m_in = false, m_started = false;
};

} // namespace esm
