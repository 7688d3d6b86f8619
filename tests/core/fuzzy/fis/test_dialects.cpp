// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// FCL of the standard and of jFuzzyLogic, FIS of MATLAB, FLL of fuzzylite as real files carry them.
#include "tests/core/fuzzy/fis/mutations.h"

#include <gtest/gtest.h>

#include <cmath>

namespace esm::fis {

namespace {

std::string joined(const std::vector<std::string>& lines)
{
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

/// The first output at these inputs; -999 with a failure if the text is not read.
double valueOf(const Result<System>& system, std::vector<double> inputs)
{
  if (!system) {
    ADD_FAILURE() << system.error().detail;
    return -999.0;
  }
  const auto evaluator = Evaluator::create(*system);
  EXPECT_TRUE(evaluator) << evaluator.error().detail;
  if (!evaluator) return -999.0;
  Workspace workspace = evaluator->makeWorkspace();
  evaluator->evaluate(inputs, workspace);
  return workspace.outputs()[0].value;
}

double membershipOf(const Term& term, double x)
{
  if (term.shape != Shape::Function) return membership(Curve{term.shape, term.parameters, term.height}, x);
  const Formula formula = std::get<Formula>(Formula::parse(term.formula, std::vector<std::string>{"x"}));
  return formula.evaluate(x, {});
}

/// A block with one input that is `a` at 0 and `b` at 10, and an output; the parts can be exchanged.
struct Fcl {
  std::string name = "first", range, type = "REAL";
  std::string input = "TERM a := (0, 1) (10, 0);\n TERM b := (0, 0) (10, 1);";
  std::string output = "TERM low := 2;\n TERM high := 6;\n METHOD : COGS;\n DEFAULT := 0;";
  std::string norms = "AND : MIN;";
  std::string rules = "RULE 1 : IF x IS a THEN y IS low;\n RULE 2 : IF x IS b THEN y IS high;";

  std::string text() const
  {
    return "FUNCTION_BLOCK " + name + "\nVAR_INPUT\n x : " + type + "; " + range +
           "\nEND_VAR\nVAR_OUTPUT\n y : REAL;\nEND_VAR\nFUZZIFY x\n " + input +
           "\nEND_FUZZIFY\nDEFUZZIFY y\n " + output + "\nEND_DEFUZZIFY\nRULEBLOCK one\n " + norms + "\n " +
           rules + "\nEND_RULEBLOCK\nEND_FUNCTION_BLOCK\n";
  }
  double at(double x) const { return valueOf(readFcl(text(), "t.fcl"), {x}); }
  Term term() const
  {
    const auto system = readFcl(text(), "t.fcl");
    EXPECT_TRUE(system) << system.error().detail;
    return system ? system->inputs[0].terms[0] : Term{};
  }
};

Result<System> withNotes(const std::string& text, std::vector<std::string>& notes,
                         std::string_view block = {})
{
  return readFcl(text, "t.fcl", {&notes, block});
}

/// Two inputs, one rule with OR and one with AND, over singletons 2 and 6.
std::string pairOf(const std::string& norms)
{
  return "FUNCTION_BLOCK tissue\nVAR_INPUT\n water : REAL;\n fat : REAL;\nEND_VAR\nVAR_OUTPUT\n stiff : "
         "REAL;\n"
         "END_VAR\nFUZZIFY water\n TERM low := (0, 1) (10, 0);\nEND_FUZZIFY\nFUZZIFY fat\n TERM high := (0, "
         "0) "
         "(10, 1);\nEND_FUZZIFY\nDEFUZZIFY stiff\n TERM soft := 2;\n TERM hard := 6;\n METHOD : COGS;\n "
         "DEFAULT := "
         "0;\nEND_DEFUZZIFY\nRULEBLOCK one\n " +
         norms +
         "\n ACT : MIN;\n ACCU : MAX;\n RULE 1 : IF water IS low OR fat IS high THEN stiff IS soft;\n RULE 2 "
         ": IF "
         "water IS low AND fat IS high THEN stiff IS hard;\nEND_RULEBLOCK\nEND_FUNCTION_BLOCK\n";
}

} // namespace

// By the standard one of AND and OR follows from the other. With degrees a and b: (2 or + 6 and) / (or +
// and).
TEST(FclPairs, OneNormFollowsFromTheOther)
{
  EXPECT_NEAR(valueOf(readFcl(pairOf("AND : MIN;"), "t"), {2, 5}), (2 * 0.8 + 6 * 0.5) / 1.3, 1e-12);
  EXPECT_NEAR(valueOf(readFcl(pairOf("AND : MIN;"), "t"), {8, 9}), (2 * 0.9 + 6 * 0.2) / 1.1, 1e-12);
  EXPECT_NEAR(valueOf(readFcl(pairOf("OR : MAX;"), "t"), {2, 5}), (2 * 0.8 + 6 * 0.5) / 1.3, 1e-12);
  EXPECT_NEAR(valueOf(readFcl(pairOf(""), "t"), {2, 5}), (2 * 0.8 + 6 * 0.5) / 1.3, 1e-12);
  const double a = 0.8, b = 0.5;
  const std::tuple<const char*, double, double> pairs[] = {
    {"AND : PROD;", a * b, a + b - a * b},
    {"OR : ASUM;", a * b, a + b - a * b},
    {"AND : BDIF;", a + b - 1, 1.0},
    {"OR : BSUM;", a + b - 1, 1.0},
    {"AND : DMIN;", 0.0, 1.0},
    {"OR : NIPMAX;", b, 1.0},
    {"AND : HAMACHER;", a * b / (a + b - a * b), (a + b) / (1 + a * b)}, // jFuzzyLogic pairs it with EINSTEIN
    {"OR : EINSTEIN;", a * b / (a + b - a * b), (a + b) / (1 + a * b)},
    {"AND : HPROD;", a * b / (a + b - a * b), (a + b - 2 * a * b) / (1 - a * b)},
    {"AND : MIN; OR : ASUM;", b, a + b - a * b}}; // both are given: no law fills in
  for (const auto& [norms, both, either] : pairs)
    EXPECT_NEAR(valueOf(readFcl(pairOf(norms), "t"), {2, 5}), (2 * either + 6 * both) / (either + both),
                1e-12)
      << norms;
}

TEST(FclDeclarations, HaveRangesAndSeveralNames)
{
  Fcl fcl;
  fcl.range = "RANGE := (0 .. 10);";
  EXPECT_NEAR(fcl.at(2.5), 3.0, 1e-12);
  EXPECT_EQ(readFcl(fcl.text(), "t")->inputs[0].maximum, 10.0);
  fcl.range = "RANGE := (-1.5..1e1);";
  EXPECT_EQ(readFcl(fcl.text(), "t")->inputs[0].minimum, -1.5);
  fcl.range = "u, v : REAL;";
  EXPECT_EQ(readFcl(fcl.text(), "t")->inputs.size(), 3U);
}

// Two outputs from one rule, between commas or "and"; the weight holds for both.
TEST(FclRules, ConcludeSeveralThings)
{
  for (const char* between : {", ", ",", " AND "}) {
    Fcl fcl;
    fcl.range = "";
    fcl.rules = std::string("RULE 1 : IF x IS a THEN y IS low") + between +
                "z IS q (* why *) WITH 0.5;\n RULE 2 : IF x IS b THEN y IS high;";
    std::string text = fcl.text();
    text.insert(text.find(" y : REAL;"), " z : REAL;\n");
    text.insert(text.find("RULEBLOCK"), "DEFUZZIFY z\n TERM q := 7;\n METHOD : COGS;\nEND_DEFUZZIFY\n");
    const auto system = readFcl(text, "t.fcl");
    ASSERT_TRUE(system) << system.error().detail;
    ASSERT_EQ(system->blocks[0].rules[0].consequents.size(), 2U);
    const auto evaluator = Evaluator::create(*system);
    Workspace workspace = evaluator->makeWorkspace();
    evaluator->evaluate(std::vector<double>{5.0}, workspace);
    EXPECT_NEAR(workspace.outputs()[0].value, 7.0, 1e-12);
    EXPECT_NEAR(workspace.outputs()[1].value, (2 * 0.25 + 6 * 0.5) / 0.75, 1e-12);
  }
}

// An upright edge belongs to the set with its highest point, as that of a rectangle does.
TEST(FclPoints, MayStandAboveOneAnother)
{
  Fcl fcl;
  fcl.input = "TERM a := (2, 0) (2, 1) (4, 1) (4, 0.25) (8, 0.25) (8, 0);\n TERM b := (0, 1) (0, 1);";
  const Term term = fcl.term();
  for (const auto& [x, degree] :
       {std::pair{1.9, 0.0}, {2.0, 1.0}, {3.0, 1.0}, {4.0, 1.0}, {4.1, 0.25}, {8.0, 0.25}, {8.1, 0.0}})
    EXPECT_EQ(membershipOf(term, x), degree) << x;
  fcl.input = "TERM a := (0, 0) (5, 0) (4, 1);";
  EXPECT_EQ(readFcl(fcl.text(), "t.fcl").error().detail,
            "t.fcl:9:12: term 'a': needs x that do not fall, but 5 stands before 4");
}

// A box from upright edges has its centroid in the middle, the ends of its top at the edges.
TEST(FclPoints, UprightEdgesBoundAreas)
{
  Fcl fcl;
  fcl.rules = "RULE 1 : IF x IS a THEN y IS box;";
  for (const auto& [method, value] :
       {std::pair{"COG", 4.5}, {"COA", 4.5}, {"MM", 4.5}, {"LM", 3.0}, {"RM", 6.0}}) {
    fcl.output =
      std::string("TERM box := (3, 0) (3, 1) (6, 1) (6, 0);\n RANGE := (0 .. 9);\n METHOD : ") + method + ';';
    EXPECT_NEAR(fcl.at(0.0), value, 1e-12) << method;
  }
}

// The formulas of jFuzzyLogic's own classes, at places beside their centres.
TEST(FclShapes, AreThoseOfJFuzzyLogic)
{
  const auto sigmoid = [](double gain, double centre, double x) {
    return 1 / (1 + std::exp(-gain * (x - centre)));
  };
  const std::tuple<const char*, double, double> shapes[] = {
    {"TRIAN 0 5 10", 2, 0.4},
    {"TRAPE 0 2 8 10", 9, 0.5},
    {"GAUSS 5 2", 3, std::exp(-0.5)},
    {"GAUSS2 2 1 8 2", 1, std::exp(-0.5)},
    {"GAUSS2 2 1 8 2", 5, 1.0},
    {"GAUSS2 2 1 8 2", 10, std::exp(-0.5)},
    {"GBELL 2 4 5", 6, 1 / (1 + std::pow(0.5, 8))},
    {"SIGM 4 5", 5.5, sigmoid(4, 5, 5.5)},
    {"SIGM -4 3", 3.5, sigmoid(-4, 3, 3.5)},
    {"DSIGM 4 2 4 8", 2.5, sigmoid(4, 2, 2.5) - sigmoid(4, 8, 2.5)},
    {"DSIGM 1 8 5 9", 8.5, sigmoid(1, 8, 8.5) - sigmoid(5, 9, 8.5)},
    {"DSIGM 1 8 5 9", 12, 0.0}, // the difference is negative there
    {"COSINE 2 8", 7, 0.5},
    {"COSINE 2 8", 5.9, 0.0},
    {"cosine 4 4", 6, 0.5},
    {"SINGLETONS (1, 0.5) (3, 1)", 1, 0.5},
    {"SINGLETONS (1, 0.5) (3, 1)", 3, 1.0},
    {"SINGLETONS (1, 0.5) (3, 1)", 2, 0.0},
    {"SINGLETONS (1, 0.5) (3, 1)", 0, 0.0},
    {"5", 5, 1.0}, // a singleton holds its number only
    {"5", 5.1, 0.0}};
  for (const auto& [shape, x, degree] : shapes) {
    Fcl fcl;
    fcl.input = std::string("TERM a := ") + shape + ";\n TERM b := (0, 0) (10, 1);";
    EXPECT_NEAR(membershipOf(fcl.term(), x), degree, 1e-14) << shape << " at " << x;
  }
  Fcl fcl;
  fcl.input = "TERM a := SIGM 4;";
  EXPECT_EQ(readFcl(fcl.text(), "t.fcl").error().detail, "t.fcl:9:17: SIGM needs 2 numbers, it has 1");
}

// What fuzzylite writes keeps its order of parameters, and its height.
TEST(FclShapes, OfFuzzyliteKeepTheirOrder)
{
  Fcl fcl;
  fcl.input = "TERM a := Sigmoid 5 4 0.5;\n TERM b := Bell 5 2 4;";
  EXPECT_NEAR(membershipOf(fcl.term(), 5.0), 0.25, 1e-15);
  EXPECT_NEAR(membershipOf(readFcl(fcl.text(), "t")->inputs[0].terms[1], 6.0), 1 / (1 + std::pow(0.5, 8)),
              1e-15);
}

// low (2x) and high (6 + sin x) with degrees 3/4 and 1/4 at 2.5; an input called x is what "x" means.
TEST(FclFunctions, ComputeOverTheInputs)
{
  Fcl fcl;
  for (const auto& [low, value] : {std::pair{"FUNCTION (x * 2.0)", 5.0},
                                   {"FUNCTION 2 * X ^ 2 - 7.5", 5.0},
                                   {"function LN(EXP(x)) * 2", 5.0},
                                   {"FUNCTION LOG(100) * x", 5.0},
                                   {"FUNCTION 3 * 7.5 % 5 - 2.5", 5.0},
                                   {"FUNCTION -x + abs(-7.5)", 5.0},
                                   {"FUNCTION 2 ^ 3 ^ 2 / 12.8", 5.0},
                                   {"FUNCTION x+2.5", 5.0},
                                   {"FUNCTION 2.5-1-x+6E0", 5.0}}) {
    fcl.output = std::string("TERM low := ") + low + ";\n TERM high := FUNCTION 6 + SIN(x);\n METHOD : COGF;";
    EXPECT_NEAR(fcl.at(2.5), 0.75 * value + 0.25 * (6 + std::sin(2.5)), 1e-12) << low;
  }
  fcl.output = "TERM low := FUNCTION w * 2;\n TERM high := 6;\n METHOD : COGS;";
  EXPECT_EQ(readFcl(fcl.text(), "t.fcl").error().detail,
            "t.fcl:13:23: 'w' is neither a variable nor a function");
  fcl.output = "TERM low := (0, 0) (x, 1) (6, 0);\n METHOD : COG;";
  EXPECT_NE(readFcl(fcl.text(), "t.fcl").error().detail.find("curves that move with a variable are not read"),
            std::string::npos);
}

// SINGLETONS concluded: each with the rule's degree times its height.
TEST(FclFunctions, SingletonsConcludeEachOfThem)
{
  Fcl fcl;
  fcl.output = "TERM low := SINGLETONS (1, 1) (3, 1);\n TERM high := 6;\n METHOD : COGS;";
  EXPECT_NEAR(fcl.at(2.5), (0.75 * 1 + 0.75 * 3 + 0.25 * 6) / 1.75, 1e-12);
  fcl.output = "TERM low := SINGLETONS (1, 1) (3, 0.5);\n TERM high := 6;\n METHOD : COGS;";
  EXPECT_NE(readFcl(fcl.text(), "t").error().detail.find("ACT : PROD"), std::string::npos);
  fcl.norms = "AND : PROD; ACT : PROD;";
  EXPECT_NEAR(fcl.at(2.5), (0.75 * 1 + 0.375 * 3 + 0.25 * 6) / 1.375, 1e-12);
}

// The standard gathers what several rules say of one singleton before the average is taken: with degrees 3/4
// and 1/4 for low, 1/4 for high.
TEST(FclAccumulation, GathersEqualConclusionsFirst)
{
  Fcl fcl;
  fcl.rules += "\n RULE 3 : IF x IS b THEN y IS low;";
  const std::pair<const char*, double> norms[] = {{"", 1.0},
                                                  {"ACCU : MAX;", 0.75},
                                                  {"ACCU : BSUM;", 1.0},
                                                  {"ACCU : PROBOR;", 0.8125},
                                                  {"ACCU : SUM;", 1.0},
                                                  {"ACCU : NONE;", 1.0}};
  for (const auto& [norm, low] : norms) {
    fcl.norms = std::string("AND : MIN; ") + norm;
    EXPECT_NEAR(fcl.at(2.5), (2 * low + 6 * 0.25) / (low + 0.25), 1e-12) << norm;
    const auto system = readFcl(fcl.text(), "t.fcl");
    EXPECT_TRUE(readFll(writeFll(*system).text, "back").value() == *system);
    EXPECT_EQ(valueOf(readFcl(writeFcl(*system).text, "back"), {2.5}), fcl.at(2.5)) << norm;
    const auto evaluator = Evaluator::create(*system);
    Workspace workspace = evaluator->makeWorkspace();
    evaluator->evaluate(std::vector<double>{2.5}, workspace);
    Gradient gradient;
    evaluator->differentiate(0, workspace, gradient);
    // Central differences of a smooth quotient at 1e-5 are right to about 1e-10.
    EXPECT_NEAR(gradient.byInput[0], (fcl.at(2.5 + 1e-5) - fcl.at(2.5 - 1e-5)) / 2e-5, 1e-8) << norm;
  }
}

// A term may be called as a hedge is.
TEST(FclRules, TermsMayBeCalledAsHedgesAre)
{
  Fcl fcl;
  fcl.input = "TERM very := (0, 1) (10, 0);\n TERM b := (0, 0) (10, 1);";
  fcl.rules = "RULE 1 : IF x IS VERY THEN y IS low;\n RULE 2 : IF x IS NOT very THEN y IS high;";
  EXPECT_NEAR(fcl.at(2.5), 3.0, 1e-12);
}

// Without RANGE a bell reaches as far as with jFuzzyLogic, four deviations: its centroid is its mean.
TEST(FclDefaults, RangeAndMethodFollowFromTheTerms)
{
  Fcl fcl;
  fcl.rules = "RULE 1 : IF x IS a THEN y IS low;";
  fcl.output = "TERM low := GAUSS 3 1;\n TERM high := GAUSS 9 1;\n METHOD : COG;";
  EXPECT_EQ(readFcl(fcl.text(), "t")->outputs[0].minimum, -1.0);
  EXPECT_EQ(readFcl(fcl.text(), "t")->outputs[0].maximum, 13.0);
  fcl.output = "TERM low := TRIAN 0 2 4;";
  EXPECT_NEAR(fcl.at(0.0), 2.0, 1e-12);
  fcl.output = "TERM low := 5;";
  EXPECT_NEAR(fcl.at(0.0), 5.0, 1e-12);
}

TEST(FclBlocks, AreChosenOrNamed)
{
  Fcl first, second;
  second.name = "second";
  second.output = "TERM low := 20;\n TERM high := 60;\n METHOD : COGS;";
  const std::string text = first.text() + "\n" + second.text();
  std::vector<std::string> notes;
  EXPECT_NEAR(valueOf(withNotes(text, notes), {2.5}), 3.0, 1e-12);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("the file holds 2 function blocks; 'first' is read, not 'second'"),
            std::string::npos)
    << notes[0];
  for (const char* name : {"second", "SECOND", "2"}) {
    notes.clear();
    EXPECT_NEAR(valueOf(withNotes(text, notes, name), {2.5}), 30.0, 1e-12);
    EXPECT_TRUE(notes.empty());
  }
  EXPECT_NE(withNotes(text, notes, "third")
              .error()
              .detail.find("no function block 'third'; there are 'first', 'second'"),
            std::string::npos);
  EXPECT_NE(
    withNotes(text + "rubbish", notes).error().detail.find("'FUNCTION_BLOCK' was expected, not 'rubbish'"),
    std::string::npos);
}

// Whatever has no meaning here is named with its place, never dropped in silence.
TEST(FclNotes, NameWhatIsPassedOver)
{
  Fcl fcl;
  fcl.type = "INT := 5";
  fcl.norms = "AND : MIN; ACCU : MAX;";
  fcl.output += " ACCU : BSUM;";
  std::string text = fcl.text();
  text.insert(text.find("FUZZIFY"), "VAR\n k : REAL;\nEND_VAR\n");
  std::vector<std::string> notes;
  EXPECT_NEAR(valueOf(withNotes(text, notes), {2.5}), 3.0, 1e-12);
  EXPECT_EQ(joined(notes), "t.fcl:3:6: 'x' is read as REAL, not as 'INT'\n"
                           "t.fcl:3:10: the initial value of 'x' is passed over\n"
                           "t.fcl:8:1: VAR ... END_VAR is passed over\n"
                           "t.fcl:22:20: ACCU : MAX is passed over for 'y', which has another one already\n");
  notes.clear();
  fcl = {};
  fcl.output = "TERM low := 2;\n TERM high := 6;\n METHOD : COG;";
  EXPECT_NEAR(valueOf(withNotes(fcl.text(), notes), {2.5}), 3.0, 1e-12);
  EXPECT_EQ(joined(notes), "t.fcl: the terms of 'y' are singletons: METHOD : COG is read as COGS\n");
}

// With two of a kind the last holds, as with jFuzzyLogic, and the other is named; equal ones say nothing.
TEST(FclNotes, NameWhatIsGivenAgain)
{
  Fcl fcl;
  fcl.range = "RANGE := (0 .. 10);";
  fcl.input += " RANGE := (0 .. 20);";
  fcl.output += " METHOD : COGS; METHOD : LM; METHOD : COGS; DEFAULT := 0; DEFAULT := 1;";
  fcl.norms =
    "AND : MIN; AND : PROD; and : prod; OR : MAX; OR : ASUM; ACT : MIN; ACT : PROD; ENABLED : FALSE; "
    "ENABLED : TRUE;";
  std::vector<std::string> notes;
  const auto system = withNotes(fcl.text(), notes);
  ASSERT_TRUE(system) << system.error().detail;
  EXPECT_NEAR(valueOf(system, {2.5}), 3.0, 1e-12);
  EXPECT_EQ(system->blocks[0].conjunction, TNorm::AlgebraicProduct);
  EXPECT_EQ(joined(notes),
            "t.fcl:10:38: RANGE of 'x' is given again: '0 .. 20' holds, '0 .. 10' is passed over\n"
            "t.fcl:16:40: METHOD of 'y' is given again: 'LM' holds, 'COGS' is passed over\n"
            "t.fcl:16:53: METHOD of 'y' is given again: 'COGS' holds, 'LM' is passed over\n"
            "t.fcl:16:84: DEFAULT of 'y' is given again: '1' holds, '0' is passed over\n"
            "t.fcl:19:19: AND of 'one' is given again: 'PROD' holds, 'MIN' is passed over\n"
            "t.fcl:19:31: AND of 'one' is given again: 'prod' holds, 'PROD' is passed over\n"
            "t.fcl:19:52: OR of 'one' is given again: 'ASUM' holds, 'MAX' is passed over\n"
            "t.fcl:19:75: ACT of 'one' is given again: 'PROD' holds, 'MIN' is passed over\n"
            "t.fcl:19:108: ENABLED of 'one' is given again: 'TRUE' holds, 'FALSE' is passed over\n");
}

TEST(FllNotes, NameWhatIsGivenAgain)
{
  const std::string text =
    "Engine: e\nInputVariable: x\n  range: 0 10\n  range: 0 10\n  term: a Ramp 10 0\n  term: b Ramp 0 10\n"
    "OutputVariable: y\n  range: 0 10\n  aggregation: Maximum\n  accumulation: none\n"
    "  defuzzifier: Centroid\n  defuzzifier: WeightedAverage\n  term: l Constant 2\n  term: h Constant 6\n"
    "RuleBlock: r\n  conjunction: Minimum\n  conjunction: AlgebraicProduct\n  activation: Minimum\n"
    "  implication: AlgebraicProduct\n  activation: General\n  rule: if x is a then y is l\n"
    "  rule: if x is b then y is h\nRuleBlock: s\n  conjunction: Minimum\n";
  std::vector<std::string> notes;
  EXPECT_NEAR(valueOf(readFll(text, "t.fll", {&notes, {}}), {2.5}), 3.0, 1e-12);
  EXPECT_EQ(joined(notes),
            "t.fll:10:17: aggregation is given again: 'none' holds, 'Maximum' is passed over\n"
            "t.fll:12:16: defuzzifier is given again: 'WeightedAverage' holds, 'Centroid' is passed over\n"
            "t.fll:17:16: conjunction is given again: 'AlgebraicProduct' holds, 'Minimum' is passed over\n"
            "t.fll:19:16: implication is given again: 'AlgebraicProduct' holds, 'Minimum' is passed over\n");
}

// a OR b AND c: 1/4 or (3/4 and 0) by the standard; brackets leave no doubt and nothing to say.
TEST(FclNotes, MixedConditionsSayHowTheyAreJoined)
{
  Fcl fcl;
  for (const auto& [condition, count] : {std::pair{"x IS b OR x IS a AND x IS none", 1U},
                                         {"x IS b OR (x IS a AND x IS none)", 0U},
                                         {"x IS a AND x IS none OR x IS b", 0U}}) {
    fcl.input = "TERM a := (0, 1) (10, 0);\n TERM b := (0, 0) (10, 1);\n TERM none := 7;";
    fcl.rules =
      std::string("RULE 1 : IF ") + condition + " THEN y IS low;\n RULE 2 : IF x IS a THEN y IS high;";
    std::vector<std::string> notes;
    EXPECT_NEAR(valueOf(withNotes(fcl.text(), notes), {2.5}), (2 * 0.25 + 6 * 0.75) / 1.0, 1e-12)
      << condition;
    EXPECT_EQ(notes.size(), count) << joined(notes);
  }
}

// Comments stand anywhere, within rules, too; % begins one at the start of a line only.
TEST(FclNotes, CommentsMayStandAnywhere)
{
  Fcl fcl;
  fcl.rules =
    "% all\n RULE 1 : IF x (* the input *) IS a // low\n THEN y IS low; # one\n RULE 2 : IF x IS b /* b */ "
    "THEN y IS high;";
  EXPECT_NEAR(fcl.at(2.5), 3.0, 1e-12);
}

// The text that the tests of damaged files begin with is sound itself.
TEST(FclDialects, AllWordsAtOnceAreRead)
{
  const auto system = readFcl(kForeignFcl, "t.fcl");
  ASSERT_TRUE(system) << system.error().detail;
  EXPECT_EQ(system->blocks[0].rules.size(), 3U); // one for the singleton of half height
}

// What is read can be written in every format and says the same when it is read again.
TEST(FclDialects, SurviveWritingAndReading)
{
  Fcl fcl;
  fcl.range = "RANGE := (0 .. 10);";
  fcl.input = "TERM a := (0, 1) (4, 1) (4, 0);\n TERM b := DSIGM 1 2 5 9;\n TERM c := COSINE 2 8;";
  fcl.output = "TERM low := FUNCTION x * 2;\n TERM high := 6;\n METHOD : COGF;\n DEFAULT := 1;";
  const auto system = readFcl(fcl.text(), "t.fcl");
  for (const Format format : {Format::Fll, Format::Fcl, Format::Fis}) {
    const Written written = writeSystem(format, *system);
    const bool named = joined(written.losses).find("fuzzylite cannot read 'input.x'") != std::string::npos;
    EXPECT_EQ(named, format == Format::Fll);
    const auto back = readSystem(format, written.text, "back");
    ASSERT_TRUE(back) << back.error().detail << '\n' << written.text;
    for (const double x : {1.0, 3.0, 4.0, 4.5, 7.0})
      EXPECT_EQ(valueOf(*back, {x}), valueOf(*system, {x})) << written.text << x;
  }
}

namespace {

std::string fisOf(const std::string& system, const std::string& input, const std::string& output,
                  const std::string& rules)
{
  return "[System]\nName='two'\nType='sugeno'\n" + system +
         "AndMethod='prod'\nOrMethod='probor'\nImpMethod='prod'\nAggMethod='sum'\nDefuzzMethod='wtaver'\n\n["
         "Input1]\n" +
         input + "\n[Output1]\n" + output + "\n[Rules]\n" + rules;
}

const std::string kFisInput =
  "Name='x'\nRange=[0 10]\nNumMFs=2\nMF1='mf':'trimf',[-10 0 10]\nMF2='mf':'trimf',[0 10 20]\n";
const std::string kFisOutput =
  "Name='y'\nRange=[0 1]\nNumMFs=2\nMF1='out1mf':'constant',[2]\nMF2='out1mf':'constant',[6]\n";
const std::string kFisRules = "1, 1 (1) : 1\n2, 2 (1) : 1\n";

} // namespace

TEST(FisNotes, NameWhatIsGivenAgain)
{
  std::vector<std::string> notes;
  const auto system =
    readFis("[System]\nAndMethod='min'\nAndMethod='prod'\nDefuzzMethod='mom'\n[Input1]\nName='x'\n"
            "Range=[0 10]\nRange=[0 20]\nMF1='a':'trimf',[0 0 10]\n[Output1]\nName='y'\n"
            "Range=[0 10]\nMF1='a':'trimf',[0 0 10]\n[System]\nDefuzzMethod='centroid'\n"
            "[Rules]\n1, 1 (1) : 1\n",
            "t.fis", {&notes, {}});
  ASSERT_TRUE(system) << system.error().detail;
  EXPECT_EQ(system->blocks[0].conjunction, TNorm::AlgebraicProduct);
  EXPECT_EQ(system->outputs[0].defuzzifier, Defuzzifier::Centroid);
  EXPECT_EQ(joined(notes),
            "t.fis:3:12: AndMethod is given again: 'prod' holds, 'min' is passed over\n"
            "t.fis:8:7: Range of [Input1] is given again: '[0 20]' holds, '[0 10]' is passed over\n"
            "t.fis:15:15: DefuzzMethod is given again: 'centroid' holds, 'mom' is passed over\n");
}

TEST(FisNames, MayOccurAgainSinceRulesGoByNumber)
{
  std::vector<std::string> notes;
  const auto system = readFis(fisOf("", kFisInput, kFisOutput, kFisRules), "t.fis", {&notes, {}});
  EXPECT_NEAR(valueOf(system, {2.5}), 3.0, 1e-12);
  EXPECT_EQ(joined(notes),
            "t.fis: [Input1], MF2: the name 'mf' occurs again and is read as 'mf_2'\n"
            "t.fis: [Output1], MF2: the name 'out1mf' occurs again and is read as 'out1mf_2'\n");
  for (const Format format : {Format::Fll, Format::Fcl, Format::Fis})
    EXPECT_NEAR(valueOf(readSystem(format, writeSystem(format, *system).text, "back"), {2.5}), 3.0, 1e-12);
}

// The number of a curve or section counts, not its turn in the file.
TEST(FisNames, NumbersCountNotTheOrder)
{
  const std::string input = "Name='x'\nRange=[0 10]\nMF2='b':'trimf',[0 10 20]\nMF1='a':'trimf',[-10 0 10]\n";
  EXPECT_NEAR(valueOf(readFis(fisOf("", input, kFisOutput, kFisRules), "t"), {2.5}), 3.0, 1e-12);
  const std::string gap = "Name='x'\nRange=[0 10]\nMF1='a':'trimf',[-10 0 10]\nMF3='b':'trimf',[0 10 20]\n";
  EXPECT_NE(
    readFis(fisOf("", gap, kFisOutput, kFisRules), "t").error().detail.find("[Input1], MF2 is missing"),
    std::string::npos);
}

TEST(FisNotes, NameWhatIsPassedOver)
{
  std::vector<std::string> notes;
  const std::string input =
    "Name='x'\nRange=[0 10]\nNumMFs=3\nMF1='a':'trimf',[-10 0 10 0]\nMF2='b':'trimf',[0 10 20]\n";
  const std::string output = "Name='y'\nRange=[0 1]\nMF1='c':'constant',[2]\nMF2='d':'constant',[6]\n";
  const auto system = readFis(fisOf("NumInputs=2\nNumRules=2\n", input, output, kFisRules + "0, 2 (1) : 1\n"),
                              "t.fis", {&notes, {}});
  EXPECT_NEAR(valueOf(system, {2.5}), 3.0, 1e-12);
  EXPECT_EQ(joined(notes),
            "t.fis:28:1: a rule without a condition is left out\n"
            "t.fis: NumInputs says 2, the file holds 1\n"
            "t.fis: NumRules says 2, the file holds 3\n"
            "t.fis:15:1: NumMFs says 3, the section holds 2\n"
            "t.fis: curves with more numbers than their shape needs: 1; those beyond are passed over, "
            "as MATLAB does\n");
}

TEST(FisTypes, TypeTwoIsNamed)
{
  std::string byType = fisOf("", kFisInput, kFisOutput, kFisRules), byCurve = byType;
  byType.replace(byType.find("'sugeno'"), 8, "'sugenotype2'");
  byCurve.replace(byCurve.find("MF1="), 4, "MF1U=");
  EXPECT_EQ(readFis(byType, "t.fis").error().detail, "t.fis:3:7: type-2 systems are not read");
  EXPECT_NE(readFis(byCurve, "t.fis").error().detail.find("type-2 systems are not read"), std::string::npos);
}

// One system, whose names have an umlaut, in the encodings in which such files are found.
TEST(Encodings, DoNotChangeTheSystem)
{
  std::string utf8 = fisOf("", kFisInput, kFisOutput, kFisRules);
  utf8.replace(utf8.find("Name='x'"), 8, "Name='h\xC3\xA4rte'");
  std::string latin = utf8, wide = "\xFF\xFE";
  latin.replace(latin.find("\xC3\xA4"), 2, "\xE4");
  for (const char c : latin) (wide += c) += '\0';
  for (const std::string& text : {utf8, latin, "\xEF\xBB\xBF" + utf8, wide}) {
    const auto system = readFis(text, "t.fis");
    ASSERT_TRUE(system) << system.error().detail;
    EXPECT_EQ(system->inputs[0].name, "h\xC3\xA4rte");
  }
  for (const char* name : {"k\xE4lte", "k\xC3\xA4lte"}) {
    const std::string fll = std::string("Engine: e\nInputVariable: ") + name + "\n  range: 0 1\n";
    EXPECT_EQ(readFll(fll, "t.fll")->inputs[0].name, "k\xC3\xA4lte");
  }
}

TEST(FllFiles, ASecondEngineIsNamed)
{
  EXPECT_EQ(readFll("Engine: a\nEngine: b\n", "t.fll").error().detail,
            "t.fll:2:1: a second engine begins here; a file holds one");
}

// fuzzylite's formulas with a flank at infinity, which is none.
TEST(InfiniteCorners, MakeShoulders)
{
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const auto at = [](Shape shape, std::vector<double> p, double x) {
    const Term term{"t", shape, std::move(p), 1.0, {}};
    const Status status = checkTerm(term);
    EXPECT_TRUE(status) << status.error().detail;
    return membership(Curve{shape, term.parameters, 1.0}, x);
  };
  EXPECT_EQ(at(Shape::Trapezoid, {-kInf, -kInf, 3, 6}, -1e9), 1.0);
  EXPECT_EQ(at(Shape::Trapezoid, {-kInf, -kInf, 3, 6}, 4.5), 0.5);
  EXPECT_EQ(at(Shape::Trapezoid, {3, 6, kInf, kInf}, 4.5), 0.5);
  EXPECT_EQ(at(Shape::Trapezoid, {3, 6, kInf, kInf}, 1e9), 1.0);
  EXPECT_EQ(at(Shape::Trapezoid, {-kInf, -kInf, kInf, kInf}, 0.0), 1.0);
  EXPECT_EQ(at(Shape::PiShape, {-kInf, -kInf, 2, 6}, 4.0), 0.5);
  EXPECT_EQ(at(Shape::PiShape, {2, 6, kInf, kInf}, 4.0), 0.5);
  EXPECT_EQ(at(Shape::Rectangle, {-kInf, 3}, -1e9), 1.0);
  EXPECT_EQ(at(Shape::Rectangle, {3, kInf}, 2.9), 0.0);
  EXPECT_EQ(at(Shape::GaussianProduct, {-kInf, 1, 5, 2}, -1e9), 1.0);
  EXPECT_EQ(at(Shape::GaussianProduct, {-kInf, 1, 5, 2}, 7.0), std::exp(-0.5));
  for (const auto& [shape, p] : {std::pair{Shape::Trapezoid, std::vector{-kInf, -kInf, -kInf, 5.0}},
                                 {Shape::Trapezoid, {kInf, kInf, kInf, kInf}},
                                 {Shape::PiShape, {-kInf, 0.0, 2.0, 6.0}},
                                 {Shape::Ramp, {-kInf, 5.0}},
                                 {Shape::Gaussian, {kInf, 1.0}}})
    EXPECT_FALSE(checkTerm({"t", shape, p, 1.0, {}})) << nameOf(shape);
}

// An area whose set is open to the left is bounded by the range: 1 up to 3, then down to 6.
TEST(InfiniteCorners, BoundAreasByTheRange)
{
  const auto system =
    readFll("Engine: e\nInputVariable: x\n  range: 0 1\n  term: on Ramp 0 1\nOutputVariable: y\n  range: "
            "0 10\n  aggregation: Maximum\n  defuzzifier: Centroid 100\n  term: t Trapezoid -inf -inf 3 "
            "6\nRuleBlock: r\n  conjunction: none\n  disjunction: none\n  implication: Minimum\n  "
            "activation: General\n  rule: if x is on then y is t\n",
            "t.fll");
  EXPECT_NEAR(valueOf(system, {1.0}), (3 * 1.5 + 1.5 * 4) / 4.5, 1e-12);
}

// A sigmoid reaches its ends at infinity; Tsukamoto's inverse stays within the output's range.
TEST(TsukamotoInverse, StaysWithinTheRange)
{
  for (const auto& [shape, p, w, value] : {std::tuple{Shape::Sigmoid, std::vector{5.0, 2.0}, 1e-9, 0.0},
                                           {Shape::Sigmoid, {5.0, 2.0}, 1.0 - 1e-9, 10.0},
                                           {Shape::Sigmoid, {5.0, -2.0}, 1e-9, 10.0},
                                           {Shape::Sigmoid, {5.0, 2.0}, 0.5, 5.0},
                                           {Shape::Concave, {4.0, 8.0}, 1e-6, 0.0}}) {
    const Curve curve{shape, p, 1.0};
    EXPECT_EQ(tsukamoto(curve, w, 0.0, 10.0, false), value) << nameOf(shape) << w;
    const bool held = value == 0.0 || value == 10.0;
    EXPECT_EQ(tsukamotoSlope(curve, w, 0.0, 10.0, false).byX == 0.0, held);
  }
}

} // namespace esm::fis
