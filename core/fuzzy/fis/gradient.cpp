// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/compiled.h"

#include <algorithm>
#include <cmath>

namespace esm::fis {

namespace {

/// Carries the derivative of one output back through the last evaluation (reverse differentiation): from the
/// number to the degrees of the conclusions, from there rule by rule, last first, to the terms and inputs.
class Reverse {
public:
  Reverse(const Compiled& c, Scratch& s, Gradient& gradient)
    : m_c(c), m_s(s), m_gradient(gradient), m_slopes{gradient.byParameter, s.variableSlopes}
  {}

  void run(int output)
  {
    for (auto* list :
         {&m_s.activatedAdjoint, &m_s.slotAdjoint, &m_s.ruleAdjoint, &m_s.outputAdjoint, &m_s.variableSlopes})
      std::fill(list->begin(), list->end(), 0.0);
    m_s.outputAdjoint[at(output)] = 1.0;
    const std::size_t inputs = m_c.system.inputs.size();
    for (int o = output; o >= 0; --o) { // a formula may ask for outputs before its own
      m_s.outputAdjoint[at(o)] += m_s.variableSlopes[1 + inputs + at(o)];
      if (m_s.outputAdjoint[at(o)] != 0.0) throughOutput(o, m_s.outputAdjoint[at(o)]);
    }
    for (std::size_t b = m_c.blocks.size(); b-- > 0;)
      if (m_c.blocks[b].enabled) throughBlock(m_c.blocks[b], m_s.blockSum[b]);
    for (std::size_t f = 0; f < m_c.inputFacts.size(); ++f)
      throughFact(m_c.inputFacts[f], m_s.slotAdjoint[f]);
    for (std::size_t i = 0; i < inputs; ++i)
      m_gradient.byInput[i] = isFree(i) ? m_s.variableSlopes[1 + i] : 0.0;
  }

private:
  /// A number, not held at an end of the range.
  bool isFree(std::size_t input) const
  {
    const Input& given = m_s.inputs[input];
    const InputVariable& variable = m_c.system.inputs[input];
    const double x = m_s.variables[input];
    return !given.set && !(given.low < given.high) && std::isfinite(x) &&
           !(variable.lockRange && (x <= variable.minimum || x >= variable.maximum));
  }

  void throughOutput(int index, double factor)
  {
    const FlatOutput& output = m_c.outputs[at(index)];
    const OutputResult& result = m_s.outputs[at(index)];
    if (result.origin != Origin::Rules) return;
    if (output.lockRange && (result.value <= output.minimum || result.value >= output.maximum)) return;
    if (isWeighted(output.defuzzifier)) return addWeightedSlopes(m_c, output, index, m_s, factor, m_slopes);
    collectSets(m_c, output, index, m_s);
    if (output.resolution > 0) return addSampledSlopes(m_c, output, m_s, factor, m_slopes);
    addExactSlopes(m_c, output, m_s, result.value, factor, m_slopes);
  }

  void throughBlock(const FlatBlock& block, double sum)
  {
    const auto kind = block.activation.kind;
    const bool oneByOne = kind == ActivationKind::General || kind == ActivationKind::First ||
                          kind == ActivationKind::Last || kind == ActivationKind::Threshold;
    const bool backward = kind == ActivationKind::Last; // these were computed from the last rule on
    const auto forEachReversed = [&](const auto& visit) {
      for (int k = 0; k < block.rules.count; ++k)
        visit(backward ? block.rules.first + k : block.rules.end() - 1 - k);
    };
    if (oneByOne) {
      forEachReversed([&](int r) {
        throughConclusions(block, r);
        throughAntecedent(block, r);
      });
      return;
    }
    forEachReversed([&](int r) { throughConclusions(block, r); });
    if (kind == ActivationKind::Proportional) throughShares(block, sum);
    forEachReversed([&](int r) { throughAntecedent(block, r); });
  }

  /// degree / sum of degrees
  void throughShares(const FlatBlock& block, double sum)
  {
    if (!(sum > 0.0)) return;
    double common = 0.0;
    for (int r = block.rules.first; r < block.rules.end(); ++r)
      common += m_s.ruleAdjoint[at(r)] * m_s.degrees[at(r)] / sum;
    for (int r = block.rules.first; r < block.rules.end(); ++r)
      m_s.ruleAdjoint[at(r)] = (m_s.ruleAdjoint[at(r)] - common) / sum;
  }

  /// Its conclusions' degrees follow one from another where hedges bend them.
  void throughConclusions(const FlatBlock& block, int ruleIndex)
  {
    if (!(m_s.firings[at(ruleIndex)] > 0.0)) return;
    const FlatRule& rule = m_c.rules[at(ruleIndex)];
    double adjoint = 0.0;
    for (int k = rule.conclusions.end() - 1; k >= rule.conclusions.first; --k) {
      const Conclusion& conclusion = m_c.conclusions[at(k)];
      const FlatOutput& output = m_c.outputs[at(conclusion.output)];
      if (!output.enabled) continue;
      adjoint += m_s.activatedAdjoint[at(placeOf(output, conclusion.output, k))];
      if (!block.hedgesOnSet && conclusion.hedges.count > 0)
        adjoint *= hedgeSlope(m_c.hedgesOf(conclusion.hedges), degreeBefore(rule, ruleIndex, k));
    }
    m_s.ruleAdjoint[at(ruleIndex)] += adjoint;
  }

  int placeOf(const FlatOutput& output, int outputIndex, int conclusion) const
  {
    for (int k = 0; k < m_s.activatedCount[at(outputIndex)]; ++k)
      if (m_s.activated[at(output.activated.first + k)].conclusion == conclusion)
        return output.activated.first + k;
    return output.activated.first; // not reached: a rule that fired put all its conclusions
  }

