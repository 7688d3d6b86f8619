// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/hand_over.h"
#include "core/base/triple_buffer.h"
#include "core/contact/static_compliance.h"
#include "core/contact/tool_grip.h"
#include "core/contact/tool_tip.h"
#include "core/dynamics/simulation.h"
#include "core/runtime/sim_command.h"
#include "core/runtime/sim_thread.h"
#include "core/runtime/told_error.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace esm {

/// What the simulation thread does, without the thread and without a clock: carries out commands, moves the
/// net frame by frame, draws up pictures of it and tells the hand what it feels. Tests drive it directly;
/// SimThread adds the wall clock.
/// @note Threads: one.
class SimRunner {
public:
  /// @param tool, contact outlive the runner; it is the reader of the one, the writer of the other.
  SimRunner(double frameRate, TripleBuffer<ToolState>& tool, TripleBuffer<ContactModel>& contact);

  void apply(SimCommand&& command);

  /// Whether there is motion to compute: playing, or a single step asked for.
  bool wantsFrame() const noexcept { return m_simulation && (m_playing || m_stepPending); }
  bool playing() const noexcept { return m_playing; }
  double framePeriod() const noexcept { return m_period; } ///< [s]

  /// Moves the net one frame ahead; returns the simulated time [s].
  /// @param enough see Budget::isSpent: true ends the frame where it is, so that a net that is too large for the
  ///        frame rate moves in slow motion but still obeys. A call may get nowhere, if a single step takes
  ///        longer; then the next one needs more time. Without it the frame is done as a whole, and equal
  ///        commands give equal bits.
  double runFrame(const std::function<bool()>& enough = {});

  /// A frame has taken `took` of the wall clock [s]: where that is too much, accuracy gives way by the plan
  /// of the last SetQuality; without one only the clock does. Never called, never changed: see runFrame().
  void keepTime(double took);

  /// Pauses as after failed numerics; for what went wrong outside the mathematics (no memory).
  void stopWith(std::string message);

  /// The state of things into `picture`, all of it but `sequence` and the two figures of the clock.
  void draw(SimSnapshot& picture);

private:
  void carryOut(command::Load&& load);
  void carryOut(command::SetParameters&& change);
  void carryOut(const command::PatchParameters& change);
  void carryOut(command::Play);
  void carryOut(command::Pause);
  void carryOut(command::StepOnce);
  void carryOut(command::Reset);
  void carryOut(const command::SetFrameRate& rate);
  void carryOut(command::SetQuality&& quality);
  void carryOut(const command::Grab& grab);
  void carryOut(const command::MoveGrab& move);
  void carryOut(command::Release);
  void carryOut(const command::FollowDevice& follow);
  void carryOut(const command::Touch& touch);

  bool takePatch(const ParameterPatch& patch);
  void refuseParameters(const Status& status);
  void applyAccuracy();
  Stability stability() const;
  bool deviceTouches() const noexcept { return m_tip && m_followDevice && !m_grip; }
  bool deviceLeads();
  StepReport advanceHeld(const Eigen::Vector3d& hand, const std::function<bool()>& enough);
  StepReport advanceLed(const std::function<bool()>& enough);
  void moveTool(const Eigen::Vector3d& hand, const Eigen::Vector3d& velocity);
  void pull();
  StepReport advance(double interval, const std::function<bool()>& enough);
  void judge(const StepReport& report);
  void keepPicture();
  void keepPicture(const ParameterChange& change);
  void keepMoment();
  bool deviceFeels() const noexcept { return (m_grip || m_tip) && m_followDevice; }
  void publishContact();
  void endContact();
  void closeScene();
  void publish(ContactModel model);

  TripleBuffer<ToolState>& m_tool;
  TripleBuffer<ContactModel>& m_contact;
  std::optional<Simulation> m_simulation;
  std::optional<ToolGrip> m_grip;
  Eigen::Vector3d m_hand = Eigen::Vector3d::Zero(); ///< that m_grip is led to [m]
  std::optional<ToolTip> m_tip;
  std::optional<command::Touch> m_touch; ///< wanted, for nets to come too
  NodeLinks m_links;
  StaticCompliance m_compliance;
  QualityLadder m_ladder;
  bool m_auto = false; ///< the solver is the engine's own choice
  std::uint64_t m_generation = 0;
  std::uint64_t m_contactSequence = 0, m_edition = 0;
  std::uint64_t m_sceneCount = 0, m_scene = 0; ///< so far; published now, 0 for none
  double m_period;
  bool m_playing = false, m_stepPending = false, m_followDevice = false, m_contactActive = false;
  bool m_handIsThere = false; ///< the last led frame came to its end, and the tool to where the hand was
  bool m_failed = false;      ///< numerics; stays until a command gives hope
  StepReport m_report;
  ToldError m_told;
  double m_roughUntil = -1.0; ///< see SimSnapshot
  std::string m_why;          ///< the simulation's own, but for what it says of a frame broken off
  bool m_brokenOff = false;   ///< the last frame was
  std::string m_message;      ///< a refusal or a failure; empty: m_why is what there is to say
  // The last finite picture, so that a NaN cannot leave even if the dynamics let one through.
  NetPicture m_picture;
  double m_time = 0.0;
  Energies m_energies;
};

} // namespace esm
