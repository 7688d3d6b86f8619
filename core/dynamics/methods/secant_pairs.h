// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/node_array.h"

#include <array>

namespace esm {

/// What the last steps of a Newton iteration have shown of its symmetric matrix A, so that an old factor of
/// it serves longer: limited-memory BFGS (Nocedal 1980, Math. Comp. 35) that starts from that factor, as Liu,
/// Bouaziz and Kavan (2017, ACM Trans. Graph. 36) do with a constant one. With B the old matrix, a change is
///
///     fold(r);   solve B z = r;   unfold(z)        instead of        solve B z = r
///
/// which is the inverse of a matrix that is as symmetric and positive as B, and right for the last pair:
/// what lets the residual fall by y is answered with the step s that did.
/// @note Threads: one at a time.
class SecantPairs {
public:
  static constexpr std::size_t kMost = 8; ///< pairs that are kept

  /// Forgets all; the next vectors may be of another size. A pair takes its room when it first comes: methods that
  /// are weighed and not used have none.
  void clearAll() noexcept;
  void clear() noexcept { m_count = 0; }
  /// After the step fraction * change [m/s], by which the residual went from `before` to `after` [N s]. Keeps
  /// it, in place of the oldest, unless A had no positive curvature along it.
  void add(const NodeArray& change, double fraction, const NodeArray& before, const NodeArray& after);
  void fold(NodeArray& residual) noexcept;
  void unfold(NodeArray& change) noexcept;

private:
  struct Pair {
    NodeArray step, drop;   ///< s, y
    double curvature = 0.0; ///< s.y
    double share = 0.0;     ///< of s that fold() has answered
  };
  /// @param age  0 = the newest, < m_count.
  Pair& pair(std::size_t age) noexcept { return m_pairs[(m_next + kMost - 1 - age) % kMost]; }

  std::array<Pair, kMost> m_pairs;
  std::size_t m_count = 0, m_next = 0;
};

} // namespace esm
