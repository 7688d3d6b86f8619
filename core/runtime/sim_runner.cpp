// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/sim_runner.h"

#include "core/base/machine_memory.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

namespace {

constexpr double kLeastRate = 1.0, kMostRate = 1000.0; ///< frames per second
constexpr double kLeadTime = 0.004;                    ///< between two places of a led hand [s]
constexpr int kThreads = 4;          ///< where there are so many processors: more gain little
constexpr double kFastestHand = 2.0; ///< what goes further was placed anew [m/s]
constexpr Index kLargeNet = 20'000;  ///< nodes: some tens of MB

double periodOf(double framesPerSecond)
{
  return 1.0 / (std::isfinite(framesPerSecond) ? std::clamp(framesPerSecond, kLeastRate, kMostRate) : 60.0);
}

bool isFinite(const Energies& energies)
{
  return std::isfinite(energies.total());
}

} // namespace

SimRunner::SimRunner(double frameRate, TripleBuffer<ToolState>& tool, TripleBuffer<ContactModel>& contact)
  : m_tool(tool), m_contact(contact), m_period(periodOf(frameRate))
{}

// === Commands

void SimRunner::apply(SimCommand&& command)
{
  std::visit([this](auto&& content) { carryOut(std::forward<decltype(content)>(content)); },
             std::move(command));
}

void SimRunner::carryOut(command::Load&& load)
{
  QualityLadder ladder = m_ladder;
  ladder.start(load.settings);
  load.settings.tolerance = ladder.tolerance();
  load.settings.effort = ladder.effort();
  load.settings.workLimit = 0.0; // the clock and the effort bound it
  const bool isAuto = load.settings.solver == "auto";
  load.settings.keepsTime = true;
  load.settings.threads = std::max(load.settings.threads, kThreads);
  Result<Simulation> fresh =
    Simulation::create(std::move(load.net), std::move(load.loads), std::move(load.settings));
  if (!fresh) {
    m_message = "The net was not taken, the former one goes on: " + fresh.error().detail;
    return;
  }
  closeScene();
  m_grip.reset();
  m_simulation.emplace(std::move(*fresh));
  m_links.forget();
  m_compliance.forget();
  m_told.begin(m_simulation->state().position);
  m_tip.reset();
  if (m_touch) m_tip.emplace(m_simulation->net(), m_touch->radius, m_touch->maxForce);
  m_ladder = std::move(ladder);
  m_auto = isAuto;
  m_generation = load.generation;
  m_playing = m_stepPending = m_failed = false;
  m_report = {};
  m_roughUntil = -1.0;
  m_message.clear();
  keepPicture();
  // What it took to make a large one, and the former one, would else stay with the heap.
  if (m_simulation->net().nodeCount() > kLargeNet) giveBackFreeMemory();
}

void SimRunner::carryOut(command::SetParameters&& change)
{
  if (!m_simulation) return;
  if (const Status status = m_simulation->setParameters(std::move(change.net)); !status)
    return refuseParameters(status);
  m_links.forgetAnchors();
  if (m_grip) m_grip->adapt(m_simulation->net());
  if (m_tip) m_tip->adapt(m_simulation->net());
  m_compliance.forget();
  ++m_edition;
  m_failed = false;
  m_message.clear();
  keepPicture();
}

/// All at once, but each is judged by itself: one that is refused takes no other along.
void SimRunner::carryOut(const command::PatchParameters& change)
{
  if (!m_simulation) return;
  bool allTaken = true;
  ParameterPatch sum;
  for (const std::shared_ptr<const ParameterPatch>& patch : change.patches) {
    if (const Status status = checkPatch(*patch, m_simulation->net()); !status) {
      refuseParameters(status);
      allTaken = false;
    } else {
      sum.append(*patch);
    }
    // What comes next may speak of anchors that only it brings.
    if (patch->anchorSet || patch == change.patches.back()) {
      if (!sum.isEmpty()) allTaken = takePatch(sum) && allTaken;
      sum = {};
    }
  }
  if (allTaken) m_message.clear();
}

