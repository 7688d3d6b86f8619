// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/explain.h"

#include "core/base/text_number.h"
#include "core/fuzzy/axis.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace esm {

namespace {

constexpr int kGrid = 64;               ///< steps of the range between which a way is looked for
constexpr double kNoEffect = 1e-9;      ///< an input that moves ln(number) less has none
constexpr double kBeside = 1e-4;        ///< so far from a kink its side is looked at, as a share of the range
constexpr double kKink = 0.02;          ///< slopes that differ more have a kink between them
constexpr double kExact = 1e-6;         ///< of ln(factor), where bisection may end
constexpr double kReached = 0.00995;    ///< ln(1.01)
constexpr double kGoodEnough = 0.00498; ///< ln(1.005): digits are dropped as long as this holds

/// The rules that conclude one of the parameters with a power, and these conclusions only: the number hangs
/// on no others, and a search evaluates them hundreds of times.
Result<fuzzy::Engine> engineFor(const TissueField& field,
                                const std::array<std::int8_t, kTissueOutputCount>& powers,
                                std::array<int, kTissueOutputCount>& outputs)
{
  const fuzzy::RuleBase& rules = field.engine().ruleBase();
  fuzzy::RuleBase small{rules.inputs, {}, rules.rules};
  outputs.fill(-1);
  for (std::size_t i = 0; i < powers.size(); ++i)
    if (const int output = field.outputOf(static_cast<int>(i)); powers[i] != 0 && output >= 0) {
      outputs[i] = static_cast<int>(small.outputs.size());
      small.outputs.push_back(rules.outputs[static_cast<std::size_t>(output)]);
    }
  for (fuzzy::Rule& rule : small.rules)
    std::erase_if(rule.consequents, [&](const fuzzy::Proposition& consequent) {
      return small.findOutput(consequent.variable) == nullptr;
    });
  std::erase_if(small.rules,
                [](const fuzzy::Rule& rule) { return rule.consequents.empty() || !rule.enabled; });
  return fuzzy::Engine::create(std::move(small));
}

/// How one number of an explanation answers other inputs of one layer, everything else as it is.
class WhatIf {
public:
  WhatIf(const TissueField& field, const TissueExplanation& why, const ExplainedValue& value)
    : m_field(field), m_why(why), m_powers(value.kind->powers), m_engine(engineFor(field, m_powers, m_output))
  {
    for (const LayerReason& reason : why.layers) m_layers.push_back(reason.layer);
    m_now = logOf(field.blended(m_layers));
  }
  /// false: the number is 0 or does not hang on rules.
  bool canChange() const noexcept { return m_engine && std::isfinite(m_now); }

  /// ln(number then / number now); -infinity where it becomes 0.
  double logFactor(std::size_t layer, int input, double to)
  {
    TissueLayer& changed = m_layers[layer];
    const LogParameters before = changed.logs;
    const fuzzy::Inference small = m_engine->evaluate(inputsWith(layer, input, to));
    for (std::size_t i = 0; i < m_output.size(); ++i)
      if (m_output[i] >= 0)
        changed.inference.outputs[static_cast<std::size_t>(m_field.outputOf(static_cast<int>(i)))] =
          small.outputs[static_cast<std::size_t>(m_output[i])];
    changed.logs = m_field.logsOf(changed.inference);
    const double then = logOf(m_field.blended(m_layers));
    changed.logs = before;
    return then - m_now;
  }

  /// d ln(number)/d(input) at `from`; at a kink that towards `to`.
  double slopeTowards(std::size_t layer, int input, double from, double to) const
  {
    const fuzzy::Variable& variable = m_engine->ruleBase().inputs[static_cast<std::size_t>(input)];
    const double step = kBeside * (variable.maximum - variable.minimum);
    const double here = slopeAt(layer, input, from);
    const double beside = slopeAt(
      layer, input, std::clamp(to < from ? from - step : from + step, variable.minimum, variable.maximum));
    return std::abs(beside - here) <= kKink * std::abs(beside) ? here : beside;
  }

