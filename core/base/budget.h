// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

namespace esm {

/// How much one Simulation::advance() may take. What it has done when that is spent is kept, as long as it is a
/// good state.
struct Budget {
  /// Substeps of each part of the net that moves on its own; 0: any number. Ends at the same one on every machine.
  std::int64_t steps = 0;
  /// Asked after each piece of work of kPiece or less: true ends the call there. For whoever keeps time with
  /// a clock, or may be called away. Must not throw; several threads ask, one at a time. Null: nobody is asked.
  /// Runs of steps that are longer than a piece are divided for it, which changes the last bits of some methods.
  std::function<bool()> isSpent = nullptr;

  /// Spring evaluations between two questions, about 2 ms of one core; a step of an explicit method and a
  /// force pass are not divided.
  static constexpr double kPiece = 250'000.0;
};

/// A budget's question, asked in the depth of a call: who has heard yes hears it until the call is over.
class Interruption {
public:
  Interruption() = default;
  explicit Interruption(const std::function<bool()>& isSpent) noexcept : m_isSpent(&isSpent) {}

  bool isPossible() const noexcept { return m_isSpent != nullptr && *m_isSpent != nullptr; }
  bool isDue() noexcept
  {
    m_isDue = m_isDue || (isPossible() && (*m_isSpent)());
    return m_isDue;
  }

private:
  const std::function<bool()>* m_isSpent = nullptr; ///< not owned
  bool m_isDue = false;
};

} // namespace esm
