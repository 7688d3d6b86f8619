// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/hand_over.h"
#include "core/base/result.h"
#include "core/contact/node_patch.h"
#include "core/dynamics/simulation.h"
#include "core/runtime/frame_clock.h"
#include "core/runtime/quality_ladder.h"

#include <memory>
#include <string>
#include <vector>

namespace esm {

/// How the simulation feels; the window's stability light.
enum class Stability : std::uint8_t {
  Idle,     ///< nothing loaded
  Good,     ///< the tolerance is kept
  Implicit, ///< kept, but so stiff that the engine went implicit; `message` names the place
  Rough,    ///< bounded, but the wanted tolerance is not kept: `quality` and `message` say why
  Slow,     ///< stable, but behind the wall clock: realTimeFactor < 0.95
  Stopped   ///< numerics failed; paused on the last good state, `message` says cause and cure
};

/// Where the net is, and what its springs bear: what is dear to copy, and to draw.
struct NetPicture {
  std::uint64_t revision = 0; ///< another one for each other picture of a runner; 0: not known
  Eigen::Matrix3Xd position;  ///< 3 x N [m], finite always
  Eigen::ArrayXd tension;     ///< S [N]

  NetPicture() = default;
  NetPicture(const NetPicture&) = default;
  NetPicture(NetPicture&&) noexcept = default;
  NetPicture& operator=(NetPicture&&) noexcept = default;
  ~NetPicture() = default;
  /// Copies nothing where both are the same picture.
  NetPicture& operator=(const NetPicture& other);
};

/// One picture of the running simulation. Plain data. While the net rests, `revision` stays.
struct SimSnapshot : NetPicture {
  std::uint64_t sequence = 0;   ///< rises with each publish
  std::uint64_t generation = 0; ///< of the load() whose net this is: a reader skips snapshots of an older net
  bool playing = false;
  double time = 0.0;           ///< simulated [s]
  FrameClock clock{0.0};       ///< as of this picture; see readClock()
  double realTimeFactor = 0.0; ///< simulated over wall time, smoothed; 0 while paused
  double lag = 0.0;            ///< of simulated time behind the wall clock; 0 while paused [s]
  double frameTime = 0.0;      ///< for how long the next picture has been computed; 0: it is not due [s]
  double frameCost = 0.0;      ///< processor time per frame over frame period [1]
  Stability stability = Stability::Idle;
  StepReport report; ///< of the last frame
  /// Until when the motion was rough (StepReport::rough), as it goes on from there; -1: it never was since
  /// the start or since all came to rest [s].
  double roughUntil = -1.0;
  double toldError = 0.0; ///< of the motion by its own estimate, see ToldError [1]
  Energies energies;
  QualityState quality;
  std::string solver;
  std::string message; ///< why this solver, or what went wrong and the cure (English)
  Index grabbedNode = kNoIndex;
  std::vector<Index> heldNodes; ///< the patch in the hand, grabbedNode the first of it
  Eigen::Vector3d toolPosition = Eigen::Vector3d::Zero(); ///< [m]
  Eigen::Vector3d toolForce = Eigen::Vector3d::Zero();    ///< on the hand [N]
  double tipRadius = 0.0;                                 ///< [m]; 0: no tip that touches
  bool tipTouches = false;
  Eigen::Vector3d tipPosition = Eigen::Vector3d::Zero(); ///< where it is shown: never beyond the surface [m]
};

/// Brings the figures of the clock up to `now`, and the stability that follows from them: a picture is as old
/// as the frame under way is long, and would else tell of a run in time while the simulation hangs.
/// Only arithmetic, see FrameClock. @param now  on SimThread's clock, not before the picture was made [s].
void readClock(SimSnapshot& picture, double now) noexcept;

/// The simulation in its own thread, on the wall clock at frames of 1/frameRate. All calls return at once:
/// commands go through a queue and take effect at the next frame border, in order.
/// @note Threads: every member is for one thread (the GUI's), except that the two buffers' other ends belong
/// to
///       the servo thread. The destructor joins.
class SimThread {
public:
  explicit SimThread(double frameRate = 60.0);
  ~SimThread();
  SimThread(const SimThread&) = delete;
  SimThread& operator=(const SimThread&) = delete;

  /// Takes another net: paused at t = 0. Returns its generation. A net that Simulation::create() refuses
  /// leaves the former one running; the next snapshot's message says why.
  std::uint64_t load(SpringNet net, Loads loads, SolverSettings settings);
  void setParameters(SpringNet net); ///< same topology; the motion goes on
  /// The same where only that has changed: costs what the patch names. Not null.
  void setParameters(std::shared_ptr<const ParameterPatch> patch);
  void play();
  void pause();
  void stepOnce(); ///< one frame, then pause
  void reset();    ///< to t = 0, playing or not as before
  void setFrameRate(double framesPerSecond);
  /// What gives way when the net is too heavy for the frame rate, from the next frame on and for all nets to
  /// come. Before the first call: only the clock.
  void setQuality(QualityPlan plan);

  /// Takes hold of the patch within `radius` [m] of a node, and leads it: the node to `target`. The hold's
  /// stiffness is chosen from the net so that grabbing never makes it unstable, and the pull is limited to
  /// `maxForce` [N].
  void grab(Index node, const Eigen::Vector3d& target, double maxForce = 5.0, double radius = kGripRadius);
  void moveGrab(const Eigen::Vector3d& target);
  void release();
  /// While on, the grab's target is the newest ToolState instead of moveGrab(): the hand on a device leads.
  void followDevice(bool on);
  /// While on, and the device leads and holds no node, the hand presses on the surface with a ball of
  /// `radius` [m].
  void touch(bool on, double radius = 0.003, double maxForce = 5.0);

  /// The newest picture; valid until the next call. Never waits. Its figures of the clock are as old as it is.
  const SimSnapshot& latest();
  static double now() noexcept; ///< for readClock() [s]; any thread

  TripleBuffer<ToolState>& toolInput() noexcept;        ///< servo thread writes
  TripleBuffer<ContactModel>& contactOutput() noexcept; ///< servo thread reads

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace esm
