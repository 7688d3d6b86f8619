// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/viewport/scene_view.h"
#include "core/runtime/sim_thread.h"
#include "haptics/haptic_session.h"
#include "haptics/placed_device.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <vector>

namespace esm {

/// Joins document, simulation thread, haptic device and preview. The document's changes go to the simulation
/// as messages; at each refresh of the screen (t_delta) the newest snapshot is shown, and as long as there is no
/// newer one, how late that is. Nothing here waits for another thread. GUI thread.
///
/// The pull tool takes hold of a node directly. A device is coupled in one of two ways:
///
///     HoldsNode  simulated devices: the mouse takes a node with the pull tool; once the user has armed the
///                device, its hand leads the node, and the mouse the hand
///     Touches    all others: their hand leads a ball that presses on the surface, wherever it goes; the
///                workspace can be placed in the scene
///
/// Either way force limits and stop are the device layer's, and no device feels force before arm().
class SimulationController : public QObject {
  Q_OBJECT
public:
  SimulationController(Document* document, SceneView* view, QObject* parent = nullptr);
  ~SimulationController() override;

  // === Transport
  void setPlaying(bool playing);
  bool isPlaying() const noexcept { return m_playing; } ///< as asked for; the snapshot follows
  void stepOnce();
  void reset();
  void setQuality(const QualityPlan& plan); ///< what gives way when the model is too heavy for real time
  const SimSnapshot& snapshot() const noexcept { return m_snapshot; }
  bool snapshotIsCurrent() const noexcept { return m_snapshot.generation == m_generation; }

  // === Pulling (also for scripted runs)
  void startPull(Index node, const Eigen::Vector3d& target);
  void movePull(const Eigen::Vector3d& target);
  void endPull();
  bool isPulling() const noexcept { return m_pulledNode != kNoIndex; }

  // === Device
  enum class Coupling { HoldsNode, Touches };
  static constexpr double kTipRadius = 0.003; ///< of the ball that touches [m]

  Status attachDevice(std::unique_ptr<HapticDevice> device, const std::string& name, Coupling coupling);
  void detachDevice();                                                    ///< its force falls to zero first
  const std::string& deviceName() const noexcept { return m_deviceName; } ///< as attached; empty: none
  Coupling coupling() const noexcept { return m_coupling; }
  HapticStatus hapticStatus() const;          ///< Absent without a session
  DeviceReport deviceReport() const;          ///< Lost without a session
  const DeviceProfile* deviceProfile() const; ///< null without a session
  JitterCounts jitter() const;
  void requestHome();
  /// Where the zero of a device that touches lies in the scene [m]; kept for the next one.
  void placeWorkspace(const Eigen::Vector3d& offset);
  const Eigen::Vector3d& workspacePlace() const noexcept { return m_place; }
  void arm();
  void disarm();
  void stop(); ///< zero force at the next tick, lets go of the node; stays so until arm()
  void setForceLimit(double newtons);
  double forceLimit() const noexcept { return m_forceLimit; }
  /// Of the patch that the next pull takes hold of [m]; 0: a node alone. Remembered in the settings.
  void setGripRadius(double metres);
  double gripRadius() const noexcept { return m_gripRadius; }
  void setForceScale(double scale); ///< force felt over force of the tissue [1]
  double forceScale() const noexcept { return m_forceScale; }
  /// What the device gives while force is on; else what it would give: the tissue's force times the gain, up
  /// to the limit [N].
  Eigen::Vector3d forceInHand() const;
  /// Whether the user has let force flow and nothing has taken it back yet.
  bool forceMayFlow() const;

signals:
  void frame();                      ///< a new snapshot is there and shown
  void clockRead();                  ///< none is yet, but the snapshot's figures of the clock are new
  void playingChanged(bool playing); ///< asked for by the user, or the simulation has stopped itself
  void deviceChanged();
  void deviceTicked(const std::vector<esm::TraceSample>& ticks); ///< what it did since the last time

private:
  void load();
  void poll();
  void letDeviceLead();
  void forgetHold();
  void touchWithDevice();
  void showInstrument();

  Document* m_document;
  SceneView* m_view;
  SimThread m_sim;
  std::unique_ptr<HapticSession> m_session; ///< after m_sim: it writes into the simulation's buffers
  PlacedDevice* m_placed = nullptr;         ///< the session's, if it touches
  std::string m_deviceName;
  Coupling m_coupling = Coupling::HoldsNode;
  Eigen::Vector3d m_place = Eigen::Vector3d::Zero(); ///< [m]
  std::vector<TraceSample> m_trace;
  QTimer m_timer;
  SimSnapshot m_snapshot;
  std::uint64_t m_generation = 0; ///< of the net that was loaded last
  bool m_playing = false;
  bool m_armed = false; ///< by the user, not taken back by him; the device may have closed by itself
  bool m_deviceLeads = false, m_leadsByMouse = false;
  Index m_pulledNode = kNoIndex;
  Eigen::Vector3d m_pullTarget = Eigen::Vector3d::Zero();
  double m_forceLimit = 5.0; ///< [N]
  double m_gripRadius;       ///< [m]
  double m_forceScale = 1.0;
};

} // namespace esm