  double degreeBefore(const FlatRule& rule, int ruleIndex, int conclusion) const
  {
    double degree = m_s.firings[at(ruleIndex)];
    for (int k = rule.conclusions.first; k < conclusion; ++k)
      if (m_c.outputs[at(m_c.conclusions[at(k)].output)].enabled)
        degree = applyHedges(m_c.hedgesOf(m_c.conclusions[at(k)].hedges), degree);
    return degree;
  }

  void throughAntecedent(const FlatBlock& block, int ruleIndex)
  {
    const FlatRule& rule = m_c.rules[at(ruleIndex)];
    const double adjoint = m_s.ruleAdjoint[at(ruleIndex)];
    if (adjoint == 0.0 || std::isnan(m_s.degrees[at(ruleIndex)])) return;
    // Slots of facts on outputs and nodes may have been overwritten by no one: each rule has its own.
    m_gradient.byWeight[at(ruleIndex)] += adjoint * m_s.slots[at(rule.root)];
    m_s.slotAdjoint[at(rule.root)] += adjoint * rule.weight;
    for (int n = rule.nodes.end() - 1; n >= rule.nodes.first; --n) throughNode(block, m_c.nodes[at(n)]);
    for (int f = rule.outputFacts.first; f < rule.outputFacts.end(); ++f)
      throughOutputFact(m_c.outputFacts[at(f)], m_s.seen[at(f)]);
  }

  void throughNode(const FlatBlock& block, const Node& node)
  {
    double adjoint = m_s.slotAdjoint[at(node.slot)];
    if (adjoint == 0.0) return;
    const int* child = m_c.children.data() + node.children.first;
    if (node.kind == Antecedent::Kind::Not) {
      m_s.slotAdjoint[at(child[0])] -= adjoint;
      return;
    }
    const auto join = [&](const auto& a, const auto& b) {
      return node.kind == Antecedent::Kind::And ? apply(block.conjunction, a, b, m_c.width)
                                                : apply(block.disjunction, a, b, m_c.width);
    };
    double degree = m_s.slots[at(child[0])];
    for (int k = 1; k < node.children.count; ++k) {
      m_s.prefix[at(k)] = degree;
      degree = join(degree, m_s.slots[at(child[k])]);
    }
    using D = Dual<2>;
    for (int k = node.children.count - 1; k > 0; --k) {
      const D joined = join(D::variable(m_s.prefix[at(k)], 0), D::variable(m_s.slots[at(child[k])], 1));
      m_s.slotAdjoint[at(child[k])] += adjoint * joined.d[1];
      adjoint *= joined.d[0];
    }
    m_s.slotAdjoint[at(child[0])] += adjoint;
  }

  void throughOutputFact(const OutputFact& fact, int seen)
  {
    const double outer = m_s.slotAdjoint[at(fact.slot)];
    const FlatOutput& output = m_c.outputs[at(fact.output)];
    if (outer == 0.0 || fact.term < 0 || !output.enabled) return;
    const auto join = [&](const auto& a, const auto& b) {
      return output.aggregates ? apply(output.aggregation, a, b, m_c.width) : a + b;
    };
    double degree = 0.0;
    for (int k = 0; k < seen; ++k) {
      const Activated& activated = m_s.activated[at(output.activated.first + k)];
      m_s.prefix[at(k)] = degree;
      if (activated.term == fact.term) degree = join(degree, activated.degree);
    }
    double adjoint = outer * hedgeSlope(m_c.hedgesOf(fact.hedges), degree);
    using D = Dual<2>;
    for (int k = seen - 1; k >= 0; --k) {
      const int place = output.activated.first + k;
      const Activated& activated = m_s.activated[at(place)];
      if (activated.term != fact.term) continue;
      const D joined = join(D::variable(m_s.prefix[at(k)], 0), D::variable(activated.degree, 1));
      m_s.activatedAdjoint[at(place)] += adjoint * joined.d[1];
      adjoint *= joined.d[0];
    }
  }

  void throughFact(const InputFact& fact, double adjoint)
  {
    const InputVariable& variable = m_c.system.inputs[at(fact.input)];
    if (adjoint == 0.0 || fact.term < 0 || !variable.enabled) return;
    const Input& input = m_s.inputs[at(fact.input)];
    const Curve curve = m_c.curve(fact.term, m_s.variables);
    const double x = m_s.variables[at(fact.input)];
    if (input.set || input.low < input.high) {
      const double plain = fuzzyDegree(curve, input, variable.minimum, variable.maximum);
      addFuzzyDegreeSlopes(m_c, fact.term, curve, input, variable.minimum, variable.maximum,
                           adjoint * hedgeSlope(m_c.hedgesOf(fact.hedges), plain), m_slopes);
      return;
    }
    const double plain = membership(curve, x);
    if (std::isnan(plain)) return;
    const double factor = adjoint * hedgeSlope(m_c.hedgesOf(fact.hedges), plain);
    const double byX = addCurveSlopes(m_c, fact.term, curve, x, factor, m_slopes);
    m_s.variableSlopes[1 + at(fact.input)] += factor * byX;
  }

  const Compiled& m_c;
  Scratch& m_s;
  Gradient& m_gradient;
  Slopes m_slopes;
};

} // namespace

void Evaluator::differentiate(int output, Workspace& workspace, Gradient& gradient) const
{
  const Compiled& c = *m_compiled;
  gradient.byInput.assign(c.system.inputs.size(), 0.0);
  gradient.byWeight.assign(c.rules.size(), 0.0);
  gradient.byParameter.assign(c.numbers.size(), 0.0);
  if (output < 0 || output >= static_cast<int>(c.outputs.size())) return;
  Reverse(c, *workspace.m_scratch, gradient).run(output);
}

} // namespace esm::fis
