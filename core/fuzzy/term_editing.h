// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fuzzy/axis.h"
#include "core/fuzzy/rule_base.h"

#include <optional>
#include <vector>

namespace esm::fuzzy {

/// What people may do to the curves of one variable's terms. Every place is one on the variable's axis (log10
/// for a logarithmic variable). Pure functions, any thread; what they give passes checkRuleBase() wherever
/// the variable did.
///
/// A strong partition (Ruspini 1969): in the order of their cores, each term falls where the next one rises,
/// so that memberships sum to 1 at every place from the first core to the last.
///
///     1 ---.      .--.      .---      cores of two terms meet the foot of their neighbours
///           \    /    \    /
///            \  /      \  /           what lies outside the outermost cores is either a shoulder, which
///             \/        \/            keeps the sum to the end of the range, or a flank of its own
///     0 ------/\--------/\------

/// What can be taken hold of. A Triangle with a shoulder has the foot on its other side and the peak, where
/// the shoulder begins; a Gaussian its peak and the flanks, one deviation beside it.
enum class Handle : std::uint8_t {
  LeftFoot,
  LeftShoulder,
  Peak,
  RightShoulder,
  RightFoot,
  LeftFlank,
  RightFlank,
  Curve
};

/// From left to right; without Curve, which every term has.
std::vector<Handle> handlesOf(const Term& term);
/// Where a handle of the term is; of Curve, the middle of its core.
double placeOf(const Term& term, Handle handle) noexcept;
/// Height at which the handle is drawn: 0 for feet, exp(-1/2) for flanks, else 1.
double heightOf(Handle handle) noexcept;

/// Whether the terms are a strong partition, to 1e-9 of the range. Never with a Gaussian or without a term.
bool isPartition(const Variable& variable);

/// Where moveHandle() can bring a handle, least to greatest: corners keep their order, stay in the range, no
/// term loses its width, and cores of a kept partition stay kLeastGap of the range apart. Both ends are the
/// present place where it cannot move at all, as a corner that is out of reach beyond the range.
struct Limits {
  double least = 0.0, greatest = 0.0;
};
inline constexpr double kLeastGap = 1e-3;
Limits limitsOf(const Variable& variable, int term, Handle handle, bool keepPartition);

/// The variable's terms after a handle went to `to`, or to the nearer limit. In a kept partition the feet of
/// the neighbours follow its core, and its own feet are the neighbours' cores. An outer flank that was as
/// wide as the inner one stays so, another one moves along, a shoulder stays one.
/// @param keepPartition without effect where isPartition() does not hold
std::vector<Term> moveHandle(const Variable& variable, int term, Handle handle, double to,
                             bool keepPartition);

/// The forms that people choose from: a shoulder is a Triangle that does not end.
enum class Form : std::uint8_t { Triangle, Trapezoid, LeftShoulder, RightShoulder, Gaussian };
Form formOf(const Term& term) noexcept;
/// The term in another form, about where it was: same middle of the core and, as far as the form has them,
/// same places of membership 1/2.
Term withForm(const Term& term, Form form, const Axis& axis);

/// Feet moved to the neighbours' cores, so that the terms are a strong partition; cores stay.
/// Nothing if there is a Gaussian, or cores overlap or touch.
std::optional<std::vector<Term>> fittedPartition(const Variable& variable);

/// Ends of an evenly spread partition: inputs go on for ever, while outer terms of an output are as wide
/// outward as inward, so that their centre, which is what rules conclude, lies at their peak.
enum class Outside : std::uint8_t { Shoulder, Flank };
/// The same words, in the order of their cores, as triangles whose peaks have equal distances over the range.
std::vector<Term> spreadEvenly(const Variable& variable, Outside outside);

/// A new term in the widest room between cores, never on top of another: id and names are left empty.
/// With keepPartition (and a partition) its neighbours make room, else they stay.
/// @return all terms, the new one last
std::vector<Term> withNewTerm(const Variable& variable, bool keepPartition);
/// Without one; in a kept partition its neighbours close the gap.
std::vector<Term> withoutTerm(const Variable& variable, int term, bool keepPartition);

/// Indices of the terms by the middle of their cores.
std::vector<int> orderOfCores(const Variable& variable);
/// Indices of the rules, on or off, that speak of a term.
std::vector<int> rulesWith(const RuleBase& ruleBase, const std::string& variable, const std::string& term);

} // namespace esm::fuzzy
