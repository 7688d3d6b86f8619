// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/runtime/sim_runner.h"
#include "haptics/hand_path.h"
#include "haptics/servo_loop.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace esm {

/// Which device in the computer a path leads.
enum class ReplayDevice : std::uint8_t {
  Simulated,
  Falcon ///< its emulated twin under the real driver: packets, encoder steps, motor units, 2 s of arming
};

/// What is touched, and how. Plain data.
struct ReplayScene {
  SpringNet net;
  Loads loads;
  SolverSettings solver;
  std::optional<Index> node;       ///< held; else a ball presses on the surface
  double gripRadius = kGripRadius; ///< of the patch that is held around the node [m]
  double tipRadius = 0.003;        ///< of the ball [m]
  double toolLimit = 5.0;          ///< largest force between tool and net [N]
};

/// One tick as it arrived at the device.
struct ReplayTick {
  double time = 0.0;                               ///< servo clock [s]
  Eigen::Vector3d grip = Eigen::Vector3d::Zero();  ///< where it truly was, scene [m]
  Eigen::Vector3d force = Eigen::Vector3d::Zero(); ///< of the motors on the grip from this tick on [N]
  DeviceState state = DeviceState::Idle;
  double handWork = 0.0; ///< what the hand has put into the grip since the start [J]
};

/// A recorded hand against a net, all of it on one thread and a virtual clock: equal scenes give equal
/// forces, bit for bit.
///
///     hand along the path --> grip --> (driver) --> ServoLoop <--> SimRunner, a frame when it is due
///
/// The net moves as accurately as in the window where nothing has to give way (the first rung of
/// QualityLadder), not as accurately as `esm simulate`: that would cost up to a second of computing for each
/// frame, for digits that no hand feels. The Falcon's twin stands so that the path's middle is its own.
class Replay {
public:
  /// Errors: InvalidValue for a net that Simulation refuses or a frame rate that is no positive number.
  static Result<std::unique_ptr<Replay>> create(ReplayScene scene, HandPath path, ReplayDevice device,
                                                double frameRate = 60.0);

  void tick(); ///< of the servo, and the frame that is due, if any
  double now() const noexcept { return m_last.time; }
  const ReplayTick& last() const noexcept { return m_last; }

  void arm() noexcept { m_armWanted = true; } ///< as soon as the device works
  ServoCore& servo() noexcept { return m_loop->core(); }
  ServoLoop& loop() noexcept { return *m_loop; }
  SimRunner& simulation() noexcept { return *m_runner; }
  /// @pre positive. From the next frame on; each still moves the net by the time between two.
  void setFrameRate(double framesPerSecond);
  /// The simulation is gone, as if its thread had died: no word of it comes any more.
  void killSimulation() noexcept { m_alive = false; }
  void reviveSimulation() noexcept { m_alive = true; }

private:
  Replay() = default;
  void makeDevice(HandPath path, ReplayDevice device);

  TripleBuffer<ToolState> m_tool;
  TripleBuffer<ContactModel> m_contact;
  std::unique_ptr<SimRunner> m_runner;
  std::unique_ptr<ServoLoop> m_loop;
  std::function<ReplayTick()> m_look; ///< at the device behind the loop
  ReplayTick m_last;
  double m_nextFrame = 0.0;
  bool m_alive = true, m_armWanted = false;
};

} // namespace esm
