// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/checks.h"

#include "core/base/text_number.h"
#include "core/fuzzy/fis/coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>
#include <type_traits>

namespace esm::fis {

namespace {

std::string ruleName(const System& system, RulePlace place)
{
  const RuleBlock& block = system.blocks[static_cast<std::size_t>(place.block)];
  return "rule " + std::to_string(place.rule + 1) +
         (system.blocks.size() > 1 ? " of block '" + block.name + "'" : "");
}

class Checker {
public:
  Checker(const System& system, const CheckOptions& options) : m_system(system), m_options(options) {}

  std::vector<Finding> run()
  {
    checkTerms();
    checkOutputs();
    collectRules();
    checkPairs();
    checkPlaces();
    return std::move(m_findings);
  }

private:
  Finding& add(FindingKind kind, std::string message)
  {
    m_findings.emplace_back();
    m_findings.back().kind = kind;
    m_findings.back().message = std::move(message);
    return m_findings.back();
  }

  // --- terms

  template <class Variable>
  void checkTermsOf(const Variable& variable, bool onOutput, int index)
  {
    const Stretch stretch = stretchOf(variable);
    constexpr int kSteps = 1000;
    std::vector<std::vector<double>> heights;
    for (const Term& term : variable.terms) {
      heights.emplace_back();
      for (int i = 0; i <= kSteps && !isNumber(term.shape); ++i)
        heights.back().push_back(
          membership(curveOf(term), stretch.low + (stretch.high - stretch.low) * i / kSteps));
    }
    for (std::size_t a = 0; a < heights.size(); ++a)
      for (std::size_t b = a + 1; b < heights.size(); ++b)
        compareTerms(variable, heights, a, b, onOutput, index);
    if constexpr (std::is_same_v<Variable, InputVariable>) findGap(variable, heights, stretch, index);
  }

  template <class Variable>
  void compareTerms(const Variable& variable, const std::vector<std::vector<double>>& heights, std::size_t a,
                    std::size_t b, bool onOutput, int index)
  {
    double both = 0.0, either = 0.0;
    for (std::size_t i = 0; i < std::min(heights[a].size(), heights[b].size()); ++i) {
      both += std::min(heights[a][i], heights[b][i]);
      either += std::max(heights[a][i], heights[b][i]);
    }
    if (!(either > 0.0) || both / either <= m_options.overlapLimit) return;
    Finding& finding =
      add(FindingKind::Overlap, "terms '" + variable.terms[a].name + "' and '" + variable.terms[b].name +
                                  "' of '" + variable.name + "' share " +
                                  formatDouble(std::round(100.0 * both / either)) +
                                  " per cent of their area, so that they hardly differ");
    finding.onOutput = onOutput;
    finding.variable = index;
    finding.term = static_cast<int>(a);
    finding.otherTerm = static_cast<int>(b);
    finding.overlap = both / either;
  }

  /// The widest stretch where no term holds.
  void findGap(const InputVariable& input, const std::vector<std::vector<double>>& heights, Stretch stretch,
               int index)
  {
    std::size_t best = 0, bestEnd = 0, start = 0;
    const std::size_t count = 1001;
    const auto holds = [&](std::size_t i) {
      return std::any_of(heights.begin(), heights.end(),
                         [&](const auto& h) { return h.empty() || h[i] > m_options.gapLimit; });
    };
    for (std::size_t i = 0; i < count; ++i) {
      if (holds(i)) {
        start = i + 1;
      } else if (i + 1 - start > bestEnd - best) {
        best = start, bestEnd = i + 1;
      }
    }
    if (bestEnd == best || input.terms.empty()) return;
    const auto at = [&](double i) { return stretch.low + (stretch.high - stretch.low) * i / 1000.0; };
    const double middle = at(0.5 * static_cast<double>(best + bestEnd - 1));
    Finding& finding = add(FindingKind::Gap, "no term of '" + input.name + "' holds from " +
                                               formatDouble(at(static_cast<double>(best)), 4) + " to " +
                                               formatDouble(at(static_cast<double>(bestEnd - 1)), 4));
    finding.variable = index;
    finding.witness = middlesOf(m_system);
    finding.witness[static_cast<std::size_t>(index)] = middle;
    finding.inputs = {index};
  }

