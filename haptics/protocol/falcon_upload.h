// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/protocol/usb_setup.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace esm::falcon {

/// Brings the Falcon's firmware into the device: it forgets it with each power-off.
///
///     purge, 9600 baud, DTR toggle -> "\n C \r" until it answers -> 142857 baud, 'A' -> image in chunks,
///     each compared with its echo -> done;   a wrong or missing echo: all again
///
/// Says what to send and is told what came; no USB, no clock of its own, no allocation. Known to be flaky on
/// real devices, so it starts over kMostAttempts times before it gives up.
/// @note One thread.
class UploadFsm {
public:
  static constexpr int kMostAttempts = 20;
  static constexpr int kMostHellos = 100;       ///< per attempt
  static constexpr double kHelloTimeout = 0.06; ///< [s]; the chip holds short answers for 16 ms
  static constexpr double kEchoTimeout = 0.5;   ///< [s]

  enum class Step : std::uint8_t { Wait, Control, Send, Done, Failed };

  struct Action {
    Step step = Step::Wait;
    UsbSetup setup;                      ///< Control
    std::span<const std::uint8_t> bytes; ///< Send; valid while the image is
  };

  /// @param image stays the caller's and must outlive this.
  explicit UploadFsm(std::span<const std::uint8_t> image) noexcept : m_image(image) {}

  Action next(double now) noexcept;                              ///< what to do now
  void received(std::span<const std::uint8_t> payload) noexcept; ///< bytes from the device

  double progress() const noexcept; ///< 0 ... 1
  int attempts() const noexcept { return m_attempt; }

private:
  enum class Phase : std::uint8_t {
    Prepare,
    Hello,
    AwaitHello,
    Faster,
    AwaitReady,
    Chunk,
    AwaitEcho,
    Done,
    Failed
  };

  void restart() noexcept;
  Action send(std::span<const std::uint8_t> bytes, Phase then, double now, double timeout) noexcept;
  void compareHello(std::uint8_t byte) noexcept;

  std::span<const std::uint8_t> m_image;
  Phase m_phase = Phase::Prepare;
  std::size_t m_control = 0; ///< next of the phase's control requests
  std::size_t m_sent = 0;    ///< of the image, echoed
  std::size_t m_chunk = 0;   ///< size of the one on its way
  std::size_t m_matched = 0; ///< of the answer or echo
  int m_attempt = 1, m_hellos = 0;
  bool m_answered = false, m_wrong = false;
  double m_deadline = 0.0;
};

} // namespace esm::falcon
