// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/words.h"

#include <gtest/gtest.h>

namespace esm::fuzzy {
namespace {

TEST(FoldCase, KnowsUmlautsAndSharpS)
{
  EXPECT_EQ(foldCase("HÄRTE"), "härte");
  EXPECT_EQ(foldCase("Ölig ÜBER"), "ölig über");
  EXPECT_EQ(foldCase("groß"), foldCase("GROSS"));
  EXPECT_EQ(foldCase("GROẞ"), foldCase("groß"));
  EXPECT_EQ(foldCase("Ha\xCC\x88rte"), "härte") << "a + combining diaeresis";
  EXPECT_EQ(foldCase("  two \t blanks\xC2\xA0here "), "two blanks here");
  EXPECT_EQ(foldCase("3 × 4"), "3 × 4") << "the times sign has no lower case";
}

TEST(FoldCase, LeavesBrokenBytesAlone)
{
  EXPECT_EQ(foldCase("\xC3"), "\xC3");
  EXPECT_EQ(foldCase("\xFF\xFE"), "\xFF\xFE");
}

TEST(Tokenize, FindsWordsParenthesesAndQuotes)
{
  const std::vector<Token> tokens = tokenize("(Härte, \"a b\")x.");
  ASSERT_EQ(tokens.size(), 5U);
  EXPECT_EQ(tokens[0].kind, Token::Kind::Open);
  EXPECT_EQ(tokens[1].folded, "härte");
  EXPECT_EQ(tokens[1].offset, 1U);
  EXPECT_EQ(tokens[1].length, 6U); // bytes, ä takes two; the comma is passed over
  EXPECT_EQ(tokens[2].kind, Token::Kind::Quoted);
  EXPECT_EQ(tokens[2].folded, "a b");
  EXPECT_EQ(tokens[2].length, 5U);
  EXPECT_EQ(tokens[3].kind, Token::Kind::Close);
  EXPECT_EQ(tokens[4].folded, "x");
}

TEST(EditDistance, CountsCharactersNotBytes)
{
  EXPECT_EQ(editDistance("hrad", "hard", 3), 1) << "a swap of neighbours";
  EXPECT_EQ(editDistance("harte", "härte", 3), 1);
  EXPECT_EQ(editDistance("", "abc", 5), 3);
  EXPECT_EQ(editDistance("kitten", "sitting", 5), 3);
  EXPECT_EQ(editDistance("abc", "xyz", 1), 2) << "limit + 1 means more than the limit";
}

TEST(NearestWord, SuggestsASlipButNotAnotherWord)
{
  const std::vector<std::string> words = {"groß", "hard", "Härte", "stiffness"};
  EXPECT_EQ(nearestWord("gros", words), "groß");
  EXPECT_EQ(nearestWord("hrad", words), "hard");
  EXPECT_EQ(nearestWord("HARTE", words), "Härte");
  EXPECT_EQ(nearestWord("stifness", words), "stiffness");
  EXPECT_EQ(nearestWord("liver", words), "");
}

} // namespace
} // namespace esm::fuzzy
