// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace esm {

/// What supports have put in while Descent moved the net, until the frame ends [J].
///
/// Descent moves the supports first, all their way, and lets the net follow in steps. What they stretch on
/// that way and the net gives up again before the frame ends was never in the motion that is seen. So it is
/// lent: what steps lose pays it back before it counts as a loss, and work of the supports is only what has
/// become heat of it and what is left of it in the end.
///
/// A jump may lend 1e57 J to a net that ends with some millijoules. Where a figure may be the rounding of
/// such sums, it is no more than the net has left, or had of its own.
class SupportLoan {
public:
  bool isOpen() const noexcept { return m_owed > 0.0; }
  double owed() const noexcept { return m_owed; }
  /// @param own  that the net had before
  void lend(double energy, double own) noexcept
  {
    if (!isOpen()) m_own = own;
    m_owed += energy;
    m_most = std::max(m_most, m_owed);
  }
  /// Energy is gone without heat. @return what of it was the net's own.
  double payBack(double lost) noexcept
  {
    const double paid = std::min(lost, m_owed), rest = lost - paid;
    m_owed -= paid;
    if (!mayBeRounding(rest)) return rest;
    const double own = std::min(rest, m_own);
    m_own -= own;
    return own;
  }
  /// Heat has been made. @return what of it was lent.
  double turnToHeat(double heat) noexcept
  {
    const double made = std::clamp(heat, 0.0, m_owed);
    m_owed -= made;
    return made;
  }
  /// The net has no more than this left.
  void boundBy(double left) noexcept
  {
    if (mayBeRounding(m_owed)) m_owed = std::min(m_owed, left);
  }
  /// The frame ends. @return what is left of the loan, from now on in the motion that is seen.
  double close() noexcept
  {
    const double left = m_owed;
    *this = {};
    return left;
  }

private:
  bool mayBeRounding(double energy) const noexcept
  {
    constexpr double kRounding = 1e-9; // of sums over steps
    return energy <= kRounding * m_most;
  }

  double m_owed = 0.0;
  double m_most = 0.0; ///< in this frame so far
  double m_own = 0.0;  ///< of the net, when the loan began
};

/// What a motion has exchanged since t = 0: sums over the trajectory, integrated with the step's own
/// quadrature [J].
struct EnergySums {
  double work = 0.0;     ///< done by nodal forces, motions and tools
  double heat = 0.0;     ///< made by dampers, and where a motion ends
  double loss = 0.0;     ///< taken away by the method, as it estimates itself; negative where it adds
  double restored = 0.0; ///< given to bodies that nothing holds with the momentum that steps had taken
  SupportLoan loan;      ///< not yet in `work`

  /// A stretch in which supports may have lent: `lost` has gone without heat, `made` has become heat, whose
  /// sum is kept by the caller, and `left` is what the net has.
  void settle(double lost, double made, double left) noexcept
  {
    loss += loan.payBack(lost);
    work += loan.turnToHeat(made);
    loan.boundBy(left);
  }
  /// Somebody looks at the motion.
  void endFrame() noexcept { work += loan.close(); }
};

} // namespace esm
