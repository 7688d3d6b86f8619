// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Our sampled mode against fuzzylite 6.0. Each engine is generated, written by us as FLL, loaded by both, and
// both answer the same rows one after another (so that "the value before" is compared, too).
#include "core/base/hash.h"
#include "core/fuzzy/fis/evaluator.h"
#include "core/fuzzy/fis/files.h"
#include "tests/core/fuzzy/fis/random_system.h"

#include <fl/Headers.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>

namespace esm::fis {

namespace {

struct Family {
  std::string name;
  Recipe recipe;
  int engines = 2;
};

Recipe plain()
{
  Recipe r;
  r.inputShapes = r.outputShapes = {Shape::Triangle, Shape::Trapezoid, Shape::Gaussian};
  return r;
}

/// Each feature alone in an otherwise plain engine, then all mixed.
std::vector<Family> families()
{
  std::vector<Family> list;
  const auto add = [&](const std::string& name, int engines, const auto& change) {
    Family family{name, plain(), engines};
    change(family.recipe);
    list.push_back(std::move(family));
  };
  for (const Shape shape : curveShapes())
    add("term " + std::string(nameOf(shape)), 3,
        [&](Recipe& r) { r.inputShapes = r.outputShapes = {shape}; });
  for (int i = 0; i < kTNormCount; ++i) {
    const auto norm = static_cast<TNorm>(i);
    add("conjunction " + std::string(nameOf(norm)), 2, [&](Recipe& r) { r.conjunctions = {norm}; });
    add("implication " + std::string(nameOf(norm)), 2, [&](Recipe& r) { r.implications = {norm}; });
  }
  for (int i = 0; i < kSNormCount; ++i) {
    const auto norm = static_cast<SNorm>(i);
    add("disjunction " + std::string(nameOf(norm)), 2, [&](Recipe& r) { r.disjunctions = {norm}; });
    add("aggregation " + std::string(nameOf(norm)), 2, [&](Recipe& r) { r.aggregations = {norm}; });
  }
  for (const Hedge hedge : everything().hedges)
    add("hedge " + std::string(nameOf(hedge)), 2, [&](Recipe& r) { r.hedges = {hedge}; });
  for (const Defuzzifier defuzzifier : everything().defuzzifiers)
    for (const int resolution : {7, 100, 1000})
      add("defuzzifier " + std::to_string(static_cast<int>(defuzzifier)) + " at " +
            std::to_string(resolution),
          2, [&](Recipe& r) { r.defuzzifiers = {defuzzifier}, r.resolutions = {resolution}; });
  for (const Activation& activation : everything().activations)
    add("activation " + std::to_string(static_cast<int>(activation.kind)), 3,
        [&](Recipe& r) { r.activations = {activation}; });
  for (const Defuzzifier weighted : {Defuzzifier::WeightedAverage, Defuzzifier::WeightedSum}) {
    add("Takagi-Sugeno", 6, [&](Recipe& r) {
      r.defuzzifiers = {weighted};
      r.outputShapes = {Shape::Constant, Shape::Linear, Shape::Function};
    });
    add("Tsukamoto", 6, [&](Recipe& r) { r.defuzzifiers = {weighted}, r.outputShapes = monotoneShapes(); });
    add("inverse Tsukamoto", 4, [&](Recipe& r) {
      r.defuzzifiers = {weighted};
      r.weightedType = WeightedType::TakagiSugeno;
      r.outputShapes = curveShapes();
    });
  }
  add("weights", 3, [](Recipe& r) { r.weights = true; });
  add("heights", 3, [](Recipe& r) { r.heights = true; });
  add("blocks and chains", 6, [](Recipe& r) { r.severalBlocks = r.chained = true; });
  add("options", 6, [](Recipe& r) { r.options = true, r.inputShapes = {Shape::Triangle, Shape::Rectangle}; });
  add("hedged conclusions", 4, [](Recipe& r) { r.conclusionHedges = true; });
  list.push_back({"mixed", everything(), 80});
  Recipe weighted = everything();
  weighted.defuzzifiers = {Defuzzifier::WeightedAverage, Defuzzifier::WeightedSum};
  list.push_back({"mixed, weighted", weighted, 20});
  return list;
}

/// fuzzylite over a text; `epsilon` is the width of its comparisons (1e-6 unless told).
class Reference {
public:
  explicit Reference(const std::string& fll, double epsilon)
    : m_epsilon(epsilon), m_engine(fl::FllImporter().fromString(fll))
  {}

