// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/bound_watch.h"
#include "core/dynamics/planner/method_facts.h"
#include "core/dynamics/planner/weighing.h"

#include <string>

namespace esm {

/// Says in words which method runs and why, and what helps where none does.
class StepReasons {
public:
  /// What runs, and what limits its steps.
  /// @param explicitStep  the largest that one force pass can take [s]
  void explain(const Choice& choice, bool isAuto, const MethodFacts& facts, const BoundWatch& bound,
               double explicitStep);
  void add(const char* words) { m_why += words; }
  void setName(Method method);

  void beginCall() { m_limitText.clear(); }
  void sayInterrupted(const BoundWatch& bound);
  void sayStepLimit(std::int64_t steps, const BoundWatch& bound);
  void sayWorkLimit(double passes, const BoundWatch& bound);
  /// @param fixedStep  the largest that would do, if a fixed one was asked for [s]; 0 if not
  void sayNonFinite(double fixedStep, const BoundWatch& bound);
  void sayNotConverged(const BoundWatch& bound);

  const std::string& name() const noexcept { return m_name; }
  const std::string& why() const noexcept { return m_limitText.empty() ? m_why : m_limitText; }

private:
  std::string m_name, m_why;
  std::string m_limitText; ///< of the last call, if its work limit ended it
};

} // namespace esm
