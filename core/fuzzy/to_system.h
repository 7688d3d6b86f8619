// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fuzzy/fis/system.h"
#include "core/fuzzy/rule_base.h"

namespace esm::fuzzy {

/// A rule base as a general fuzzy system: one Mamdani block (minimum, maximum, hedges of conclusions on
/// sets), centroid outputs, every variable on its axis (log10 for a logarithmic one). Variables and terms
/// keep their places, rules their order. Ids that are usable names stay names, others get numbers.
/// @pre checkRuleBase(ruleBase)
fis::System toSystem(const RuleBase& ruleBase);

fis::Shape toShape(Shape shape) noexcept;
fis::Hedge toHedge(Hedge hedge) noexcept;
std::vector<fis::Hedge> toHedges(const std::vector<Hedge>& hedges);
fis::Term toTerm(const Term& term); ///< without a name

} // namespace esm::fuzzy
