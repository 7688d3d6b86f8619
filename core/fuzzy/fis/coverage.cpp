// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/coverage.h"

#include <array>
#include <map>
#include <set>

namespace esm::fis {

namespace {

constexpr std::size_t kMostHoles = 4;   ///< of one output; a list of more would not be read
constexpr std::size_t kMostKept = 4096; ///< uncovered places of one output that are looked at closer
constexpr int kJointTries = 400;        ///< to make sure that a hole does not hang on an input

using Inputs = std::vector<int>;

/// Places at which to try an input: ends, corners of its terms and the middles between.
std::vector<double> triesOf(const InputVariable& input)
{
  const Stretch stretch = stretchOf(input);
  std::set<double> places = {stretch.low, stretch.high};
  for (const Term& term : input.terms)
    forEachCorner(curveOf(term), [&](const Corner& corner) {
      if (corner.x > stretch.low && corner.x < stretch.high && places.size() < 200) places.insert(corner.x);
    });
  std::vector<double> tries;
  for (const double place : places) {
    if (!tries.empty()) tries.push_back(0.5 * (tries.back() + place));
    tries.push_back(place);
  }
  return tries;
}

double halton(int index, int base)
{
  double value = 0.0, share = 1.0;
  for (; index > 0; index /= base) {
    share /= base;
    value += share * (index % base);
  }
  return value;
}

double spread(int index, std::size_t dimension)
{
  constexpr std::array<int, 16> kBases = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53};
  return halton(index + static_cast<int>(dimension / kBases.size()) * 7919,
                kBases[dimension % kBases.size()]);
}

/// Which inputs decide whether a rule sets an output, by output; empty where no rule concludes on it.
class Dependence {
public:
  explicit Dependence(const System& system) : m_inputs(system.outputs.size())
  {
    // A condition on an output hangs on what that one hangs on: repeat until nothing is added.
    for (bool changed = true; changed;) {
      changed = false;
      for (const RuleBlock& block : system.blocks)
        if (block.enabled) changed = addBlock(block) || changed;
    }
  }
  bool isSet(std::size_t output) const { return m_isSet.count(static_cast<int>(output)) > 0; }
  Inputs inputsOf(std::size_t output) const { return {m_inputs[output].begin(), m_inputs[output].end()}; }

private:
  bool addBlock(const RuleBlock& block)
  {
    std::set<int> ofBlock;
    for (const Rule& rule : block.rules)
      if (rule.enabled) addCondition(rule, ofBlock);
    bool changed = false;
    for (const Rule& rule : block.rules) {
      if (!rule.enabled) continue;
      std::set<int> inputs;
      addCondition(rule, inputs);
      // Where only some rules of a block may fire, each hangs on the others' conditions too.
      const std::set<int>& all = block.activation.kind == ActivationKind::General ? inputs : ofBlock;
      for (const Proposition& consequent : rule.consequents) {
        m_isSet.insert(consequent.variable);
        std::set<int>& mine = m_inputs[static_cast<std::size_t>(consequent.variable)];
        const std::size_t before = mine.size();
        mine.insert(all.begin(), all.end());
        changed = changed || mine.size() != before;
      }
    }
    return changed;
  }

  void addCondition(const Rule& rule, std::set<int>& inputs) const
  {
    for (const Antecedent::Node& node : rule.antecedent.nodes) {
      if (node.kind != Antecedent::Kind::Proposition) continue;
      const auto variable = static_cast<std::size_t>(node.proposition.variable);
      if (!node.proposition.onOutput)
        inputs.insert(node.proposition.variable);
      else if (variable < m_inputs.size())
        inputs.insert(m_inputs[variable].begin(), m_inputs[variable].end());
    }
  }

  std::vector<std::set<int>> m_inputs;
  std::set<int> m_isSet;
};

class Prober {
public:
  Prober(const Evaluator& evaluator, int places)
    : m_system(evaluator.system()),
      m_evaluator(evaluator),
      m_places(places),
      m_workspace(evaluator.makeWorkspace()),
      m_middles(middlesOf(m_system))
  {
    for (const InputVariable& input : m_system.inputs) m_tries.push_back(triesOf(input));
    m_coverage.silent.assign(evaluator.ruleCount(), true);
  }