bool SimRunner::takePatch(const ParameterPatch& patch)
{
  const Result<ParameterChange> change = m_simulation->setParameters(patch);
  if (!change) {
    refuseParameters(change.error());
    return false;
  }
  const SpringNet& net = m_simulation->net();
  if (change->otherAnchors) m_links.forgetAnchors();
  if (change->everything) {
    if (m_grip) m_grip->adapt(net);
    if (m_tip) m_tip->adapt(net);
    m_compliance.forget();
  } else {
    if (m_grip) m_grip->adapt(net, change->nodes, m_links);
    if (m_tip) m_tip->adapt(net, change->nodes, m_links);
    m_compliance.adapt(change->nodes);
  }
  ++m_edition;
  m_failed = false;
  keepPicture(*change);
  return true;
}

void SimRunner::refuseParameters(const Status& status)
{
  m_message = "The change was not taken, the former values hold: " + status.error().detail;
}

void SimRunner::carryOut(command::Play)
{
  if (!m_simulation) return;
  m_playing = true;
  if (std::exchange(m_failed, false)) m_message.clear();
}

void SimRunner::carryOut(command::Pause)
{
  m_playing = m_stepPending = false;
  closeScene();
}

void SimRunner::carryOut(command::StepOnce)
{
  if (!m_simulation) return;
  m_playing = false;
  m_stepPending = true;
  if (std::exchange(m_failed, false)) m_message.clear();
  closeScene();
}

void SimRunner::carryOut(command::Reset)
{
  if (!m_simulation) return;
  closeScene();
  m_grip.reset();
  if (m_tip) m_tip->letGo();
  m_simulation->setTools({});
  m_simulation->reset();
  m_told.begin(m_simulation->state().position);
  m_failed = m_stepPending = false;
  m_report = {};
  m_roughUntil = -1.0;
  m_message.clear();
  keepPicture();
}

void SimRunner::carryOut(const command::SetFrameRate& rate)
{
  m_period = periodOf(rate.framesPerSecond);
}

void SimRunner::carryOut(command::SetQuality&& quality)
{
  m_ladder.setPlan(std::move(quality.plan));
  applyAccuracy();
}

void SimRunner::carryOut(const command::Grab& grab)
{
  // The window may still show an older net than the one that runs: such a node is no fault, only too late.
  if (!m_simulation || grab.node < 0 || grab.node >= m_simulation->net().nodeCount()) return;
  if (m_contactActive) closeScene();
  m_grip.emplace(m_simulation->net(), m_simulation->state().position, grab.node, grab.radius, grab.target,
                 grab.maxForce);
  m_hand = m_grip->target();
  m_told.begin(m_simulation->state().position);
}

void SimRunner::carryOut(const command::MoveGrab& move)
{
  if (m_grip && !m_followDevice && move.target.allFinite()) m_hand = move.target;
}

void SimRunner::carryOut(command::Release)
{
  if (m_tip && m_grip)
    closeScene();
  else
    endContact();
  m_grip.reset();
  if (m_simulation) m_simulation->setTools({});
}

void SimRunner::carryOut(const command::FollowDevice& follow)
{
  if (m_tip && follow.on != m_followDevice) closeScene();
  m_followDevice = follow.on;
  if (follow.on) return;
  endContact();
  if (m_tip) m_tip->letGo();
  if (m_simulation && !m_grip) m_simulation->setTools({});
}

void SimRunner::carryOut(const command::Touch& touch)
{
  const bool sameBall = touch.on && m_touch && m_touch->radius == touch.radius;
  m_touch.reset();
  if (touch.on) m_touch = touch;
  if (sameBall && m_tip) return m_tip->setMaxForce(touch.maxForce);
  closeScene();
  m_tip.reset();
  if (!m_simulation) return;
  if (!m_grip) m_simulation->setTools({});
  if (touch.on) m_tip.emplace(m_simulation->net(), touch.radius, touch.maxForce);
}

// === Motion

double SimRunner::runFrame(const std::function<bool()>& enough)
{
  if (!wantsFrame()) return 0.0;
  m_stepPending = false;
  const StepReport report = deviceLeads() ? advanceLed(enough)
                            : m_grip      ? advanceHeld(m_hand, enough)
                                          : advance(m_period, enough);
  judge(report);
  if (report.nothingMoved()) {
    keepMoment();
  } else {
    keepPicture();
    m_told.add(m_picture.position, m_simulation->livingError(), report.simulatedTime);
  }
  if (m_playing) publishContact();
  return report.simulatedTime;
}

void SimRunner::keepTime(double took)
{
  if (m_playing && m_simulation && m_ladder.endFrame(took, m_period, m_report.nothingMoved()))
    applyAccuracy();
}

