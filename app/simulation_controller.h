// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/viewport/scene_view.h"
#include "core/runtime/sim_thread.h"
#include "haptics/haptic_session.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <vector>

namespace esm {

/// Joins document, simulation thread, haptic device and preview. The document's changes go to the simulation
/// as messages; at each refresh of the screen (t_delta) the newest snapshot is shown. Nothing here waits for
/// another thread. GUI thread.
///
/// The pull tool takes hold of a node directly. Once the user has armed a device, the hand on the device
/// leads instead: the mouse then moves the simulated hand, and force limits and stop are the device layer's.
/// A device never feels force before arm().
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
  Status openDevice(const std::string& name);
  const std::string& deviceName() const noexcept { return m_deviceName; }
  HapticStatus hapticStatus() const; ///< Absent without a session
  void arm();
  void disarm();
  void stop(); ///< zero force at the next tick, lets go of the node; stays so until arm()
  void setForceLimit(double newtons);
  double forceLimit() const noexcept { return m_forceLimit; }
  /// What the device did since the last call.
  void takeTrace(std::vector<TraceSample>& samples);

signals:
  void frame();                      ///< a new snapshot is there and shown
  void playingChanged(bool playing); ///< asked for by the user, or the simulation has stopped itself
  void deviceChanged();

private:
  void load();
  void poll();
  void letDeviceLead();

  Document* m_document;
  SceneView* m_view;
  SimThread m_sim;
  std::unique_ptr<HapticSession> m_session; ///< after m_sim: it writes into the simulation's buffers
  std::string m_deviceName;
  QTimer m_timer;
  SimSnapshot m_snapshot;
  std::uint64_t m_generation = 0; ///< of the net that was loaded last
  bool m_playing = false;
  bool m_deviceLeads = false;
  Index m_pulledNode = kNoIndex;
  Eigen::Vector3d m_pullTarget = Eigen::Vector3d::Zero();
  double m_forceLimit = 5.0; ///< [N]
};

} // namespace esm