  std::vector<double> evaluate(const std::vector<double>& row)
  {
    const double before = fl::fuzzylite::macheps();
    fl::fuzzylite::setMachEps(m_epsilon);
    for (std::size_t i = 0; i < row.size(); ++i) m_engine->getInputVariable(i)->setValue(row[i]);
    m_engine->process();
    fl::fuzzylite::setMachEps(before);
    std::vector<double> values;
    for (const auto* output : m_engine->outputVariables()) values.push_back(output->getValue());
    return values;
  }

private:
  double m_epsilon;
  std::unique_ptr<fl::Engine> m_engine;
};

struct Tally {
  int engines = 0, values = 0, ties = 0, undefined = 0, failures = 0;
  std::map<std::string, int> tiesOf; ///< per family
};

bool agrees(double ours, double theirs, double range)
{
  return (std::isnan(ours) && std::isnan(theirs)) || std::abs(ours - theirs) <= 1e-9 * range;
}

void compare(const Family& family, int index, int rows, Tally& tally)
{
  Dice dice(hashBytes(family.name) + static_cast<std::uint64_t>(index));
  const System system = randomSystem(dice, family.recipe);
  const Written written = writeFll(system);
  ASSERT_TRUE(written.losses.empty()) << family.name << ": " << written.losses.front();
  const auto back = readFll(written.text, "generated");
  ASSERT_TRUE(back) << family.name << ": " << back.error().detail;
  ASSERT_TRUE(*back == system) << family.name << ": FLL is not read back as written";
  const auto evaluator = Evaluator::create(system, {Options::Area::Sampled, 0});
  ASSERT_TRUE(evaluator) << family.name << ": " << evaluator.error().detail;
  Workspace workspace = evaluator->makeWorkspace();
  Reference usual(written.text, 1e-6), sharp(written.text, 1e-12), exact(written.text, 1e-300);
  ++tally.engines;
  for (int r = 0; r < rows; ++r) {
    const std::vector<double> row = randomRow(dice, system);
    evaluator->evaluate(row, workspace);
    const auto theirs = usual.evaluate(row), sharply = sharp.evaluate(row), exactly = exact.evaluate(row);
    for (std::size_t o = 0; o < system.outputs.size(); ++o) {
      const OutputResult ours = workspace.outputs()[o];
      const double range =
        std::max({system.outputs[o].maximum - system.outputs[o].minimum, std::abs(ours.value)});
      ++tally.values;
      if (agrees(ours.value, theirs[o], range)) continue;
      // fuzzylite gives NaN where rules fired without an area; we give the default and say so.
      if (std::isnan(theirs[o]) && ours.origin == Origin::NoArea) {
        ++tally.undefined;
        continue;
      }
      // A tie: where two numbers differ by less than 1e-6 fuzzylite takes them as equal. With sharper
      // comparisons it agrees.
      if (agrees(ours.value, sharply[o], range) || agrees(ours.value, exactly[o], range)) {
        ++tally.ties;
        ++tally.tiesOf[family.name];
        continue;
      }
      if (++tally.failures <= 20)
        ADD_FAILURE() << family.name << ' ' << index << " row " << r << " output " << o << ": " << ours.value
                      << " (origin " << static_cast<int>(ours.origin) << "), fuzzylite " << theirs[o]
                      << ", sharply " << sharply[o] << '\n'
                      << (tally.failures <= 3 ? written.text : std::string());
    }
  }
}

} // namespace

TEST(AgainstFuzzylite, SampledModeGivesItsValues)
{
  Tally tally;
  for (const Family& family : families())
    for (int i = 0; i < family.engines; ++i) compare(family, i, 200, tally);
  EXPECT_GE(tally.engines, 200);
  std::printf("%d engines, %d values: %d ties within 1e-6 of a kink, %d undefined in fuzzylite\n",
              tally.engines, tally.values, tally.ties, tally.undefined);
  for (const auto& [name, ties] : tally.tiesOf) std::printf("  %d ties: %s\n", ties, name.c_str());
}

// Terms whose corners lie at infinity, against fuzzylite at places on all sides of the finite ones.
TEST(AgainstFuzzylite, CornersAtInfinityGiveItsMemberships)
{
  for (const char* term :
       {"Trapezoid -inf -inf 3 6", "Trapezoid 3 6 inf inf", "Trapezoid -inf 2 3 6",
        "Trapezoid -inf -inf inf inf", "Triangle -inf 3 6", "Triangle 3 6 inf", "Rectangle -inf 3",
        "Rectangle 3 inf", "Binary 3 inf", "Binary 3 -inf", "PiShape -inf -inf 2 6", "PiShape 2 6 inf inf",
        "GaussianProduct -inf 1 5 2", "GaussianProduct 5 2 inf 1"}) {
    const std::string fll =
      std::string("Engine: e\nInputVariable: x\n  range: 0 10\n  term: t ") + term + "\n";
    const auto system = readFll(fll, "t.fll");
    ASSERT_TRUE(system) << system.error().detail;
    const std::unique_ptr<fl::Engine> engine(fl::FllImporter().fromString(fll));
    const Term& ours = system->inputs[0].terms[0];
    for (const double x : {-1e6, -1.0, 0.0, 2.5, 3.5, 4.5, 5.5, 7.0, 1e6})
      EXPECT_NEAR(membership(Curve{ours.shape, ours.parameters, ours.height}, x),
                  engine->getInputVariable(0)->getTerm(0)->membership(x), 1e-14)
        << term << " at " << x;
  }
}

// Points above one another, read from FCL by both; at the edge itself we take the highest point.
TEST(AgainstFuzzylite, UprightEdgesGiveItsMembershipsBesideThem)
{
  const std::string fcl =
    "FUNCTION_BLOCK t\nVAR_INPUT\nx : REAL;\nEND_VAR\nVAR_OUTPUT\ny : REAL;\nEND_VAR\nFUZZIFY "
    "x\nRANGE := (0 .. 10);\nTERM a := (2, 0) (2, 1) (4, 1) (4, 0.25) (8, 0.25) (8, 0);\n"
    "END_FUZZIFY\nEND_FUNCTION_BLOCK\n";
  const auto system = readFcl(fcl, "t.fcl");
  ASSERT_TRUE(system) << system.error().detail;
  const std::unique_ptr<fl::Engine> engine(fl::FclImporter().fromString(fcl));
  const Term& ours = system->inputs[0].terms[0];
  for (const double x : {0.0, 1.9, 2.1, 3.0, 3.9, 4.1, 7.9, 8.1})
    EXPECT_NEAR(membership(Curve{ours.shape, ours.parameters, ours.height}, x),
                engine->getInputVariable(0)->getTerm(0)->membership(x), 1e-14)
      << x;
}

} // namespace esm::fis

/// The library of fuzzylite brings a main() of its own, which would win over that of gtest.
int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
