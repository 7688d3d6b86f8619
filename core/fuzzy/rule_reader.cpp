// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/rule_reader.h"

#include "core/base/text_number.h"

#include <algorithm>
#include <array>

namespace esm::fuzzy {

namespace {

constexpr std::array kAfterProposition = {Keyword::And, Keyword::Or, Keyword::Then};
constexpr std::array kAfterConclusion = {Keyword::And, Keyword::With};

} // namespace

RuleReader::RuleReader(std::string_view text, const RuleBase& ruleBase)
  : m_text(text),
    m_ruleBase(ruleBase),
    m_inputs(ruleBase.inputs),
    m_outputs(ruleBase.outputs),
    m_tokens(tokenize(text))
{}

std::optional<Rule> RuleReader::readRule()
{
  if (atEnd()) {
    fail(Kind::Empty, "there is no rule here", {});
    return std::nullopt;
  }
  if (!accept(Keyword::If)) {
    failKeyword(Kind::ExpectedIf, "a rule starts with IF", std::array{Keyword::If});
    return std::nullopt;
  }
  const auto condition = readChain(Condition::Kind::Or, 1);
  if (!condition) return std::nullopt;
  if (!accept(Keyword::Then)) {
    if (!atEnd() && m_tokens[m_next].kind == Token::Kind::Close)
      fail(Kind::UnbalancedParenthesis, "this parenthesis was never opened", {});
    else
      failKeyword(Kind::ExpectedThen, "here AND, OR or THEN must follow", kAfterProposition);
    return std::nullopt;
  }
  Rule rule;
  if (!readConclusions(rule) || !readWeight(rule)) return std::nullopt;
  if (flatten(*condition, rule.condition) > kMaximumConditionDepth) {
    m_next = 0;
    fail(Kind::UnbalancedParenthesis, "the condition is nested too deeply", {});
    return std::nullopt;
  }
  return rule;
}

/// Alternatives joined by OR, or members joined by AND; one alone stays itself.
std::optional<RuleReader::Branch> RuleReader::readChain(Condition::Kind kind, int depth)
{
  const bool isOr = kind == Condition::Kind::Or;
  const Keyword joint = isOr ? Keyword::Or : Keyword::And;
  Branch chain{kind, {}, {}};
  do {
    auto member = isOr ? readChain(Condition::Kind::And, depth) : readOne(depth);
    if (!member) return std::nullopt;
    chain.children.push_back(std::move(*member));
  } while (accept(joint));
  if (chain.children.size() > 1) return chain;
  Branch only = std::move(chain.children.front());
  return only;
}

std::optional<RuleReader::Branch> RuleReader::readOne(int depth)
{
  const bool opens = !atEnd() && m_tokens[m_next].kind == Token::Kind::Open;
  if (depth >= kMaximumConditionDepth && (opens || nextKeyword() == Keyword::Not)) {
    fail(Kind::UnbalancedParenthesis, "the condition is nested too deeply", {});
    return std::nullopt;
  }
  if (opens) return readGroup(depth + 1);
  if (accept(Keyword::Not)) {
    auto negated = readOne(depth + 1);
    if (!negated) return std::nullopt;
    Branch branch{Condition::Kind::Not, {}, {}};
    branch.children.push_back(std::move(*negated));
    return branch;
  }
  auto proposition = readProposition(Role::Input);
  if (!proposition) return std::nullopt;
  return Branch{Condition::Kind::Proposition, std::move(*proposition), {}};
}

std::optional<RuleReader::Branch> RuleReader::readGroup(int depth)
{
  const std::size_t opening = m_next++;
  auto group = readChain(Condition::Kind::Or, depth);
  if (!group) return std::nullopt;
  if (!atEnd() && m_tokens[m_next].kind == Token::Kind::Close) {
    ++m_next;
    return group;
  }
  if (!atEnd() && !nextKeyword()) {
    failKeyword(Kind::UnexpectedText, "here AND, OR or a closing parenthesis must follow",
                std::array{Keyword::And, Keyword::Or});
    return std::nullopt;
  }
  m_next = opening;
  fail(Kind::UnbalancedParenthesis, "this parenthesis is not closed", {});
  return std::nullopt;
}

std::optional<Proposition> RuleReader::readProposition(Role role)
{
  const Variable* variable = readVariable(role);
  if (!variable) return std::nullopt;
  if (!accept(Keyword::Is)) {
    failKeyword(Kind::ExpectedIs, "after a variable IS must follow", std::array{Keyword::Is});
    return std::nullopt;
  }
  const std::size_t start = m_next;
  auto word = readWord(*variable);
  if (!word) return std::nullopt;
  const bool negated = std::find(word->hedges.begin(), word->hedges.end(), Hedge::Not) != word->hedges.end();
  if (role == Role::Output && negated) {
    m_next = start;
    while (!matchHedge(rest()) || matchHedge(rest())->hedges.front() != Hedge::Not) ++m_next;
    fail(Kind::UnexpectedText, "a conclusion cannot be negated", {});
    return std::nullopt;
  }
  return Proposition{variable->id, std::move(word->term), std::move(word->hedges)};
}

const Variable* RuleReader::readVariable(Role role)
{
  const bool isInput = role == Role::Input;
  const auto& variables = isInput ? m_ruleBase.inputs : m_ruleBase.outputs;
  const NameTable& names = isInput ? m_inputs : m_outputs;
  const NameTable& wrongNames = isInput ? m_outputs : m_inputs;
  const auto match = names.match(rest());
  const auto wrong = wrongNames.match(rest());
  if (match && (!wrong || match->tokens >= wrong->tokens)) {
    m_next += match->tokens;
    return &variables[match->index];
  }
  if (wrong && isInput)
    fail(Kind::OutputInCondition, "this is an output, a condition speaks of inputs", {}, wrong->tokens);
  else if (wrong)
    fail(Kind::InputInConclusion, "this is an input, a conclusion speaks of outputs", {}, wrong->tokens);
  else
    failName(Kind::ExpectedVariable, Kind::UnknownVariable, isInput ? "input" : "output", names.spellings(),
             wrongNames.spellings());
  return nullptr;
}

std::optional<Word> RuleReader::readWord(const Variable& variable)
{
  const NameTable names(variable.terms);
  Word word;
  for (;;) {
    const auto term = names.match(rest());
    const auto hedge = matchHedge(rest());
    // A term's name may start with a hedge ("a little elastic"); it is the term if the phrase ends with it.
    if (term && (endsProposition(m_next + term->tokens) || !hedge)) {
      word.term = variable.terms[term->index].id;
      m_next += term->tokens;
      return word;
    }
    if (!hedge) break;
    word.hedges.insert(word.hedges.end(), hedge->hedges.begin(), hedge->hedges.end());
    m_next += hedge->tokens;
  }
  failName(Kind::ExpectedTerm, Kind::UnknownTerm, "term of '" + variable.name.english + "'",
           names.spellings(), hedgeTexts());
  return std::nullopt;
}

bool RuleReader::readConclusions(Rule& rule)
{
  do {
    auto consequent = readProposition(Role::Output);
    if (!consequent) return false;
    rule.consequents.push_back(std::move(*consequent));
  } while (accept(Keyword::And));
  return true;
}

bool RuleReader::readWeight(Rule& rule)
{
  if (atEnd()) return true;
  if (!accept(Keyword::With)) {
    refuseRest();
    return false;
  }
  if (!atEnd()) {
    std::string number = m_tokens[m_next].folded;
    std::replace(number.begin(), number.end(), ',', '.');
    const auto weight = parseDouble(number);
    if (weight && *weight >= 0.0 && *weight <= 1.0) {
      rule.weight = *weight;
      ++m_next;
      if (atEnd()) return true;
      refuseRest();
      return false;
    }
  }
  fail(Kind::ExpectedWeight, "here a weight from 0 to 1 must follow", {});
  return false;
}

void RuleReader::refuseRest()
{
  const bool close = !atEnd() && m_tokens[m_next].kind == Token::Kind::Close;
  if (close)
    fail(Kind::UnbalancedParenthesis, "this parenthesis was never opened", {});
  else
    failKeyword(Kind::UnexpectedText, "the text should end here", kAfterConclusion);
}

/// Appends the branch, parents first; returns how many nodes its longest way down has.
int RuleReader::flatten(const Branch& branch, Condition& condition)
{
  const std::size_t place = condition.nodes.size();
  condition.nodes.push_back({branch.kind, branch.proposition, {}});
  int deepest = 0;
  for (const Branch& child : branch.children) {
    condition.nodes[place].children.push_back(static_cast<int>(condition.nodes.size()));
    deepest = std::max(deepest, flatten(child, condition));
  }
  return deepest + 1;
}

std::optional<Keyword> RuleReader::nextKeyword() const
{
  return atEnd() ? std::nullopt : keywordOf(m_tokens[m_next]);
}

bool RuleReader::accept(Keyword keyword)
{
  if (nextKeyword() != keyword) return false;
  ++m_next;
  return true;
}

bool RuleReader::isBoundary(std::size_t at) const
{
  if (at >= m_tokens.size()) return true;
  const Token& token = m_tokens[at];
  return token.kind == Token::Kind::Open || token.kind == Token::Kind::Close || keywordOf(token).has_value();
}

bool RuleReader::endsProposition(std::size_t at) const
{
  return isBoundary(at) && (at >= m_tokens.size() || (m_tokens[at].kind != Token::Kind::Open &&
                                                      keywordOf(m_tokens[at]) != Keyword::Not));
}

std::size_t RuleReader::phraseEnd() const
{
  std::size_t end = m_next;
  while (!isBoundary(end)) ++end;
  return end;
}

std::string_view RuleReader::textOf(std::size_t from, std::size_t to) const
{
  const std::size_t start = m_tokens[from].offset;
  return m_text.substr(start, m_tokens[to - 1].offset + m_tokens[to - 1].length - start);
}

void RuleReader::fail(Kind kind, std::string message, const std::vector<std::string>& candidates,
                      std::size_t tokens)
{
  m_error = {m_text.size(), 0, std::move(message), {}, kind};
  if (atEnd()) return;
  const std::string_view word = textOf(m_next, std::min(m_next + tokens, m_tokens.size()));
  m_error.offset = m_tokens[m_next].offset;
  m_error.length = word.size();
  m_error.suggestion = nearestWord(word, candidates);
}

void RuleReader::failKeyword(Kind kind, std::string message, std::span<const Keyword> expected)
{
  fail(kind, std::move(message), keywordTexts(expected));
}

/// A name was wanted. Marks the whole phrase if it is nearly one of `names`, else its first word.
void RuleReader::failName(Kind missing, Kind unknown, const std::string& what,
                          const std::vector<std::string>& names, const std::vector<std::string>& others)
{
  const std::size_t end = phraseEnd();
  if (end == m_next) {
    fail(missing, "here the name of an " + what + " must follow", {});
    return;
  }
  fail(unknown, {}, names, end - m_next);
  if (m_error.suggestion.empty() && end > m_next + 1) {
    std::vector<std::string> candidates = names;
    candidates.insert(candidates.end(), others.begin(), others.end());
    fail(unknown, {}, candidates);
  }
  std::string_view shown = m_text.substr(m_error.offset, std::min<std::size_t>(m_error.length, 60));
  m_error.message = "'" + std::string(shown) + "' is no known " + what;
}

} // namespace esm::fuzzy
