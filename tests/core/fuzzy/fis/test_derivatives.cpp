// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Every derivative against central differences with Richardson extrapolation. A place is near a kink where
// the extrapolations from two step sizes disagree; there is no derivative to compare, it is passed over.
#include "core/fuzzy/fis/evaluator.h"
#include "tests/core/fuzzy/fis/random_system.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace esm::fis {

namespace {

/// Exact up to h^6 from steps h, h/2, h/4.
double richardson(const std::function<double(double)>& f, double h)
{
  const auto central = [&](double step) { return (f(step) - f(-step)) / (2.0 * step); };
  const double d0 = central(h), d1 = central(h / 2), d2 = central(h / 4);
  const double e0 = (4.0 * d1 - d0) / 3.0, e1 = (4.0 * d2 - d1) / 3.0;
  return (16.0 * e1 - e0) / 15.0;
}

struct Count {
  int compared = 0, kinks = 0;
};

class Checker {
public:
  Checker(System system, Options options, std::vector<double> row, int output, Count& count,
          std::string where)
    : m_system(std::move(system)),
      m_options(options),
      m_row(std::move(row)),
      m_output(output),
      m_count(count),
      m_where(std::move(where))
  {}

  void run()
  {
    const auto evaluator = Evaluator::create(m_system, m_options);
    ASSERT_TRUE(evaluator) << evaluator.error().detail;
    Workspace workspace = evaluator->makeWorkspace();
    evaluator->evaluate(m_row, workspace);
    if (workspace.outputs()[static_cast<std::size_t>(m_output)].origin != Origin::Rules) return;
    Gradient gradient;
    evaluator->differentiate(m_output, workspace, gradient);
    for (std::size_t i = 0; i < m_row.size(); ++i) {
      auto row = m_row;
      compare(gradient.byInput[i], "input " + std::to_string(i), [&](double h) {
        row[i] = m_row[i] + h;
        evaluator->evaluate(row, workspace);
        return workspace.outputs()[static_cast<std::size_t>(m_output)].value;
      });
    }
    std::size_t rule = 0;
    for (RuleBlock& block : m_system.blocks)
      for (Rule& r : block.rules) {
        compareNumber(gradient.byWeight[rule], r.weight, "weight " + std::to_string(rule));
        ++rule;
      }
    const auto places = evaluator->parameters();
    for (std::size_t p = 0; p < places.size(); ++p) {
      const auto variable = static_cast<std::size_t>(places[p].variable),
                 t = static_cast<std::size_t>(places[p].term);
      Term& term =
        places[p].onOutput ? m_system.outputs[variable].terms[t] : m_system.inputs[variable].terms[t];
      if (places[p].index < 0 && isNumber(term.shape)) continue;
      double& number =
        places[p].index < 0 ? term.height : term.parameters[static_cast<std::size_t>(places[p].index)];
      compareNumber(gradient.byParameter[p], number,
                    std::string(nameOf(term.shape)) + " parameter " + std::to_string(places[p].index) +
                      (places[p].onOutput ? " out" : " in"));
    }
  }

private:
  void compareNumber(double exact, double& number, const std::string& what)
  {
    if (!std::isfinite(number)) return;
    const double before = number;
    compare(exact, what, [&](double h) {
      number = before + h;
      const auto evaluator = Evaluator::create(m_system, m_options);
      if (!evaluator) return kNoValue; // the order of corners was lost: as good as a kink
      Workspace workspace = evaluator->makeWorkspace();
      evaluator->evaluate(m_row, workspace);
      return workspace.outputs()[static_cast<std::size_t>(m_output)].value;
    });
    number = before;
  }

  void compare(double exact, const std::string& what, const std::function<double(double)>& f)
  {
    const double coarse = richardson(f, 4e-3), fine = richardson(f, 2.5e-3);
    const double scale = std::max(1.0, std::abs(fine));
    if (!(std::abs(coarse - fine) <= 2e-10 * scale)) {
      ++m_count.kinks;
      return;
    }
    ++m_count.compared;
    EXPECT_NEAR(exact, fine, 1e-9 * scale) << m_where << ", " << what;
  }