  Coverage run()
  {
    const Dependence dependence(m_system);
    std::map<Inputs, std::vector<std::size_t>> groups; // outputs that hang on the same inputs
    for (std::size_t o = 0; o < m_system.outputs.size(); ++o)
      if (m_system.outputs[o].enabled && dependence.isSet(o)) groups[dependence.inputsOf(o)].push_back(o);
    for (const auto& [inputs, outputs] : groups) tryGroup(inputs, outputs);
    std::sort(m_coverage.holes.begin(), m_coverage.holes.end(),
              [](const Hole& a, const Hole& b) { return a.output < b.output; });
    tryHarder();
    return std::move(m_coverage);
  }

private:
  void evaluate(const std::vector<double>& place)
  {
    m_workspace.restart();
    m_evaluator.evaluate(place, m_workspace);
    for (std::size_t r = 0; r < m_coverage.silent.size(); ++r)
      if (m_workspace.degrees()[r] > Evaluator::kLeastDegree) m_coverage.silent[r] = false;
  }
  bool isHole(std::size_t output) const { return m_workspace.outputs()[output].origin == Origin::Default; }
  bool isHoleAt(const std::vector<double>& place, std::size_t output)
  {
    evaluate(place);
    return isHole(output);
  }

  /// Calls visit(place) for all combinations of tries of `inputs`, or for `most` of them spread evenly, until
  /// it returns false. @return false: it did.
  template <class Visit>
  bool forPlaces(const Inputs& inputs, std::vector<double> place, int most, bool alsoBetween,
                 const Visit& visit)
  {
    double combinations = 1.0;
    for (const int i : inputs) combinations *= static_cast<double>(triesFor(i).size());
    if (combinations <= most) {
      std::vector<std::size_t> digit(inputs.size(), 0);
      for (;;) {
        for (std::size_t k = 0; k < inputs.size(); ++k)
          place[static_cast<std::size_t>(inputs[k])] = triesFor(inputs[k])[digit[k]];
        if (!visit(place)) return false;
        std::size_t k = 0;
        while (k < digit.size() && ++digit[k] == triesFor(inputs[k]).size()) digit[k++] = 0;
        if (k == digit.size()) return true;
      }
    }
    for (int n = 1; n <= most; ++n) {
      for (std::size_t k = 0; k < inputs.size(); ++k) {
        const std::vector<double>& tries = triesFor(inputs[k]);
        const double share = spread(n, k);
        const auto corner = static_cast<std::size_t>(share * static_cast<double>(tries.size()));
        place[static_cast<std::size_t>(inputs[k])] =
          alsoBetween && n % 2 == 0 ? tries.front() + share * (tries.back() - tries.front()) : tries[corner];
      }
      if (!visit(place)) return false;
    }
    return true;
  }
  const std::vector<double>& triesFor(int input) const { return m_tries[static_cast<std::size_t>(input)]; }

  void tryGroup(const Inputs& inputs, const std::vector<std::size_t>& outputs)
  {
    std::vector<std::vector<std::vector<double>>> uncovered(outputs.size());
    int tried = 0;
    forPlaces(inputs, m_middles, m_places, true, [&](const std::vector<double>& place) {
      evaluate(place);
      ++tried;
      for (std::size_t k = 0; k < outputs.size(); ++k)
        if (isHole(outputs[k]) && uncovered[k].size() < kMostKept) uncovered[k].push_back(place);
      return true;
    });
    for (std::size_t k = 0; k < outputs.size(); ++k)
      addHoles(outputs[k], inputs, std::move(uncovered[k]), tried);
  }

