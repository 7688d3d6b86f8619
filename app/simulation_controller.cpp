// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation_controller.h"

#include "core/contact/limited_pull.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QScreen>
#include <QSettings>

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

/// Or fades in, or out.
bool givesForce(DeviceState state)
{
  return state == DeviceState::Arming || state == DeviceState::Active || state == DeviceState::Fading;
}

const QString kGripRadiusKey = QStringLiteral("pull/radius"); ///< [m]
constexpr double kLargestGrip = 0.05;                         ///< [m]

double savedGripRadius()
{
  bool isNumber = false;
  const double metres = QSettings().value(kGripRadiusKey).toDouble(&isNumber);
  return isNumber && metres >= 0.0 && metres <= kLargestGrip ? metres : kGripRadius;
}

} // namespace

SimulationController::SimulationController(Document* document, SceneView* view, QObject* parent)
  : QObject(parent), m_document(document), m_view(view), m_sim(refreshRate()), m_gripRadius(savedGripRadius())
{
  setQuality({});
  view->setGripRadius(m_gripRadius);
  connect(document, &Document::projectReset, this, [this] {
    disarm(); // the hand does not know what comes
    load();
  });
  connect(document, &Document::netChanged, this, &SimulationController::load);
  connect(document, &Document::parametersChanged, this, [this] {
    if (m_generation == 0) return;
    const auto patch = m_document->lastPatch();
    if (!patch) {
      m_sim.setParameters(*m_document->net());
      m_view->setParameters(m_document->net());
    } else if (!patch->isEmpty()) {
      m_sim.setParameters(patch);
      m_view->setParameters(*patch);
    }
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
  letDeviceLead();
  if (m_session) {
    m_trace.clear();
    m_session->takeTrace(m_trace);
    emit deviceTicked(m_trace);
    showInstrument();
  }
  if (newest.sequence == m_snapshot.sequence) {
    if (!m_snapshot.playing) return;
    readClock(m_snapshot, SimThread::now());
    return emit clockRead();
  }
  m_snapshot = newest;
  if (m_snapshot.grabbedNode != m_pulledNode) forgetHold();
  readClock(m_snapshot, SimThread::now());
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
  m_view->letGo(); // its ring and line, too
  endPull();
  m_sim.reset();
}

void SimulationController::setQuality(const QualityPlan& plan)
{
  m_sim.setQuality(plan);
}

// === Pulling

void SimulationController::startPull(Index node, const Eigen::Vector3d& target)
{
  if (node < 0 || node >= m_document->project().net.nodeCount()) return;
  m_pulledNode = node;
  m_pullTarget = target;
  m_leadsByMouse = m_coupling == Coupling::Touches && m_session && m_session->ledByMouse();
  if (m_leadsByMouse) return m_session->moveHand(target - m_place);
  if (m_session) m_session->placeHand(target);
  m_sim.grab(node, target, m_forceLimit, m_gripRadius);
  letDeviceLead();
}

void SimulationController::movePull(const Eigen::Vector3d& target)
{
  if (m_pulledNode == kNoIndex) return;
  m_pullTarget = target;
  if (m_leadsByMouse) return m_session->moveHand(target - m_place);
  if (m_session) m_session->moveHand(target);
  m_sim.moveGrab(target);
}

void SimulationController::endPull()
{
  if (m_pulledNode == kNoIndex) return;
  m_pulledNode = kNoIndex;
  if (!std::exchange(m_leadsByMouse, false)) m_sim.release();
  letDeviceLead();
  forgetHold();
  m_view->showNothingHeld();
}

/// A simulation that is late may go on for a while with what the hand has let go of: the hand feels nothing of it.
void SimulationController::forgetHold()
{
  if (m_snapshot.grabbedNode == kNoIndex) return;
  m_snapshot.grabbedNode = kNoIndex;
  m_snapshot.heldNodes.clear();
  m_snapshot.toolForce.setZero();
}

/// A device that touches leads as long as it works, but while the mouse holds a node; one that holds nodes
/// leads while it has one and may feel force.
void SimulationController::letDeviceLead()
{
  const DeviceState state = hapticStatus().state;
  bool leads = m_session && deviceReport().phase == DevicePhase::Running && state != DeviceState::Absent;
  if (m_coupling == Coupling::Touches)
    leads = leads && (m_pulledNode == kNoIndex || m_leadsByMouse);
  else
    leads =
      leads && m_pulledNode != kNoIndex && (state == DeviceState::Arming || state == DeviceState::Active);
  if (leads == m_deviceLeads) return;
  m_deviceLeads = leads;
  m_sim.followDevice(leads);
  if (!leads && m_pulledNode != kNoIndex) m_sim.moveGrab(m_pullTarget);
}

// === Device

Status SimulationController::attachDevice(std::unique_ptr<HapticDevice> device, const std::string& name,
                                          Coupling coupling)
{
  detachDevice();
  PlacedDevice* placed = nullptr;
  if (coupling == Coupling::Touches) {
    auto wrapped = std::make_unique<PlacedDevice>(std::move(device));
    placed = wrapped.get();
    placed->place(m_place);
    device = std::move(wrapped);
  }
  auto session = HapticSession::start(std::move(device), m_sim.toolInput(), m_sim.contactOutput());
  if (!session) return session.error();
  m_session = std::move(session).value();
  m_placed = placed;
  m_session->setForceLimit(m_forceLimit);
  m_session->setForceScale(m_forceScale);
  m_deviceName = name;
  m_coupling = coupling;
  touchWithDevice();
  letDeviceLead();
  emit deviceChanged();
  return {};
}

void SimulationController::detachDevice()
{
  if (!m_session) return;
  endPull();
  m_session.reset();
  m_placed = nullptr;
  m_deviceName.clear();
  m_coupling = Coupling::HoldsNode;
  touchWithDevice();
  letDeviceLead();
  m_view->setInstrument({});
  emit deviceChanged();
}

void SimulationController::touchWithDevice()
{
  m_sim.touch(m_coupling == Coupling::Touches, kTipRadius, m_forceLimit);
}

HapticStatus SimulationController::hapticStatus() const
{
  return m_session ? m_session->status() : HapticStatus{};
}

DeviceReport SimulationController::deviceReport() const
{
  return m_session ? m_session->report() : DeviceReport{DevicePhase::Lost};
}

const DeviceProfile* SimulationController::deviceProfile() const
{
  return m_session ? &m_session->profile() : nullptr;
}

JitterCounts SimulationController::jitter() const
{
  return m_session ? m_session->jitter() : JitterCounts{};
}

void SimulationController::requestHome()
{
  if (m_session) m_session->requestHome();
}

void SimulationController::placeWorkspace(const Eigen::Vector3d& offset)
{
  if (!offset.allFinite()) return;
  m_place = offset;
  if (m_placed) m_placed->place(offset);
}

/// From now on a file dialog of the desktop could take the keyboard away from the stop: Qt's own ones do not.
void SimulationController::arm()
{
  if (!m_session) return;
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  m_armed = true;
  m_session->arm();
}

void SimulationController::disarm()
{
  m_armed = false;
  if (m_session) m_session->disarm();
}

void SimulationController::stop()
{
  m_armed = false;
  if (m_session) m_session->emergencyStop();
  endPull();
}

bool SimulationController::forceMayFlow() const
{
  if (!m_session) return false;
  return m_armed || givesForce(m_session->status().state);
}

void SimulationController::setForceLimit(double newtons)
{
  m_forceLimit = std::max(newtons, 0.0);
  if (m_session) m_session->setForceLimit(m_forceLimit);
  if (m_coupling == Coupling::Touches) touchWithDevice();
}

void SimulationController::setGripRadius(double metres)
{
  m_gripRadius = std::clamp(metres, 0.0, kLargestGrip);
  QSettings().setValue(kGripRadiusKey, m_gripRadius);
  m_view->setGripRadius(m_gripRadius);
}

void SimulationController::setForceScale(double scale)
{
  m_forceScale = std::clamp(scale, 0.0, 10.0);
  if (m_session) m_session->setForceScale(m_forceScale);
}

Eigen::Vector3d SimulationController::forceInHand() const
{
  const HapticStatus status = hapticStatus();
  if (givesForce(status.state)) return status.force;
  const double limit = m_session ? std::min(m_forceLimit, m_session->profile().maxForce) : m_forceLimit;
  return limitedForce(m_forceScale * m_snapshot.toolForce, limit);
}

/// The ball is shown where the tissue lets it be; while the simulation rests there is only the hand.
void SimulationController::showInstrument()
{
  if (!m_placed) return;
  const HapticStatus status = m_session->status();
  Instrument shown;
  shown.visible = status.state != DeviceState::Absent && deviceReport().phase == DevicePhase::Running;
  shown.workspace = {m_session->profile().workspaceMin + m_place,
                     m_session->profile().workspaceMax + m_place};
  shown.hand = status.position;
  shown.touches = m_snapshot.playing && m_snapshot.tipTouches;
  shown.tip = shown.touches ? m_snapshot.tipPosition : status.position;
  shown.radius = kTipRadius;
  m_view->setInstrument(shown);
}

} // namespace esm
