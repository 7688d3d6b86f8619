// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/tissue_json.h"

#include "core/project/net_json.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm::json {

using namespace fuzzy;

namespace {

constexpr const char* kShapes[] = {"triangle", "trapezoid", "gaussian"};
constexpr const char* kProfiles[] = {"smooth", "linear", "smoother"};
constexpr const char* kHedges[] = {"not", "very", "extremely", "somewhat"};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Json namesOf(const Names& names)
{
  return {{"en", validUtf8(names.english)}, {"de", validUtf8(names.german)}};
}

Names readNames(const View& object)
{
  object.expectKeys({"en", "de"});
  return {object["en"].text(), object["de"].text()};
}

Json hedgesOf(const std::vector<Hedge>& hedges)
{
  Json::array_t list;
  for (const Hedge hedge : hedges) list.emplace_back(kHedges[static_cast<std::size_t>(hedge)]);
  return list;
}

std::vector<Hedge> readHedges(const View& object)
{
  std::vector<Hedge> hedges;
  if (!object.has("hedges")) return hedges;
  const View list = object["hedges"];
  for (std::size_t i = 0; i < list.size() && list.sound(); ++i)
    hedges.push_back(Hedge(list[i].choice(kHedges)));
  return hedges;
}

/// A corner of a shoulder lies at infinity, which JSON numbers cannot say.
Json cornersOf(const std::vector<double>& parameters)
{
  Json::array_t list;
  for (const double corner : parameters)
    list.push_back(std::isinf(corner) ? Json(corner > 0 ? "infinity" : "-infinity") : Json(corner));
  return list;
}

std::vector<double> readCorners(const View& list)
{
  constexpr const char* kWords[] = {"-infinity", "infinity"};
  std::vector<double> corners;
  for (std::size_t i = 0; i < list.size() && list.sound(); ++i)
    corners.push_back(!list[i].isText()             ? list[i].number()
                      : list[i].choice(kWords) == 0 ? -kInfinity
                                                    : kInfinity);
  return corners;
}

Json variableOf(const Variable& variable)
{
  Json terms = Json::array();
  for (const Term& term : variable.terms)
    terms.push_back({{"id", validUtf8(term.id)},
                     {"name", namesOf(term.name)},
                     {"shape", kShapes[static_cast<std::size_t>(term.shape)]},
                     {"parameters", cornersOf(term.parameters)}});
  return {{"id", validUtf8(variable.id)},        {"name", namesOf(variable.name)},
          {"unit", validUtf8(variable.unit)},    {"minimum", variable.minimum},
          {"maximum", variable.maximum},         {"default", variable.defaultValue},
          {"logarithmic", variable.logarithmic}, {"terms", std::move(terms)}};
}

Variable readVariable(const View& object)
{
  object.expectKeys({"id", "name", "unit", "minimum", "maximum", "default", "logarithmic", "terms"});
  Variable variable{object["id"].text(),
                    readNames(object["name"]),
                    object["unit"].text(),
                    object["minimum"].number(),
                    object["maximum"].number(),
                    object["default"].number(),
                    object["logarithmic"].boolean(),
                    {}};
  const View terms = object["terms"];
  for (std::size_t i = 0; i < terms.size() && terms.sound(); ++i) {
    terms[i].expectKeys({"id", "name", "shape", "parameters"});
    variable.terms.push_back({terms[i]["id"].text(), readNames(terms[i]["name"]),
                              Shape(terms[i]["shape"].choice(kShapes)), readCorners(terms[i]["parameters"])});
  }
  return variable;
}

std::vector<Variable> readVariables(const View& list)
{
  std::vector<Variable> variables;
  for (std::size_t i = 0; i < list.size() && list.sound(); ++i) variables.push_back(readVariable(list[i]));
  return variables;
}

Json propositionOf(const Proposition& proposition)
{
  Json object = {{"variable", validUtf8(proposition.variable)}, {"term", validUtf8(proposition.term)}};
  if (!proposition.hedges.empty()) object["hedges"] = hedgesOf(proposition.hedges);
  return object;
}

Proposition readProposition(const View& object)
{
  object.expectKeys({"variable", "term"}, {"hedges"});
  return {object["variable"].text(), object["term"].text(), readHedges(object)};
}

/// The flat tree as in memory: {"and": [1, 2]}, {"or": [...]} and {"not": [3]} point to later entries.
Json conditionOf(const Condition& condition)
{
  using Kind = Condition::Kind;
  Json::array_t list;
  for (const Condition::Node& node : condition.nodes) {
    if (node.kind == Kind::Proposition)
      list.push_back(propositionOf(node.proposition));
    else
      list.push_back({{node.kind == Kind::And  ? "and"
                       : node.kind == Kind::Or ? "or"
                                               : "not",
                       node.children}});
  }
  return list;
}

Condition readCondition(const View& list)
{
  using Kind = Condition::Kind;
  Condition condition;
  const auto count = static_cast<Index>(list.size());
  for (std::size_t i = 0; i < list.size() && list.sound(); ++i) {
    Condition::Node node;
    const char* key = list[i].has("and")   ? "and"
                      : list[i].has("or")  ? "or"
                      : list[i].has("not") ? "not"
                                           : nullptr;
    if (key) {
      list[i].expectKeys({key});
      node.kind = *key == 'a' ? Kind::And : *key == 'o' ? Kind::Or : Kind::Not;
      node.children = list[i][key].indexList(count);
    } else {
      node.proposition = readProposition(list[i]);
    }
    condition.nodes.push_back(std::move(node));
  }
  return condition;
}

Rule readRule(const View& object)
{
  object.expectKeys({"if", "then", "weight", "enabled", "note"});
  Rule rule;
  rule.condition = readCondition(object["if"]);
  const View consequents = object["then"];
  for (std::size_t i = 0; i < consequents.size() && consequents.sound(); ++i)
    rule.consequents.push_back(readProposition(consequents[i]));
  rule.weight = object["weight"].number(Range::ZeroToOne);
  rule.enabled = object["enabled"].boolean();
  rule.note = object["note"].text();
  return rule;
}

Json inputOf(const InputValue& value)
{
  if (const double* crisp = std::get_if<double>(&value)) return *crisp;
  const Word& word = std::get<Word>(value);
  Json object = {{"term", validUtf8(word.term)}};
  if (!word.hedges.empty()) object["hedges"] = hedgesOf(word.hedges);
  return object;
}

InputValue readInput(const View& value, const Variable& variable)
{
  if (!value.isObject()) return value.number();
  value.expectKeys({"term"}, {"hedges"});
  Word word{value["term"].text(), readHedges(value)};
  if (std::none_of(variable.terms.begin(), variable.terms.end(),
                   [&](const Term& t) { return t.id == word.term; }))
    value["term"].mustBe(("a term of \"" + variable.id + "\"").c_str());
  return word;
}

Eigen::Quaterniond readRotation(const View& list)
{
  if (!list.isList() || list.size() != 4) {
    list.mustBe("a list of four numbers, the unit quaternion w, x, y, z");
    return Eigen::Quaterniond::Identity();
  }
  const Eigen::ArrayXd q = list.numbers(4);
  const Eigen::Quaterniond rotation(q[0], q[1], q[2], q[3]);
  if (std::abs(rotation.norm() - 1.0) > 1e-6) list.mustBe("a unit quaternion w, x, y, z");
  return rotation;
}

MirrorPlane readMirror(const View& object)
{
  object.expectKeys({"point", "normal"});
  const MirrorPlane plane{object["point"].vector(), object["normal"].vector()};
  if (object.sound() && !(plane.normal.squaredNorm() > 0.0)) object["normal"].mustBe("longer than 0");
  return plane;
}

Region readRegion(const View& object, const RuleBase& rules)
{
  object.expectKeys({"name", "centre", "semi_axes", "rotation", "falloff", "enabled", "inputs"},
                    {"profile", "inside_out", "mirror", "locked", "visible"});
  Region region;
  region.name = object["name"].text();
  region.ellipsoid = readEllipsoid(object);
  region.falloff = object["falloff"].number(Range::ZeroToOne);
  region.enabled = object["enabled"].boolean();
  region.inputs = readInputs(object["inputs"], rules);
  if (object.has("profile")) region.profile = FalloffProfile(object["profile"].choice(kProfiles));
  if (object.has("inside_out")) region.insideOut = object["inside_out"].boolean();
  if (object.has("mirror")) region.mirror = readMirror(object["mirror"]);
  if (object.has("locked")) region.locked = object["locked"].boolean();
  if (object.has("visible")) region.visible = object["visible"].boolean();
  return region;
}

/// What a region seldom has is left out, so that programs from before can read the rest.
Json regionOf(const Region& region, const RuleBase& rules)
{
  Json object = {{"name", validUtf8(region.name)}};
  object.update(ellipsoidOf(region.ellipsoid));
  object["falloff"] = region.falloff;
  object["enabled"] = region.enabled;
  object["inputs"] = inputsOf(region.inputs, rules);
  if (region.profile != FalloffProfile::Smooth)
    object["profile"] = kProfiles[static_cast<std::size_t>(region.profile)];
  if (region.insideOut) object["inside_out"] = true;
  if (region.mirror)
    object["mirror"] = {{"point", listOf(region.mirror->point)}, {"normal", listOf(region.mirror->normal)}};
  if (region.locked) object["locked"] = true;
  if (!region.visible) object["visible"] = false;
  return object;
}

} // namespace