  /// Makes holes of uncovered places: the first place grows into a box, which takes its places out.
  void addHoles(std::size_t output, const Inputs& inputs, std::vector<std::vector<double>> places, int tried)
  {
    for (std::size_t count = 0; count < kMostHoles && !places.empty(); ++count) {
      Hole hole{static_cast<int>(output), places.front(), {}, 0.0};
      Inputs free;
      sortOut(inputs, hole, free);
      std::vector<Stretch> box;
      for (const int i : hole.inputs) box.push_back(widen(hole.place, i, free, output));
      const std::size_t before = places.size();
      std::erase_if(places, [&](const std::vector<double>& place) {
        for (std::size_t k = 0; k < box.size(); ++k) {
          const double x = place[static_cast<std::size_t>(hole.inputs[k])];
          if (x < box[k].low || x > box[k].high) return false;
        }
        return true;
      });
      if (places.size() == before) places.erase(places.begin()); // its middle moved out of its own box
      hole.share = static_cast<double>(before - places.size()) / tried;
      m_coverage.holes.push_back(std::move(hole));
    }
  }

  /// Whether the output stays without a rule with the `free` inputs anywhere.
  bool isHoleFor(const Inputs& free, const std::vector<double>& place, std::size_t output)
  {
    return forPlaces(free, place, kJointTries, false,
                     [&](const std::vector<double>& other) { return isHoleAt(other, output); });
  }

  /// Parts the inputs into those that the hole hangs on and those that are free.
  void sortOut(const Inputs& inputs, Hole& hole, Inputs& free)
  {
    for (const int input : inputs) {
      free.push_back(input);
      if (isHoleFor(free, hole.place, static_cast<std::size_t>(hole.output))) continue;
      free.pop_back();
      hole.inputs.push_back(input);
    }
  }

  /// The stretch along an input around `place` where the output stays without a rule, whatever the free
  /// inputs are; moves `place` to its middle.
  Stretch widen(std::vector<double>& place, int input, const Inputs& free, std::size_t output)
  {
    double& x = place[static_cast<std::size_t>(input)];
    const double start = x;
    Stretch box{start, start};
    const std::vector<double>& tries = triesFor(input);
    for (auto it = std::upper_bound(tries.begin(), tries.end(), start); it != tries.end(); ++it) {
      x = *it;
      if (!isHoleFor(free, place, output)) break;
      box.high = x;
    }
    for (auto it = std::make_reverse_iterator(std::lower_bound(tries.begin(), tries.end(), start));
         it != tries.rend(); ++it) {
      x = *it;
      if (!isHoleFor(free, place, output)) break;
      box.low = x;
    }
    x = 0.5 * (box.low + box.high);
    if (!isHoleFor(free, place, output)) x = start;
    return box;
  }

  /// Rules that seemed silent are tried at the places that suit each of their conditions best.
  void tryHarder()
  {
    std::size_t flat = 0;
    for (const RuleBlock& block : m_system.blocks)
      for (std::size_t r = 0; r < block.rules.size(); ++r, ++flat)
        if (block.enabled && block.rules[r].enabled) climb(flat);
  }

  void climb(std::size_t rule)
  {
    for (int start = 0; start < 4 && m_coverage.silent[rule]; ++start) {
      std::vector<double> values = m_middles;
      for (std::size_t i = 0; i < values.size() && start > 0; ++i)
        values[i] = m_tries[i][(static_cast<std::size_t>(start) * 7 + i * 3) % m_tries[i].size()];
      for (int sweep = 0; sweep < 2; ++sweep)
        for (std::size_t i = 0; i < values.size() && m_coverage.silent[rule]; ++i) {
          double bestValue = values[i], best = -1.0;
          for (const double value : m_tries[i]) {
            values[i] = value;
            evaluate(values);
            if (m_workspace.degrees()[rule] > best) best = m_workspace.degrees()[rule], bestValue = value;
          }
          values[i] = bestValue;
        }
    }
  }

  const System& m_system;
  const Evaluator& m_evaluator;
  int m_places;
  Workspace m_workspace;
  std::vector<double> m_middles;
  std::vector<std::vector<double>> m_tries;
  Coverage m_coverage;
};

} // namespace

std::vector<double> middlesOf(const System& system)
{
  std::vector<double> values;
  for (const InputVariable& input : system.inputs) {
    const Stretch stretch = stretchOf(input);
    values.push_back(0.5 * (stretch.low + stretch.high));
  }
  return values;
}

Coverage tryPlaces(const Evaluator& evaluator, int places)
{
  return Prober(evaluator, places).run();
}

} // namespace esm::fis
