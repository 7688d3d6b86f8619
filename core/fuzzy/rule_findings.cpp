// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/rule_findings.h"

#include "core/fuzzy/axis.h"
#include "core/fuzzy/to_system.h"

namespace esm::fuzzy {

std::vector<RuleFinding> findOddities(const RuleBase& ruleBase)
{
  std::vector<RuleFinding> result;
  for (const fis::Finding& finding : fis::checkRules(toSystem(ruleBase))) {
    RuleFinding found{finding.kind,      finding.rule.rule, finding.otherRule.rule,
                      finding.onOutput,  finding.variable,  finding.term,
                      finding.otherTerm, finding.overlap,   {}};
    for (const int input : finding.inputs) {
      const auto i = static_cast<std::size_t>(input);
      found.place.emplace_back(input, fromAxis(ruleBase.inputs[i], finding.witness[i]));
    }
    result.push_back(std::move(found));
  }
  return result;
}

} // namespace esm::fuzzy