void SimRunner::applyAccuracy()
{
  if (!m_simulation) return;
  if (const Status status = m_simulation->setAccuracy(m_ladder.tolerance(), m_ladder.effort()); !status)
    m_message = "The accuracy was not taken, the former one holds: " + status.error().detail;
}

bool SimRunner::deviceLeads()
{
  return (m_grip || m_tip) && m_followDevice && m_tool.latest().sequence != 0;
}

/// What the hand holds goes evenly to where it is now. A frame that was broken off has left it behind.
StepReport SimRunner::advanceHeld(const Eigen::Vector3d& hand, const std::function<bool()>& enough)
{
  m_grip->leadTo(hand, m_period);
  pull();
  const StepReport report = advance(m_period, enough);
  m_grip->endLead(report.simulatedTime);
  return report;
}

/// Along the way that the device's hand went since the last frame: what it holds evenly, the ball a piece at a time, as
/// each asks anew whether it still touches. In one leap light tissue would ring, and be felt in whatever phase of it
/// the frame ends. A frame that was broken off has left the hand behind; then the leap is what catches up.
StepReport SimRunner::advanceLed(const std::function<bool()>& enough)
{
  const ToolState& tool = m_tool.latest();
  const Eigen::Vector3d from = m_grip ? m_grip->target() : m_tip->hand(), way = tool.position - from;
  const bool leaps =
    !m_handIsThere || way.norm() > kFastestHand * m_period || (deviceTouches() && !m_tip->isLed());
  m_hand = tool.position; // goes on from there when the device no longer leads
  if (m_grip && !leaps) {
    const StepReport report = advanceHeld(tool.position, enough);
    m_handIsThere = report.good() && !report.interrupted;
    return report;
  }
  const bool isFree = deviceTouches() && m_tip->gap() > way.norm();
  const int pieces = leaps || isFree ? 1 : static_cast<int>(std::ceil(m_period / kLeadTime));
  m_handIsThere = false;
  StepReport sum;
  for (int i = 1; i <= pieces; ++i) {
    moveTool(from + way * (static_cast<double>(i) / pieces), leaps ? tool.velocity : way / m_period);
    // Tissue that is held comes after the hand first, and is then asked whether it still touches.
    if (deviceTouches() && (leaps || !m_tip->pulls())) m_tip->update(m_simulation->state());
    pull();
    const StepReport piece = advance(m_period / pieces, enough);
    sum.add(piece);
    if (!piece.good()) return sum;
    if (deviceTouches()) m_tip->update(m_simulation->state());
    if (i < pieces && enough && enough()) return sum;
  }
  m_handIsThere = true;
  return sum;
}

void SimRunner::moveTool(const Eigen::Vector3d& hand, const Eigen::Vector3d& velocity)
{
  if (m_grip)
    m_grip->moveTo(hand, velocity);
  else
    m_tip->moveTo(hand, velocity);
}

/// At the net as it is now, with whichever tool there is.
void SimRunner::pull()
{
  const NetState& state = m_simulation->state();
  if (m_grip) {
    m_simulation->setTools(m_grip->springs(state));
  } else if (deviceTouches() && m_tip->pulls()) {
    m_simulation->setTools(m_tip->springs(state));
  } else {
    m_simulation->setTools({});
  }
}

/// A frame that is broken off is a slow one, no fault of the net.
StepReport SimRunner::advance(double interval, const std::function<bool()>& enough)
{
  StepReport report = m_simulation->advance(interval, {0, enough});
  m_brokenOff = report.interrupted;
  if (report.interrupted) report.stepLimit = false;
  return report;
}

void SimRunner::judge(const StepReport& report)
{
  m_report = report;
  if (report.rough)
    m_roughUntil = m_simulation->state().time;
  else if (report.nothingMoved())
    m_roughUntil = -1.0;
  const bool stayedFinite = report.nothingMoved() || m_simulation->state().position.allFinite();
  if (!report.good() || !stayedFinite) stopWith(m_simulation->why());
}

void SimRunner::stopWith(std::string message)
{
  m_failed = true;
  m_playing = m_stepPending = false;
  m_message = std::move(message);
  closeScene();
}

void SimRunner::keepPicture()
{
  const NetState& state = m_simulation->state();
  keepMoment();
  if (!state.position.allFinite()) return;
  ++m_picture.revision;
  m_picture.position = state.position;
  Eigen::ArrayXd& tension = m_picture.tension;
  tension.resize(m_simulation->net().springCount());
  m_simulation->springTensions(tension);
  if (!tension.allFinite()) tension = tension.isFinite().select(tension, 0.0);
  if (const Energies energies = m_simulation->energies(); isFinite(energies)) m_energies = energies;
}

