// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/fuzzy/fis/mutations.h"

#include <array>

namespace esm::fis {

namespace {

constexpr const char* kFan = R"(# a fan
Engine: fan
description: turns with the heat
InputVariable: heat
  enabled: true
  range: 0 10
  lock-range: true
  term: cold Ramp 6 2
  term: hot Ramp 4 8
OutputVariable: speed
  enabled: true
  range: 0 100
  aggregation: Maximum
  defuzzifier: Centroid 200
  default: nan
  lock-previous: false
  term: low Triangle 0 20 40
  term: high Triangle 60 80 100
RuleBlock: rules
  conjunction: Minimum
  implication: Minimum
  activation: General
  rule: if heat is cold then speed is low
  rule: if heat is hot and not heat is very cold then speed is high with 0.5
)";

std::string replaced(std::string text, const std::string& what, const std::string& with)
{
  text.replace(text.find(what), what.size(), with);
  return text;
}

double valueOf(const System& system, double x)
{
  const auto evaluator = Evaluator::create(system);
  Workspace workspace = evaluator->makeWorkspace();
  evaluator->evaluate(std::array{x}, workspace);
  return workspace.outputs()[0].value;
}

} // namespace

TEST(Files, FaultsAreNamedByLineAndColumn)
{
  const auto detail = [](const std::string& text) {
    const auto system = readFll(text, "fan.fll");
    return system ? std::string("read") : system.error().detail;
  };
  EXPECT_EQ(detail(kFan), "read");
  EXPECT_EQ(detail(replaced(kFan, "Triangle 0 20 40", "Triangel 0 20 40")),
            "fan.fll:17:13: 'Triangel' is no known shape of a term");
  EXPECT_EQ(detail(replaced(kFan, "heat is cold", "heat is warm")),
            "fan.fll:23:20: 'warm' is neither a hedge nor a term of that variable");
  EXPECT_EQ(detail(replaced(kFan, "with 0.5", "with half")), "fan.fll:24:74: 'half' is no number");
  EXPECT_EQ(detail(replaced(kFan, "0 20 40", "0 40 20")),
            "fan.fll:17:22: term 'low': needs numbers that do not fall, but 40 stands before 20");
}

TEST(Files, LineEndsAndByteOrderMarksDoNotMatter)
{
  std::string dos = "\xEF\xBB\xBF";
  for (const char* c = kFan; *c; ++c) dos += *c == '\n' ? std::string("\r\n") : std::string(1, *c);
  const auto one = readFll(kFan, "a"), two = readFll(dos, "b");
  ASSERT_TRUE(one && two);
  EXPECT_TRUE(*one == *two);
}

// A MATLAB file as they are found: surplus parameters, expressions, comments, a name with a blank.
TEST(Files, FisAsItIsFound)
{
  const auto system = readFis(
    "% made by hand\r\n[System]\r\nName='pendulum'\r\nType='mamdani'\r\nAndMethod='min'\r\nOrMethod='max'\r\n"
    "ImpMethod='min'\r\nAggMethod='max'\r\nDefuzzMethod='centroid'\r\n\r\n[Input1]\r\nName='the angle'\r\n"
    "Range=[-pi/4 pi/4]\r\nNumMFs=2\r\nMF1='left':'trimf',[-pi/2 -pi/4 0 0]\r\nMF2='right':'gaussmf',[0.3 "
    "pi/4]\r\n\r\n"
    "[Output1]\r\nName='force'\r\nRange=[-10 10]\r\nMF1='push':'trimf',[-10 -5 0 0]\r\nMF2='pull':'trimf',[0 "
    "5 10]\r\n\r\n"
    "[Rules]\r\n1, 2 (1) : 1\r\n-1, 1 (0.5) : 1 % weaker\r\n",
    "pendulum.fis");
  ASSERT_TRUE(system) << system.error().detail;
  EXPECT_EQ(system->inputs[0].name, "theangle");
  EXPECT_DOUBLE_EQ(system->inputs[0].maximum, std::atan(1.0));
  EXPECT_EQ(system->inputs[0].terms[0].parameters.size(), 3U);
  EXPECT_EQ(system->inputs[0].terms[1].parameters, (std::vector{std::atan(1.0), 0.3}));
  EXPECT_EQ(system->blocks[0].rules[1].antecedent.nodes[0].proposition.hedges, std::vector{Hedge::Not});
  EXPECT_EQ(system->blocks[0].rules[1].weight, 0.5);
}

