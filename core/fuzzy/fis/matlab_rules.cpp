// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/matlab_rules.h"

#include "core/fuzzy/fis/format_names.h"

#include <cmath>

namespace esm::fis {

namespace {

using namespace matlab;

/// A term's number, negative for not; behind the point, with fuzzylite, a hedge.
Proposition readCode(double code, std::string_view word, int variable, std::size_t terms, bool onOutput)
{
  const double size = std::abs(code), whole = std::floor(size + 1e-6);
  const int fraction = static_cast<int>(std::lround((size - whole) * 100.0));
  if (!(whole <= static_cast<double>(terms)))
    throw Fault{word.data(), shown(word) + " is no term: the variable has " + std::to_string(terms)};
  Proposition proposition{onOutput, variable, static_cast<int>(whole) - 1, {}};
  if (code < 0.0) proposition.hedges.push_back(Hedge::Not);
  if (fraction == 40) proposition.hedges.insert(proposition.hedges.end(), {Hedge::Very, Hedge::Very});
  bool known = fraction == 0 || fraction == 40;
  for (const auto& [number, hedge] : kHedgeCodes)
    if (fraction == number) proposition.hedges.push_back(hedge), known = true;
  if (fraction == 99) proposition.term = -1;
  if (!known || (proposition.term < 0 && fraction != 99))
    throw Fault{word.data(), shown(word) + " is no known term or hedge"};
  return proposition;
}

template <class Variable>
std::vector<Proposition> readRow(std::string_view row, const std::vector<Variable>& variables, bool onOutput)
{
  std::vector<Proposition> propositions;
  std::size_t place = 0;
  std::string_view rest = trimmed(row);
  for (; !rest.empty(); ++place) {
    const std::string_view word = takeWord(rest);
    if (place >= variables.size()) throw Fault{word.data(), "the rule names more variables than there are"};
    const double code = readNumber(word);
    if (code != 0.0)
      propositions.push_back(
        readCode(code, word, static_cast<int>(place), variables[place].terms.size(), onOutput));
  }
  if (place < variables.size()) throw Fault{row.data(), "the rule names fewer variables than there are"};
  return propositions;
}

} // namespace

Rule readRuleRow(std::string_view line, const System& system)
{
  const std::size_t comma = line.find(','), open = line.find('('), close = line.find(')'),
                    colon = line.rfind(':');
  if (comma == std::string_view::npos || open == std::string_view::npos || close == std::string_view::npos ||
      colon == std::string_view::npos || comma > open || open > close || close > colon)
    throw Fault{line.data(), "here a rule 'inputs, outputs (weight) : 1 or 2' was expected"};
  Rule rule;
  const auto conditions = readRow(line.substr(0, comma), system.inputs, false);
  rule.consequents = readRow(line.substr(comma + 1, open - comma - 1), system.outputs, true);
  rule.weight = readExpression(trimmed(line.substr(open + 1, close - open - 1)));
  const std::string_view connection = trimmed(line.substr(colon + 1));
  const double joins = readExpression(connection);
  if (joins != 1.0 && joins != 2.0) throw Fault{connection.data(), "the connection is 1 (and) or 2 (or)"};
  if (rule.consequents.empty()) throw Fault{line.data(), "the rule has no conclusion"};
  if (conditions.size() > 1) {
    Antecedent::Node chain;
    chain.kind = joins == 1.0 ? Antecedent::Kind::And : Antecedent::Kind::Or;
    for (std::size_t i = 0; i < conditions.size(); ++i) chain.children.push_back(static_cast<int>(i) + 1);
    rule.antecedent.nodes.push_back(std::move(chain));
  }
  for (const Proposition& condition : conditions)
    rule.antecedent.nodes.push_back({Antecedent::Kind::Proposition, condition, {}});
  return rule;
}

} // namespace esm::fis
