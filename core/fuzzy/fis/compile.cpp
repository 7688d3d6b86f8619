// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/compiled.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace esm::fis {

namespace {

/// Flattens a checked System.
class Compiler {
public:
  explicit Compiler(Compiled& target) : m_c(target) {}

  void run()
  {
    for (const InputVariable& input : m_c.system.inputs)
      m_inputTerms.push_back(addTerms(input.terms, false, 0));
    for (std::size_t i = 0; i < m_c.system.outputs.size(); ++i) addOutput(i);
    for (const RuleBlock& block : m_c.system.blocks) countFacts(block);
    m_c.slotCount = static_cast<int>(m_c.inputFacts.size());
    for (const RuleBlock& block : m_c.system.blocks) addBlock(block);
    placeActivated();
    for (FlatBlock& block : m_c.blocks) addMasks(block);
    for (FlatOutput& output : m_c.outputs) tabulate(output);
  }

private:
  Range addTerms(const std::vector<Term>& terms, bool onOutput, std::size_t output)
  {
    const Range range{static_cast<int>(m_c.terms.size()), static_cast<int>(terms.size())};
    const int variable = static_cast<int>(onOutput ? output : m_inputTerms.size());
    for (std::size_t t = 0; t < terms.size(); ++t) {
      const Term& term = terms[t];
      FlatTerm flat;
      flat.shape = term.shape;
      flat.straight = isPiecewiseLinear(term.shape);
      flat.parameters = {static_cast<int>(m_c.numbers.size()), static_cast<int>(term.parameters.size())};
      for (std::size_t i = 0; i <= term.parameters.size(); ++i) {
        const bool isHeight = i == term.parameters.size();
        m_c.numbers.push_back(isHeight ? term.height : term.parameters[i]);
        m_c.places.push_back({onOutput, variable, static_cast<int>(t), isHeight ? -1 : static_cast<int>(i)});
      }
      if (term.shape == Shape::Linear) flat.variables = static_cast<int>(m_c.system.inputs.size());
      if (term.shape == Shape::Function) {
        flat.formula = static_cast<int>(m_c.formulas.size());
        const auto names = formulaNames(m_c.system, onOutput ? output : 0);
        flat.variables = static_cast<int>(names.size()) - 1;
        m_c.formulas.push_back(std::get<Formula>(Formula::parse(term.formula, names)));
      }
      m_c.terms.push_back(flat);
    }
    return range;
  }

  void addOutput(std::size_t index)
  {
    const OutputVariable& output = m_c.system.outputs[index];
    FlatOutput flat;
    flat.enabled = output.enabled;
    flat.lockRange = output.lockRange;
    flat.lockPrevious = output.lockPrevious;
    flat.aggregates = output.aggregation.has_value();
    flat.minimum = output.minimum;
    flat.maximum = output.maximum;
    flat.defaultValue = output.defaultValue;
    flat.aggregation = output.aggregation.value_or(SNorm::Maximum);
    flat.defuzzifier = output.defuzzifier;
    flat.weightedType = output.weightedType;
    flat.joins = output.joinsEqualTerms;
    const bool exact = m_c.options.area == Options::Area::Exact;
    flat.resolution = exact ? 0 : m_c.options.resolution > 0 ? m_c.options.resolution : output.resolution;
    flat.terms = addTerms(output.terms, true, index);
    m_c.outputs.push_back(flat);
  }

  Range addHedges(const std::vector<Hedge>& hedges)
  {
    const Range range{static_cast<int>(m_c.hedges.size()), static_cast<int>(hedges.size())};
    m_c.hedges.insert(m_c.hedges.end(), hedges.rbegin(), hedges.rend());
    return range;
  }

  int termOf(const Proposition& proposition) const
  {
    if (proposition.term < 0) return -1;
    const auto variable = static_cast<std::size_t>(proposition.variable);
    return (proposition.onOutput ? m_c.outputs[variable].terms : m_inputTerms[variable]).first +
           proposition.term;
  }

  using FactKey = std::tuple<int, int, std::vector<Hedge>>;
  static FactKey keyOf(const Proposition& p) { return {p.variable, p.term, p.hedges}; }

