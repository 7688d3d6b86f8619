// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/fuzzy/fis/system.h"

#include <memory>
#include <span>
#include <vector>

namespace esm::fis {

/// How area defuzzifiers integrate. Exact: piece by piece between the corners, in closed form where the set
/// is straight, else by adaptive quadrature (relative 1e-12). Sampled: at the middles of n equal steps, as
/// fuzzylite and MATLAB do, and the Tsukamoto inverses as fuzzylite 6.0 has them.
struct Options {
  enum class Area : std::uint8_t { Exact, Sampled } area = Area::Exact;
  int resolution = 0; ///< of Sampled; 0: each output's own
};

/// What is known about one input: a number, an interval, or a fuzzy set (a word: a term under hedges).
///
/// The degree of a term is its membership at the number, its highest membership within the interval, or the
/// height of the intersection of both sets (sup-min). Where a single number is needed (Linear and Function
/// conclusions) the middle of the interval stands in, for a set the place of its highest membership.
/// A NaN is an input nobody gave, see operators.h.
struct Input {
  double low = kNoValue, high = kNoValue; ///< equal for a number
  const Term* set = nullptr;              ///< a membership curve, not owned, or null
  std::span<const Hedge> hedges{};        ///< of the set, in the order written; not owned

  static Input number(double x) { return {x, x, nullptr, {}}; }
  static Input interval(double low, double high) { return {low, high, nullptr, {}}; }
  static Input word(const Term& set, std::span<const Hedge> hedges = {})
  {
    return {kNoValue, kNoValue, &set, hedges};
  }
};

enum class Origin : std::uint8_t {
  Rules,    ///< from the rules that fired
  Default,  ///< no rule fired: the default value, NaN if there is none
  Previous, ///< no rule fired: the value before (lockPrevious)
  NoArea,   ///< rules fired, but their sets have no area or a formula no value: the default
  Disabled  ///< the variable is off: NaN
};

/// One output's answer. The value is NaN only where Origin says why: it is never NaN from Rules.
struct OutputResult {
  double value = kNoValue;
  Origin origin = Origin::Default;
};

/// The exact partial derivatives of one output's value, see Evaluator::differentiate().
struct Gradient {
  std::vector<double> byInput;     ///< one per input
  std::vector<double> byWeight;    ///< one per rule, blocks one after another
  std::vector<double> byParameter; ///< one per place of Evaluator::parameters()
};

/// Which number of the system a place of Gradient::byParameter is.
struct ParameterPlace {
  bool onOutput = false;
  int variable = -1, term = -1;
  int index = -1; ///< into Term::parameters; -1: the height
};

struct Compiled;
struct Scratch;

/// What one thread needs to evaluate: all memory of it, and the results. Made by Evaluator::makeWorkspace();
/// fits that evaluator and its copies only.
class Workspace {
public:
  Workspace(Workspace&&) noexcept;
  Workspace& operator=(Workspace&&) noexcept;
  ~Workspace();

  std::span<const OutputResult> outputs() const noexcept; ///< one per output
  /// One per rule, blocks one after another: the degree with which it fired (weight included, after
  /// Proportional), 0 if it did not.
  std::span<const double> firings() const noexcept;
  /// One per rule: weight times the degree of its condition, before the block's activation chose; NaN if it
  /// hangs on an input that was not given. Rules that are off are computed all the same.
  std::span<const double> degrees() const noexcept;
  /// Forgets the values before: the next evaluation is the first one for lockPrevious.
  void restart() noexcept;

private:
  friend class Evaluator;
  explicit Workspace(std::unique_ptr<Scratch> scratch);
  std::unique_ptr<Scratch> m_scratch;
};

/// A System compiled into flat arrays. Const, shared by its copies, any thread; evaluate() and
/// differentiate() allocate nothing, all their memory is in the Workspace (one per thread).
///
///     const auto evaluator = Evaluator::create(system);
///     Workspace workspace = evaluator->makeWorkspace();
///     evaluator->evaluate(std::array{0.3, 7.0}, workspace);
///     workspace.outputs()[0].value
///
/// One evaluation: degrees of the input terms, then block by block the rules, then output by output the
/// number. A rule fires if its degree is not below a least one.
class Evaluator {
public:
  /// Degrees so small that no conclusion should hang on them: the far tail of a bell would else turn an
  /// output that no rule speaks of into the middle of its range. In sampled mode that of fuzzylite.
  static constexpr double kLeastDegree = 1e-12, kLeastSampledDegree = 1e-6;

  /// Errors: those of checkSystem().
  static Result<Evaluator> create(System system, Options options = {});

  const System& system() const noexcept;
  const Options& options() const noexcept;
  std::size_t ruleCount() const noexcept; ///< over all blocks
  Workspace makeWorkspace() const;

  /// @param inputs one per System::inputs; missing ones are not given (NaN), infinite ones as they are.
  void evaluate(std::span<const double> inputs, Workspace& workspace) const noexcept;
  void evaluate(std::span<const Input> inputs, Workspace& workspace) const noexcept;

  /// The derivatives of one output's value of the last evaluation in this workspace. All zero if the value
  /// did not come from rules or is held at an end of the range. At a kink (two equal degrees under minimum,
  /// an input on a corner) one side's derivative. By inputs that are no numbers: zero.
  ///
  /// Not covered: how a jump of the aggregated set moves where a norm itself jumps (drastic and nilpotent
  /// ones) in exact mode; which rules Highest, Lowest, First, Last and Threshold choose (piecewise constant).
  void differentiate(int output, Workspace& workspace, Gradient& gradient) const;
  /// What the places of Gradient::byParameter are.
  std::span<const ParameterPlace> parameters() const noexcept;

  /// The aggregated set of an output in the last evaluation at x (plots); 0 where nothing fired.
  double aggregatedAt(int output, double x, const Workspace& workspace) const noexcept;

private:
  explicit Evaluator(std::shared_ptr<const Compiled> compiled) : m_compiled(std::move(compiled)) {}
  std::shared_ptr<const Compiled> m_compiled;
};

/// sup over [low, high] of min(a, b) of two sets under hedges: how well two words agree. A number's degree is
/// membership(); this is the same for fuzzy inputs.
double heightOfIntersection(const Term& a, std::span<const Hedge> hedgesA, const Term& b,
                            std::span<const Hedge> hedgesB, double low, double high) noexcept;

} // namespace esm::fis
