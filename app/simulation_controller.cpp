// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation_controller.h"

#include <QGuiApplication>
#include <QScreen>

#include <algorithm>
#include <utility>

namespace esm {

namespace {

/// The screen's refresh rate [Hz]; screens without one (virtual ones) count as 60.
double refreshRate()
{
  const QScreen* screen = QGuiApplication::primaryScreen();
  const double rate = screen != nullptr ? screen->refreshRate() : 0.0;
  return rate >= 24.0 && rate <= 360.0 ? rate : 60.0;
}

} // namespace

SimulationController::SimulationController(Document* document, SceneView* view, QObject* parent)
  : QObject(parent), m_document(document), m_view(view), m_sim(refreshRate())
{
  setQuality({});
  connect(document, &Document::projectReset, this, &SimulationController::load);
  connect(document, &Document::netChanged, this, &SimulationController::load);
  connect(document, &Document::parametersChanged, this, [this] {
    if (m_generation == 0) return;
    m_sim.setParameters(*m_document->net());
    m_view->setParameters(m_document->net());
  });

  connect(view, &SceneView::pullStarted, this, [this](int node, double x, double y, double z) {
    startPull(node, {x, y, z});
  });
  connect(view, &SceneView::pullMoved, this, [this](double x, double y, double z) { movePull({x, y, z}); });
  connect(view, &SceneView::pullEnded, this, &SimulationController::endPull);

  m_timer.setTimerType(Qt::PreciseTimer);
  m_timer.setInterval(static_cast<int>(1000.0 / refreshRate()));
  connect(&m_timer, &QTimer::timeout, this, &SimulationController::poll);
  m_timer.start();
}

SimulationController::~SimulationController() = default;

void SimulationController::load()
{
  endPull();
  const auto net = m_document->net();
  if (net->nodeCount() == 0) {
    m_generation = 0;
    m_sim.pause();
    m_view->setNet(nullptr, 0);
    return;
  }
  const Project& project = m_document->project();
  // On the wall clock a frame in time is worth more than its last digits: see setQuality(). The command line
  // keeps to the project's own tolerance.
  m_generation = m_sim.load(*net, project.loads, project.simulation.solver);
  m_view->setNet(net, m_generation);
  if (m_playing) m_sim.play();
}

void SimulationController::poll()
{
  const SimSnapshot& newest = m_sim.latest();
  if (m_deviceLeads || m_pulledNode != kNoIndex) letDeviceLead();
  if (newest.sequence == m_snapshot.sequence) return;
  m_snapshot = newest;
  if (snapshotIsCurrent()) {
    m_view->setSnapshot(m_snapshot);
    m_view->setToolForce(m_snapshot.toolForce);
    if (m_playing && m_snapshot.stability == Stability::Stopped) { // paused on its last good state
      m_playing = false;
      emit playingChanged(false);
    }
  }
  emit frame();
}

// === Transport

void SimulationController::setPlaying(bool playing)
{
  if (playing)
    m_sim.play();
  else
    m_sim.pause();
  if (playing == m_playing) return;
  m_playing = playing;
  emit playingChanged(playing);
}

void SimulationController::stepOnce()
{
  setPlaying(false);
  m_sim.stepOnce();
}

void SimulationController::reset()
{
  m_sim.reset();
}

void SimulationController::setQuality(const QualityPlan& plan)
{
  m_sim.setQuality(plan);
}

// === Pulling

void SimulationController::startPull(Index node, const Eigen::Vector3d& target)
{
  if (node < 0 || node >= m_document->net()->nodeCount()) return;
  m_pulledNode = node;
  m_pullTarget = target;
  if (m_session) m_session->placeHand(target);
  m_sim.grab(node, target, m_forceLimit);
  letDeviceLead();
}

void SimulationController::movePull(const Eigen::Vector3d& target)
{
  if (m_pulledNode == kNoIndex) return;
  m_pullTarget = target;
  if (m_session) m_session->moveHand(target);
  m_sim.moveGrab(target);
}

void SimulationController::endPull()
{
  if (m_pulledNode == kNoIndex) return;
  m_pulledNode = kNoIndex;
  m_sim.release();
  letDeviceLead();
}

/// The hand on the device moves the grab exactly while a node is held and the device may feel force.
void SimulationController::letDeviceLead()
{
  const DeviceState state = m_session ? hapticStatus().state : DeviceState::Absent;
  const bool leads =
    m_pulledNode != kNoIndex && (state == DeviceState::Arming || state == DeviceState::Active);
  if (leads == m_deviceLeads) return;
  m_deviceLeads = leads;
  m_sim.followDevice(leads);
  if (!leads && m_pulledNode != kNoIndex) m_sim.moveGrab(m_pullTarget);
}

// === Device

Status SimulationController::openDevice(const std::string& name)
{
  m_session.reset();
  m_deviceName.clear();
  auto session = HapticSession::open(name, m_sim.toolInput(), m_sim.contactOutput());
  if (!session) {
    emit deviceChanged();
    return session.error();
  }
  m_session = std::move(session).value();
  m_session->setForceLimit(m_forceLimit);
  m_deviceName = name;
  emit deviceChanged();
  return {};
}

HapticStatus SimulationController::hapticStatus() const
{
  return m_session ? m_session->status() : HapticStatus{};
}

void SimulationController::arm()
{
  if (m_session) m_session->arm();
}

void SimulationController::disarm()
{
  if (m_session) m_session->disarm();
}

void SimulationController::stop()
{
  if (m_session) m_session->emergencyStop();
  endPull();
}

void SimulationController::setForceLimit(double newtons)
{
  m_forceLimit = std::max(newtons, 0.0);
  if (m_session) m_session->setForceLimit(m_forceLimit);
}

void SimulationController::takeTrace(std::vector<TraceSample>& samples)
{
  if (m_session) m_session->takeTrace(samples);
}

} // namespace esm
