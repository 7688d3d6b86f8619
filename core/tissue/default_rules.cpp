// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/tissue_model.h"

#include <cmath>
#include <limits>
#include <utility>

namespace esm {

namespace {

using fuzzy::Names;
using fuzzy::Proposition;
using fuzzy::RuleBase;
using fuzzy::Term;
using fuzzy::Variable;

struct NamedTerm {
  const char *id, *english, *german;
  double peak; ///< on the variable's axis
};
using NamedTerms = std::vector<NamedTerm>;

/// Triangles from peak to peak: within the outermost peaks the memberships of every place sum to 1, so that
/// no value is without a word and two neighbouring words cross at one half.
/// @param shoulders true: the outermost go on for ever; false: they are as wide outward as inward, so that
/// the
///        centre of each lies at its peak and rules can conclude the peak itself.
std::vector<Term> partition(const NamedTerms& named, bool shoulders)
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<Term> terms;
  for (std::size_t i = 0; i < named.size(); ++i) {
    const double peak = named[i].peak;
    const bool isFirst = i == 0, isLast = i + 1 == named.size();
    const double inward = isFirst ? named[1].peak : named[i - 1].peak;
    const double outer = shoulders ? (isFirst ? -kInfinity : kInfinity) : 2.0 * peak - inward;
    const double before = isFirst ? outer : named[i - 1].peak;
    const double after = isLast ? outer : named[i + 1].peak;
    terms.push_back(
      {named[i].id, {named[i].english, named[i].german}, fuzzy::Shape::Triangle, {before, peak, after}});
  }
  return terms;
}

Variable input(const char* id, Names name, const NamedTerms& terms)
{
  return {id, std::move(name), "", 0.0, 1.0, 0.5, false, partition(terms, true)};
}

/// What a hand can tell. The names let the usual findings be written as they are spoken: "rather hard",
/// "a little elastic", "hardly shiftable".
std::vector<Variable> inputs()
{
  return {input("hardness", {"hardness", "Härte"},
                {{"soft", "soft", "weich", 0.0},
                 {"doughy", "doughy", "teigig", 1.0 / 6.0},
                 {"rather_soft", "rather soft", "ziemlich weich", 2.0 / 6.0},
                 {"medium", "medium", "mittel", 0.5},
                 {"firm", "firm", "derb", 4.0 / 6.0},
                 {"rather_hard", "rather hard", "ziemlich hart", 5.0 / 6.0},
                 {"hard", "hard", "hart", 1.0}}),
          input("elasticity", {"elasticity", "Elastizität"},
                {{"low", "inelastic", "unelastisch", 0.0},
                 {"a_little", "a little elastic", "wenig elastisch", 0.25},
                 {"medium", "medium", "mittel", 0.5},
                 {"elastic", "elastic", "elastisch", 0.75},
                 {"high", "highly elastic", "hochelastisch", 1.0}}),
          input("shiftability", {"shiftability", "Verschieblichkeit"},
                {{"fixed", "fixed", "fest", 0.0},
                 {"hardly", "hardly shiftable", "kaum verschieblich", 0.25},
                 {"medium", "medium", "mittel", 0.5},
                 {"shiftable", "shiftable", "verschieblich", 0.75},
                 {"free", "free", "frei", 1.0}}),
          input("heaviness", {"heaviness", "Schwere"},
                {{"fatty", "fatty", "fettig", 0.0},
                 {"watery", "watery", "wasserreich", 0.5},
                 {"dense", "dense", "dicht", 1.0}}),
          input("toughness", {"toughness", "Zähigkeit"},
                {{"fragile", "fragile", "brüchig", 0.0},
                 {"normal", "normal", "normal", 0.5},
                 {"tough", "tough", "zäh", 1.0}}),
          input("stretch", {"stretch", "Dehnung"},
                {{"none", "without stiffening", "ohne Versteifung", 0.0},
                 {"mild", "mild stiffening", "milde Versteifung", 0.5},
                 {"strong", "strong stiffening", "starke Versteifung", 1.0}}),
          input("wall", {"wall", "Wand"},
                {{"hollow", "hollow", "hohl", 0.0},
                 {"thin", "thin", "dünnwandig", 1.0 / 3.0},
                 {"thick", "thick", "dickwandig", 2.0 / 3.0},
                 {"solid", "solid", "massiv", 1.0}})};
}

/// Terms of an output on a logarithmic axis; names from the lowest to the highest.
Variable output(const char* id, Names name, const char* unit, double minimum, double maximum, double usual,
                const std::vector<double>& peaks)
{
  static const NamedTerms kFive = {{"very_low", "very low", "sehr niedrig", 0.0},
                                   {"low", "low", "niedrig", 0.0},
                                   {"medium", "medium", "mittel", 0.0},
                                   {"high", "high", "hoch", 0.0},
                                   {"very_high", "very high", "sehr hoch", 0.0}};
  NamedTerms terms = kFive;
  if (peaks.size() == 3) terms = {kFive[1], kFive[2], kFive[3]};
  if (peaks.size() == 7) {
    terms.insert(terms.begin() + 2, {"rather_low", "rather low", "eher niedrig", 0.0});
    terms.insert(terms.begin() + 4, {"rather_high", "rather high", "eher hoch", 0.0});
  }
  for (std::size_t i = 0; i < terms.size(); ++i) terms[i].peak = std::log10(peaks[i]);
  return {id, std::move(name), unit, minimum, maximum, usual, true, partition(terms, false)};
}

/// Peaks near what is measured; docs/TISSUE.md has the table. Young's modulus: half a decade from word to
/// word. Viscosity as retardation time: damping ratios of 0.08, 0.16, 0.3, 0.6, 1.1 at 50 Hz, see
/// dampingRatio(). Anchoring: an organ with a wall of 2 mm sinks by (density g thickness) / anchoring under
/// its weight: 0.2 mm at medium, 2 cm at very low.
std::vector<Variable> outputs()
{
  const double half = std::sqrt(10.0);
  return {
    output("youngs_modulus", {"stiffness", "Steifigkeit"}, "Pa", 300.0, 1e7, 1e4 * half,
           {1e3, 1e3 * half, 1e4, 1e4 * half, 1e5, 1e5 * half, 1.5e6}),
    output("viscosity", {"viscosity", "Viskosität"}, "s", 0.2e-3, 15e-3, 1.9e-3,
           {0.5e-3, 1e-3, 1.9e-3, 3.8e-3, 7e-3}),
    output("anchoring", {"anchoring", "Verankerung"}, "Pa/m", 100.0, 1e8, 1e5, {1e3, 1e4, 1e5, 1e6, 1e7}),
    output("density", {"density", "Dichte"}, "kg/m^3", 780.0, 1350.0, 1055.0, {912.0, 1055.0, 1190.0}),
    output("rupture_strain", {"rupture strain", "Reißdehnung"}, "", 0.1, 3.3, 0.55,
           {0.2, 0.35, 0.55, 1.5, 2.2}),
    output("stiffening", {"stiffening", "Versteifung"}, "", 0.1, 60.0, 2.7, {0.6, 2.7, 12.0}),
    output("volume_ratio", {"volume stiffness", "Volumensteifigkeit"}, "", 1.0, 100.0, 10.0,
           {10.0 / 3.0, 10.0, 30.0})};
}

using NodeKind = fuzzy::Condition::Kind;

Proposition is(const char* variable, const char* term)
{
  return {variable, term, {}};
}

/// "IF all of these THEN conclusion WITH weight"; `kind` Or: any of these.
fuzzy::Rule rule(NodeKind kind, const std::vector<Proposition>& findings, const Proposition& conclusion,
                 double weight = 1.0)
{
  fuzzy::Rule made;
  if (findings.size() > 1) {
    made.condition.nodes.push_back({kind, {}, {}});
    for (std::size_t i = 1; i <= findings.size(); ++i)
      made.condition.nodes[0].children.push_back(static_cast<int>(i));
  }
  for (const Proposition& finding : findings)
    made.condition.nodes.push_back({NodeKind::Proposition, finding, {}});
  made.consequents.push_back(conclusion);
  made.weight = weight;
  return made;
}

/// One rule per term, so that each finding acts on one property. Terms from the lowest to the highest.
void addRules(RuleBase& ruleBase, const char* inputId, const char* outputId,
              const std::vector<const char*>& conclusions)
{
  const std::vector<Term>& terms = ruleBase.findInput(inputId)->terms;
  for (std::size_t i = 0; i < terms.size(); ++i)
    ruleBase.rules.push_back(
      rule(NodeKind::And, {is(inputId, terms[i].id.c_str())}, is(outputId, conclusions[i])));
}

/// Findings that mean more together than each for itself. The less certain, the lower the weight; a weight
/// below 1 also keeps each slider rising and falling with its own output.
void addInteractions(RuleBase& ruleBase)
{
  const auto add = [&](const std::vector<Proposition>& findings, const Proposition& conclusion,
                       double weight) {
    ruleBase.rules.push_back(rule(NodeKind::And, findings, conclusion, weight));
  };
  // A soft organ without a cavity is a bag of liquid: it moves aside, but keeps its volume.
  add({is("wall", "solid"), is("hardness", "soft")}, is("volume_ratio", "high"), 0.8);
  // A hard wall does not empty its cavity by giving way.
  add({is("wall", "thin"), is("hardness", "hard")}, is("volume_ratio", "medium"), 0.5);
  // Swollen and brittle: tears before all others.
  add({is("toughness", "fragile"), is("heaviness", "watery")}, is("rupture_strain", "very_low"), 0.7);
  // What is stretched to its fibres' length and brittle has nothing left to give.
  add({is("toughness", "fragile"), is("stretch", "strong")}, is("rupture_strain", "very_low"), 0.5);
  // Gut that is tough stretches to more than twice its length: folds and layers slide open first.
  add({is("toughness", "tough"), is("wall", "hollow")}, is("rupture_strain", "very_high"), 0.4);
  // Hollow and elastic organs hang on a mesentery, neither grown fast nor free.
  add({is("wall", "hollow"), is("elasticity", "elastic")}, is("anchoring", "medium"), 0.4);
  // Soft parenchyma is a sponge full of blood: squeezing it through damps (liver: a loss angle of 0.63 rad).
  add({is("wall", "solid"), is("hardness", "doughy")}, is("viscosity", "high"), 0.4);
  // A thin wall that is tough is so by its collagen, which stretch pulls straight: vessels.
  add({is("wall", "thin"), is("toughness", "tough")}, is("stiffening", "high"), 0.4);
}

} // namespace

RuleBase defaultRules()
{
  RuleBase ruleBase{inputs(), outputs(), {}};
  const std::vector<const char*> rising = {"very_low", "low", "medium", "high", "very_high"};
  const std::vector<const char*> falling(rising.rbegin(), rising.rend());
  addRules(ruleBase, "hardness", "youngs_modulus",
           {"very_low", "low", "rather_low", "medium", "rather_high", "high", "very_high"});
  addRules(ruleBase, "elasticity", "viscosity", falling);
  addRules(ruleBase, "shiftability", "anchoring", falling);
  addRules(ruleBase, "heaviness", "density", {"low", "medium", "high"});
  addRules(ruleBase, "toughness", "rupture_strain", {"low", "medium", "high"});
  addRules(ruleBase, "stretch", "stiffening", {"low", "medium", "high"});

  // What is full of liquid keeps its volume; a hollow organ gives way by emptying.
  const char* volume = "volume_ratio";
  ruleBase.rules.push_back(rule(NodeKind::Or, {is("wall", "hollow"), is("wall", "thin")}, is(volume, "low")));
  ruleBase.rules.push_back(
    rule(NodeKind::Or, {is("wall", "thick"), is("wall", "solid")}, is(volume, "medium")));
  addInteractions(ruleBase);
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
