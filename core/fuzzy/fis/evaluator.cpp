// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/evaluator.h"

#include "core/fuzzy/fis/compiled.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace esm::fis {

namespace {

/// One evaluation of one compiled system.
class Run {
public:
  Run(const Compiled& c, Scratch& s)
    : m_c(c),
      m_s(s),
      m_least(c.options.area == Options::Area::Exact ? Evaluator::kLeastDegree
                                                     : Evaluator::kLeastSampledDegree)
  {}

  void rules()
  {
    std::fill(m_s.activatedCount.begin(), m_s.activatedCount.end(), 0);
    std::fill(m_s.firings.begin(), m_s.firings.end(), 0.0);
    for (std::size_t i = 0; i < m_c.inputFacts.size(); ++i) m_s.slots[i] = degreeOf(m_c.inputFacts[i]);
    m_s.order.clear();
    for (std::size_t b = 0; b < m_c.blocks.size(); ++b)
      if (m_c.blocks[b].enabled) activate(m_c.blocks[b], m_s.blockSum[b]);
  }

  void outputs()
  {
    for (std::size_t o = 0; o < m_c.outputs.size(); ++o) {
      const OutputResult result = defuzzify(static_cast<int>(o));
      m_s.outputs[o] = result;
      m_s.variables[m_c.system.inputs.size() + o] = result.value;
      if (std::isfinite(result.value)) m_s.previous[o] = result.value;
    }
  }

private:
  double degreeOf(const InputFact& fact) const
  {
    const InputVariable& variable = m_c.system.inputs[at(fact.input)];
    if (!variable.enabled) return 0.0;
    const Input& input = m_s.inputs[at(fact.input)];
    const double x = m_s.variables[at(fact.input)];
    const bool isNumber = !input.set && !(input.low < input.high);
    double degree = 1.0; // of 'any'
    if (isNumber && (x < fact.low || x > fact.high))
      degree = 0.0;
    else if (fact.term >= 0)
      degree = isNumber ? membership(m_c.curve(fact.term, m_s.variables), x)
                        : fuzzyDegree(m_c.curve(fact.term, m_s.variables), input, variable.minimum,
                                      variable.maximum);
    return fact.hedges.count > 0 ? applyHedges(m_c.hedgesOf(fact.hedges), degree) : degree;
  }

  /// What rules before gave to an output's term.
  double degreeOf(const OutputFact& fact, int& seen) const
  {
    const FlatOutput& output = m_c.outputs[at(fact.output)];
    seen = m_s.activatedCount[at(fact.output)];
    if (!output.enabled) return 0.0;
    if (fact.term < 0) return applyHedges(m_c.hedgesOf(fact.hedges), 1.0);
    double degree = 0.0;
    for (int k = 0; k < seen; ++k) {
      const Activated& activated = m_s.activated[at(output.activated.first + k)];
      if (activated.term != fact.term) continue;
      degree = output.aggregates ? apply(output.aggregation, degree, activated.degree, m_c.width)
                                 : degree + activated.degree;
    }
    return applyHedges(m_c.hedgesOf(fact.hedges), degree);
  }

  double degreeOf(const FlatBlock& block, const FlatRule& rule) const
  {
    for (int f = rule.outputFacts.first; f < rule.outputFacts.end(); ++f) {
      const OutputFact& fact = m_c.outputFacts[at(f)];
      m_s.slots[at(fact.slot)] = degreeOf(fact, m_s.seen[at(f)]);
    }
    double* slots = m_s.slots.data();
    for (int n = rule.nodes.first; n < rule.nodes.end(); ++n) {
      const Node& node = m_c.nodes[at(n)];
      const int* child = m_c.children.data() + node.children.first;
      double degree = slots[child[0]];
      if (node.kind == Antecedent::Kind::Not) {
        degree = 1.0 - degree;
      } else if (node.kind == Antecedent::Kind::And && block.conjunction == TNorm::Minimum) {
        for (int k = 1; k < node.children.count; ++k) degree = lesser(degree, slots[child[k]]);
      } else if (node.kind == Antecedent::Kind::And) {
        for (int k = 1; k < node.children.count; ++k)
          degree = apply(block.conjunction, degree, slots[child[k]], m_c.width);
      } else {
        for (int k = 1; k < node.children.count; ++k)
          degree = apply(block.disjunction, degree, slots[child[k]], m_c.width);
      }
      slots[node.slot] = degree;
    }
    return rule.weight * slots[rule.root];
  }

  double computeDegree(const FlatBlock& block, int rule)
  {
    return m_s.degrees[at(rule)] = degreeOf(block, m_c.rules[at(rule)]);
  }

  bool fires(double degree) const { return degree >= m_least; } // not for NaN

