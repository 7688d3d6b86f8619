// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fuzzy/fis/evaluator.h"
#include "core/fuzzy/fis/files.h"
#include "tests/core/fuzzy/fis/random_system.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <string>

namespace esm::fis {

/// Damages a text as accidents and attackers do: bytes changed, cut, doubled, swapped with parts of itself.
inline std::string damaged(Dice& dice, std::string text)
{
  static constexpr const char* kBits[] = {
    "nan",       "inf", "-1e308", "1e-400", "(",  ")",    ":", "is", "not", "any", "\r",   "\n",   "[",  "]",
    "999999999", "'",   "#",      "%",      "if", "with", "0", "-",  ",",   ";",   "RULE", "\xC3", "\0x"};
  for (int i = 1 + dice.below(4); i > 0 && !text.empty(); --i) {
    const auto place = static_cast<std::size_t>(dice.below(static_cast<int>(text.size())));
    const auto length = static_cast<std::size_t>(1 + dice.below(30));
    switch (dice.below(5)) {
    case 0:
      text[place] = static_cast<char>(dice.below(256));
      break;
    case 1:
      text.erase(place, length);
      break;
    case 2:
      text.insert(place,
                  text.substr(static_cast<std::size_t>(dice.below(static_cast<int>(text.size()))), length));
      break;
    case 3:
      text.insert(place, kBits[dice.below(27)]);
      break;
    default:
      text.resize(place);
      break;
    }
  }
  return text;
}

/// What no writer here writes: jFuzzyLogic's words, several blocks, upright edges, numbers given several
/// times.
inline constexpr const char* kForeignFcl = R"(FUNCTION_BLOCK one
VAR_INPUT x : REAL; RANGE := (0 .. 10); w, v : REAL := 1; END_VAR
VAR_OUTPUT y : REAL; z : REAL; END_VAR
VAR k : REAL; END_VAR
FUZZIFY x TERM a := (0, 1) (4, 1) (4, 0); TERM b := DSIGM 1 2 5 9; TERM c := GBELL 2 4 5; END_FUZZIFY
FUZZIFY w TERM a := SINGLETONS (1, 0.5) (3, 1); TERM very := COSINE 2 8; END_FUZZIFY
DEFUZZIFY y TERM low := FUNCTION -x * LN(w + 2) ^ 2 % 3; TERM high := SINGLETONS (1, 1) (3, 0.5); METHOD : COGF; END_DEFUZZIFY
DEFUZZIFY z TERM s := GAUSS2 2 1 8 1; TERM t := SIGM -4 3; ACCU : PROBOR; DEFAULT := NC; END_DEFUZZIFY
RULEBLOCK r (* all *) AND : HAMACHER; ACT : PROD; ACCU : MAX;
RULE 1 : IF x IS a AND NOT (w IS very OR x IS c) THEN y IS low, z IS s WITH 0.5;
RULE 2 : IF x IS b THEN y IS high AND z IS NOT t;
END_RULEBLOCK
END_FUNCTION_BLOCK
FUNCTION_BLOCK END_FUNCTION_BLOCK
)";

/// A damaged text gives a system whose answers are numbers where they say so, or one error with its place.
inline void feed(Format format, const std::string& text, Dice& dice)
{
  const auto system = readSystem(format, text, "damaged");
  if (!system) {
    const std::string& detail = system.error().detail;
    EXPECT_EQ(detail.rfind("damaged:", 0), 0U) << detail;
    EXPECT_EQ(detail.find('\n'), std::string::npos) << detail;
    return;
  }
  const auto evaluator =
    Evaluator::create(*system, {dice.chance(0.5) ? Options::Area::Exact : Options::Area::Sampled, 50});
  ASSERT_TRUE(evaluator) << evaluator.error().detail;
  Workspace workspace = evaluator->makeWorkspace();
  std::vector<double> row;
  for (const InputVariable& input : system->inputs)
    row.push_back(dice.chance(0.05) ? kNoValue
                  : std::isfinite(input.minimum) && std::isfinite(input.maximum)
                    ? dice.number(input.minimum, input.maximum)
                    : dice.number(-10, 10));
  evaluator->evaluate(row, workspace);
  for (const OutputResult& result : workspace.outputs())
    EXPECT_FALSE(result.origin == Origin::Rules && std::isnan(result.value)) << text;
  for (const Format other : {Format::Fll, Format::Fcl, Format::Fis}) (void)writeSystem(other, *system);
}

/// @return how many texts were fed within the time
inline int feedDamagedTexts(int count, std::chrono::seconds limit)
{
  const auto end = std::chrono::steady_clock::now() + limit;
  Dice dice(4711);
  int fed = 0;
  while (fed < count && std::chrono::steady_clock::now() < end) {
    Recipe recipe = everything();
    if (dice.chance(0.3)) {
      recipe.defuzzifiers = {Defuzzifier::WeightedAverage};
      recipe.outputShapes = {Shape::Constant, Shape::Linear, Shape::Function};
    }
    const System system = randomSystem(dice, recipe);
    for (const Format format : {Format::Fll, Format::Fcl, Format::Fis}) {
      const std::string text = writeSystem(format, system).text;
      for (int i = 0; i < 40; ++i, ++fed) feed(format, damaged(dice, text), dice);
    }
    for (int i = 0; i < 40; ++i, ++fed) feed(Format::Fcl, damaged(dice, kForeignFcl), dice);
    if (testing::Test::HasFailure()) break;
  }
  return fed;
}

} // namespace esm::fis