  void checkTerms()
  {
    for (std::size_t i = 0; i < m_system.inputs.size(); ++i)
      checkTermsOf(m_system.inputs[i], false, static_cast<int>(i));
    for (std::size_t i = 0; i < m_system.outputs.size(); ++i)
      checkTermsOf(m_system.outputs[i], true, static_cast<int>(i));
  }

  void checkOutputs()
  {
    std::vector<bool> isSet(m_system.outputs.size(), false);
    for (const RuleBlock& block : m_system.blocks)
      for (const Rule& rule : block.rules)
        for (const Proposition& consequent : rule.consequents)
          if (block.enabled && rule.enabled) isSet[static_cast<std::size_t>(consequent.variable)] = true;
    for (std::size_t i = 0; i < isSet.size(); ++i) {
      if (isSet[i] || !m_system.outputs[i].enabled) continue;
      Finding& finding =
        add(FindingKind::OutputNeverSet, "no rule concludes on '" + m_system.outputs[i].name + "'");
      finding.onOutput = true;
      finding.variable = static_cast<int>(i);
    }
  }

  // --- pairs of rules

  /// A rule in a form in which equal ones are equal texts: children of 'and' and 'or' sorted.
  struct Known {
    RulePlace place;
    const Rule* rule;
    std::string condition;
    std::set<std::string> parts; ///< of a plain chain of 'and'; empty for other forms
    bool plain = false;
  };

  static std::string key(const Proposition& p)
  {
    std::string text = (p.onOutput ? "o" : "i") + std::to_string(p.variable) + '.' + std::to_string(p.term);
    for (const Hedge hedge : p.hedges) text += ' ' + std::string(nameOf(hedge));
    return text;
  }
  static std::string key(const Antecedent& antecedent, int index)
  {
    const Antecedent::Node& node = antecedent.nodes[static_cast<std::size_t>(index)];
    if (node.kind == Antecedent::Kind::Proposition) return key(node.proposition);
    std::multiset<std::string> parts;
    for (const int child : node.children) parts.insert(key(antecedent, child));
    std::string text = node.kind == Antecedent::Kind::And  ? "and("
                       : node.kind == Antecedent::Kind::Or ? "or("
                                                           : "not(";
    for (const std::string& part : parts) text += part + ';';
    return text + ')';
  }

  void collectRules()
  {
    for (std::size_t b = 0; b < m_system.blocks.size(); ++b)
      for (std::size_t r = 0; r < m_system.blocks[b].rules.size(); ++r) {
        const Rule& rule = m_system.blocks[b].rules[r];
        if (!rule.enabled || !m_system.blocks[b].enabled) continue;
        Known known{{static_cast<int>(b), static_cast<int>(r)}, &rule, key(rule.antecedent, 0), {}, true};
        const auto& nodes = rule.antecedent.nodes;
        for (std::size_t n = 0; n < nodes.size(); ++n)
          if (nodes[n].kind == Antecedent::Kind::Proposition)
            known.parts.insert(key(nodes[n].proposition));
          else if (n > 0 || nodes[n].kind != Antecedent::Kind::And)
            known.plain = false;
        m_rules.push_back(std::move(known));
      }
  }

  void checkPairs()
  {
    constexpr std::size_t kMostRules = 3000; // pairs grow with the square
    for (std::size_t a = 0; a < std::min(m_rules.size(), kMostRules); ++a)
      for (std::size_t b = a + 1; b < std::min(m_rules.size(), kMostRules); ++b)
        if (m_rules[a].place.block == m_rules[b].place.block) comparePair(m_rules[a], m_rules[b]);
  }

  void comparePair(const Known& a, const Known& b)
  {
    if (a.condition == b.condition) {
      compareConclusions(a, b);
    } else if (a.plain && b.plain && a.rule->consequents == b.rule->consequents && minimumAndMaximum(a)) {
      const auto contains = [](const auto& whole, const auto& part) {
        return std::includes(whole.begin(), whole.end(), part.begin(), part.end());
      };
      if (contains(a.parts, b.parts) && a.rule->weight <= b.rule->weight) addShadow(a, b);
      if (contains(b.parts, a.parts) && b.rule->weight <= a.rule->weight) addShadow(b, a);
    }
  }

  /// Only where the greater of two degrees decides does the other not count.
  bool minimumAndMaximum(const Known& a) const
  {
    if (m_system.blocks[static_cast<std::size_t>(a.place.block)].activation.kind != ActivationKind::General)
      return false;
    return std::all_of(a.rule->consequents.begin(), a.rule->consequents.end(), [&](const Proposition& p) {
      const OutputVariable& output = m_system.outputs[static_cast<std::size_t>(p.variable)];
      return output.aggregation == SNorm::Maximum && isArea(output.defuzzifier);
    });
  }