  /// Whether any rule of an output that counts speaks of the input.
  bool mayMatter(int input) const
  {
    const fuzzy::RuleBase& rules = m_engine->ruleBase();
    const std::string& id = rules.inputs[static_cast<std::size_t>(input)].id;
    return std::any_of(rules.rules.begin(), rules.rules.end(), [&](const fuzzy::Rule& rule) {
      return std::any_of(rule.condition.nodes.begin(), rule.condition.nodes.end(),
                         [&](const auto& node) { return node.proposition.variable == id; });
    });
  }

private:
  std::vector<fuzzy::InputValue> inputsWith(std::size_t layer, int input, double value) const
  {
    std::vector<fuzzy::InputValue> inputs = m_why.layers[layer].inputs;
    inputs[static_cast<std::size_t>(input)] = value;
    return inputs;
  }
  /// By the engine's exact derivatives: the blend is linear in logarithms.
  double slopeAt(std::size_t layer, int input, double at) const
  {
    const auto inputs = inputsWith(layer, input, at);
    const fuzzy::Inference inference = m_engine->evaluate(inputs);
    double sum = 0.0;
    for (std::size_t i = 0; i < m_output.size(); ++i) {
      if (m_output[i] < 0) continue;
      const double value = inference.outputs[static_cast<std::size_t>(m_output[i])].value;
      if (value > 0.0)
        sum += m_powers[i] * m_engine->slopes(inputs, m_output[i])[static_cast<std::size_t>(input)] / value;
    }
    return m_why.layers[layer].layer.share * sum;
  }
  double logOf(const TissueParameters& tissue) const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < m_powers.size(); ++i)
      if (m_powers[i] != 0) sum += m_powers[i] * std::log(tissue.*kTissueOutputs[i].value);
    return sum;
  }

  const TissueField& m_field;
  const TissueExplanation& m_why;
  const std::array<std::int8_t, kTissueOutputCount>& m_powers;
  std::array<int, kTissueOutputCount>
    m_output; ///< of m_engine, per parameter; -1: the number hangs not on it
  Result<fuzzy::Engine> m_engine;
  std::vector<TissueLayer> m_layers; ///< logs are those of the explanation, but during logFactor()
  double m_now = 0.0;
};

/// One input of one layer on its axis, and how far the number is from the wanted one there.
class Search {
public:
  Search(WhatIf& whatIf, const fuzzy::Variable& variable, std::size_t layer, int input, double wanted)
    : m_whatIf(whatIf), m_variable(variable), m_layer(layer), m_input(input), m_wanted(wanted)
  {}

  /// @param start on the axis. @return the plain value next to it that does it, or the one that comes
  /// nearest.
  double find(double start)
  {
    const fuzzy::Axis axis = axisOf(m_variable);
    std::vector<double> places = {start};
    for (int i = 0; i <= kGrid; ++i) places.push_back(axis.low + (axis.high - axis.low) * i / kGrid);
    std::sort(places.begin(), places.end());
    std::vector<double> misses;
    misses.reserve(places.size());
    for (const double place : places) misses.push_back(missAt(place));
    double best = start, least = std::abs(missAt(start)), nearest = 2.0 * (axis.high - axis.low) + 1.0;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (std::abs(misses[i]) < least) {
        least = std::abs(misses[i]);
        best = places[i];
      }
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      if ((misses[i] < 0.0) == (misses[i + 1] < 0.0)) continue;
      const double crossing = bisect(places[i], places[i + 1], misses[i] < 0.0);
      if (std::abs(missAt(crossing)) > kReached || std::abs(crossing - start) >= nearest) continue;
      nearest = std::abs(crossing - start);
      best = crossing;
    }
    return withFewDigits(fromAxis(m_variable, best));
  }
  /// The most that the number moves over the range, as found by find().
  double range() const noexcept { return m_high - m_low; }
  double logFactor(double value) { return m_whatIf.logFactor(m_layer, m_input, value); }

