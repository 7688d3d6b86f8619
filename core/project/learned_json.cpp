// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/tissue_json.h"

#include <limits>
#include <utility>

namespace esm::json {

namespace {

constexpr const char* kQuantities[] = {"stiffness", "law_parameter", "anchor"};
constexpr const char* kSpringKinds[] = {"edge",          "line",        "strut",     "wall_edge",
                                        "wall_diagonal", "wall_across", "wall_brace"};
static_assert(std::size(kSpringKinds) == kSpringKindCount);
constexpr std::pair<const char*, std::vector<double> SpringQuestions::*> kBorders[] = {
  {"length", &SpringQuestions::lengthBorders},
  {"normal", &SpringQuestions::normalBorders},
  {"axis", &SpringQuestions::axisBorders},
  {"depth", &SpringQuestions::depthBorders}};
constexpr std::pair<const char*, int SpringClass::*> kAnswers[] = {{"length", &SpringClass::length},
                                                                   {"normal", &SpringClass::normal},
                                                                   {"axis", &SpringClass::axis},
                                                                   {"depth", &SpringClass::depth}};
constexpr Index kMostAnswers = 1000;

Json factorOf(const LearnedFactor& factor)
{
  Json object = {{"quantity", kQuantities[static_cast<std::size_t>(factor.quantity)]},
                 {"value", factor.value},
                 {"deviation", factor.deviation}};
  if (!factor.isSeen) object["seen"] = false;
  if (!factor.region.empty()) object["region"] = validUtf8(factor.region);
  if (factor.of.kind >= 0) object["kind"] = kSpringKinds[factor.of.kind];
  for (const auto& [key, answer] : kAnswers)
    if (factor.of.*answer >= 0) object[key] = factor.of.*answer;
  return object;
}

LearnedFactor readFactor(const View& object)
{
  object.expectKeys({"quantity", "value", "deviation"},
                    {"seen", "region", "kind", "length", "normal", "axis", "depth"});
  LearnedFactor factor;
  factor.quantity = LearnedQuantity(object["quantity"].choice(kQuantities));
  factor.value = object["value"].number();
  factor.deviation = object["deviation"].number(Range::NotNegative);
  if (object.has("seen")) factor.isSeen = object["seen"].boolean();
  if (object.has("region")) factor.region = object["region"].text();
  if (object.has("kind")) factor.of.kind = static_cast<int>(object["kind"].choice(kSpringKinds));
  for (const auto& [key, answer] : kAnswers)
    if (object.has(key)) factor.of.*answer = object[key].integer(0, kMostAnswers);
  return factor;
}

} // namespace

Json learnedOf(const LearnedLayer& layer)
{
  Json questions = Json::object();
  if (layer.questions.byKind) questions["kind"] = true;
  for (const auto& [key, borders] : kBorders)
    if (!(layer.questions.*borders).empty()) questions[key] = layer.questions.*borders;
  Json factors = Json::array();
  for (const LearnedFactor& factor : layer.factors) factors.push_back(factorOf(factor));
  Json object = {
    {"recordings", layer.recordings}, {"questions", std::move(questions)}, {"factors", std::move(factors)}};
  if (layer.springs.empty()) return object;
  Json ids = Json::array(), logs = Json::array();
  for (const LearnedLayer::OneSpring& one : layer.springs) {
    ids.push_back(static_cast<Index>(one.spring));
    logs.push_back(one.log);
  }
  object["springs"] = {{"id", std::move(ids)}, {"log", std::move(logs)}};
  return object;
}

LearnedLayer readLearned(const View& object)
{
  object.expectKeys({"recordings", "questions", "factors"}, {"springs"});
  LearnedLayer layer;
  layer.recordings = object["recordings"].integer(0, std::numeric_limits<Index>::max());
  const View questions = object["questions"];
  questions.expectKeys({}, {"kind", "length", "normal", "axis", "depth"});
  if (questions.has("kind")) layer.questions.byKind = questions["kind"].boolean();
  for (const auto& [key, borders] : kBorders)
    if (questions.has(key)) layer.questions.*borders = questions[key].numberList();
  const View factors = object["factors"];
  for (std::size_t i = 0; i < factors.size() && factors.sound(); ++i)
    layer.factors.push_back(readFactor(factors[i]));
  if (object.has("springs")) {
    const View springs = object["springs"];
    springs.expectKeys({"id", "log"});
    const std::vector<Index> ids = springs["id"].indexList(std::numeric_limits<Index>::max());
    const Eigen::ArrayXd logs = springs["log"].numbers(static_cast<Index>(ids.size()));
    for (std::size_t i = 0; i < ids.size() && springs.sound(); ++i)
      layer.springs.push_back({SpringId{ids[i]}, logs[static_cast<Eigen::Index>(i)]});
  }
  return layer;
}

} // namespace esm::json
