// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/fuzzy/fis/operators.h"
#include "core/fuzzy/fis/shape.h"

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace esm::fis {

/// A fuzzy inference system as values: what the files FLL, FCL and FIS hold and what Evaluator compiles.
///
///     System
///       inputs      range and terms
///       outputs     range, terms, how their fuzzy set is gathered and made a number
///       blocks      rules, the norms that join their parts, and which of them fire
///
/// Rules refer to variables and terms by their places. Mamdani, Larsen, Takagi-Sugeno, Tsukamoto and inverse
/// Tsukamoto systems are no types of their own: they follow from the implication, the defuzzifier and the
/// shapes of the output's terms, and one system may mix them.

inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

struct InputVariable {
  std::string name, description;
  bool enabled = true; ///< false: every proposition on it has degree 0
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool lockRange = false; ///< values beyond the range count as its nearer end
  std::vector<Term> terms;
};

enum class Defuzzifier : std::uint8_t {
  None,
  Bisector,
  Centroid,
  LargestOfMaximum,
  MeanOfMaximum,
  SmallestOfMaximum,
  WeightedAverage,
  WeightedSum
};
/// How a weighted defuzzifier reads its terms: as numbers at the rule's degree (Takagi-Sugeno, inverse
/// Tsukamoto), or as monotone curves to be inverted (Tsukamoto). Automatic: by the first term that fires.
enum class WeightedType : std::uint8_t { Automatic, TakagiSugeno, Tsukamoto };

struct OutputVariable {
  std::string name, description;
  bool enabled = true; ///< false: rules do not conclude on it and it has no value
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool lockRange = false;         ///< the value is held within the range
  bool lockPrevious = false;      ///< without a rule the last value stays; see Workspace::restart()
  double defaultValue = kNoValue; ///< without a rule; NaN: none
  std::optional<SNorm> aggregation = SNorm::Maximum;
  Defuzzifier defuzzifier = Defuzzifier::Centroid;
  int resolution = 100; ///< of area defuzzifiers, where Options ask for it
  WeightedType weightedType = WeightedType::Automatic;
  /// Of weighted defuzzifiers: rules that conclude the same term count once, with their degrees gathered by
  /// the aggregation (IEC 61131-7). Else each counts by itself, as with fuzzylite 6 and MATLAB.
  bool joinsEqualTerms = false;
  std::vector<Term> terms;
};

/// "service is not very good": hedges in the order written, so the last is applied first. Without a term
/// ("service is any") the hedges end with Any.
struct Proposition {
  bool onOutput = false; ///< an output's term counts with the degree that rules before gave it
  int variable = -1;
  int term = -1; ///< -1: none
  std::vector<Hedge> hedges;
  bool operator==(const Proposition&) const = default;
};

/// What must hold, as a flat tree: node 0 is the root, children come after their parent. And, Or: two or more
/// children, joined from the left; Not: one (1 - degree).
struct Antecedent {
  static constexpr int kMaximumDepth = 64;
  enum class Kind : std::uint8_t { Proposition, And, Or, Not };
  struct Node {
    Kind kind = Kind::Proposition;
    Proposition proposition;
    std::vector<int> children;
    bool operator==(const Node&) const = default;
  };
  std::vector<Node> nodes;
  bool operator==(const Antecedent&) const = default;
};

struct Rule {
  Antecedent antecedent;
  std::vector<Proposition> consequents; ///< one or more, on outputs, each with a term
  double weight = 1.0;
  bool enabled = true;
  bool operator==(const Rule&) const = default;
};

/// Which rules of a block fire. General: all. First, Last: the first (last) `count` rules whose degree is
/// above 0 and not below `threshold`. Highest, Lowest: the `count` rules of highest (lowest) degree above 0.
/// Proportional: all, with degrees divided by their sum. Threshold: those whose degree compares so.
enum class ActivationKind : std::uint8_t { General, First, Last, Highest, Lowest, Proportional, Threshold };
enum class Comparison : std::uint8_t { Less, LessEqual, Equal, NotEqual, GreaterEqual, Greater };
struct Activation {
  ActivationKind kind = ActivationKind::General;
  int count = 1;
  double threshold = 0.0;
  Comparison comparison = Comparison::GreaterEqual;
  bool operator==(const Activation&) const = default;
};

/// What hedges of a conclusion bend: the rule's degree and, as in fuzzylite, that of the conclusions behind
/// it in the same rule; or the term's set ("very stiff" is a narrower set).
enum class ConclusionHedges : std::uint8_t { OnDegree, OnSet };

struct RuleBlock {
  std::string name, description;
  bool enabled = true;
  std::optional<TNorm> conjunction = TNorm::Minimum;
  std::optional<SNorm> disjunction = SNorm::Maximum;
  std::optional<TNorm> implication = TNorm::Minimum;
  Activation activation;
  ConclusionHedges conclusionHedges = ConclusionHedges::OnDegree;
  std::vector<Rule> rules;
};

struct System {
  std::string name, description;
  std::vector<InputVariable> inputs;
  std::vector<OutputVariable> outputs;
  std::vector<RuleBlock> blocks;
};
/// Equal field by field; two NaN are equal.
bool operator==(const InputVariable& a, const InputVariable& b);
bool operator==(const OutputVariable& a, const OutputVariable& b);
bool operator==(const RuleBlock& a, const RuleBlock& b);
bool operator==(const System& a, const System& b);

/// Names are distinct words (letters, digits, _ and .; no keyword or hedge), terms sound, rules over what
/// exists, and everything there that an evaluation needs: norms, defuzzifiers, finite ranges for areas,
/// formulas over inputs and outputs before. The detail names the culprit ("rule 3 of block 'main': ...").
Status checkSystem(const System& system);

/// "FLL word": letters, digits, _ and . (and any byte above 0x7f), no keyword, no hedge.
bool isUsableName(std::string_view name) noexcept;
/// The nearest usable name: other bytes left out, as fuzzylite does; "_" behind a keyword; "unnamed" for
/// none.
std::string usableName(std::string_view name);

bool isArea(Defuzzifier defuzzifier) noexcept;
bool isWeighted(Defuzzifier defuzzifier) noexcept;

/// What the system is called in the literature.
enum class SystemKind : std::uint8_t {
  Mamdani,
  Larsen,
  TakagiSugeno,
  Tsukamoto,
  InverseTsukamoto,
  Hybrid,
  Unknown
};
SystemKind kindOf(const System& system) noexcept;
std::string_view nameOf(SystemKind kind) noexcept;

/// The names that a formula of output `output` may use: x (the place on the axis, or the rule's degree), the
/// inputs, the outputs before; an input called x is "input.x", an output "output.x".
std::vector<std::string> formulaNames(const System& system, std::size_t output);

/// "IF a is b and ..." in the words of FLL, for messages and files.
std::string ruleText(const System& system, const Rule& rule);

} // namespace esm::fis