  /// Puts the rule's conclusions to their outputs.
  void trigger(const FlatBlock& block, int ruleIndex, double degree)
  {
    const FlatRule& rule = m_c.rules[at(ruleIndex)];
    if (!rule.enabled || !fires(degree)) return;
    m_s.firings[at(ruleIndex)] = degree;
    m_s.order.push_back(ruleIndex);
    for (int k = rule.conclusions.first; k < rule.conclusions.end(); ++k) {
      const Conclusion& conclusion = m_c.conclusions[at(k)];
      const FlatOutput& output = m_c.outputs[at(conclusion.output)];
      if (!output.enabled) continue;
      if (conclusion.hedges.count > 0 && !block.hedgesOnSet)
        degree = applyHedges(m_c.hedgesOf(conclusion.hedges), degree);
      int& count = m_s.activatedCount[at(conclusion.output)];
      m_s.activated[at(output.activated.first + count)] = {
        ruleIndex,         k,
        conclusion.term,   degree,
        block.implication, block.hedgesOnSet ? conclusion.hedges : Range{}};
      ++count;
    }
  }

  bool compares(const Activation& activation, double degree) const
  {
    const bool equal = near(degree, activation.threshold, m_c.width);
    switch (activation.comparison) {
    case Comparison::Less:
      return !equal && degree < activation.threshold;
    case Comparison::LessEqual:
      return equal || degree < activation.threshold;
    case Comparison::Equal:
      return equal;
    case Comparison::NotEqual:
      return !equal;
    case Comparison::GreaterEqual:
      return equal || degree > activation.threshold;
    case Comparison::Greater:
      return !equal && degree > activation.threshold;
    }
    return false;
  }

  /// Marks the rules that lack a fact they need: most of them, where terms are narrow.
  void findDead(const FlatBlock& block)
  {
    const std::size_t count = block.needs.size();
    const std::uint64_t* mask = block.masks.data();
    std::uint64_t* lacks = m_s.lacks.data();
    std::uint64_t dead = 0; // of the first 64 rules: small rule bases have no more
    for (std::size_t k = 0; k < count; ++k) {
      // Without a branch: whether a fact is 0 is a coin toss.
      lacks[k] = m_s.slots[at(block.needs[k])] == 0.0 ? ~std::uint64_t{0} : std::uint64_t{0};
      dead |= mask[k] & lacks[k];
    }
    m_s.dead[0] = dead;
    for (std::size_t w = 1; w < at(block.maskWords); ++w) {
      mask += count;
      dead = 0;
      for (std::size_t k = 0; k < count; ++k) dead |= mask[k] & lacks[k];
      m_s.dead[w] = dead;
    }
    std::fill_n(m_s.degrees.begin() + block.rules.first, block.rules.count, 0.0);
  }

  /// Calls visit(rule) for those rules of the block that may have a degree.
  template <class Visit>
  void forEachAlive(const FlatBlock& block, const Visit& visit) const
  {
    if (block.maskWords == 0) {
      for (int r = block.rules.first; r < block.rules.end(); ++r) visit(r);
      return;
    }
    for (int w = 0; w < block.maskWords; ++w) {
      const int left = block.rules.count - 64 * w;
      const std::uint64_t all = left >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << left) - 1;
      for (std::uint64_t alive = ~m_s.dead[at(w)] & all; alive != 0; alive &= alive - 1)
        visit(block.rules.first + 64 * w + std::countr_zero(alive));
    }
  }

  void activate(const FlatBlock& block, double& sum)
  {
    findDead(block);
    switch (block.activation.kind) {
    case ActivationKind::General:
      forEachAlive(block, [&](int r) { trigger(block, r, computeDegree(block, r)); });
      break;
    case ActivationKind::First:
    case ActivationKind::Last:
      activateSome(block);
      break;
    case ActivationKind::Highest:
    case ActivationKind::Lowest:
      activateBest(block);
      break;
    case ActivationKind::Proportional:
      sum = 0.0;
      forEachAlive(block, [&](int r) { sum += computeDegree(block, r); });
      forEachAlive(block, [&](int r) { trigger(block, r, m_s.degrees[at(r)] / sum); });
      break;
    case ActivationKind::Threshold:
      forEachAlive(block, [&](int r) {
        if (const double degree = computeDegree(block, r); compares(block.activation, degree))
          trigger(block, r, degree);
      });
      break;
    }
  }

  void activateSome(const FlatBlock& block)
  {
    const bool forward = block.activation.kind == ActivationKind::First;
    int left = block.activation.count;
    for (int k = 0; k < block.rules.count; ++k) {
      const int r = forward ? block.rules.first + k : block.rules.end() - 1 - k;
      const double degree = computeDegree(block, r);
      const bool enough =
        degree > block.activation.threshold || near(degree, block.activation.threshold, m_c.width);
      if (left <= 0 || !fires(degree) || !enough) continue;
      trigger(block, r, degree);
      --left;
    }
  }

