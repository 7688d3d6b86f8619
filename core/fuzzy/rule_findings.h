// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fuzzy/fis/checks.h"
#include "core/fuzzy/rule_base.h"

#include <vector>

namespace esm::fuzzy {

/// What is odd about a rule base of words: fis::checkRules() with its places given as values.
struct RuleFinding {
  fis::FindingKind kind{};
  int rule = -1, otherRule = -1;             ///< into RuleBase::rules, or -1
  bool onOutput = false;                     ///< whether `variable` is one of RuleBase::outputs
  int variable = -1;                         ///< which this is about, or -1
  int term = -1, otherTerm = -1;             ///< of that variable: terms that overlap too much
  double overlap = 0.0;                      ///< of them: shared part of their area, (0, 1]
  std::vector<std::pair<int, double>> place; ///< where to look: input and value (plain, not its logarithm);
                                             ///< whatever the other inputs are, the finding holds there
  bool operator==(const RuleFinding&) const = default;
};

/// All findings, the same for equal rule bases. About 3 ms for the rules of a new project, 20 to 100 ms for
/// a thousand: run it beside the edit, not in it.
/// @pre checkRuleBase(ruleBase)
std::vector<RuleFinding> findOddities(const RuleBase& ruleBase);

} // namespace esm::fuzzy
