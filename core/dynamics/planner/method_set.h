// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/method_facts.h"

#include <memory>
#include <string_view>

namespace esm {

/// The methods of the table, each laid out for the net when it is first needed.
/// @note One thread. layOut() may allocate.
class MethodSet final : public MethodFacts {
public:
  MethodSet();

  /// All is about this system from now on; it must live until the next call. Not owned.
  void setSystem(const System& system) noexcept { m_system = &system; }
  /// The bounds of the motion have changed.
  void tune(const FastestMode& mode);

  double limit(Method method) const noexcept override { return at(method).stableStep(m_mode); }
  double stepCost(Method method, double step) override { return at(method).stepCost(*m_system, step); }
  bool isLaidOut(Method method) const noexcept override { return m_methods[method].isLaidOut; }
  void layOut(Method method) override;

  Integrator& at(Method method) noexcept { return *m_methods[method].integrator; }
  const Integrator& at(Method method) const noexcept { return *m_methods[method].integrator; }
  static std::string_view nameOf(Method method) noexcept { return integratorTable()[method].name; }
  /// If there is one of that name.
  static std::optional<Method> find(std::string_view name) noexcept;

  void dropLayouts() noexcept; ///< another net, or other parameters
  void restart() noexcept;     ///< of all that are laid out
  void restart(Method method) noexcept;
  void toolsMoved() noexcept; ///< see Integrator
  void constraintsChanged();  ///< see Integrator

private:
  struct Entry {
    std::unique_ptr<Integrator> integrator;
    bool isLaidOut = false;
  };
  std::vector<Entry> m_methods; ///< in the table's order
  const System* m_system = nullptr;
  FastestMode m_mode;
};

} // namespace esm