  /// A heap as std::priority_queue keeps it, so that equal degrees come in the order of fuzzylite.
  void activateBest(const FlatBlock& block)
  {
    const bool highest = block.activation.kind == ActivationKind::Highest;
    const auto later = [&](int a, int b) {
      return highest ? m_s.degrees[at(a)] < m_s.degrees[at(b)] : m_s.degrees[at(a)] > m_s.degrees[at(b)];
    };
    m_s.queue.clear();
    forEachAlive(block, [&](int r) {
      if (!fires(computeDegree(block, r))) return;
      m_s.queue.push_back(r);
      std::push_heap(m_s.queue.begin(), m_s.queue.end(), later);
    });
    for (int left = block.activation.count; left > 0 && !m_s.queue.empty(); --left) {
      trigger(block, m_s.queue.front(), m_s.degrees[at(m_s.queue.front())]);
      std::pop_heap(m_s.queue.begin(), m_s.queue.end(), later);
      m_s.queue.pop_back();
    }
  }

  double valueOf(const FlatOutput& output, int index)
  {
    if (isWeighted(output.defuzzifier)) return defuzzifyWeighted(m_c, output, index, m_s);
    collectSets(m_c, output, index, m_s);
    return output.resolution > 0 ? defuzzifySampled(m_c, output, m_s) : defuzzifyExact(output, m_s);
  }

  OutputResult defuzzify(int index)
  {
    const FlatOutput& output = m_c.outputs[at(index)];
    if (!output.enabled) return {kNoValue, Origin::Disabled};
    OutputResult result{output.defaultValue, Origin::Default};
    if (m_s.activatedCount[at(index)] > 0) {
      const double value = valueOf(output, index);
      result = std::isnan(value) ? OutputResult{output.defaultValue, Origin::NoArea}
                                 : OutputResult{value, Origin::Rules};
    } else if (output.lockPrevious && !std::isnan(m_s.previous[at(index)])) {
      result = {m_s.previous[at(index)], Origin::Previous};
    }
    if (output.lockRange && !std::isnan(result.value))
      result.value = std::clamp(result.value, output.minimum, output.maximum);
    return result;
  }

  const Compiled& m_c;
  Scratch& m_s;
  double m_least;
};

double locked(const InputVariable& variable, double x)
{
  return variable.lockRange && !std::isnan(x) ? std::clamp(x, variable.minimum, variable.maximum) : x;
}

} // namespace

double applyHedges(std::span<const Hedge> hedges, double degree) noexcept
{
  for (const Hedge hedge : hedges) degree = apply(hedge, degree);
  return degree;
}

double hedgeSlope(std::span<const Hedge> hedges, double degree) noexcept
{
  Dual<1> value = Dual<1>::variable(degree, 0);
  for (const Hedge hedge : hedges) value = apply(hedge, value);
  return value.d[0];
}

Result<Evaluator> Evaluator::create(System system, Options options)
{
  if (Status status = checkSystem(system); !status) return status.error();
  if (options.resolution < 0 || options.resolution > 1000000)
    return Error{ErrorCode::InvalidValue, "the resolution is outside 0 to 1000000"};
  auto compiled = std::make_shared<Compiled>();
  compiled->system = std::move(system);
  compiled->options = options;
  compiled->compile();
  return Evaluator(std::move(compiled));
}

const System& Evaluator::system() const noexcept
{
  return m_compiled->system;
}
const Options& Evaluator::options() const noexcept
{
  return m_compiled->options;
}
std::size_t Evaluator::ruleCount() const noexcept
{
  return m_compiled->rules.size();
}
std::span<const ParameterPlace> Evaluator::parameters() const noexcept
{
  return m_compiled->places;
}

void Evaluator::evaluate(std::span<const double> inputs, Workspace& workspace) const noexcept
{
  Scratch& s = *workspace.m_scratch;
  const auto& variables = m_compiled->system.inputs;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const double x = locked(variables[i], i < inputs.size() ? inputs[i] : kNoValue);
    s.variables[i] = x;
    s.inputs[i] = Input::number(x);
  }
  Run run(*m_compiled, s);
  run.rules();
  run.outputs();
}

void Evaluator::evaluate(std::span<const Input> inputs, Workspace& workspace) const noexcept
{
  Scratch& s = *workspace.m_scratch;
  const auto& variables = m_compiled->system.inputs;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    Input input = i < inputs.size() ? inputs[i] : Input{};
    if (!input.set)
      input.low = locked(variables[i], input.low), input.high = locked(variables[i], input.high);
    s.inputs[i] = input;
    s.variables[i] = standIn(input, variables[i].minimum, variables[i].maximum);
  }
  Run run(*m_compiled, s);
  run.rules();
  run.outputs();
}

double Evaluator::aggregatedAt(int outputIndex, double x, const Workspace& workspace) const noexcept
{
  const Scratch& s = *workspace.m_scratch;
  const FlatOutput& output = m_compiled->outputs[at(outputIndex)];
  double height = 0.0;
  for (int k = 0; k < s.activatedCount[at(outputIndex)]; ++k) {
    const Activated& activated = s.activated[at(output.activated.first + k)];
    const double set = applyHedges(m_compiled->hedgesOf(activated.setHedges),
                                   membership(m_compiled->curve(activated.term, s.variables), x));
    height = apply(output.aggregation, height,
                   apply(activated.implication, set, activated.degree, m_compiled->width), m_compiled->width);
  }
  return height;
}

} // namespace esm::fis
