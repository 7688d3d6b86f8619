// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/methods/integrator.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace esm {

/// Place of a method in the table.
using Method = std::size_t;

/// What a line of the table says of a method, see IntegratorEntry.
struct MethodTraits {
  MethodRole role = MethodRole::ByName;
  double order = 1.0;
  double typicalError = 0.0, offset = 0.0, typicalErrorOfWaves = 0.0;
  std::optional<Method> sharper = std::nullopt; ///< its twin

  /// Whether `auto` weighs it against others by cost.
  bool competes() const noexcept { return role == MethodRole::Explicit || role == MethodRole::Local; }
  bool isExplicit() const noexcept { return competes() || role == MethodRole::ExplicitByName; }
};

/// What methods can do on the net as it is now: all that a plan needs to know of them, so that plans can be made
/// and tested without a net.
class MethodFacts {
public:
  virtual ~MethodFacts() = default;

  std::size_t count() const noexcept { return m_traits.size(); }
  const MethodTraits& traits(Method method) const noexcept { return m_traits[method]; }
  Method plain() const noexcept { return m_plain; }       ///< one pass a step: the first explicit choice
  Method implicit() const noexcept { return m_implicit; } ///< where explicit ones are all too slow
  Method descent() const noexcept { return m_descent; }   ///< where that fails, too
  Method blocks() const noexcept { return m_blocks; }     ///< for whoever keeps time with a clock

  /// The largest stable step now, without a margin [s]; infinity if any is.
  virtual double limit(Method method) const noexcept = 0;
  /// Of a step of this length [s], in spring evaluations; of some methods only once they are laid out.
  virtual double stepCost(Method method, double step) = 0;
  virtual bool isLaidOut(Method method) const noexcept = 0;
  /// Makes what the method needs of the net, unless that is done; may be dear.
  virtual void layOut(Method method) = 0;

protected:
  MethodFacts() = default;
  MethodFacts(const MethodFacts&) = default;
  MethodFacts& operator=(const MethodFacts&) = default;
  MethodFacts(MethodFacts&&) = default;
  MethodFacts& operator=(MethodFacts&&) = default;

  std::vector<MethodTraits> m_traits;
  Method m_plain = 0, m_implicit = 0, m_descent = 0, m_blocks = 0;
};

} // namespace esm
