// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/base/work_control.h"
#include "core/net/spring_net.h"

#include <cstdint>
#include <string>
#include <vector>

namespace esm {

/// One thing about a net that a modeler should know. `text` says it in English with its numbers; kind,
/// numbers and places are there for whoever says it in another language or shows it.
struct QualityFinding {
  enum class Kind : std::uint8_t {
    Carries,   ///< all is well: value = the dent [m]
    Soft,      ///< gives way to a poke by a good part of its size: value = the dent [m]
    Collapses, ///< a poke moves it by more than its size, or the springs resist nothing: value = the dent [m]
    NothingInside, ///< a surface without springs between its walls
    Mechanisms,    ///< motions that no spring resists: count
    FlatNodes,     ///< nodes whose springs all lie in a plane or a line: nothing holds them across it: nodes
    HingeNode,     ///< parts that hang together at a node only: nodes
    HingeLine,     ///< parts that hang together along a line only: nodes
    Unheld,        ///< parts that neither anchors nor fixed nodes hold: count, nodes = one of each
    TooLarge       ///< too many nodes for the stiffness figures: count
  } kind = Kind::Carries;
  enum class Severity : std::uint8_t { Good, Note, Warning } severity = Severity::Good;
  double value = 0.0;
  std::int64_t count = 0;
  std::vector<NodeId> nodes; ///< where; at most kMostNodes
  std::string text;
  static constexpr std::size_t kMostNodes = 1000;
};
const char* nameOf(QualityFinding::Kind kind) noexcept; ///< "nothing_inside"

/// Whether a net carries load.
struct QualityReport {
  std::vector<QualityFinding> findings; ///< the gravest first
  double poke = 0.1;                    ///< [N], spread over a patch of pokeRadius
  double pokeRadius = 0.0;              ///< [m]
  double dent = 0.0;           ///< depth of the deepest of the pokes [m]; infinite where nothing resists
  NodeId dentNode{};           ///< where that was
  double size = 0.0;           ///< of the net: diagonal of its box [m]
  double frequency = 0.0;      ///< of the slowest motion that is not rigid [Hz]
  std::int64_t mechanisms = 0; ///< motions that no spring resists, rigid ones of the parts left out
  bool carriesLoad() const noexcept;
};

/// Looks at the net as tissue has made it: linear statics and vibrations about the rest shape. A dozen
/// places, far from each other, are poked one by one with 0.1 N against the surface, over 5 mm or an eighth
/// of the size if that is less; a part that nothing holds swims away with the poke, and only its dent counts.
/// (Where struts make the factor too large, mechanisms are counted by Maxwell, S - 3 N, a lower bound.)
/// Mechanisms are counted without anchors, by Sylvester's law of inertia: motions slower than 1e-9 of the
/// stiffest rate. Deterministic; any thread.
/// @pre the net has stiffness. @param control may be null.
/// Errors: InvalidValue (a net without stiffness), Cancelled.
Result<QualityReport> judgeNet(const SpringNet& net, WorkControl* control = nullptr);

} // namespace esm
