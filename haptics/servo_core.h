// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/hand_over.h"
#include "core/base/triple_buffer.h"
#include "haptics/arming.h"
#include "haptics/contact_law.h"
#include "haptics/energy_guard.h"
#include "haptics/force_limiter.h"
#include "haptics/haptic_device.h"
#include "haptics/trace_ring.h"

#include <atomic>
#include <cstdint>

namespace esm {

/// What the servo thread tells the window. Plain data.
struct ServoStatus {
  DeviceState state = DeviceState::Idle;
  ServoReason reason = ServoReason::Plain;
  double rate = 0.0;          ///< [1/s]
  double worstLateness = 0.0; ///< [s]
  std::uint64_t lateTicks = 0, ticks = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< [m]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();    ///< [N]
  double forceLimit = 0.0;                            ///< [N]
  double generated = 0.0;                             ///< [J]
  double lateness = 0.0, tickTime = 0.0;              ///< of this tick; longest of the last second [s]
};

/// One tick of the force loop, from the device's position to the device's force:
///
///     device --position--> velocity filter --> ToolState to the simulation
///        ^                      |
///        |         ContactLaw: newest ContactModel, blended, capped to what stays stable
///        |                      |
///        |         EnergyGuard: damps what was generated, trips
///        |                      |
///        |         norm --> Arming: waits, fades in --> damping while it does
///        |                      |
///        +------ ForceLimiter: finite, norm, slew
///
/// ForceLimiter stands last: no stage before it can let a large or sudden force through.
/// @note Threads: tick() and close() on the servo thread, without locks, allocation, logging or exceptions;
///       orders, setForceLimit(), status(), trace() on one other thread.
class ServoCore {
public:
  static constexpr double kDefaultForceLimit = 5.0; ///< [N]

  ServoCore(HapticDevice& device, TripleBuffer<ToolState>& tool, TripleBuffer<ContactModel>& contact);

  void tick(double now, double dt) noexcept;
  void close() noexcept { m_arming.fail(ServoReason::Closed); } ///< from now on force falls to zero, for good
  void sendZero() noexcept;
  const Eigen::Vector3d& force() const noexcept { return m_limiter.force(); }
  /// For ServoLoop to fill in its figures; published with the next tick.
  ServoStatus& figures() noexcept { return m_figures; }

  ForceOrders& orders() noexcept { return m_orders; }
  void setForceLimit(double newtons) noexcept; ///< non-finite: no change
  /// Force felt over force of the tissue; kept in [0, 10], non-finite: no change.
  void setForceScale(double scale) noexcept;
  const ServoStatus& status() noexcept { return m_status.latest(); }
  TraceRing& trace() noexcept { return m_trace; }

private:
  void take(const DeviceSample& sample, double dt) noexcept;
  Eigen::Vector3d wish(double now, double dt, double limit) noexcept;
  void watchHold() noexcept;
  void sendTool(double now) noexcept;
  ServoReason reason() const noexcept;
  void report(double now, double limit) noexcept;

  HapticDevice& m_device;
  TripleBuffer<ToolState>& m_toolBuffer;
  TripleBuffer<ContactModel>& m_contactBuffer;
  ForceOrders m_orders;
  std::atomic<double> m_userLimit{kDefaultForceLimit}, m_scale{1.0};
  TripleBuffer<ServoStatus> m_status;
  TraceRing m_trace;

  Arming m_arming;
  ContactLaw m_law;
  EnergyGuard m_energy;
  ForceLimiter m_limiter;
  double m_share = 0.0;      ///< of the law's force that was sent last [1]
  double m_beforeHold = 0.0; ///< least energy generated since a late model holds [J]
  DeviceSample m_sample;
  Eigen::Vector3d m_lastPosition = Eigen::Vector3d::Zero();
  Eigen::Vector3d m_velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d m_motion = Eigen::Vector3d::Zero(); ///< since the last tick [m]
  std::uint32_t m_epoch = 0;
  bool m_hasSample = false;
  std::uint64_t m_toolSequence = 0;
  ServoStatus m_figures;
};

} // namespace esm