  /// Input facts come first, so that all of them can be computed in one go.
  void countFacts(const RuleBlock& block)
  {
    for (const Rule& rule : block.rules)
      for (const Antecedent::Node& node : rule.antecedent.nodes) {
        const Proposition& p = node.proposition;
        if (node.kind != Antecedent::Kind::Proposition || p.onOutput) continue;
        const auto [place, isNew] = m_facts.try_emplace(keyOf(p), static_cast<int>(m_c.inputFacts.size()));
        if (!isNew) continue;
        const auto [low, high] = supportOf(termOf(p));
        m_c.inputFacts.push_back({p.variable, termOf(p), addHedges(p.hedges), low, high});
      }
  }

  /// Outside of it the curve is 0; all numbers if that is not known.
  std::pair<double, double> supportOf(int term) const
  {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (term >= 0) {
      const Curve curve = m_c.curve(term, {});
      const auto& p = curve.parameters;
      if ((curve.shape == Shape::Triangle || curve.shape == Shape::Trapezoid) &&
          std::is_sorted(p.begin(), p.end()))
        return {p.front(), p.back()};
    }
    return {-kInfinity, kInfinity};
  }

  int addNode(const Antecedent& antecedent, int index)
  {
    const Antecedent::Node& node = antecedent.nodes[static_cast<std::size_t>(index)];
    if (node.kind == Antecedent::Kind::Proposition) {
      const Proposition& p = node.proposition;
      if (!p.onOutput) return m_facts.at(keyOf(p));
      m_c.outputFacts.push_back({p.variable, termOf(p), addHedges(p.hedges), m_c.slotCount});
      return m_c.slotCount++;
    }
    std::vector<int> slots;
    for (const int child : node.children) slots.push_back(addNode(antecedent, child));
    m_c.mostChildren = std::max(m_c.mostChildren, static_cast<int>(slots.size()));
    const Range children{static_cast<int>(m_c.children.size()), static_cast<int>(slots.size())};
    m_c.children.insert(m_c.children.end(), slots.begin(), slots.end());
    m_c.nodes.push_back({node.kind, children, m_c.slotCount});
    return m_c.slotCount++;
  }

  void addBlock(const RuleBlock& block)
  {
    FlatBlock flat;
    flat.enabled = block.enabled;
    flat.conjunction = block.conjunction.value_or(TNorm::Minimum);
    flat.disjunction = block.disjunction.value_or(SNorm::Maximum);
    flat.implication = block.implication.value_or(TNorm::Minimum);
    flat.activation = block.activation;
    flat.hedgesOnSet = block.conclusionHedges == ConclusionHedges::OnSet;
    flat.rules = {static_cast<int>(m_c.rules.size()), static_cast<int>(block.rules.size())};
    for (const Rule& rule : block.rules) {
      FlatRule target;
      target.weight = rule.weight;
      target.enabled = rule.enabled;
      target.outputFacts.first = static_cast<int>(m_c.outputFacts.size());
      target.nodes.first = static_cast<int>(m_c.nodes.size());
      target.root = addNode(rule.antecedent, 0);
      target.outputFacts.count = static_cast<int>(m_c.outputFacts.size()) - target.outputFacts.first;
      target.nodes.count = static_cast<int>(m_c.nodes.size()) - target.nodes.first;
      target.conclusions = {static_cast<int>(m_c.conclusions.size()),
                            static_cast<int>(rule.consequents.size())};
      for (const Proposition& p : rule.consequents)
        m_c.conclusions.push_back({p.variable, termOf(p), addHedges(p.hedges)});
      m_c.rules.push_back(target);
    }
    m_c.blocks.push_back(flat);
  }

