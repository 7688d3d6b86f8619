// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/protocol/pid_layout.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>

namespace esm::pid {

/// What a session needs of the device; reports with their id byte if the device numbers them.
class Port {
public:
  virtual bool output(std::span<const std::uint8_t> report) noexcept = 0;
  virtual bool setFeature(std::span<const std::uint8_t> report) noexcept = 0;
  /// @return whether the report came whole.
  virtual bool getFeature(std::uint8_t id, std::span<std::uint8_t> report) noexcept = 0;
  virtual ~Port() = default;
};

/// How a device differs from the standard, and how fast it may be driven. From its profile.
struct Quirks {
  bool controlFromOne = false;    ///< device control counts from one although its descriptor says zero
  bool noBlockLoadAnswer = false; ///< the answer never comes: effects get the numbers 1, 2
  bool endlessEffects = false;    ///< cannot restart a running effect: no time limit, hence no watchdog
  /// Sign of a force along +X (to the right) and +Y (towards the user). By direction 90 degrees a positive
  /// force comes from the east and pushes to the west, by 0 degrees from the north towards the user.
  Eigen::Vector2d polarity{-1.0, 1.0};
  double updateRate = 250.0; ///< force reports per second and axis, at most; 400 overran a wheel
};

/// Two constant forces, one along each axis, on a PID device.
///
///     open:  reset, actuators on, gain -> per axis: create, block load, set effect, force 0, start
///     then:  setForce() -> Set Constant Force, on change by more than one step and within the rate
///            effects last kDuration and are started again each kRestart: if the host dies, the device lets
///            go
///     close: force 0, stop, free, actuators off
///
/// @note One thread; no allocation. open() and close() wait for the device, setForce() as the port does.
class Session {
public:
  static constexpr double kDuration = 0.2, kRestart = 0.1; ///< [s]
  static constexpr int kMostPolls = 60;                    ///< of block load, as hid-pidff does

  Session(const Layout& layout, const Quirks& quirks, Port& port) noexcept
    : m_layout(layout), m_quirks(quirks), m_port(port)
  {}

  /// @return null, or what failed (a static text).
  const char* open(double now) noexcept;
  /// @param share of full force along X and Y, -1 ... 1; zero is always sent at once.
  /// @return false: the device did not take a report.
  bool setForce(double now, const Eigen::Vector2d& share) noexcept;
  void close() noexcept;
  int axes() const noexcept { return m_axes; }
  /// The report that takes an axis' force away, written into `bytes`; touches nothing else. @pre axis <
  /// axes()
  std::span<const std::uint8_t> zeroReport(int axis, std::span<std::uint8_t> bytes) const noexcept;

private:
  struct Effect {
    std::uint8_t block = 0;
    std::int32_t sent = 0;
    double sentAt = 0.0;
    bool known = false;
  };

  const char* createEffect(int axis) noexcept;
  bool pollBlock(int axis) noexcept;
  bool setEffect(int axis) noexcept;
  std::span<std::uint8_t> magnitudeReport(int axis, std::int32_t value,
                                          std::span<std::uint8_t> bytes) const noexcept;
  bool sendMagnitude(int axis, std::int32_t value) noexcept;
  bool operate(int axis, hid::Usage what, int loops) noexcept;
  bool control(hid::Usage what) noexcept;
  std::span<std::uint8_t> blank(const hid::Slot& any, std::size_t bytes) noexcept;
  bool put(const hid::Slot& slot, std::int64_t value) noexcept;

  const Layout& m_layout;
  Quirks m_quirks;
  Port& m_port;
  std::array<std::uint8_t, hid::ReportDescriptor::kMostReportBytes> m_bytes{};
  std::array<Effect, 2> m_effects;
  int m_axes = 0;
  double m_restartAt = 0.0;
  bool m_open = false;
};

} // namespace esm::pid
