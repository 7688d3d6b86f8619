// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/bounds/step_bound.h"
#include "core/dynamics/planner/node_names.h"
#include "core/dynamics/planner/policy.h"

#include <utility>

namespace esm {

/// Knows the fastest motion that the net can make, and looks again when enough has happened since. A look costs up to
/// thirty passes, and where struts make many pairs of springs as much again; it follows what stiffens within some
/// frames, and what turns and bends.
class BoundWatch {
public:
  /// @param names  of the body's nodes; empty: their places
  BoundWatch(const Policy& policy, std::vector<Index> names) noexcept
    : m_policy(&policy), m_names{std::move(names), {}}
  {}
  /// Of the system's nodes in the body from the next look on; empty: it is the whole body.
  void setPlaces(std::vector<Index> places) noexcept { m_names.places = std::move(places); }

  void prepare(bool findsDecay) noexcept { m_bound.prepare(findsDecay); } ///< after any change of springs
  void freeRoom() { m_bound.freeRoom(); }
  /// @param asksForFew  whether a few nodes that hold all are looked for, too
  void look(const System& system, const MotionState& state, bool asksForFew);
  /// The same if it is time.
  /// @param implicit  steps run now that do not depend on it
  /// @return whether it was
  bool lookIfDue(const System& system, const MotionState& state, bool asksForFew, bool implicit);
  void spend(double passes) noexcept { m_since += passes; } ///< work since the last look [force passes]
  void hurry() noexcept;                                    ///< the next stretch looks
  void setOld() noexcept { m_isOld = true; } ///< it was of another part of the net, or before other tools
  bool isOld() const noexcept { return m_isOld; }

  const FastestMode& mode() const noexcept { return m_mode; }
  /// Of another motion than the one that is followed: a question must not change what the next look sees.
  FastestMode ask(const System& system, const MotionState& state) const;
  bool fewHoldAll() const noexcept { return m_fewHoldAll; } ///< they ask for the small steps, see StiffNodes
  /// Whether dampers brake the fastest waves more than springs throw them.
  bool isDamped() const noexcept { return m_mode.damping * m_mode.damping > m_mode.stiffness; }

  struct Stiffest {
    Index node = kNoIndex; ///< by its name in the whole net
    double mass = 0.0;     ///< [kg]
  };
  const Stiffest& stiffest() const noexcept { return m_stiffest; }

private:
  const Policy* m_policy;
  NodeNames m_names;
  StepBound m_bound;
  FastestMode m_mode;
  Stiffest m_stiffest;
  double m_since = 0.0; ///< work since the last look [force passes]
  bool m_isOld = false;
  bool m_fewHoldAll = false;
};

} // namespace esm
