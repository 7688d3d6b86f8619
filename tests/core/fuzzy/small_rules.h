// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fuzzy/inference.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace esm::fuzzy {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline Term makeTerm(const std::string& id, Shape shape, std::vector<double> parameters)
{
  return {id, {id, id}, shape, std::move(parameters)};
}

/// hardness (soft, hard, much harder), elasticity (low, high), shiftability (free, fixed) in [0, 1] to
/// stiffness in [0, 1] (low = 1 - x, high = x) and depth in [0, 10], with names in both languages.
inline RuleBase smallRules()
{
  const auto falling = [](const char* id, Names name) {
    return Term{id, std::move(name), Shape::Triangle, {0.0, 0.0, 1.0}};
  };
  const auto rising = [](const char* id, Names name) {
    return Term{id, std::move(name), Shape::Triangle, {0.0, 1.0, 1.0}};
  };
  RuleBase base;
  base.inputs = {{"hardness",
                  {"hardness", "Härte"},
                  "",
                  0,
                  1,
                  0.5,
                  false,
                  {falling("soft", {"soft", "weich"}), rising("hard", {"hard", "hart"}),
                   rising("big", {"big lump", "groß"})}},
                 {"elasticity",
                  {"elasticity", "Elastizität"},
                  "",
                  0,
                  1,
                  0.5,
                  false,
                  {falling("low", {"low", "gering"}), rising("high", {"high", "hoch"})}},
                 {"shift",
                  {"shift ability", "Verschieblichkeit"},
                  "",
                  0,
                  1,
                  0.5,
                  false,
                  {falling("free", {"free", "frei"}), rising("fixed", {"fixed", "fest"})}}};
  base.outputs = {
    {"stiffness",
     {"stiffness", "Steifigkeit"},
     "",
     0,
     1,
     0.25,
     false,
     {falling("low", {"low", "gering"}), rising("high", {"high", "hoch"})}},
    {"depth",
     {"depth", "Tiefe"},
     "m",
     0,
     10,
     3.0,
     false,
     {makeTerm("small", Shape::Triangle, {0, 2, 4}), makeTerm("large", Shape::Triangle, {4, 6, 8})}}};
  return base;
}

/// The rule of a text that must be one.
inline Rule rule(const RuleBase& base, const std::string& text)
{
  auto parsed = parseRule(text, base);
  if (const auto* error = std::get_if<RuleTextError>(&parsed)) {
    ADD_FAILURE() << text << ": " << error->message << " at " << error->offset;
    return {};
  }
  return std::get<Rule>(parsed);
}

inline Engine engine(RuleBase base, const std::vector<std::string>& rules)
{
  for (const std::string& text : rules) base.rules.push_back(rule(base, text));
  auto created = Engine::create(std::move(base));
  if (!created) ADD_FAILURE() << created.error().detail;
  return std::move(*created);
}

} // namespace esm::fuzzy