Json ellipsoidOf(const Ellipsoid& ellipsoid)
{
  const Eigen::Quaterniond& q = ellipsoid.rotation;
  return {{"centre", listOf(ellipsoid.centre)},
          {"semi_axes", listOf(ellipsoid.semiAxes)},
          {"rotation", {q.w(), q.x(), q.y(), q.z()}}};
}

Ellipsoid readEllipsoid(const View& object)
{
  Ellipsoid ellipsoid;
  ellipsoid.centre = object["centre"].vector();
  ellipsoid.semiAxes = object["semi_axes"].vector();
  for (std::size_t axis = 0; axis < 3 && object.sound(); ++axis)
    object["semi_axes"][axis].number(Range::Positive);
  ellipsoid.rotation = readRotation(object["rotation"]);
  return ellipsoid;
}

Json ruleBaseOf(const RuleBase& rules)
{
  Json inputs = Json::array(), outputs = Json::array(), list = Json::array();
  for (const Variable& variable : rules.inputs) inputs.push_back(variableOf(variable));
  for (const Variable& variable : rules.outputs) outputs.push_back(variableOf(variable));
  for (const Rule& rule : rules.rules) {
    Json::array_t consequents;
    for (const Proposition& consequent : rule.consequents) consequents.push_back(propositionOf(consequent));
    list.push_back({{"if", conditionOf(rule.condition)},
                    {"then", std::move(consequents)},
                    {"weight", rule.weight},
                    {"enabled", rule.enabled},
                    {"note", validUtf8(rule.note)}});
  }
  return {{"inputs", std::move(inputs)}, {"outputs", std::move(outputs)}, {"rules", std::move(list)}};
}