  /// Every T-norm of 0 is 0 (of degrees up to 1): a rule that chains facts by 'and' needs each of them.
  void addMasks(FlatBlock& block) const
  {
    for (const InputVariable& input : m_c.system.inputs)
      for (const Term& term : input.terms)
        if (isNumber(term.shape) || !(term.height >= 0.0 && term.height <= 1.0)) return;
    std::map<int, std::vector<int>> rulesOf;
    for (int r = block.rules.first; r < block.rules.end(); ++r)
      addNeeds(m_c.rules[static_cast<std::size_t>(r)].root, r, rulesOf);
    block.maskWords = (block.rules.count + 63) / 64;
    block.masks.assign(static_cast<std::size_t>(block.maskWords) * rulesOf.size(), 0);
    for (const auto& [fact, rules] : rulesOf) {
      for (const int rule : rules) {
        const auto bit = static_cast<std::size_t>(rule - block.rules.first);
        block.masks[bit / 64 * rulesOf.size() + block.needs.size()] |= std::uint64_t{1} << (bit % 64);
      }
      block.needs.push_back(fact);
    }
  }

  void addNeeds(int slot, int rule, std::map<int, std::vector<int>>& rulesOf) const
  {
    if (slot < static_cast<int>(m_c.inputFacts.size())) {
      rulesOf[slot].push_back(rule);
      return;
    }
    const FlatRule& flat = m_c.rules[static_cast<std::size_t>(rule)];
    for (int n = flat.nodes.first; n < flat.nodes.end(); ++n) {
      const Node& node = m_c.nodes[static_cast<std::size_t>(n)];
      if (node.slot != slot || node.kind != Antecedent::Kind::And) continue;
      for (int k = node.children.first; k < node.children.end(); ++k)
        addNeeds(m_c.children[static_cast<std::size_t>(k)], rule, rulesOf);
    }
  }

  /// Room for every conclusion on an output, and for the marks of them all.
  void placeActivated()
  {
    for (const Conclusion& conclusion : m_c.conclusions) {
      FlatOutput& output = m_c.outputs[static_cast<std::size_t>(conclusion.output)];
      ++output.activated.count;
      const FlatTerm& term = m_c.terms[static_cast<std::size_t>(conclusion.term)];
      const int corners = term.shape == Shape::Discrete ? term.parameters.count / 2 : 40;
      output.markBound += 4 * corners + 8;
    }
    int first = 0;
    for (FlatOutput& output : m_c.outputs) {
      output.activated.first = first;
      first += output.activated.count;
      output.markBound += 40;
    }
  }

  /// Samples the terms of an output once, if they are the same in every evaluation.
  void tabulate(FlatOutput& output)
  {
    if (!isArea(output.defuzzifier) || output.resolution == 0 || output.activated.count == 0) return;
    const auto n = static_cast<std::size_t>(output.resolution);
    constexpr std::size_t kMostSamples = 4'000'000; // beyond, curves are computed anew each time
    const double step = (output.maximum - output.minimum) / output.resolution;
    output.gridFirst = static_cast<int>(m_c.tables.size());
    for (std::size_t i = 0; i < n; ++i)
      m_c.tables.push_back(output.minimum + (static_cast<double>(i) + 0.5) * step);
    output.tabulated = n * static_cast<std::size_t>(output.terms.count) <= kMostSamples;
    for (int t = output.terms.first; t < output.terms.end(); ++t) {
      FlatTerm& term = m_c.terms[static_cast<std::size_t>(t)];
      if (term.variables > 0) output.tabulated = false;
      if (!output.tabulated) return;
      term.tableFirst = static_cast<int>(m_c.tables.size());
      const Curve curve = m_c.curve(t, {});
      for (std::size_t i = 0; i < n; ++i)
        m_c.tables.push_back(membership(curve, m_c.tables[static_cast<std::size_t>(output.gridFirst) + i]));
      const double* table = m_c.tables.data() + term.tableFirst;
      int first = 0, end = output.resolution;
      while (first < end && table[first] == 0.0) ++first;
      while (end > first && table[end - 1] == 0.0) --end;
      term.support = {first, end - first};
    }
  }

  Compiled& m_c;
  std::vector<Range> m_inputTerms;
  std::map<FactKey, int> m_facts;
};

} // namespace

void Compiled::compile()
{
  width = options.area == Options::Area::Exact ? 0.0 : 1e-6;
  Compiler(*this).run();
}

} // namespace esm::fis