/// Nothing has moved: only tensions are others, and energies.
void SimRunner::keepPicture(const ParameterChange& change)
{
  Eigen::ArrayXd& tension = m_picture.tension;
  if (change.everything || tension.size() != m_simulation->net().springCount()) return keepPicture();
  keepMoment();
  if (change.isNone()) return;
  ++m_picture.revision;
  m_simulation->springTensions(change.springs, tension);
  for (const Index spring : change.springs)
    if (!std::isfinite(tension[spring])) tension[spring] = 0.0;
  const Energies energies{m_energies.kinetic + change.energies.kinetic,
                          m_energies.elastic + change.energies.elastic,
                          m_energies.gravity + change.energies.gravity};
  if (isFinite(energies)) m_energies = energies;
}

void SimRunner::keepMoment()
{
  m_time = m_simulation->state().time;
  if (!std::exchange(m_brokenOff, false)) m_why = m_simulation->why();
}

/// Each frame, be it that nothing is touched: silence would be taken for a dead simulation.
void SimRunner::publishContact()
{
  const NetState& state = m_simulation->state();
  ContactModel model;
  if (deviceFeels() && m_grip)
    model = m_grip->contactModel(state, m_compliance.at(*m_simulation, m_grip->point(), m_links));
  else if (deviceFeels() && m_tip->isNear())
    model = m_tip->contactModel(state, m_compliance.at(*m_simulation, m_tip->point(), m_links));
  if (!model.force.allFinite() || !model.stiffness.allFinite()) model = {};
  if (m_scene == 0) m_scene = ++m_sceneCount;
  publish(model);
}

/// Nothing is touched or held any more; the tissue moves on.
void SimRunner::endContact()
{
  if (m_contactActive) publish({});
}

/// The tissue stands still, or another one or another tool comes: whatever is felt next begins softly.
void SimRunner::closeScene()
{
  if (m_scene == 0) return;
  m_scene = 0;
  publish({});
}

void SimRunner::publish(ContactModel model)
{
  model.sequence = ++m_contactSequence;
  model.scene = m_scene;
  model.edition = m_edition;
  model.time = m_time;
  m_contactActive = model.active;
  m_contact.back() = model;
  m_contact.publish();
}

/// Without the clock: SimThread knows who is behind it.
Stability SimRunner::stability() const
{
  if (!m_simulation) return Stability::Idle;
  if (m_failed) return Stability::Stopped;
  const QualityState quality = m_ladder.state();
  const std::string& solver = m_simulation->solverName();
  if (m_report.rough || quality.tolerance > quality.wantedTolerance) return Stability::Rough;
  return m_auto && solver == "implicit" ? Stability::Implicit : Stability::Good;
}

void SimRunner::draw(SimSnapshot& picture)
{
  static_cast<NetPicture&>(picture) = m_picture;
  picture.generation = m_generation;
  picture.playing = m_playing;
  picture.time = m_time;
  picture.stability = stability();
  picture.quality = m_ladder.state();
  picture.report = m_report;
  picture.toldError = m_told.share();
  picture.roughUntil = m_roughUntil;
  picture.energies = m_energies;
  picture.solver = m_simulation ? m_simulation->solverName() : std::string();
  picture.message = m_message.empty() ? m_why : m_message;
  picture.grabbedNode = m_grip ? m_grip->node() : kNoIndex;
  picture.heldNodes.clear();
  if (m_grip) picture.heldNodes = m_grip->point().node;
  picture.toolPosition.setZero();
  picture.toolForce.setZero();
  picture.tipRadius = 0.0;
  picture.tipTouches = false;
  picture.tipPosition.setZero();
  if (!m_simulation) return; // nor a tool
  const NetState& state = m_simulation->state();
  if (m_grip) {
    picture.toolPosition = m_grip->target();
    picture.toolForce = m_grip->forceOnHand(state);
  } else if (deviceTouches()) {
    picture.toolPosition = m_tip->hand();
    picture.toolForce = m_tip->forceOnHand(state);
    picture.tipRadius = m_tip->radius();
    picture.tipTouches = m_tip->touches();
    picture.tipPosition = m_tip->proxy();
  }
}

} // namespace esm
