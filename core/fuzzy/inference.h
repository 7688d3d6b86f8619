// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/fuzzy/rule_base.h"
#include "core/fuzzy/rule_text.h"

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace esm::fuzzy {

/// One output's answer and the account of it.
struct OutputValue {
  double value = 0.0;     ///< plain (not log), within the variable's range
  bool fromRules = false; ///< false: no rule fired, value is the variable's default
};

struct RuleFiring {
  int rule = -1;       ///< index into RuleBase::rules
  double degree = 0.0; ///< of the condition, times the weight, in [0, 1]
};

/// Everything that led to the outputs, for "why is it stiff?".
struct Inference {
  std::vector<OutputValue> outputs; ///< one per RuleBase::outputs
  std::vector<RuleFiring> firings;  ///< one per rule that is on, in rule order, degree 0 included
};

/// Mamdani inference: AND minimum, OR maximum, implication minimum (the set is clipped at the rule's degree),
/// aggregation maximum, defuzzification centroid. The centroid of the clipped piecewise sets is integrated
/// exactly for triangles and trapezoids, by adaptive quadrature (relative 1e-12) where a Gaussian takes part.
/// The general engine (core/fuzzy/fis) does the work. Compiled once; evaluate() is const, any thread.
/// Source: Mamdani & Assilian 1975; ESM paper (1999), section 3.2.
class Engine {
public:
  /// Errors: those of checkRuleBase().
  static Result<Engine> create(RuleBase ruleBase);

  /// @param inputs one per RuleBase::inputs, in that order. A crisp value outside the range counts as the
  /// nearer end;
  ///        a Word's degree in a term is the height of the intersection of both sets (sup-min).
  ///        A missing or non-finite input or an unknown word counts as the variable's default.
  /// @return no NaN whatever the inputs. Rules of a degree below 1e-12 count as not fired.
  Inference evaluate(std::span<const InputValue> inputs) const;

  /// The exact partial derivatives of one output's value by each input, both plain. 0 by words, by numbers
  /// that are held at an end of their range, and all 0 if no rule fired. At a kink those of one side.
  /// @param output index into RuleBase::outputs. @return one per RuleBase::inputs.
  std::vector<double> slopes(std::span<const InputValue> inputs, int output) const;

  const RuleBase& ruleBase() const noexcept;

private:
  /// Rules with ids resolved; never changes after create(), so copies share it.
  struct Compiled;
  explicit Engine(std::shared_ptr<const Compiled> compiled) : m_compiled(std::move(compiled)) {}
  std::shared_ptr<const Compiled> m_compiled;
};

/// The aggregated set of one output under given firings, sampled for a plot: n points of (x, mu) over the
/// variable's range (x plain, spaced evenly on its own scale).
std::vector<std::pair<double, double>> aggregatedSet(const RuleBase& ruleBase, const Inference& inference,
                                                     int output, int points);

} // namespace esm::fuzzy
