// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/haptic_device.h"
#include "haptics/haptic_types.h"

#include <atomic>
#include <cstdint>

namespace esm {

enum class ForceOrder : std::uint8_t { Disarm, Arm, Stop };

/// What the user wants, across to the servo thread. The newest order wins, but a stop only yields to arm().
/// @note Threads: give() on one thread, latest() on the servo thread; wait-free.
class ForceOrders {
public:
  void give(ForceOrder order) noexcept
  {
    if (order == ForceOrder::Disarm && m_last == ForceOrder::Stop) return;
    m_last = order;
    m_word.store((++m_count << 2) | static_cast<std::uint32_t>(order), std::memory_order_release);
  }
  /// Another number with each order.
  std::uint32_t latest() const noexcept { return m_word.load(std::memory_order_acquire); }
  static ForceOrder orderOf(std::uint32_t word) noexcept { return static_cast<ForceOrder>(word & 3u); }

private:
  std::atomic<std::uint32_t> m_word{0};
  std::uint32_t m_count = 0;
  ForceOrder m_last = ForceOrder::Disarm;
};

/// Why the servo is in its state; words for it are in haptic_session.cpp.
enum class ServoReason : std::uint8_t {
  Plain,
  NeedsHome,
  ForceTooLarge, ///< armed, but force waits until it would begin with almost nothing
  NoScene,       ///< armed, but no tissue moves: paused, or no model
  NoContact,     ///< armed, but nothing is held or touched
  LateModel,     ///< force is on, by models that come late
  StaleModel,    ///< the simulation answers too late to be felt
  EmergencyStop,
  BadModel,      ///< the simulation sent a force that is no number
  EnergyTooHigh, ///< the loop gave energy that nobody had put in
  NoReply,
  DeviceLost,
  Closed
};

/// Whether force may flow. Only the user's arm() opens, anything can close.
///
///     Absent <-- lost -- any;   any -- fault --> Fault -- arm --> Arming --> Active
///     Idle -- arm --> Arming;   Arming, Active -- disarm, home lost --> Fading --> Idle
///
/// Opening waits until tissue was there and the force would have been below 0.2 N for 50 ticks, so that it
/// begins with nothing in the hand, then takes the profile's armTime, with some damping besides. Closing
/// takes 50 ms; a fault closes at once (the limiter's slew rate then is what the arm feels).
///
/// Another scene, or the same after a silence, waits and opens anew: tissue that appears around the hand is
/// as much of a surprise as the first. A contact that begins with more than 0.2 N, wherever it comes from,
/// fades in over armTime too.
/// @note Threads: servo only.
class Arming {
public:
  static constexpr double kDisarmTime = 0.05;   ///< [s]
  static constexpr double kReplyTimeout = 0.02; ///< [s]
  static constexpr double kSafeForce = 0.2;     ///< [N]
  static constexpr int kSafeTicks = 50;
  static constexpr double kDampingShare = 0.2; ///< of the device's most, while force fades in

  explicit Arming(double armTime) noexcept : m_armTime(armTime) {}

  void obey(std::uint32_t orderWord) noexcept; ///< does nothing for a word it has seen
  void fail(ServoReason reason) noexcept;      ///< the first reason stays until arm()
  void watch(DeviceLink link, double dt) noexcept;
  void fadeInAnew() noexcept { m_gain = 0.0; } ///< where the hand is now is no way it went
  /// @param wish   size of the force that would be sent with gain 1 and a contact that has faded in [N].
  /// @param scene  that it comes from; 0: no tissue, or it is silent or fades out.
  /// @param begins whether its contact begins with this tick.
  void advance(double dt, double wish, std::uint64_t scene, bool begins) noexcept;

  double gain() const noexcept { return m_gain; } ///< 0 ... 1
  /// Damping to add while force fades in, over the device's most [1]; comes and goes without a jump.
  double dampingShare() const noexcept;
  bool waits() const noexcept { return m_wanted && m_safeTicks < kSafeTicks; }
  bool wanted() const noexcept { return m_wanted; }
  bool opens() const noexcept { return m_wanted && !waits(); } ///< force is on, or fades in
  ServoReason fault() const noexcept { return m_fault; }
  /// @param forceFlows whether the force now sent is not zero.
  DeviceState state(bool present, bool forceFlows) const noexcept;
  bool needsHome() const noexcept { return m_needsHome; }

private:
  double m_armTime;
  double m_gain = 0.0, m_silence = 0.0;
  std::uint32_t m_seen = 0;
  std::uint64_t m_scene = 0;
  int m_safeTicks = 0;
  bool m_wanted = false, m_needsHome = false;
  ServoReason m_fault = ServoReason::Plain;
};

} // namespace esm