  /// Of one kind a rule is named once, against the first that it clashes with: a thousand equal rules make a
  /// thousand findings, not half a million.
  bool isNew(FindingKind kind, const Known& rule)
  {
    return m_said.insert({kind, rule.place.block, rule.place.rule}).second;
  }

  void addShadow(const Known& hidden, const Known& by)
  {
    if (!isNew(FindingKind::Shadowed, hidden)) return;
    Finding& finding = add(FindingKind::Shadowed, ruleName(m_system, hidden.place) +
                                                    " never counts, because " + ruleName(m_system, by.place) +
                                                    " concludes the same on a weaker condition");
    finding.rule = hidden.place;
    finding.otherRule = by.place;
  }

  void compareConclusions(const Known& a, const Known& b)
  {
    FindingKind kind = FindingKind::Duplicate;
    if (a.rule->consequents != b.rule->consequents) {
      bool contradicts = false;
      for (const Proposition& p : a.rule->consequents)
        for (const Proposition& q : b.rule->consequents)
          contradicts =
            contradicts || (p.variable == q.variable && (p.term != q.term || p.hedges != q.hedges));
      if (!contradicts) return;
      kind = FindingKind::Contradiction;
    }
    if (!isNew(kind, b)) return;
    Finding& finding =
      add(kind, ruleName(m_system, a.place) + " and " + ruleName(m_system, b.place) +
                  (kind == FindingKind::Duplicate ? " say the same"
                                                  : " conclude differently on the same condition"));
    finding.rule = a.place;
    finding.otherRule = b.place;
  }

  // --- places of input space

  void checkPlaces()
  {
    const auto evaluator = Evaluator::create(m_system, {Options::Area::Sampled, 1});
    if (!evaluator || m_system.inputs.empty()) return;
    const Coverage coverage = tryPlaces(*evaluator, m_options.places);
    for (const Hole& hole : coverage.holes) addUncovered(hole);
    std::size_t flat = 0;
    for (std::size_t b = 0; b < m_system.blocks.size(); ++b)
      for (std::size_t r = 0; r < m_system.blocks[b].rules.size(); ++r, ++flat)
        if (coverage.silent[flat]) addSilent({static_cast<int>(b), static_cast<int>(r)});
  }

  void addUncovered(const Hole& hole)
  {
    std::string where;
    for (const int input : hole.inputs) {
      const auto i = static_cast<std::size_t>(input);
      where +=
        (where.empty() ? " at " : ", ") + m_system.inputs[i].name + " = " + formatDouble(hole.place[i], 4);
    }
    Finding& finding = add(FindingKind::Uncovered,
                           "no rule sets '" + m_system.outputs[static_cast<std::size_t>(hole.output)].name +
                             "'" + (where.empty() ? " anywhere" : where) + " (in all at " +
                             formatDouble(100.0 * hole.share, 3) + " per cent of the places tried)");
    finding.onOutput = true;
    finding.variable = hole.output;
    finding.witness = hole.place;
    finding.inputs = hole.inputs;
  }

  void addSilent(RulePlace place)
  {
    const RuleBlock& block = m_system.blocks[static_cast<std::size_t>(place.block)];
    const Rule& rule = block.rules[static_cast<std::size_t>(place.rule)];
    if (!rule.enabled || !block.enabled) return;
    Finding& finding =
      add(FindingKind::NeverFires, ruleName(m_system, place) + " fires nowhere: " + ruleText(m_system, rule));
    finding.rule = place;
  }

  const System& m_system;
  const CheckOptions& m_options;
  std::vector<Finding> m_findings;
  std::vector<Known> m_rules;
  std::set<std::tuple<FindingKind, int, int>> m_said;
};

} // namespace

std::string_view nameOf(FindingKind kind) noexcept
{
  constexpr std::array<std::string_view, 8> kNames = {"uncovered", "contradiction",   "duplicate",
                                                      "shadowed",  "never-fires",     "overlap",
                                                      "gap",       "output-never-set"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::vector<Finding> checkRules(const System& system, const CheckOptions& options)
{
  return Checker(system, options).run();
}

} // namespace esm::fis
