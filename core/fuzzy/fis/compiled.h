// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

// Internal to core/fuzzy/fis: what Evaluator compiles a System into, and what an evaluation writes.
#include "core/fuzzy/fis/evaluator.h"

#include <vector>

namespace esm::fis {

/// An index of the flat arrays, which is -1 for none, where there is one.
inline std::size_t at(int index) noexcept
{
  return static_cast<std::size_t>(index);
}

/// Part of a flat array.
struct Range {
  int first = 0, count = 0;
  int end() const noexcept { return first + count; }
};

/// A term without strings; its parameters, then its height, lie in Compiled::numbers.
struct FlatTerm {
  Shape shape = Shape::Triangle;
  Range parameters;
  int formula = -1;      ///< into Compiled::formulas
  int variables = 0;     ///< how many of Scratch::variables the formula, or Linear, sees
  int tableFirst = 0;    ///< sampled outputs: where its samples start in Compiled::tables
  Range support;         ///< the samples that are not 0
  bool straight = false; ///< between corners
};

/// A degree that conditions refer to: an input's term under hedges.
struct InputFact {
  int input = -1, term = -1; ///< term: -1 for 'any', else into Compiled::terms
  Range hedges;
  double low, high; ///< outside the curve is 0: most facts of a number end here
};
/// The same on an output; its degree depends on when it is asked for, so each occurrence is one.
struct OutputFact {
  int output = -1, term = -1;
  Range hedges;
  int slot = -1;
};

/// And, Or, Not over slots; its own result is slot `slot`.
struct Node {
  Antecedent::Kind kind = Antecedent::Kind::And;
  Range children; ///< into Compiled::children
  int slot = -1;
};

struct Conclusion {
  int output = -1, term = -1;
  Range hedges;
};

struct FlatRule {
  double weight = 1.0;
  bool enabled = true;
  int root = -1; ///< slot of its degree
  Range outputFacts;
  Range nodes; ///< children before parents
  Range conclusions;
};

struct FlatBlock {
  bool enabled = true;
  TNorm conjunction{}, implication{};
  SNorm disjunction{};
  Activation activation;
  bool hedgesOnSet = false;
  Range rules;
  int maskWords = 0;                ///< of 64 rules each
  std::vector<int> needs;           ///< input facts without which rules have degree 0
  std::vector<std::uint64_t> masks; ///< per word, per such fact: which of those 64 rules need it
};

struct FlatOutput {
  bool enabled = true, lockRange = false, lockPrevious = false, aggregates = true, joins = false;
  double minimum = 0.0, maximum = 1.0, defaultValue = kNoValue;
  SNorm aggregation{};
  Defuzzifier defuzzifier{};
  WeightedType weightedType{};
  int resolution = 100; ///< 0: exact
  Range activated;      ///< its places in Scratch::activated
  Range terms;          ///< its terms in Compiled::terms
  bool tabulated = false;
  int gridFirst = 0; ///< the middles of its steps in Compiled::tables
  int markBound = 0; ///< of an exact defuzzification
};

/// All slots: first the input facts, then the output facts and nodes of all rules.
struct Compiled {
  System system;
  Options options;
  std::vector<double> numbers; ///< parameters and heights of all terms
  std::vector<ParameterPlace> places;
  std::vector<FlatTerm> terms; ///< of inputs, then of outputs
  std::vector<Formula> formulas;
  std::vector<Hedge> hedges; ///< in the order of application (last written first)
  std::vector<InputFact> inputFacts;
  std::vector<OutputFact> outputFacts;
  std::vector<Node> nodes;
  std::vector<int> children;
  std::vector<Conclusion> conclusions;
  std::vector<FlatRule> rules;
  std::vector<FlatBlock> blocks;
  std::vector<FlatOutput> outputs;
  std::vector<double> tables;
  int slotCount = 0;
  int mostChildren = 2;
  double width = 0.0; ///< of comparisons, see near(): that of fuzzylite in sampled mode