private:
  /// ln(number / wanted number).
  double missAt(double place)
  {
    const double log = logFactor(fromAxis(m_variable, place));
    m_low = std::min(m_low, log);
    m_high = std::max(m_high, log);
    return log - m_wanted;
  }
  double bisect(double low, double high, bool lowIsBelow)
  {
    for (int i = 0; i < 60 && low < high; ++i) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) break;
      const double miss = missAt(middle);
      if (std::abs(miss) < kExact) return middle;
      ((miss < 0.0) == lowIsBelow ? low : high) = middle;
    }
    return std::abs(missAt(low)) < std::abs(missAt(high)) ? low : high;
  }
  /// 0.48 rather than 0.4793412: what is read is what is set.
  double withFewDigits(double value)
  {
    const double exact = logFactor(value);
    for (int digits = 1; digits < 6; ++digits) {
      const double few = *parseDouble(formatDouble(value, digits));
      if (few < m_variable.minimum || few > m_variable.maximum) continue;
      if (std::abs(logFactor(few) - exact) <= kGoodEnough) return few;
    }
    return value;
  }

  WhatIf& m_whatIf;
  const fuzzy::Variable& m_variable;
  std::size_t m_layer;
  int m_input;
  double m_wanted;
  double m_low = 0.0, m_high = 0.0;
};

/// Where a word is wholly true, on the axis: the middle of those places.
double middleOf(const fuzzy::Word& word, const fuzzy::Variable& variable)
{
  const auto term = std::find_if(variable.terms.begin(), variable.terms.end(),
                                 [&](const fuzzy::Term& candidate) { return candidate.id == word.term; });
  const fuzzy::Axis axis = axisOf(variable);
  double highest = -1.0, first = axis.low, last = axis.high;
  for (int i = 0; i <= kGrid && term != variable.terms.end(); ++i) {
    const double x = axis.low + (axis.high - axis.low) * i / kGrid;
    const double degree = applyHedges(word.hedges, membership(*term, x));
    if (degree > highest) {
      highest = degree;
      first = x;
    }
    if (degree == highest) last = x;
  }
  return 0.5 * (first + last);
}

} // namespace

std::vector<InputChange> changesFor(const TissueField& field, const TissueExplanation& why,
                                    const ExplainedValue& value, double factor)
{
  std::vector<InputChange> changes;
  std::vector<double> efforts; ///< of each: how far the slider goes, as a share of its range
  WhatIf whatIf(field, why, value);
  if (!whatIf.canChange() || !(factor > 0.0) || !std::isfinite(factor)) return changes;
  for (std::size_t layer = 0; layer < why.layers.size(); ++layer) {
    const LayerReason& reason = why.layers[layer];
    if (!(reason.layer.share > 0.0)) continue;
    for (int input = 0; input < static_cast<int>(reason.inputs.size()); ++input) {
      if (!whatIf.mayMatter(input)) continue;
      const auto place = static_cast<std::size_t>(input);
      const fuzzy::Variable& variable = field.engine().ruleBase().inputs[place];
      const fuzzy::InputValue& from = reason.inputs[place];
      const double* number = std::get_if<double>(&from);
      const double start =
        number ? toAxis(variable, *number) : middleOf(std::get<fuzzy::Word>(from), variable);
      Search search(whatIf, variable, layer, input, std::log(factor));
      InputChange change;
      change.to = search.find(start);
      if (search.range() < kNoEffect) continue;
      const double log = search.logFactor(change.to);
      change.region = reason.layer.region;
      change.input = input;
      change.from = from;
      change.factor = std::exp(log);
      change.reached = std::abs(log - std::log(factor)) <= kReached;
      if (number && *number >= variable.minimum && *number <= variable.maximum)
        change.slope = whatIf.slopeTowards(layer, input, *number, change.to);
      change.locked = reason.locked;
      const fuzzy::Axis axis = axisOf(variable);
      efforts.push_back(change.reached
                          ? std::abs(toAxis(variable, change.to) - start) / (axis.high - axis.low)
                          : 1.0 + std::abs(log - std::log(factor)));
      changes.push_back(std::move(change));
    }
  }
  std::vector<std::size_t> order(changes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return efforts[a] < efforts[b]; });
  std::vector<InputChange> sorted;
  sorted.reserve(changes.size());
  for (const std::size_t i : order) sorted.push_back(std::move(changes[i]));
  return sorted;
}

} // namespace esm
