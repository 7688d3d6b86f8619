// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/triple_buffer.h"

#include <Eigen/Core>

#include <cstdint>

namespace esm {

/// Where the hand on a simulated device wants to be.
struct HandPose {
  Eigen::Vector3d target = Eigen::Vector3d::Zero(); ///< [m]
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< where the last jump went [m]
  std::uint32_t placeCount = 0;                     ///< rises with each jump
};

/// A hand that holds a simulated device: a script in tests, the mouse in the window.
class Hand {
public:
  virtual ~Hand() = default;
  virtual HandPose pose(double time) noexcept = 0; ///< servo thread, wait-free
};

/// The hand that the mouse leads.
/// @note Threads: moveTo() and placeAt() on one thread, pose() on the servo thread.
class MouseHand final : public Hand {
public:
  /// Non-finite targets are ignored.
  void moveTo(const Eigen::Vector3d& target)
  {
    if (!target.allFinite()) return;
    m_wanted.target = target;
    send();
  }
  /// The hand lets go, and takes hold again at rest over there.
  void placeAt(const Eigen::Vector3d& position)
  {
    if (!position.allFinite()) return;
    m_wanted.target = m_wanted.place = position;
    ++m_wanted.placeCount;
    send();
  }
  HandPose pose(double) noexcept override { return m_buffer.latest(); }

private:
  void send()
  {
    m_buffer.back() = m_wanted;
    m_buffer.publish();
  }

  HandPose m_wanted;
  TripleBuffer<HandPose> m_buffer;
};

} // namespace esm
