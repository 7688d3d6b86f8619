// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/base/types.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace esm::fuzzy {

/// A name in both languages of the program. The id of the thing lives beside it and never changes.
struct Names {
  std::string english, german;
  const std::string& in(Language language) const noexcept
  {
    return language == Language::German ? german : english;
  }
  bool operator==(const Names&) const = default;
};

/// Membership of x in a linguistic term, in [0, 1]:
///   Triangle  a b c     0 outside [a, c], 1 at b
///   Trapezoid a b c d   1 on [b, c], linear flanks (a = b or c = d makes an upright flank)
///   Gaussian  m s       exp(-(x - m)^2 / (2 s^2)), s > 0
/// -infinity/+infinity as outer corner of Triangle and Trapezoid make a shoulder.
enum class Shape : std::uint8_t { Triangle, Trapezoid, Gaussian };

struct Term {
  std::string id; ///< distinct within its variable
  Names name;
  Shape shape = Shape::Triangle;
  std::vector<double> parameters; ///< 3, 4 or 2 numbers; on a log variable in log10 of its unit
  bool operator==(const Term&) const = default;
};

/// A linguistic variable. Terms of a `logarithmic` variable live on log10(value): minimum, maximum
/// and defaultValue are plain values, term parameters are logarithms.
struct Variable {
  std::string id; ///< distinct over all variables of the rule base
  Names name;
  std::string unit; ///< "Pa", "s", empty for a number without unit
  double minimum = 0.0, maximum = 1.0;
  double defaultValue = 0.0; ///< start of an input; an output's value when no rule fires
  bool logarithmic = false;
  std::vector<Term> terms;
  bool operator==(const Variable&) const = default;
};

/// very: mu^2, extremely: mu^3, somewhat: sqrt(mu), not: 1 - mu; applied from the innermost outward.
enum class Hedge : std::uint8_t { Not, Very, Extremely, Somewhat };

/// "hardness IS not very hard": hedges in the order written, so the last one is applied first.
struct Proposition {
  std::string variable, term; ///< ids
  std::vector<Hedge> hedges;
  bool operator==(const Proposition&) const = default;
};

inline constexpr int kMaximumConditionDepth = 64;

/// The condition of a rule as a flat tree: AND is the minimum, OR the maximum, NOT 1 - mu.
/// Node 0 is the root; children come after their parent.
/// No branch is longer than kMaximumConditionDepth nodes: deeper nesting is no sentence any more.
struct Condition {
  enum class Kind : std::uint8_t { Proposition, And, Or, Not };
  struct Node {
    Kind kind = Kind::Proposition;
    Proposition proposition;   ///< for Kind::Proposition
    std::vector<int> children; ///< And, Or: two or more; Not: one
    bool operator==(const Node&) const = default;
  };
  std::vector<Node> nodes;
  bool operator==(const Condition&) const = default;
};

struct Rule {
  Condition condition;
  std::vector<Proposition> consequents; ///< one or more; no hedge Not (a set, not its complement)
  double weight = 1.0;                  ///< [0, 1]
  bool enabled = true;
  std::string note;
  bool operator==(const Rule&) const = default;
};

/// Variables and rules; rules refer to variables and terms by id, so renaming one renames it in every rule.
struct RuleBase {
  std::vector<Variable> inputs, outputs;
  std::vector<Rule> rules;
  bool operator==(const RuleBase&) const = default;

  const Variable* findInput(std::string_view id) const noexcept; ///< null if absent
  const Variable* findOutput(std::string_view id) const noexcept;
};

/// Ids distinct and present, term parameters ordered and finite where they must be, ranges not empty,
/// every rule over known ids. The detail names the culprit ("rule 3: term 'hrad' is unknown ...").
Status checkRuleBase(const RuleBase& ruleBase);

/// Membership of x (log10 x for a logarithmic variable) in [0, 1]. 0 for NaN.
double membership(const Term& term, double x) noexcept;
double applyHedges(const std::vector<Hedge>& hedges, double degree) noexcept;

/// The word that fits a crisp value best, with its degree; hedged terms are not tried.
struct NamedDegree {
  int term = -1;
  double degree = 0.0;
};
NamedDegree bestTerm(const Variable& variable, double value) noexcept;

} // namespace esm::fuzzy
