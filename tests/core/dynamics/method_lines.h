// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/method_facts.h"

#include <utility>
#include <vector>

namespace esm {

/// Methods as a test wants them, on no net: steps of equal cost, and a limit that may only be known once they are laid
/// out.
class MethodLines final : public MethodFacts {
public:
  struct Line {
    MethodTraits traits;
    double limit = 1e-4; ///< [s]
    double cost = 1.0;   ///< of a step [spring evaluations]
    bool isLaidOut = true;
    double limitOnceLaidOut = 0.0; ///< 0: the same
  };

  Method add(Line line)
  {
    m_lines.push_back(line);
    m_traits.push_back(line.traits);
    return m_lines.size() - 1;
  }
  Line& line(Method method) { return m_lines[method]; }
  MethodTraits& traitsOf(Method method) { return m_traits[method]; }
  void setRoles(Method plain, Method implicit) { m_plain = plain, m_implicit = implicit; }

  double limit(Method method) const noexcept override { return m_lines[method].limit; }
  double stepCost(Method method, double /*step*/) override { return m_lines[method].cost; }
  bool isLaidOut(Method method) const noexcept override { return m_lines[method].isLaidOut; }
  void layOut(Method method) override
  {
    Line& line = m_lines[method];
    if (std::exchange(line.isLaidOut, true) || !(line.limitOnceLaidOut > 0.0)) return;
    line.limit = line.limitOnceLaidOut;
  }

private:
  std::vector<Line> m_lines;
};

/// Plain steps of second order, its sharper twin, one of fourth order, local and implicit steps.
struct FewMethods {
  MethodLines facts;
  Method plain, twin, fine, local, implicit;

  FewMethods()
  {
    plain = facts.add({{MethodRole::Explicit, 2.0, 4e-2}, 1e-4, 100.0});
    twin = facts.add({{MethodRole::Explicit, 2.0, 1e-2}, 1e-4, 110.0});
    fine = facts.add({{MethodRole::Explicit, 4.0, 2e-5}, 1e-4, 150.0});
    local = facts.add({{MethodRole::Local, 2.0, 1e-3}, 1e-4, 50.0, false, 1e-3});
    implicit =
      facts.add({{MethodRole::Implicit, 2.0}, std::numeric_limits<double>::infinity(), 5000.0, false});
    facts.setRoles(plain, implicit);
  }
};

} // namespace esm
