// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/inference.h"

#include "core/fuzzy/axis.h"
#include "core/fuzzy/fis/evaluator.h"
#include "core/fuzzy/to_system.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace esm::fuzzy {

/// The rule base and the general engine compiled from it: equal places of variables, terms and rules.
struct Engine::Compiled {
  RuleBase ruleBase;
  fis::Evaluator evaluator;
};

Result<Engine> Engine::create(RuleBase ruleBase)
{
  if (Status status = checkRuleBase(ruleBase); !status) return status.error();
  auto evaluator = fis::Evaluator::create(toSystem(ruleBase));
  if (!evaluator) return evaluator.error();
  return Engine(std::make_shared<const Compiled>(Compiled{std::move(ruleBase), std::move(*evaluator)}));
}

const RuleBase& Engine::ruleBase() const noexcept
{
  return m_compiled->ruleBase;
}

namespace {

/// Inputs as the general engine takes them. The words' hedges live here, so it is not copied.
struct Facts {
  Facts(const RuleBase& rules, const fis::System& system, std::span<const InputValue> inputs)
    : hedges(rules.inputs.size())
  {
    for (std::size_t i = 0; i < rules.inputs.size(); ++i) {
      const Variable& variable = rules.inputs[i];
      facts.push_back(fis::Input::number(toAxis(variable, variable.defaultValue)));
      if (i >= inputs.size()) continue;
      if (const double* value = std::get_if<double>(&inputs[i])) {
        facts.back() = fis::Input::number(toAxis(variable, *value));
        continue;
      }
      const Word& word = std::get<Word>(inputs[i]);
      const auto term = std::find_if(variable.terms.begin(), variable.terms.end(),
                                     [&](const Term& candidate) { return candidate.id == word.term; });
      if (term == variable.terms.end()) continue;
      hedges[i] = toHedges(word.hedges);
      const auto place = static_cast<std::size_t>(term - variable.terms.begin());
      facts.back() = fis::Input::word(system.inputs[i].terms[place], hedges[i]);
    }
  }
  Facts(const Facts&) = delete;
  Facts& operator=(const Facts&) = delete;

  std::vector<std::vector<fis::Hedge>> hedges;
  std::vector<fis::Input> facts;
};

/// d(plain value)/d(place on the axis).
double plainPerAxis(const Variable& variable, double value) noexcept
{
  return variable.logarithmic ? value * std::numbers::ln10 : 1.0;
}

} // namespace

Inference Engine::evaluate(std::span<const InputValue> inputs) const
{
  const RuleBase& rules = m_compiled->ruleBase;
  const fis::Evaluator& evaluator = m_compiled->evaluator;
  const Facts given(rules, evaluator.system(), inputs);
  fis::Workspace workspace = evaluator.makeWorkspace();
  evaluator.evaluate(given.facts, workspace);
  Inference inference;
  for (std::size_t r = 0; r < rules.rules.size(); ++r)
    if (rules.rules[r].enabled) inference.firings.push_back({static_cast<int>(r), workspace.degrees()[r]});
  for (std::size_t o = 0; o < rules.outputs.size(); ++o) {
    const fis::OutputResult& result = workspace.outputs()[o];
    const bool fromRules = result.origin == fis::Origin::Rules;
    inference.outputs.push_back(
      {fromRules ? fromAxis(rules.outputs[o], result.value) : rules.outputs[o].defaultValue, fromRules});
  }
  return inference;
}

std::vector<double> Engine::slopes(std::span<const InputValue> inputs, int output) const
{
  const RuleBase& rules = m_compiled->ruleBase;
  const fis::Evaluator& evaluator = m_compiled->evaluator;
  std::vector<double> slopes(rules.inputs.size(), 0.0);
  const Facts given(rules, evaluator.system(), inputs);
  fis::Workspace workspace = evaluator.makeWorkspace();
  evaluator.evaluate(given.facts, workspace);
  const auto o = static_cast<std::size_t>(output);
  const fis::OutputResult& result = workspace.outputs()[o];
  if (result.origin != fis::Origin::Rules) return slopes;
  fis::Gradient gradient;
  evaluator.differentiate(output, workspace, gradient);
  const double perAxis = plainPerAxis(rules.outputs[o], fromAxis(rules.outputs[o], result.value));
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    const Variable& variable = rules.inputs[i];
    const double* number = i < inputs.size() ? std::get_if<double>(&inputs[i]) : nullptr;
    if (number && *number >= variable.minimum && *number <= variable.maximum)
      slopes[i] = perAxis * gradient.byInput[i] / plainPerAxis(variable, *number);
  }
  return slopes;
}

std::vector<std::pair<double, double>> aggregatedSet(const RuleBase& ruleBase, const Inference& inference,
                                                     int output, int points)
{
  const Variable& variable = ruleBase.outputs[static_cast<std::size_t>(output)];
  struct Cut {
    const Term* term;
    const std::vector<Hedge>* hedges;
    double degree;
  };
  std::vector<Cut> cuts;
  for (const RuleFiring& firing : inference.firings)
    for (const Proposition& consequent : ruleBase.rules[static_cast<std::size_t>(firing.rule)].consequents)
      for (const Term& term : variable.terms)
        if (consequent.variable == variable.id && consequent.term == term.id &&
            firing.degree >= fis::Evaluator::kLeastDegree)
          cuts.push_back({&term, &consequent.hedges, firing.degree});
  std::vector<std::pair<double, double>> plot;
  const Axis axis = axisOf(variable);
  for (int i = 0; i < points; ++i) {
    const double x = axis.low + (axis.high - axis.low) * i / std::max(points - 1, 1);
    double height = 0.0;
    for (const Cut& cut : cuts)
      height = std::max(height, std::min(applyHedges(*cut.hedges, membership(*cut.term, x)), cut.degree));
    plot.emplace_back(fromAxis(variable, x), height);
  }
  return plot;
}

} // namespace esm::fuzzy
