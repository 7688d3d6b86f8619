// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/learning/statics.h"

#include <array>
#include <span>

namespace esm::learning {

/// The numbers of a net that can be learned in statics.
enum class NetQuantity : std::uint8_t { Stiffness, LawParameter, RestLength, AnchorStiffness };
inline constexpr std::size_t kNetQuantityCount = 4;
const char* nameOf(NetQuantity quantity) noexcept; ///< "stiffness"
/// The array of a net that holds them: one entry per spring, or per anchor.
Eigen::ArrayXd& numbersOf(SpringNet& net, NetQuantity quantity) noexcept;
const Eigen::ArrayXd& numbersOf(const SpringNet& net, NetQuantity quantity) noexcept;

/// dL/d(number) for every number of a net, L any function of where its nodes rest.
struct NetGradient {
  std::array<Eigen::ArrayXd, kNetQuantityCount> of; ///< by NetQuantity: S, S, S, A
  explicit NetGradient(const SpringNet& net);
  Eigen::ArrayXd& operator[](NetQuantity quantity) noexcept { return of[static_cast<std::size_t>(quantity)]; }
  const Eigen::ArrayXd& operator[](NetQuantity quantity) const noexcept
  {
    return of[static_cast<std::size_t>(quantity)];
  }
};

/// A change of one number of a net.
struct NumberChange {
  NetQuantity quantity = NetQuantity::Stiffness;
  Index index = kNoIndex; ///< of the spring or anchor
  double amount = 0.0;
};

/// How the forces of a net in balance change with its numbers, and so how its place does: with F(x, p) = 0,
///
///     dx/dp = K^-1 dF/dp      (sensitivity: one solution for each change)
///     dL/dp = (K^-1 dL/dx) . dF/dp      (adjoint: one solution for all p, as K is symmetric)
///
/// A spring has dF/dp = +- u df/dp on its ends, an anchor dF/dk = - (x - p0). Exact; no factorisation of its own.
class StaticSlopes {
public:
  /// @param statics Balanced, with the numbers of `net`; must stay and rest there.
  StaticSlopes(Statics& statics, const SpringNet& net);

  /// Adds dL/dp. @param byPlace dL/dx [1/m], N; it becomes K^-1 dL/dx. One solution.
  void addGradient(NodeArray& byPlace, NetGradient& gradient);
  /// change = dx of the sum of all `changes` [m], N entries. One solution.
  void changeOfPlace(std::span<const NumberChange> changes, NodeArray& change);

private:
  Statics& m_statics;
  const SpringNet& m_net;
  NodeArray m_direction;               ///< S, u from a to b; 0 where nothing pulls
  std::vector<SpringSlopes> m_springs; ///< S
  NodeArray m_anchors;                 ///< A, - (x - p0)
};

} // namespace esm::learning
