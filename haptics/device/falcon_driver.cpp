// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/device/falcon_driver.h"

#include "haptics/protocol/ftdi.h"
#include "haptics/zero_reports.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

namespace {

constexpr int kInTransfers = 4; ///< waiting at any time, so that no reply waits for us
constexpr std::size_t kInSize = 64;
constexpr double kProbeTime = 0.5;     ///< [s]; a running device answers within a few ms
constexpr double kProbeEvery = 0.02;   ///< [s]
constexpr double kResendAfter = 0.005; ///< [s] without a reply
constexpr int kLongestJump = 600;      ///< counts between two replies; 600 are 4 m/s and more
constexpr int kUnhomedReplies = 2;
constexpr int kHomedReplies = 3;         ///< in a row before it is believed
constexpr double kLargestForce = 1000.0; ///< [N]; far beyond full scale, far below overflow

} // namespace

std::array<std::int16_t, 3> falconMotors(const Delta3& mechanism, const Eigen::Vector3d& position,
                                         const Eigen::Vector3d& angles, const Eigen::Vector3d& force) noexcept
{
  if (!force.allFinite()) return {};
  const double largest = force.cwiseAbs().maxCoeff();
  const Eigen::Vector3d bounded =
    largest > kLargestForce ? Eigen::Vector3d(force / largest * kLargestForce) : force;
  Eigen::Vector3d torques;
  if (!mechanism.torques(position, angles, bounded, torques)) return {};
  return falcon::motorWords(torques);
}

FalconDriver::FalconDriver(DriverProfile profile, std::unique_ptr<Wakeup> wakeup,
                           std::unique_ptr<UsbHandle> handle, std::vector<std::uint8_t> image)
  : m_profile(std::move(profile)), m_handle(std::move(handle)), m_image(std::move(image))
{
  m_wakeup = std::move(wakeup);
  enter(DevicePhase::Opening);
}

void FalconDriver::enter(DevicePhase phase) noexcept
{
  m_state.report.phase = phase;
  m_state.report.reason = "";
  m_state.report.unhomed = phase == DevicePhase::NeedsHome ? falcon::kHomedAll : std::uint8_t{0};
  switch (phase) {
  case DevicePhase::Opening:
    m_state.report.reason = "Asking the device whether it runs already";
    break;
  case DevicePhase::Upload:
    m_state.report.reason = "Uploading the firmware";
    break;
  case DevicePhase::NeedsHome:
    m_state.report.reason = "Pull the grip all the way out, then push it all the way in";
    break;
  default:
    break;
  }
  if (phase != DevicePhase::Lost)
    m_state.link = phase == DevicePhase::Running ? DeviceLink::Ready : DeviceLink::NeedsHome;
}

void FalconDriver::fail(const char* reason) noexcept
{
  enter(DevicePhase::Fault);
  m_state.report.reason = reason;
}

void FalconDriver::lose() noexcept
{
  enter(DevicePhase::Lost);
  m_state.report.reason = "The device was unplugged";
  m_state.link = DeviceLink::Lost;
}

bool FalconDriver::request(const UsbSetup& setup) noexcept
{
  const UsbStatus status = m_handle->control(setup, {}).status;
  if (status == UsbStatus::Ok) return true;
  if (status == UsbStatus::Lost)
    lose();
  else
    fail("The device refuses its serial settings; plug it out and in again");
  return false;
}

void FalconDriver::keepListening() noexcept
{
  while (m_listening < kInTransfers && m_handle->submitIn(kInSize)) ++m_listening;
}

void FalconDriver::step(double now, const Eigen::Vector3d& force, bool fresh) noexcept
{
  if (m_state.report.phase == DevicePhase::Lost) return;
  if (!m_started) {
    m_started = true;
    startProbe(now);
  }
  drain(now);
  if (m_handle->lost()) return lose();
  switch (m_state.report.phase) {
  case DevicePhase::Opening:
    probe(now);
    break;
  case DevicePhase::Upload:
    upload(now);
    break;
  case DevicePhase::NeedsHome:
  case DevicePhase::Running:
    exchange(now, force, fresh);
    break;
  default:
    break;
  }
  keepListening();
}

void FalconDriver::drain(double now) noexcept
{
  while (m_handle->take(now, m_completion)) {
    if (m_completion.status == UsbStatus::Lost) return lose();
    if (m_completion.endpoint != m_handle->endpoints().in) continue;
    m_listening = std::max(m_listening - 1, 0);
    if (m_completion.status == UsbStatus::Ok) {
      ftdi::forEachPayload(m_completion.data(), [&](std::span<const std::uint8_t> payload) {
        if (m_upload) return m_upload->received(payload);
        for (const std::uint8_t byte : payload)
          if (m_parser.push(byte)) take(m_parser.reply(), now);
      });
    }
    keepListening();
  }
}

void FalconDriver::startProbe(double now) noexcept
{
  enter(DevicePhase::Opening);
  m_upload.reset();
  m_hasReply = m_awaiting = m_pending = m_doubted = false;
  m_homed = false;
  m_homeChange = 0;
  for (const UsbSetup& setup : {ftdi::latency(1), ftdi::k1500000Baud, ftdi::kPurgeReceived, ftdi::kPurgeSent})
    if (!request(setup)) return;
  keepListening();
  m_probeUntil = now + kProbeTime;
  m_sentAt = now - kProbeEvery;
}