  void compile();
  Curve curve(int term, std::span<const double> variables) const noexcept
  {
    const FlatTerm& flat = terms[static_cast<std::size_t>(term)];
    const auto first = static_cast<std::size_t>(flat.parameters.first);
    const auto count = static_cast<std::size_t>(flat.parameters.count);
    Curve result{flat.shape, {numbers.data() + first, count}, numbers[first + count], nullptr, {}};
    if (flat.formula >= 0) result.formula = &formulas[static_cast<std::size_t>(flat.formula)];
    if (flat.variables > 0) result.variables = variables.first(static_cast<std::size_t>(flat.variables));
    return result;
  }
  std::span<const Hedge> hedgesOf(Range range) const noexcept
  {
    return {hedges.data() + range.first, static_cast<std::size_t>(range.count)};
  }
};

/// One conclusion of a rule that fired.
struct Activated {
  int rule = -1, conclusion = -1, term = -1;
  double degree = 0.0;
  TNorm implication{};
  Range setHedges; ///< hedges on the set, not on the degree
};

/// A place on the axis of an output, in [0, 1] of its range, and why it is one.
struct Mark {
  enum class Kind : std::uint8_t {
    Corner, ///< of a set's curve
    Level,  ///< where a set's curve passes the degree, or 1 - degree
    Fixed   ///< an end of the range, or a place between
  };
  double u = 0.0;
  Kind kind = Kind::Fixed;
  int set = -1;            ///< into Scratch::sets
  bool complement = false; ///< of Level: 1 - degree
  Corner corner{};         ///< of Corner, in the output's own unit
};

/// The sets whose union is defuzzified: activated ones, equal terms joined where the aggregation is maximum.
struct ActiveSet {
  int activated = -1; ///< the one that counts, into Scratch::activated
  Curve curve;
  int term = -1;
  double degree = 0.0;
  TNorm implication{};
  std::span<const Hedge> hedges;
  Range setHedges;
  bool straight = false; ///< between corners and level crossings
};

/// Area and first moment between two marks.
struct Segment {
  double area = 0.0, moment = 0.0;
};

/// All memory of an evaluation.
struct Scratch {
  std::vector<double> variables; ///< of inputs, then outputs: what formulas see
  std::vector<Input> inputs;
  std::vector<double> slots, slotAdjoint;
  std::vector<double> prefix; ///< of folds
  std::vector<double> degrees, firings, ruleAdjoint;
  std::vector<int> queue;           ///< of Highest and Lowest
  std::vector<std::uint64_t> dead;  ///< rules that lack a fact they need
  std::vector<std::uint64_t> lacks; ///< per need: all bits if its fact is 0
  std::vector<int> order;           ///< rules that fired, in the order they did
  std::vector<double> blockSum;     ///< of Proportional
  std::vector<Activated> activated;
  std::vector<double> activatedAdjoint;
  std::vector<int> activatedCount; ///< per output
  std::vector<int> seen;           ///< per output fact: how many were activated when it was asked for
  std::vector<OutputResult> outputs;
  std::vector<double> outputAdjoint;
  std::vector<double> previous;
  std::vector<double> samples;
  std::vector<ActiveSet> sets;
  std::vector<int> setOfTerm; ///< per term: the last set of it, -1 none
  std::vector<Mark> marks;
  std::vector<Segment> segments;
  std::vector<double> starts, ends; ///< of straight pieces
  std::vector<double> heights;      ///< of the sets at one place
  std::vector<double> byDegree;     ///< derivatives, per set
  std::vector<double> variableSlopes;
  std::vector<double> partial, partialCoarse,
    partialScale; ///< derivatives of integrals: sets, numbers, variables
};

/// Where derivatives are gathered: sums of (derivative of the wanted output by ...).
struct Slopes {
  std::span<double> byNumber;   ///< Compiled::numbers
  std::span<double> byVariable; ///< an unused place for x, then Scratch::variables
};

double applyHedges(std::span<const Hedge> hedges, double degree) noexcept;
/// d(result)/d(degree).
double hedgeSlope(std::span<const Hedge> hedges, double degree) noexcept;
/// Adds `factor` times the slopes of the term's curve at x; returns its derivative by x.
double addCurveSlopes(const Compiled& c, int term, const Curve& curve, double x, double factor,
                      const Slopes& slopes) noexcept;

// fuzzy_input.cpp: inputs that are no numbers.
double fuzzyDegree(const Curve& term, const Input& input, double low, double high) noexcept;
void addFuzzyDegreeSlopes(const Compiled& c, int termIndex, const Curve& term, const Input& input, double low,
                          double high, double factor, const Slopes& slopes) noexcept;
/// The number that stands in for it.
double standIn(const Input& input, double low, double high) noexcept;

// sets.cpp: what is to be united, in order.
void collectSets(const Compiled& c, const FlatOutput& output, int outputIndex, Scratch& s) noexcept;
double heightOf(const ActiveSet& set, double x, double width = 0.0) noexcept;
double heightOfAll(const FlatOutput& output, std::span<const ActiveSet> sets,
                   double x) noexcept; ///< exact mode
/// Adds `factor` times the slopes of the aggregated height at x: by each set's degree to byDegree[set].
void addHeightSlopes(const Compiled& c, const FlatOutput& output, Scratch& s, double x, double factor,
                     std::span<double> byDegree, const Slopes& slopes) noexcept;

// The defuzzifiers: the value in the output's unit (NaN: none), and `factor` times its derivatives, those by
// degrees added to Scratch::activatedAdjoint. Both after collectSets().
double defuzzifyWeighted(const Compiled& c, const FlatOutput& output, int outputIndex, Scratch& s) noexcept;
void addWeightedSlopes(const Compiled& c, const FlatOutput& output, int outputIndex, Scratch& s,
                       double factor, const Slopes& slopes) noexcept;
double defuzzifySampled(const Compiled& c, const FlatOutput& output, Scratch& s) noexcept;
void addSampledSlopes(const Compiled& c, const FlatOutput& output, Scratch& s, double factor,
                      const Slopes& slopes) noexcept;
double defuzzifyExact(const FlatOutput& output, Scratch& s) noexcept;
void addExactSlopes(const Compiled& c, const FlatOutput& output, Scratch& s, double value, double factor,
                    const Slopes& slopes) noexcept;

} // namespace esm::fis