  System m_system;
  Options m_options;
  std::vector<double> m_row;
  int m_output;
  Count& m_count;
  std::string m_where;
};

Count check(const std::string& name, const Recipe& recipe, Options options, int engines)
{
  Count count;
  for (int e = 0; e < engines; ++e) {
    Dice dice(static_cast<std::uint64_t>(e) + 77);
    const System system = randomSystem(dice, recipe);
    const auto row = randomRow(dice, system);
    for (int o = 0; o < 2; ++o)
      Checker(system, options, row, o, count, name + " " + std::to_string(e) + " output " + std::to_string(o))
        .run();
  }
  std::printf("%s: %d derivatives compared, %d near kinks\n", name.c_str(), count.compared, count.kinks);
  EXPECT_GT(count.compared, 2 * count.kinks) << name;
  return count;
}

/// Norms without jumps: where a set jumps by itself its derivative is not defined everywhere.
Recipe smooth()
{
  Recipe r = everything();
  r.hedges = {Hedge::Any, Hedge::Not, Hedge::Very, Hedge::Somewhat, Hedge::Seldom, Hedge::Extremely};
  r.conjunctions = {TNorm::Minimum, TNorm::AlgebraicProduct, TNorm::EinsteinProduct, TNorm::HamacherProduct};
  r.implications = r.conjunctions;
  r.disjunctions = {SNorm::Maximum, SNorm::AlgebraicSum, SNorm::EinsteinSum, SNorm::HamacherSum,
                    SNorm::NormalizedSum};
  r.aggregations = r.disjunctions;
  r.options = false;
  r.activations = {{}, {ActivationKind::Proportional, 1, 0.0, Comparison::GreaterEqual}};
  return r;
}

} // namespace

TEST(Derivatives, OfExactAreas)
{
  for (const Defuzzifier defuzzifier : {Defuzzifier::Centroid, Defuzzifier::Bisector}) {
    Recipe r = smooth();
    r.defuzzifiers = {defuzzifier};
    check("exact " + std::to_string(static_cast<int>(defuzzifier)), r, {}, 3);
  }
}

TEST(Derivatives, OfMaxima)
{
  for (const Defuzzifier defuzzifier :
       {Defuzzifier::SmallestOfMaximum, Defuzzifier::MeanOfMaximum, Defuzzifier::LargestOfMaximum}) {
    Recipe r = smooth();
    r.defuzzifiers = {defuzzifier};
    r.aggregations = {SNorm::Maximum};
    r.implications = {TNorm::Minimum};
    // How their tops move with the parameters is not told.
    for (const Shape turning : {Shape::SigmoidProduct, Shape::SigmoidDifference, Shape::GaussianProduct})
      std::erase(r.outputShapes, turning);
    check("maximum " + std::to_string(static_cast<int>(defuzzifier)), r, {}, 3);
  }
}

TEST(Derivatives, OfSampledCentroids)
{
  check("sampled", smooth(), {Options::Area::Sampled, 50}, 4);
}

TEST(Derivatives, OfWeightedDefuzzifiers)
{
  Recipe r = smooth();
  r.defuzzifiers = {Defuzzifier::WeightedAverage, Defuzzifier::WeightedSum};
  r.outputShapes = {Shape::Constant, Shape::Linear, Shape::Function};
  check("Takagi-Sugeno", r, {}, 4);
  r.outputShapes = monotoneShapes();
  check("Tsukamoto", r, {}, 4);
  check("Tsukamoto of fuzzylite", r, {Options::Area::Sampled, 0}, 4);
  r.outputShapes = curveShapes();
  r.weightedType = WeightedType::TakagiSugeno;
  check("inverse Tsukamoto", r, {}, 4);
}

} // namespace esm::fis
