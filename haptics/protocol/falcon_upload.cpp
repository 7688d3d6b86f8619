// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/protocol/falcon_upload.h"

#include "haptics/protocol/ftdi.h"

#include <algorithm>

namespace esm::falcon {

namespace {

constexpr std::array kPrepare{ftdi::kPurgeReceived, ftdi::kPurgeSent, ftdi::latency(16),
                              ftdi::k9600Baud,      ftdi::k8N1,       ftdi::kNoFlowControl,
                              ftdi::kRtsLow,        ftdi::kDtrLow,    ftdi::kDtrHigh};
constexpr std::array kFaster{ftdi::kDtrLow, ftdi::k142857Baud};
constexpr std::array<std::uint8_t, 3> kHello{0x0a, 0x43, 0x0d};
constexpr std::array<std::uint8_t, 4> kHelloAnswer{0x0a, 0x44, 0x2c, 0x0d};
constexpr std::array<std::uint8_t, 1> kReady{0x41};

} // namespace

void UploadFsm::restart() noexcept
{
  m_phase = m_attempt < kMostAttempts ? Phase::Prepare : Phase::Failed;
  if (m_phase == Phase::Prepare) ++m_attempt;
  m_control = m_sent = m_chunk = m_matched = 0;
  m_hellos = 0;
  m_answered = m_wrong = false;
}

UploadFsm::Action UploadFsm::send(std::span<const std::uint8_t> bytes, Phase then, double now,
                                  double timeout) noexcept
{
  m_phase = then;
  m_matched = 0;
  m_answered = false;
  m_deadline = now + timeout;
  return {Step::Send, {}, bytes};
}

UploadFsm::Action UploadFsm::next(double now) noexcept
{
  const bool late = now > m_deadline;
  switch (m_phase) {
  case Phase::Prepare:
    if (m_control < kPrepare.size()) return {Step::Control, kPrepare[m_control++], {}};
    m_phase = Phase::Hello;
    [[fallthrough]];
  case Phase::Hello:
    if (m_hellos++ < kMostHellos) return send(kHello, Phase::AwaitHello, now, kHelloTimeout);
    restart();
    return {};
  case Phase::AwaitHello:
    if (m_answered) {
      m_phase = Phase::Faster;
      m_control = 0;
    } else if (late) {
      m_phase = Phase::Hello;
    }
    return {};
  case Phase::Faster:
    if (m_control < kFaster.size()) return {Step::Control, kFaster[m_control++], {}};
    return send(kReady, Phase::AwaitReady, now, kEchoTimeout);
  case Phase::AwaitReady:
    if (m_answered)
      m_phase = Phase::Chunk;
    else if (late)
      restart();
    return {};
  case Phase::Chunk:
    if (m_sent == m_image.size()) {
      m_phase = Phase::Done;
      return {Step::Done, {}, {}};
    }
    m_chunk = std::min(ftdi::kPayloadSize, m_image.size() - m_sent);
    return send(m_image.subspan(m_sent, m_chunk), Phase::AwaitEcho, now, kEchoTimeout);
  case Phase::AwaitEcho:
    if (m_wrong || late) {
      restart();
    } else if (m_matched == m_chunk) {
      m_sent += m_chunk;
      m_phase = Phase::Chunk;
    }
    return {};
  case Phase::Done:
    return {Step::Done, {}, {}};
  case Phase::Failed:
    return {Step::Failed, {}, {}};
  }
  return {};
}

void UploadFsm::compareHello(std::uint8_t byte) noexcept
{
  if (byte == 0 && m_matched == 0) return; // some send one first
  m_matched = byte == kHelloAnswer[m_matched] ? m_matched + 1 : (byte == kHelloAnswer[0] ? 1u : 0u);
  if (m_matched < kHelloAnswer.size()) return;
  m_answered = true;
  m_matched = 0;
}

void UploadFsm::received(std::span<const std::uint8_t> payload) noexcept
{
  for (const std::uint8_t byte : payload) {
    switch (m_phase) {
    case Phase::AwaitHello:
      if (!m_answered) compareHello(byte);
      break;
    case Phase::AwaitReady:
      m_answered = m_answered || byte == kReady[0];
      break;
    case Phase::AwaitEcho:
      if (m_matched == m_chunk || byte != m_image[m_sent + m_matched])
        m_wrong = true;
      else
        ++m_matched;
      break;
    default: // nobody waits for it
      break;
    }
  }
}

double UploadFsm::progress() const noexcept
{
  return m_image.empty() ? 0.0 : static_cast<double>(m_sent) / static_cast<double>(m_image.size());
}

} // namespace esm::falcon
