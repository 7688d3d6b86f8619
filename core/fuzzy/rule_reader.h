// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fuzzy/lexicon.h"
#include "core/fuzzy/rule_text.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace esm::fuzzy {

/// Reads the controlled language by recursive descent. Each read...() either moves on and returns what it
/// read, or returns nothing and leaves the first fault in error().
///
///     rule       := IF any THEN conclusion (AND conclusion)* [WITH number]
///     any        := all (OR all)*
///     all        := one (AND one)*
///     one        := NOT one | '(' any ')' | proposition
///     proposition:= variable IS hedge* term
class RuleReader {
public:
  RuleReader(std::string_view text, const RuleBase& ruleBase);

  std::optional<Rule> readRule();
  /// hedge* term, up to a keyword, a parenthesis or the end.
  std::optional<Word> readWord(const Variable& variable);
  bool atEnd() const noexcept { return m_next == m_tokens.size(); }
  std::span<const Token> rest() const noexcept { return std::span(m_tokens).subspan(m_next); }
  const RuleTextError& error() const noexcept { return m_error; }
  /// Leaves the fault "nothing more may come here".
  void refuseRest();

private:
  enum class Role { Input, Output };
  /// A condition while it grows; turned into the flat tree, parents first, at the end.
  struct Branch {
    Condition::Kind kind = Condition::Kind::Proposition;
    Proposition proposition;
    std::vector<Branch> children;
  };
  std::optional<Branch> readChain(Condition::Kind kind, int depth);
  std::optional<Branch> readOne(int depth);
  std::optional<Branch> readGroup(int depth);
  std::optional<Proposition> readProposition(Role role);
  const Variable* readVariable(Role role);
  bool readConclusions(Rule& rule);
  bool readWeight(Rule& rule);
  static int flatten(const Branch& branch, Condition& condition);

  std::optional<Keyword> nextKeyword() const;
  bool accept(Keyword keyword);
  /// Whether a phrase of names ends at this token.
  bool isBoundary(std::size_t at) const;
  /// Whether what stands here may follow a term: not so for "not", which may be one more hedge.
  bool endsProposition(std::size_t at) const;
  std::size_t phraseEnd() const;
  using Kind = RuleTextError::Kind;
  /// Notes a fault at the next `tokens` tokens (at the end of the text if there are none).
  void fail(Kind kind, std::string message, const std::vector<std::string>& candidates,
            std::size_t tokens = 1);
  void failKeyword(Kind kind, std::string message, std::span<const Keyword> expected);
  void failName(Kind missing, Kind unknown, const std::string& what, const std::vector<std::string>& names,
                const std::vector<std::string>& others);
  std::string_view textOf(std::size_t from, std::size_t to) const;

  std::string_view m_text;
  const RuleBase& m_ruleBase;
  NameTable m_inputs, m_outputs;
  std::vector<Token> m_tokens;
  std::size_t m_next = 0;
  RuleTextError m_error;
};

} // namespace esm::fuzzy