// The example of the standard: points, singletons, comments in (* *), keywords in any case.
TEST(Files, FclOfTheStandard)
{
  const auto system = readFcl(
    "FUNCTION_BLOCK valve\nVAR_INPUT\n temp : REAL; (* RANGE(0 .. 80) *)\nEND_VAR\nVAR_OUTPUT\n valve : "
    "REAL;\nEND_VAR\n"
    "FUZZIFY temp\n TERM cold := (3, 1) (27, 0);\n TERM hot := (3, 0) (27, 1);\nEND_FUZZIFY\n"
    "DEFUZZIFY valve\n TERM drainage := -100; TERM inlet := 100;\n METHOD : COGS;\n DEFAULT := "
    "0;\nEND_DEFUZZIFY\n"
    "RULEBLOCK No1\n AND : MIN; ACCU : MAX;\n RULE 1 : IF temp IS cold THEN valve IS inlet;\n"
    " rule 2 : if NOT (temp IS cold) then valve is drainage WITH 0.5;\nEND_RULEBLOCK\nEND_FUNCTION_BLOCK\n",
    "valve.fcl");
  ASSERT_TRUE(system) << system.error().detail;
  // cold 1/2, not cold 1/2 times 1/2: (100 / 2 - 100 / 4) / (3 / 4)
  EXPECT_NEAR(valueOf(*system, 15.0), 100.0 / 3.0, 1e-13);
}

TEST(Files, FllHoldsEverythingWithoutLoss)
{
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Dice dice(seed + 5);
    Recipe recipe = everything();
    recipe.hedges.push_back(Hedge::Cubed);
    System system = randomSystem(dice, recipe);
    system.description = "with \xC3\xA4 word: and a colon";
    system.inputs[1].enabled = seed % 2 == 0;
    system.blocks[0].rules[1].enabled = false;
    system.blocks[1].conclusionHedges = ConclusionHedges::OnSet;
    system.blocks[0].rules[2].antecedent.nodes = {
      {Antecedent::Kind::Not, {}, {1}},
      {Antecedent::Kind::Or, {}, {2, 3}},
      {Antecedent::Kind::Proposition, {false, 0, 1, {}}, {}},
      {Antecedent::Kind::Proposition, {false, 1, 1, {Hedge::Very}}, {}}};
    const Written written = writeFll(system);
    EXPECT_GE(written.losses.size(), 3U); // what fuzzylite will not understand
    const auto back = readFll(written.text, "back");
    ASSERT_TRUE(back) << back.error().detail;
    EXPECT_TRUE(*back == system) << written.text;
  }
}

// fuzzylite has '~' for it and takes '-' as a subtraction that lacks a number.
TEST(Files, FllNamesFormulasWithASignThatFuzzyliteCannotRead)
{
  const auto lossesOf = [](const std::string& formula) {
    System system = readFll(kFan, "fan").value();
    system.outputs[0].terms.push_back({"f", Shape::Function, {}, 1.0, formula});
    const auto& losses = writeFll(system).losses;
    return std::count_if(losses.begin(), losses.end(), [](const std::string& loss) {
      return loss == "term 'f': fuzzylite cannot read '-' before an operand";
    });
  };
  for (const char* formula : {"-x", "2*-x", "max(1, -x)", "(1 - 2)^-x", "x and -1", "- x", "1e-3 - -x"})
    EXPECT_EQ(lossesOf(formula), 1) << formula;
  for (const char* formula : {"1-x", "1e-3", "2.5E-3 - x", "(x)-1", "~x", "max(1,2)-x", "pi-x"})
    EXPECT_EQ(lossesOf(formula), 0) << formula;
}

// What a writer does not list as lost is there when the file is read again: it computes the same.
TEST(Files, OtherFormatsComputeTheSameWhereNothingIsLost)
{
  Recipe recipe;
  recipe.inputShapes = recipe.outputShapes = curveShapes();
  recipe.hedges = {Hedge::Not, Hedge::Very};
  recipe.weights = true;
  int lossless = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Dice dice(seed);
    const System system = randomSystem(dice, recipe);
    const auto row = randomRow(dice, system);
    for (const Format format : {Format::Fcl, Format::Fis}) {
      const Written written = writeSystem(format, system);
      const auto back = readSystem(format, written.text, "back");
      ASSERT_TRUE(back) << back.error().detail << '\n' << written.text;
      const bool same =
        std::all_of(written.losses.begin(), written.losses.end(), [](const std::string& loss) {
          return loss.find("name") != std::string::npos || loss.find("for MATLAB") != std::string::npos;
        });
      if (!same) continue;
      ++lossless;
      const auto before = Evaluator::create(system), after = Evaluator::create(*back);
      ASSERT_TRUE(before && after);
      Workspace a = before->makeWorkspace(), b = after->makeWorkspace();
      before->evaluate(row, a);
      after->evaluate(row, b);
      for (std::size_t o = 0; o < 2; ++o)
        EXPECT_TRUE(a.outputs()[o].value == b.outputs()[o].value || std::isnan(a.outputs()[o].value))
          << written.text;
    }
  }
  EXPECT_GT(lossless, 30);
}

TEST(DamagedFiles, EndInASystemOrAnError)
{
  EXPECT_GT(feedDamagedTexts(3000, std::chrono::seconds(20)), 100);
}

} // namespace esm::fis
