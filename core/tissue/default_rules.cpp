// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/tissue_model.h"

#include <array>
#include <cmath>
#include <limits>

namespace esm {

namespace {

using fuzzy::Names;
using fuzzy::RuleBase;
using fuzzy::Term;
using fuzzy::Variable;

struct NamedTerm {
  const char *id, *english, *german;
  double peak; ///< on the variable's axis
};
using FiveTerms = std::array<NamedTerm, 5>;

/// Triangles from peak to peak with shoulders at both ends: the memberships of every place sum to 1, so
/// that no value is without a word and two neighbouring words cross at one half.
std::vector<Term> partition(const FiveTerms& named)
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<Term> terms;
  for (std::size_t i = 0; i < named.size(); ++i) {
    const double before = i > 0 ? named[i - 1].peak : -kInfinity;
    const double after = i + 1 < named.size() ? named[i + 1].peak : kInfinity;
    terms.push_back({named[i].id,
                     {named[i].english, named[i].german},
                     fuzzy::Shape::Triangle,
                     {before, named[i].peak, after}});
  }
  return terms;
}

/// What a hand can tell. The names let the usual findings be written as they are spoken: "rather hard",
/// "a little elastic", "hardly shiftable".
std::vector<Variable> inputs()
{
  const FiveTerms hardness = {{{"soft", "soft", "weich", 0.0},
                               {"rather_soft", "rather soft", "ziemlich weich", 0.25},
                               {"medium", "medium", "mittel", 0.5},
                               {"rather_hard", "rather hard", "ziemlich hart", 0.75},
                               {"hard", "hard", "hart", 1.0}}};
  const FiveTerms elasticity = {{{"low", "inelastic", "unelastisch", 0.0},
                                 {"a_little", "a little elastic", "wenig elastisch", 0.25},
                                 {"medium", "medium", "mittel", 0.5},
                                 {"elastic", "elastic", "elastisch", 0.75},
                                 {"high", "highly elastic", "hochelastisch", 1.0}}};
  const FiveTerms shiftability = {{{"fixed", "fixed", "fest", 0.0},
                                   {"hardly", "hardly shiftable", "kaum verschieblich", 0.25},
                                   {"medium", "medium", "mittel", 0.5},
                                   {"shiftable", "shiftable", "verschieblich", 0.75},
                                   {"free", "free", "frei", 1.0}}};
  return {{"hardness", {"hardness", "Härte"}, "", 0.0, 1.0, 0.5, false, partition(hardness)},
          {"elasticity", {"elasticity", "Elastizität"}, "", 0.0, 1.0, 0.5, false, partition(elasticity)},
          {"shiftability",
           {"shiftability", "Verschieblichkeit"},
           "",
           0.0,
           1.0,
           0.5,
           false,
           partition(shiftability)}};
}

FiveTerms levels(const std::array<double, 5>& peaks)
{
  return {{{"very_low", "very low", "sehr niedrig", std::log10(peaks[0])},
           {"low", "low", "niedrig", std::log10(peaks[1])},
           {"medium", "medium", "mittel", std::log10(peaks[2])},
           {"high", "high", "hoch", std::log10(peaks[3])},
           {"very_high", "very high", "sehr hoch", std::log10(peaks[4])}}};
}

/// Peaks near what is measured. Young's modulus: fat and liver 2-5 kPa, muscle 7 kPa, uterus 30-90 kPa
/// (Kiss 2006), gallbladder 255 kPa (Karimi 2017), vessels and bile duct 0.5-0.6 MPa, skin above 1 MPa.
/// Viscosity as retardation time: tan(delta) / omega of uterus and liver is 2-3 ms. Anchoring: an organ
/// with a wall of 2 mm sinks by (density g thickness) / anchoring under its weight: 0.2 mm at medium,
/// 2 cm at very low.
std::vector<Variable> outputs()
{
  const auto modulus = levels({1e3, 7e3, 45e3, 250e3, 1.6e6});
  const auto viscosity = levels({0.5e-3, 1.2e-3, 3e-3, 10e-3, 40e-3});
  const auto anchoring = levels({1e3, 1e4, 1e5, 1e6, 1e7});
  return {{"youngs_modulus", {"stiffness", "Steifigkeit"}, "Pa", 500.0, 1e7, 43e3, true, partition(modulus)},
          {"viscosity", {"viscosity", "Viskosität"}, "s", 0.2e-3, 0.1, 3e-3, true, partition(viscosity)},
          {"anchoring", {"anchoring", "Verankerung"}, "Pa/m", 300.0, 3e7, 1e5, true, partition(anchoring)}};
}

/// "IF input IS term THEN output IS level": one rule per term, so that each finding acts on one property.
void addRules(RuleBase& ruleBase, const Variable& input, const Variable& output, bool rising)
{
  for (std::size_t i = 0; i < input.terms.size(); ++i) {
    const std::size_t level = rising ? i : output.terms.size() - 1 - i;
    fuzzy::Rule rule;
    rule.condition.nodes.push_back(
      {fuzzy::Condition::Kind::Proposition, {input.id, input.terms[i].id, {}}, {}});
    rule.consequents.push_back({output.id, output.terms[level].id, {}});
    ruleBase.rules.push_back(std::move(rule));
  }
}

} // namespace

RuleBase defaultRules()
{
  RuleBase ruleBase{inputs(), outputs(), {}};
  addRules(ruleBase, ruleBase.inputs[0], ruleBase.outputs[0], true);  // harder: stiffer
  addRules(ruleBase, ruleBase.inputs[1], ruleBase.outputs[1], false); // more elastic: less sluggish
  addRules(ruleBase, ruleBase.inputs[2], ruleBase.outputs[2], false); // more shiftable: less held
  return ruleBase;
}

TissueModel defaultTissue()
{
  TissueModel model;
  model.rules = defaultRules();
  for (const Variable& input : model.rules.inputs) model.inputs.emplace_back(input.defaultValue);
  return model;
}

} // namespace esm
