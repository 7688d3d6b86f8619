// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/rule_text.h"

#include "core/base/text_number.h"
#include "core/fuzzy/rule_reader.h"

#include <algorithm>
#include <cmath>

namespace esm::fuzzy {

namespace {

std::string_view trimmed(std::string_view text)
{
  constexpr std::string_view kBlanks = " \t\r\f\v";
  const std::size_t from = text.find_first_not_of(kBlanks);
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(kBlanks) - from + 1);
}

/// Puts names into words: plainly where that reads back as the same thing, else in quotes, else as the
/// quoted id, which always does.
class RuleWriter {
public:
  RuleWriter(const RuleBase& ruleBase, Language language)
    : m_ruleBase(ruleBase), m_inputs(ruleBase.inputs), m_outputs(ruleBase.outputs), m_language(language)
  {}

  std::string keyword(Keyword keyword) const { return keywordText(keyword, m_language); }

  std::string proposition(const Proposition& proposition, bool isInput) const
  {
    const Variable* variable =
      isInput ? m_ruleBase.findInput(proposition.variable) : m_ruleBase.findOutput(proposition.variable);
    if (!variable) return '"' + proposition.variable + '"';
    return variableName(*variable, isInput) + ' ' + keyword(Keyword::Is) + ' ' +
           formatInput(Word{proposition.term, proposition.hedges}, *variable, m_language);
  }

  std::string condition(const Condition& condition, int index) const
  {
    const Condition::Node& node = condition.nodes[static_cast<std::size_t>(index)];
    if (node.kind == Condition::Kind::Proposition) return proposition(node.proposition, true);
    std::string text;
    for (const int child : node.children) {
      if (node.kind == Condition::Kind::Not)
        text += keyword(Keyword::Not) + ' ';
      else if (!text.empty())
        text += ' ' + keyword(node.kind == Condition::Kind::And ? Keyword::And : Keyword::Or) + ' ';
      const std::string part = this->condition(condition, child);
      const auto kind = condition.nodes[static_cast<std::size_t>(child)].kind;
      text += needsParentheses(node.kind, kind) ? '(' + part + ')' : part;
    }
    return text;
  }

private:
  /// NOT binds before AND, AND before OR; a group within its like is kept as a group.
  static bool needsParentheses(Condition::Kind outer, Condition::Kind inner)
  {
    if (inner == Condition::Kind::Or) return true;
    return inner == Condition::Kind::And && outer != Condition::Kind::Or;
  }

  std::string variableName(const Variable& variable, bool isInput) const
  {
    const auto& variables = isInput ? m_ruleBase.inputs : m_ruleBase.outputs;
    const NameTable& names = isInput ? m_inputs : m_outputs;
    const NameTable& others = isInput ? m_outputs : m_inputs;
    const std::string& name = variable.name.in(m_language);
    for (const std::string& text : {name, '"' + name + '"'}) {
      const std::vector<Token> tokens = tokenize(text);
      const auto match = names.match(tokens);
      const auto other = others.match(tokens);
      if (match && match->tokens == tokens.size() && &variables[match->index] == &variable &&
          (!other || other->tokens <= match->tokens))
        return text;
    }
    return '"' + variable.id + '"';
  }

  const RuleBase& m_ruleBase;
  NameTable m_inputs, m_outputs;
  Language m_language;
};

bool isOneLine(const std::string& text)
{
  return std::none_of(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; });
}

} // namespace

std::variant<Rule, RuleTextError> parseRule(std::string_view text, const RuleBase& ruleBase)
{
  RuleReader reader(text, ruleBase);
  if (auto rule = reader.readRule()) return std::move(*rule);
  return reader.error();
}

std::string formatRule(const Rule& rule, const RuleBase& ruleBase, Language language)
{
  const RuleWriter writer(ruleBase, language);
  std::string text = writer.keyword(Keyword::If);
  if (!rule.condition.nodes.empty()) text += ' ' + writer.condition(rule.condition, 0);
  for (std::size_t i = 0; i < rule.consequents.size(); ++i) {
    text += ' ' + writer.keyword(i == 0 ? Keyword::Then : Keyword::And) + ' ';
    text += writer.proposition(rule.consequents[i], false);
  }
  if (rule.weight != 1.0) text += ' ' + writer.keyword(Keyword::With) + ' ' + formatDouble(rule.weight);
  return text;
}

std::variant<std::vector<Rule>, RuleLineError> parseRules(std::string_view text, const RuleBase& ruleBase)
{
  std::vector<Rule> rules;
  int line = 0;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find('\n', from), text.size());
    const std::string_view content = text.substr(from, to - from);
    from = to + 1;
    ++line;
    const std::string_view visible = trimmed(content);
    if (visible.empty() || visible.front() == '#') continue;
    auto parsed = parseRule(content, ruleBase);
    if (const auto* error = std::get_if<RuleTextError>(&parsed)) return RuleLineError{line, *error};
    rules.push_back(std::get<Rule>(std::move(parsed)));
  }
  return rules;
}

std::variant<InputValue, RuleTextError> parseInput(std::string_view text, const Variable& variable)
{
  std::string number(trimmed(text));
  std::replace(number.begin(), number.end(), ',', '.');
  if (const auto value = parseDouble(number); value && std::isfinite(*value)) return InputValue(*value);

  const RuleBase noNames;
  RuleReader reader(text, noNames);
  if (reader.atEnd()) {
    return RuleTextError{
      text.size(), 0, "here a number or a word must follow", {}, RuleTextError::Kind::Empty};
  }
  auto word = reader.readWord(variable);
  if (word && reader.atEnd()) return InputValue(std::move(*word));
  if (word) reader.refuseRest();
  return reader.error();
}

std::string formatInput(const InputValue& value, const Variable& variable, Language language)
{
  if (const double* number = std::get_if<double>(&value)) return formatDouble(*number);
  const Word& word = std::get<Word>(value);
  std::string hedges;
  for (const Hedge hedge : word.hedges) hedges += std::string(hedgeText(hedge, language)) + ' ';
  const auto term = std::find_if(variable.terms.begin(), variable.terms.end(),
                                 [&](const Term& candidate) { return candidate.id == word.term; });
  const auto quoted = [&hedges](const std::string& text) {
    std::string result = hedges;
    return result.append(1, '"').append(text).append(1, '"');
  };
  if (term == variable.terms.end()) return quoted(word.term);
  const RuleBase noNames;
  const std::string& name = term->name.in(language);
  for (const std::string& text : {hedges + name, quoted(name)}) {
    RuleReader reader(text, noNames);
    const auto read = reader.readWord(variable);
    if (read && reader.atEnd() && *read == word && isOneLine(text)) return text;
  }
  return quoted(word.term);
}

} // namespace esm::fuzzy
