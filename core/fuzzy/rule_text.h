// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fuzzy/rule_base.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace esm::fuzzy {

/// Why a rule text is no rule, and where: for the red mark under the word.
struct RuleTextError {
  std::size_t offset = 0; ///< first byte of the offending word in the UTF-8 text
  std::size_t length = 0; ///< bytes; 0 at the end of the text ("something is missing here")
  std::string message;    ///< English sentence without full stop
  std::string suggestion; ///< the word that may have been meant, empty if none is near
  /// What kind, so that the window can say it in its own language; `message` is the English text.
  enum class Kind : std::uint8_t {
    ExpectedIf,
    ExpectedThen,
    ExpectedIs,
    ExpectedVariable,
    ExpectedTerm,
    UnknownVariable,
    UnknownTerm,
    OutputInCondition,
    InputInConclusion,
    ExpectedWeight,
    UnbalancedParenthesis,
    UnexpectedText,
    Empty
  } kind = Kind::UnexpectedText;
};

/// One rule of controlled language:
///
///     IF hardness IS very hard AND (elasticity IS inelastic OR NOT shiftability IS free)
///     THEN stiffness IS high WITH 0.8
///
///     WENN Härte IST sehr hart UND (Elastizität IST unelastisch ODER NICHT Verschieblichkeit IST frei)
///     DANN Steifigkeit IST hoch MIT 0.8
///
/// Keywords in either case, of either language in the same text; variables and terms by name in either
/// language or by id, in any case (umlauts included), names may hold blanks; ',' also works as decimal
/// mark of the weight. Several consequents are joined by AND. NOT binds before AND, AND before OR.
///
/// A name in "quotes" is taken whole, for names that look like keywords or hedges. Unquoted, the longest
/// name wins ("rather hard", if there is such a term, before the hedge "rather"). Further words for hedges:
///     somewhat       rather, fairly, a little; etwas, ziemlich, ein wenig
///     extremely      extrem, äußerst
///     not somewhat   hardly; kaum
/// A comma, semicolon or full stop behind a word is passed over. Any text gives a rule or an error.
std::variant<Rule, RuleTextError> parseRule(std::string_view text, const RuleBase& ruleBase);

/// The rule as text; parseRule(formatRule(r)) == r up to enabled and note, for every rule that
/// checkRuleBase() accepts and whose condition stands depth first, as the parser writes it.
std::string formatRule(const Rule& rule, const RuleBase& ruleBase, Language language);

/// A whole rule base's rules, one per line; blank lines and lines starting with '#' are passed over.
struct RuleLineError {
  int line = 0;        ///< from 1
  RuleTextError error; ///< its offset counts from the start of that line
};
std::variant<std::vector<Rule>, RuleLineError> parseRules(std::string_view text, const RuleBase& ruleBase);

/// What an input field takes: a number ("0.7", "0,7") or a word with hedges ("very hard", "sehr hart").
struct Word {
  std::string term; ///< id
  std::vector<Hedge> hedges;
  bool operator==(const Word&) const = default;
};
using InputValue = std::variant<double, Word>;
std::variant<InputValue, RuleTextError> parseInput(std::string_view text, const Variable& variable);
std::string formatInput(const InputValue& value, const Variable& variable, Language language);

/// Keywords and hedges of a language in display form, for highlighting and completion.
struct Vocabulary {
  std::vector<std::string> keywords; ///< IF THEN IS AND OR NOT WITH
  std::vector<std::string> hedges;
};
Vocabulary vocabulary(Language language);

} // namespace esm::fuzzy