RuleBase readRuleBase(const View& object)
{
  object.expectKeys({"inputs", "outputs", "rules"});
  RuleBase rules{readVariables(object["inputs"]), readVariables(object["outputs"]), {}};
  const View list = object["rules"];
  for (std::size_t i = 0; i < list.size() && list.sound(); ++i) rules.rules.push_back(readRule(list[i]));
  return rules;
}

Json inputsOf(const std::vector<InputValue>& inputs, const RuleBase& rules)
{
  Json object = Json::object();
  for (std::size_t i = 0; i < std::min(inputs.size(), rules.inputs.size()); ++i)
    object[validUtf8(rules.inputs[i].id)] = inputOf(inputs[i]);
  return object;
}

std::vector<InputValue> readInputs(const View& object, const RuleBase& rules)
{
  std::vector<InputValue> inputs;
  for (const std::string& key : object.keys())
    if (!rules.findInput(key)) object[key.c_str()].complain("is no input of the rule base");
  for (const Variable& variable : rules.inputs) {
    if (!object.has(variable.id.c_str()))
      object.complain("lacks \"" + variable.id + "\", an input of the rule base");
    inputs.push_back(object.sound() ? readInput(object[variable.id.c_str()], variable) : InputValue{});
  }
  return inputs;
}

Json regionsOf(const TissueModel& tissue)
{
  Json list = Json::array();
  for (const Region& region : tissue.regions) list.push_back(regionOf(region, tissue.rules));
  return list;
}

std::vector<Region> readRegions(const View& list, const RuleBase& rules)
{
  std::vector<Region> regions;
  for (std::size_t i = 0; i < list.size() && list.sound(); ++i) regions.push_back(readRegion(list[i], rules));
  return regions;
}

} // namespace esm::json
