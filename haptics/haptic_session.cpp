// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/haptic_session.h"

#include "haptics/device_registry.h"
#include "haptics/hand.h"
#include "haptics/servo_loop.h"

#include <exception>
#include <utility>

namespace esm {

std::string reasonText(ServoReason reason)
{
  switch (reason) {
  case ServoReason::Plain:
    return {};
  case ServoReason::NeedsHome:
    return "The device does not know its position yet; move its grip out and in once";
  case ServoReason::ForceTooLarge:
    return "Force waits until it would begin below 0.2 N; move the tool away from the tissue";
  case ServoReason::NoScene:
    return "No tissue moves: there is no model, or the simulation is paused";
  case ServoReason::NoContact:
    return "Nothing is touched or held";
  case ServoReason::LateModel:
    return "The simulation answers late: the force goes on by its last answer; a model with fewer nodes or a "
           "larger allowed error helps";
  case ServoReason::StaleModel:
    return "The simulation answers too late to be felt: the scene is too heavy for this computer; a model "
           "with fewer nodes or a larger allowed error helps; force comes back after five answers in time";
  case ServoReason::EmergencyStop:
    return "Stopped by the user; arm again to go on";
  case ServoReason::BadModel:
    return "The simulation sent a force that is not a number; reset it, then arm again";
  case ServoReason::EnergyTooHigh:
    return "The force gave the hand more energy than the tissue holds; lower the gain or the stiffness, then "
           "arm again";
  case ServoReason::NoReply:
    return "The device does not reply; check its cable, then arm again";
  case ServoReason::DeviceLost:
    return "The device was unplugged; connect it and open it again";
  case ServoReason::Closed:
    return "The device is closed";
  }
  return {};
}

namespace {

std::string priorityText(ServoPriority priority)
{
  switch (priority) {
  case ServoPriority::RealTime:
    return "real-time";
  case ServoPriority::Raised:
    return "raised";
  case ServoPriority::Normal:
    return "normal";
  }
  return {};
}

} // namespace

struct HapticSession::Impl {
  Impl(std::unique_ptr<HapticDevice> device, TripleBuffer<ToolState>& tool,
       TripleBuffer<ContactModel>& contact)
    : name(device->profile().name), loop(std::move(device), std::make_unique<SteadyClock>(), tool, contact)
  {}

  std::string name;
  ServoLoop loop;
};

HapticSession::HapticSession(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}

HapticSession::~HapticSession() = default;

std::vector<std::string> HapticSession::deviceNames()
{
  std::vector<std::string> names;
  for (const DeviceKind& kind : deviceKinds()) names.emplace_back(kind.name);
  return names;
}

Result<std::unique_ptr<HapticSession>> HapticSession::open(const std::string& device,
                                                           TripleBuffer<ToolState>& tool,
                                                           TripleBuffer<ContactModel>& contact,
                                                           const DeviceOptions& options)
{
  Result<std::unique_ptr<HapticDevice>> opened = openDevice(device, options);
  if (!opened) return opened.error();
  return start(std::move(*opened), tool, contact);
}

Result<std::unique_ptr<HapticSession>> HapticSession::start(std::unique_ptr<HapticDevice> device,
                                                            TripleBuffer<ToolState>& tool,
                                                            TripleBuffer<ContactModel>& contact)
{
  const std::string name = device->profile().name;
  try {
    auto impl = std::make_unique<Impl>(std::move(device), tool, contact);
    impl->loop.start();
    return std::unique_ptr<HapticSession>(new HapticSession(std::move(impl)));
  } catch (const std::exception& trouble) { // no memory or no thread to be had
    return Error{ErrorCode::NoDevice, "The device '" + name + "' could not be started: " + trouble.what()};
  }
}

void HapticSession::arm()
{
  m_impl->loop.core().orders().give(ForceOrder::Arm);
}

void HapticSession::disarm()
{
  m_impl->loop.core().orders().give(ForceOrder::Disarm);
}

void HapticSession::emergencyStop()
{
  m_impl->loop.core().orders().give(ForceOrder::Stop);
}

void HapticSession::setForceLimit(double newtons)
{
  m_impl->loop.core().setForceLimit(newtons);
}

void HapticSession::setForceScale(double scale)
{
  m_impl->loop.core().setForceScale(scale);
}

void HapticSession::moveHand(const Eigen::Vector3d& target)
{
  if (MouseHand* hand = m_impl->loop.device().mouseHand()) hand->moveTo(target);
}

void HapticSession::placeHand(const Eigen::Vector3d& position)
{
  if (MouseHand* hand = m_impl->loop.device().mouseHand()) hand->placeAt(position);
}

void HapticSession::requestHome()
{
  m_impl->loop.device().requestHome();
}

DeviceReport HapticSession::report() const
{
  return m_impl->loop.device().report();
}

const DeviceProfile& HapticSession::profile() const
{
  return m_impl->loop.device().profile();
}

bool HapticSession::ledByMouse() const
{
  return m_impl->loop.device().mouseHand() != nullptr;
}

HapticStatus HapticSession::status()
{
  const ServoStatus& servo = m_impl->loop.core().status();
  HapticStatus status;
  status.state = servo.state;
  status.device = m_impl->name;
  status.reason = reasonText(servo.reason);
  status.priority = priorityText(m_impl->loop.priority());
  status.rate = servo.rate;
  status.worstLateness = servo.worstLateness;
  status.lateTicks = servo.lateTicks;
  status.ticks = servo.ticks;
  status.position = servo.position;
  status.force = servo.force;
  status.forceLimit = servo.forceLimit;
  status.generated = servo.generated;
  status.tickTime = servo.tickTime;
  return status;
}

JitterCounts HapticSession::jitter() const
{
  return m_impl->loop.jitter();
}

void HapticSession::takeTrace(std::vector<TraceSample>& samples)
{
  m_impl->loop.core().trace().takeNew(samples);
}

} // namespace esm
