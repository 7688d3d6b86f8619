// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/fuzzy/small_rules.h"

#include <cmath>

namespace esm::fuzzy {
namespace {

using FaultKind = RuleTextError::Kind;

// One model, two languages: both sentences are the same rule.
TEST(RuleText, EnglishAndGermanAreOneRule)
{
  const RuleBase base = smallRules();
  const Rule english = rule(base, "IF hardness IS very hard THEN stiffness IS high");
  EXPECT_EQ(rule(base, "WENN Härte IST sehr hart DANN Steifigkeit IST hoch"), english);
  EXPECT_EQ(rule(base, "if HÄRTE is SEHR hart, then Steifigkeit ist HIGH."), english) << "mixed, any case";
  ASSERT_EQ(english.condition.nodes.size(), 1U);
  EXPECT_EQ(english.condition.nodes[0].proposition, (Proposition{"hardness", "hard", {Hedge::Very}}));
  EXPECT_EQ(english.consequents, (std::vector<Proposition>{{"stiffness", "high", {}}}));
  EXPECT_EQ(english.weight, 1.0);
}

TEST(RuleText, TheExampleOfTheHeaderIsATree)
{
  const RuleBase base = smallRules();
  const Rule english =
    rule(base, "IF hardness IS very hard AND (elasticity IS low OR NOT shift IS free) THEN "
               "stiffness IS high WITH 0.8");
  const auto kind = [&](int i) { return english.condition.nodes.at(static_cast<std::size_t>(i)).kind; };
  EXPECT_EQ(kind(0), Condition::Kind::And);
  EXPECT_EQ(english.condition.nodes[0].children, (std::vector<int>{1, 2}));
  EXPECT_EQ(kind(2), Condition::Kind::Or);
  EXPECT_EQ(english.condition.nodes[2].children, (std::vector<int>{3, 4}));
  EXPECT_EQ(kind(4), Condition::Kind::Not);
  EXPECT_EQ(english.weight, 0.8);
  EXPECT_EQ(rule(base,
                 "WENN Härte IST sehr hart UND (Elastizität IST gering ODER NICHT Verschieblichkeit IST "
                 "frei) DANN Steifigkeit IST hoch MIT 0,8"),
            english);
}

TEST(RuleText, NamesMayHoldBlanksAndIdsServeToo)
{
  const RuleBase base = smallRules();
  const Rule byName = rule(base, "IF shift ability IS free AND hardness IS Big  Lump THEN depth IS small");
  EXPECT_EQ(rule(base, "IF shift IS free AND hardness IS big THEN depth IS small"), byName);
  EXPECT_EQ(rule(base, "IF \"Shift Ability\" IS \"free\" AND hardness IS GROSS THEN depth IS small"), byName);
}

TEST(RuleText, PhysiciansWordsAreHedges)
{
  const RuleBase base = smallRules();
  const auto hedges = [&](const std::string& phrase) {
    return rule(base, "IF hardness IS " + phrase + " hard THEN depth IS small")
      .condition.nodes.at(0)
      .proposition.hedges;
  };
  for (const char* text : {"rather", "a little", "somewhat", "ziemlich", "etwas", "ein wenig"})
    EXPECT_EQ(hedges(text), std::vector{Hedge::Somewhat}) << text;
  for (const char* text : {"hardly", "kaum", "not somewhat", "nicht etwas"})
    EXPECT_EQ(hedges(text), (std::vector{Hedge::Not, Hedge::Somewhat})) << text;
  EXPECT_EQ(hedges("äußerst"), std::vector{Hedge::Extremely});
}

// A term may be named like a hedged one; the longer name wins, and writing puts quotes where they are needed.
TEST(RuleText, TermsNamedLikeHedgesStayApart)
{
  RuleBase base = smallRules();
  base.inputs[0].terms.push_back(makeTerm("very hard", Shape::Triangle, {0, 1, 1}));
  Rule named = rule(base, "IF hardness IS very hard THEN depth IS small");
  EXPECT_EQ(named.condition.nodes[0].proposition, (Proposition{"hardness", "very hard", {}}));
  Rule hedged = named;
  hedged.condition.nodes[0].proposition = {"hardness", "hard", {Hedge::Very}};
  const std::string text = formatRule(hedged, base, Language::English);
  EXPECT_EQ(text, "IF hardness IS very \"hard\" THEN depth IS small");
  EXPECT_EQ(rule(base, text), hedged);
}

struct Mistake {
  const char* text;
  FaultKind kind;
  std::size_t offset, length; ///< bytes
  const char* suggestion;
};

// Where the red mark goes, and what is offered. Offsets counted by hand in bytes (ä, ö, ß take two).
TEST(RuleText, MistakesAreMarkedAtTheWord)
{
  const Mistake mistakes[] = {
    {"", FaultKind::Empty, 0, 0, ""},
    {"hardness IS hard THEN depth IS small", FaultKind::ExpectedIf, 0, 8, ""},
    {"WEN hardness IS hard THEN depth IS small", FaultKind::ExpectedIf, 0, 3, "WENN"},
    {"IF", FaultKind::ExpectedVariable, 2, 0, ""},
    {"IF IS hard THEN depth IS small", FaultKind::ExpectedVariable, 3, 2, ""},
    {"IF hardnes IS hard THEN depth IS small", FaultKind::UnknownVariable, 3, 7, "hardness"},
    {"IF shft ability IS free THEN depth IS small", FaultKind::UnknownVariable, 3, 12, "shift ability"},
    {"WENN Harte IST hart DANN depth IST small", FaultKind::UnknownVariable, 5, 5, "Härte"},
    {"IF hardness hard THEN depth IS small", FaultKind::ExpectedIs, 12, 4, ""},
    {"IF hardness SI hard THEN depth IS small", FaultKind::ExpectedIs, 12, 2, "IS"},
    {"IF hardness IS THEN depth IS small", FaultKind::ExpectedTerm, 15, 4, ""},
    {"IF hardness IS hrad THEN depth IS small", FaultKind::UnknownTerm, 15, 4, "hard"},
    {"IF hardness IS vrey hard THEN depth IS small", FaultKind::UnknownTerm, 15, 4, "very"},
    {"WENN Härte IST sehr gros DANN Tiefe IST small", FaultKind::UnknownTerm, 21, 4, "groß"},
    {"IF hardness IS hard soft THEN depth IS small", FaultKind::ExpectedThen, 20, 4, ""},
    {"IF hardness IS hard THNE depth IS small", FaultKind::ExpectedThen, 20, 4, "THEN"},
    {"IF hardness IS hard", FaultKind::ExpectedThen, 19, 0, ""},
    {"IF depth IS small THEN stiffness IS high", FaultKind::OutputInCondition, 3, 5, ""},
    {"IF hardness IS hard THEN shift ability IS free", FaultKind::InputInConclusion, 25, 13, ""},
    {"IF hardness IS hard THEN depth IS not small", FaultKind::UnexpectedText, 34, 3, ""},
    {"IF (hardness IS hard THEN depth IS small", FaultKind::UnbalancedParenthesis, 3, 1, ""},
    {"IF hardness IS hard) THEN depth IS small", FaultKind::UnbalancedParenthesis, 19, 1, ""},
    {"IF (hardness IS hard soft) THEN depth IS small", FaultKind::UnexpectedText, 21, 4, ""},
    {"IF hardness IS hard THEN depth IS small WITH", FaultKind::ExpectedWeight, 44, 0, ""},
    {"IF hardness IS hard THEN depth IS small WITH 1,5", FaultKind::ExpectedWeight, 45, 3, ""},
    {"IF hardness IS hard THEN depth IS small WITH nan", FaultKind::ExpectedWeight, 45, 3, ""},
    {"IF hardness IS hard THEN depth IS small WIHT 1", FaultKind::UnexpectedText, 40, 4, "WITH"},
    {"IF hardness IS hard THEN depth IS small WITH 1 2", FaultKind::UnexpectedText, 47, 1, ""},
  };
  const RuleBase base = smallRules();
  for (const Mistake& mistake : mistakes) {
    const auto parsed = parseRule(mistake.text, base);
    const auto* error = std::get_if<RuleTextError>(&parsed);
    ASSERT_NE(error, nullptr) << mistake.text;
    EXPECT_EQ(error->kind, mistake.kind) << mistake.text << ": " << error->message;
    EXPECT_EQ(error->offset, mistake.offset) << mistake.text;
    EXPECT_EQ(error->length, mistake.length) << mistake.text;
    EXPECT_EQ(error->suggestion, mistake.suggestion) << mistake.text;
    EXPECT_FALSE(error->message.empty());
    EXPECT_NE(error->message.back(), '.');
  }
}

TEST(RuleText, AListOfRulesPassesOverCommentsAndNamesTheLine)
{
  const RuleBase base = smallRules();
  const auto good = parseRules("# a comment\r\n\r\nIF hardness IS hard THEN depth IS small\r\n"
                               "  WENN Härte IST weich DANN Tiefe IST large",
                               base);
  ASSERT_TRUE(std::holds_alternative<std::vector<Rule>>(good));
  EXPECT_EQ(std::get<0>(good).size(), 2U);
  const auto bad = parseRules("\nIF hardness IS hrad THEN depth IS small\n", base);
  ASSERT_TRUE(std::holds_alternative<RuleLineError>(bad));
  EXPECT_EQ(std::get<1>(bad).line, 2);
  EXPECT_EQ(std::get<1>(bad).error.offset, 15U) << "within its line";
}

TEST(InputText, IsANumberOrAWord)
{
  const Variable hardness = smallRules().inputs[0];
  const auto value = [&](std::string_view text) { return std::get<InputValue>(parseInput(text, hardness)); };
  EXPECT_EQ(value(" 0.7 "), InputValue(0.7));
  EXPECT_EQ(value("0,7"), InputValue(0.7));
  EXPECT_EQ(value("sehr hart"), InputValue(Word{"hard", {Hedge::Very}}));
  EXPECT_EQ(value("hard"), InputValue(Word{"hard", {}}));
  EXPECT_EQ(formatInput(value("very hard"), hardness, Language::German), "sehr hart");
  EXPECT_EQ(formatInput(value("0.7"), hardness, Language::German), "0.7");

  const auto error = [&](std::string_view text) {
    return std::get<RuleTextError>(parseInput(text, hardness));
  };
  EXPECT_EQ(error("  ").kind, FaultKind::Empty);
  EXPECT_EQ(error("nan").kind, FaultKind::UnknownTerm);
  EXPECT_EQ(error("very hrad").suggestion, "hard");
  EXPECT_EQ(error("very hrad").offset, 5U);
  EXPECT_EQ(error("hard soft").kind, FaultKind::UnexpectedText);
  EXPECT_EQ(error("(hard").kind, FaultKind::ExpectedTerm);
}

TEST(Vocabulary, HoldsTheWordsOfItsLanguage)
{
  EXPECT_EQ(vocabulary(Language::German).keywords,
            (std::vector<std::string>{"WENN", "DANN", "IST", "UND", "ODER", "NICHT", "MIT"}));
  const auto hedges = vocabulary(Language::English).hedges;
  for (const char* word : {"not", "very", "extremely", "somewhat", "hardly"})
    EXPECT_NE(std::find(hedges.begin(), hedges.end(), word), hedges.end()) << word;
}

} // namespace
} // namespace esm::fuzzy