void FalconDriver::probe(double now) noexcept
{
  if (m_hasReply) return enter(DevicePhase::NeedsHome);
  if (now >= m_probeUntil) {
    if (m_uploaded) return fail("The device took its firmware but does not answer; plug it out and in again");
    if (m_image.empty())
      return fail("The device needs its firmware: name the file of it in the settings of the device");
    m_upload.emplace(m_image);
    return enter(DevicePhase::Upload);
  }
  if (now - m_sentAt < kProbeEvery) return;
  falcon::Command idle;
  idle.homing = true;
  send(idle, now);
}

void FalconDriver::upload(double now) noexcept
{
  for (;;) {
    const falcon::UploadFsm::Action action = m_upload->next(now);
    m_state.report.progress = static_cast<float>(m_upload->progress());
    switch (action.step) {
    case falcon::UploadFsm::Step::Wait:
      return;
    case falcon::UploadFsm::Step::Control:
      if (!request(action.setup)) return;
      break;
    case falcon::UploadFsm::Step::Send:
      m_handle->submitOut(action.bytes); // if it does not leave, no echo comes, and the upload starts over
      return;
    case falcon::UploadFsm::Step::Done:
      m_uploaded = true;
      return startProbe(now);
    case falcon::UploadFsm::Step::Failed:
      return fail("The device does not take the firmware; switch it off and on, and check the file");
    }
  }
}

bool FalconDriver::send(const falcon::Command& command, double now) noexcept
{
  const falcon::Packet packet = falcon::encode(command);
  m_sentAt = now;
  return m_handle->submitOut(packet);
}

bool FalconDriver::plausible(const falcon::Reply& reply) noexcept
{
  bool jumped = false;
  for (std::size_t i = 0; m_hasReply && i < 3; ++i)
    jumped = jumped || std::abs(reply.encoder[i] - m_reply.encoder[i]) > kLongestJump;
  // A nibble that was changed on its way: only a second reply from over there is believed.
  m_doubted = jumped && !m_doubted;
  return !m_doubted;
}

void FalconDriver::take(const falcon::Reply& reply, double now) noexcept
{
  m_awaiting = false;
  ++m_exchanges;
  if (!plausible(reply)) return;
  m_state.heard = now;
  m_hasReply = true;
  m_reply = reply;
  const Eigen::Vector3d counts(reply.encoder[0], reply.encoder[1], reply.encoder[2]);
  m_angles = m_mechanism.anglesOfCounts(counts);
  m_mechanism.forward(m_angles, m_pose); // out of reach: the last pose stays
  m_state.sample.position = m_pose - m_profile.origin;
  m_state.sample.buttons = reply.buttons;

  const bool says = reply.homed == falcon::kHomedAll;
  m_homeChange = says == m_homed ? 0 : m_homeChange + 1;
  const bool wasHomed = m_homed;
  if (m_homeChange >= (says ? kHomedReplies : kUnhomedReplies)) {
    m_homed = says;
    m_homeChange = 0;
  }
  const bool homed = m_homed;
  if (homed && !wasHomed) {
    m_homedAt = now;
    ++m_state.sample.epoch;
  }
  if (m_state.report.phase == DevicePhase::Running && !homed) enter(DevicePhase::NeedsHome);
  if (m_state.report.phase == DevicePhase::NeedsHome)
    m_state.report.unhomed = static_cast<std::uint8_t>(falcon::kHomedAll & ~reply.homed);
  if (m_state.report.phase == DevicePhase::NeedsHome && homed && now - m_homedAt >= kSettleTime)
    enter(DevicePhase::Running);
}

void FalconDriver::exchange(double now, const Eigen::Vector3d& force, bool fresh) noexcept
{
  m_pending = m_pending || fresh;
  const double since = now - m_sentAt;
  const bool free = !m_awaiting || since > kResendAfter;
  if (!free || (!m_pending && since < kKeepAlive)) return;
  falcon::Command command;
  command.homing = true;
  const bool running = m_state.report.phase == DevicePhase::Running;
  if (running) command.motor = falconMotors(m_mechanism, m_pose, m_angles, force);
  command.leds = !running ? falcon::kRed : force.isZero(0.0) ? falcon::kGreen : falcon::kBlue;
  m_awaiting = send(command, now) || m_awaiting;
  m_pending = false;
}

void FalconDriver::close(double now) noexcept
{
  const DevicePhase phase = m_state.report.phase;
  if (!m_handle) return;
  if (phase == DevicePhase::NeedsHome || phase == DevicePhase::Running) {
    falcon::Command zero;
    zero.homing = true;
    zero.leds = falcon::kRed;
    for (int i = 0; i < kZeroReports; ++i) {
      send(zero, now);
      m_wakeup->wait(0.005);
      while (m_handle->take(now, m_completion)) {
      }
    }
  }
  m_handle.reset();
  lose();
  m_state.report.reason = "Closed";
}

void FalconDriver::sendLastZero() noexcept
{
  const DevicePhase phase = m_state.report.phase;
  if (phase != DevicePhase::NeedsHome && phase != DevicePhase::Running) return; // no motor moves yet
  falcon::Command zero;
  zero.homing = true;
  zero.leds = falcon::kRed;
  const falcon::Packet packet = falcon::encode(zero);
  for (int i = 0; i < kZeroReports; ++i) m_handle->sendAtLast({}, packet);
}

} // namespace esm
