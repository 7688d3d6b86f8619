// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/explain.h"

#include "core/base/assert.h"
#include "core/fuzzy/fis/evaluator.h"
#include "core/tissue/tissue_units.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

// clang-format off
//                                     E tau anchoring density stiffening rupture K/mu
constexpr std::array<std::int8_t, 7>  kE{1, 0, 0, 0, 0, 0, 0}, kTauE{1, 1, 0, 0, 0, 0, 0}, kDensity{0, 0, 0, 1, 0, 0, 0},
  kAnchoring{0, 0, 1, 0, 0, 0, 0}, kTauAnchoring{0, 1, 1, 0, 0, 0, 0}, kStiffening{0, 0, 0, 0, 1, 0, 0},
  kStiffening2{0, 0, 0, 0, 2, 0, 0}, kNone{};
// clang-format on

const ExplainedKind kEdgeStiffness{"stiffness", "N/m", "E h A / L^2", {"stiffness", "Steifigkeit"}, 1.0,
                                   "N/m",       kE};
const ExplainedKind kLineStiffness{"stiffness", "N/m", "E a / L", {"stiffness", "Steifigkeit"},
                                   1.0,         "N/m", kE};
/// The same times the material's scale s, where a net has one.
const ExplainedKind kScaledEdgeStiffness{
  "stiffness", "N/m", "s E h A / L^2", {"stiffness", "Steifigkeit"}, 1.0, "N/m", kE};
const ExplainedKind kScaledLineStiffness{"stiffness", "N/m", "s E a / L", {"stiffness", "Steifigkeit"},
                                         1.0,         "N/m", kE};
/// The same times the learned factor g.
const ExplainedKind kLearnedEdge{"stiffness", "N/m", "g E h A / L^2", {"stiffness", "Steifigkeit"}, 1.0,
                                 "N/m",       kE};
const ExplainedKind kLearnedLine{"stiffness", "N/m", "g E a / L", {"stiffness", "Steifigkeit"},
                                 1.0,         "N/m", kE};
const ExplainedKind kLearnedScaledEdge{
  "stiffness", "N/m", "g s E h A / L^2", {"stiffness", "Steifigkeit"}, 1.0, "N/m", kE};
const ExplainedKind kLearnedScaledLine{"stiffness", "N/m", "g s E a / L", {"stiffness", "Steifigkeit"}, 1.0,
                                       "N/m",       kE};
const ExplainedKind kLearnedLawB{"law_parameter",
                                 "",
                                 "b + d",
                                 {"parameter of the force law", "Parameter des Kraftgesetzes"},
                                 1.0,
                                 "",
                                 kNone};
const ExplainedKind kLearnedAnchor{
  "anchor_stiffness", "N/m", "g q A", {"stiffness of the anchor", "Steifigkeit des Ankers"}, 1.0, "N/m",
  kAnchoring};

/// [is learned][is scaled][is an edge]
const ExplainedKind& stiffnessKind(bool isLearned, bool isScaled, bool isEdge)
{
  const ExplainedKind* const kinds[2][2][2] = {
    {{&kLineStiffness, &kEdgeStiffness}, {&kScaledLineStiffness, &kScaledEdgeStiffness}},
    {{&kLearnedLine, &kLearnedEdge}, {&kLearnedScaledLine, &kLearnedScaledEdge}}};
  return *kinds[isLearned][isScaled][isEdge];
}
const ExplainedKind kViscosity{"viscosity", "N s/m",  "tau k", {"viscosity", "Viskosität"},
                               1e-3,        "mN s/m", kTauE};
const ExplainedKind kLawB{
  "law_parameter", "", "b", {"parameter of the force law", "Parameter des Kraftgesetzes"}, 1.0, "",
  kStiffening};
const ExplainedKind kLawCubic{
  "law_parameter", "", "b^2 / 6", {"parameter of the force law", "Parameter des Kraftgesetzes"}, 1.0, "",
  kStiffening2};
const ExplainedKind kSurfaceMass{"mass", "kg", "rho h A", {"mass", "Masse"}, 1e-6, "mg", kDensity};
const ExplainedKind kVolumeMass{"mass", "kg", "rho V", {"mass", "Masse"}, 1e-6, "mg", kDensity};
const ExplainedKind kLineMass{"mass", "kg", "sum of rho a L / 2", {"mass", "Masse"}, 1e-6, "mg", kNone};
const ExplainedKind kAnchor{
  "anchor_stiffness", "N/m", "q A", {"stiffness of the anchor", "Steifigkeit des Ankers"}, 1.0, "N/m",
  kAnchoring};
const ExplainedKind kAnchorViscosity{
  "anchor_viscosity", "N s/m",      "tau q A", {"viscosity of the anchor", "Viskosität des Ankers"}, 1e-3,
  "mN s/m",           kTauAnchoring};
const ExplainedKind kBand{
  "band_stiffness", "N/m", "E A / l", {"stiffness of the bands", "Steifigkeit der Bänder"}, 1.0, "N/m", kE};
const ExplainedKind kBandViscosity{
  "band_viscosity", "N s/m", "tau E A / l", {"viscosity of the bands", "Viskosität der Bänder"}, 1e-3,
  "mN s/m",         kTauE};

/// The tissue's parameters as kinds, in the order of kTissueOutputs.
const std::array<ExplainedKind, kTissueOutputCount>& parameterKinds()
{
  static const std::array<ExplainedKind, kTissueOutputCount> kinds = [] {
    constexpr const char *kUnit[] = {"Pa", "s", "Pa/m", "kg/m^3", "", "", ""},
                         *kSymbol[] = {"E", "tau", "q", "rho", "b", "", "K/mu"};
    std::array<ExplainedKind, kTissueOutputCount> made{};
    for (std::size_t i = 0; i < made.size(); ++i) {
      const auto parameter = kTissueOutputs[i].value;
      const ShownUnit shown = shownUnit(parameter);
      made[i] = {kTissueOutputs[i].id,
                 kUnit[i],
                 kSymbol[i],
                 {shownName(parameter, Language::English), shownName(parameter, Language::German)},
                 shown.perUnit,
                 shown.unit,
                 {}};
      made[i].powers[i] = 1;
    }
    return made;
  }();
  return kinds;
}

void addParameters(const TissueParameters& tissue, TissueExplanation& why)
{
  for (std::size_t i = 0; i < kTissueOutputs.size(); ++i) {
    const double value = tissue.*kTissueOutputs[i].value;
    why.parameters.push_back({&parameterKinds()[i], value, value});
  }
}

/// The parameters that the explanation is about: those of the thing's numbers, of tissue alone all; and
/// Young's modulus, which everybody asks for.
std::array<bool, kTissueOutputCount> parametersOf(const TissueExplanation& why)
{
  std::array<bool, kTissueOutputCount> wanted{};
  wanted.fill(why.thing.kind == ExplainedThing::Kind::Tissue);
  wanted[0] = true;
  if (!why.isOnSurface) wanted[3] = true; // its lines' mass asks for density
  for (const ExplainedValue& value : why.values)
    for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] |= value.kind->powers[i] != 0;
  return wanted;
}

bool concludes(const fuzzy::Rule& rule, const std::string& output)
{
  return std::any_of(rule.consequents.begin(), rule.consequents.end(),
                     [&](const fuzzy::Proposition& consequent) { return consequent.variable == output; });
}

std::vector<int> inputsOf(const fuzzy::Rule& rule, const fuzzy::RuleBase& rules)
{
  std::vector<int> inputs;
  for (std::size_t i = 0; i < rules.inputs.size(); ++i)
    if (std::any_of(rule.condition.nodes.begin(), rule.condition.nodes.end(), [&](const auto& node) {
          return node.kind == fuzzy::Condition::Kind::Proposition &&
                 node.proposition.variable == rules.inputs[i].id;
        }))
      inputs.push_back(static_cast<int>(i));
  return inputs;
}

/// The output's value by the rules that fired for it, less one. Only these are compiled again: the others add
/// nothing to the set.
double valueWithout(int omitted, const std::vector<RuleReason>& fired, const fuzzy::RuleBase& rules,
                    const fuzzy::Variable& output, const std::vector<fuzzy::InputValue>& inputs)
{
  fuzzy::RuleBase small{rules.inputs, {output}, {}};
  for (const RuleReason& reason : fired) {
    if (reason.rule == omitted) continue;
    small.rules.push_back(rules.rules[static_cast<std::size_t>(reason.rule)]);
    std::erase_if(small.rules.back().consequents,
                  [&](const fuzzy::Proposition& consequent) { return consequent.variable != output.id; });
  }
  if (small.rules.empty()) return output.defaultValue;
  const auto engine = fuzzy::Engine::create(std::move(small));
  return engine ? engine->evaluate(inputs).outputs[0].value : output.defaultValue;
}

OutputReason outputReason(const TissueField& field, int parameter, const LayerReason& layer)
{
  const fuzzy::RuleBase& rules = field.engine().ruleBase();
  OutputReason reason;
  reason.parameter = parameter;
  reason.output = field.outputOf(parameter);
  const fuzzy::Variable& output = rules.outputs[static_cast<std::size_t>(reason.output)];
  const fuzzy::OutputValue& value = layer.layer.inference.outputs[static_cast<std::size_t>(reason.output)];
  reason.value = value.value;
  reason.fromRules = value.fromRules;
  for (const fuzzy::RuleFiring& firing : layer.layer.inference.firings) {
    const fuzzy::Rule& rule = rules.rules[static_cast<std::size_t>(firing.rule)];
    if (value.fromRules && firing.degree >= fis::Evaluator::kLeastDegree && concludes(rule, output.id))
      reason.rules.push_back({firing.rule, firing.degree, 0.0, inputsOf(rule, rules)});
  }
  for (RuleReason& rule : reason.rules)
    rule.without = valueWithout(rule.rule, reason.rules, rules, output, layer.inputs);
  std::stable_sort(reason.rules.begin(), reason.rules.end(),
                   [](const RuleReason& a, const RuleReason& b) { return a.degree > b.degree; });
  return reason;
}

void addLayers(const TissueField& field, std::vector<TissueLayer> layers, TissueExplanation& why)
{
  const auto wanted = parametersOf(why);
  for (TissueLayer& layer : layers) {
    LayerReason reason;
    if (layer.region < 0) {
      reason.inputs = field.model().inputs;
    } else {
      const Region& region = field.model().regions[static_cast<std::size_t>(layer.region)];
      reason.name = region.name;
      reason.locked = region.locked;
      reason.inputs = region.inputs;
    }
    reason.layer = std::move(layer);
    for (int i = 0; i < kTissueOutputCount; ++i)
      if (wanted[static_cast<std::size_t>(i)] && field.outputOf(i) >= 0)
        reason.outputs.push_back(outputReason(field, i, reason));
    why.layers.push_back(std::move(reason));
  }
}

ExplainedGeometry lengthOf(const char* id, const char* symbol, const char* english, const char* german,
                           double value)
{
  return {id, symbol, "m", {english, german}, value, 1e-3, "mm"};
}

ExplainedGeometry area(const char* id, const char* symbol, const char* english, const char* german,
                       double value)
{
  return {id, symbol, "m^2", {english, german}, value, 1e-6, "mm²"};
}

ExplainedGeometry learnedFact(double factor)
{
  return {"learned_factor", "g", "", {"learned factor", "gelernter Faktor"}, factor};
}

/// Sum over the node's anchors: those of tissue's own bed, or the bands of the support layer.
double anchorOf(const SpringNet& net, Index node, const Eigen::ArrayXd& numbers, bool bands)
{
  double sum = 0.0;
  for (Index anchor = 0; anchor < net.anchors.count(); ++anchor)
    if (net.anchors.node[static_cast<std::size_t>(anchor)] == node && net.anchors.isBand(anchor) == bands)
      sum += numbers[anchor];
  return sum;
}

void addBands(const SpringNet& net, Index node, const TissueParameters& tissue, double dualArea,
              TissueExplanation& why)
{
  AnchorNumbers sum;
  double length = 0.0;
  for (Index anchor = 0; anchor < net.anchors.count(); ++anchor)
    if (net.anchors.node[static_cast<std::size_t>(anchor)] == node && net.anchors.isBand(anchor)) {
      length = net.anchors.bandLength[anchor];
      const AnchorNumbers one = bandNumbers(tissue, dualArea, length);
      sum.stiffness += one.stiffness;
      sum.viscosity += one.viscosity;
    }
  if (!(length > 0.0)) return;
  why.values.push_back({&kBand, anchorOf(net, node, net.anchors.stiffness, true), sum.stiffness});
  why.values.push_back({&kBandViscosity, anchorOf(net, node, net.anchors.viscosity, true), sum.viscosity});
  why.geometry.push_back(lengthOf("band_length", "l", "length of the bands", "Länge der Bänder", length));
}

} // namespace

const ExplainedValue& TissueExplanation::main() const noexcept
{
  return thing.kind == ExplainedThing::Kind::Spring ? values.front() : parameters.front();
}

const ExplainedValue* TissueExplanation::find(std::string_view kindId) const noexcept
{
  for (const auto* list : {&values, &parameters}) // a spring's own viscosity before the tissue's
    for (const ExplainedValue& value : *list)
      if (kindId == value.kind->id) return &value;
  return nullptr;
}

void TissueExplainer::explainSpring(const TissueField& field, const SpringNet& net,
                                    TissueExplanation& why) const
{
  const Index s = why.thing.index;
  const auto place = static_cast<std::size_t>(s);
  const TissueModel& model = field.model();
  const SpringGeometry geometry = m_places.springGeometry(s, model.thickness, net);
  const bool cubic = cubicFromStiffening(model), isEdge = geometry.isWall;
  const bool isScaled = net.material.modulusScale != 1.0;
  why.learned = learnedOfSpring(model, net, s);
  const bool isLearned = !why.learned.reasons.empty();
  const double lawShift = model.law == SpringLaw::Exponential ? why.learned.lawShift : 0.0;
  const SpringNumbers numbers =
    learned(springNumbers(field.at(why.place), geometry.perModulus, cubic), why.learned.factor, lawShift);
  why.id = static_cast<Index>(net.springId[place]);
  for (int end = 0; end < 2; ++end)
    why.nodes.push_back(static_cast<Index>(net.nodeId[static_cast<std::size_t>(net.ends(end, s))]));
  why.values.push_back({&stiffnessKind(isLearned, isScaled, isEdge), net.stiffness[s], numbers.stiffness});
  why.values.push_back({&kViscosity, net.viscosity[s], numbers.viscosity});
  const ExplainedKind& law = cubic ? kLawCubic : lawShift != 0.0 ? kLearnedLawB : kLawB;
  why.values.push_back({&law, net.lawParameter[s], numbers.lawParameter});
  if (isEdge) {
    why.geometry.push_back(area("area", "A", "area", "Fläche", geometry.area));
    why.geometry.push_back(lengthOf("thickness", "h", "wall thickness", "Wanddicke", model.thickness));
  } else {
    why.geometry.push_back(area("section", "a", "section", "Querschnitt", geometry.area));
  }
  why.geometry.push_back(lengthOf("length", "L", "length", "Länge", net.restLength[s]));
  if (isScaled)
    why.geometry.push_back({"modulus_scale",
                            "s",
                            "",
                            {"scale of the material", "Maßstab des Materials"},
                            net.material.modulusScale,
                            1.0,
                            ""});
  if (isLearned) why.geometry.push_back(learnedFact(why.learned.factor));
  if (lawShift != 0.0)
    why.geometry.push_back({"learned_shift", "d", "", {"learned addition", "gelernter Zuschlag"}, lawShift});
}

/// Of a node off the surface: half of each of its lines; as of nodes to which nothing belongs, whatever
/// applyTissue() makes of them beside the others.
double TissueExplainer::massOff(const TissueField& field, const SpringNet& net, Index node) const
{
  double mass = 0.0;
  const auto i = static_cast<std::size_t>(m_places.looseOfNode[static_cast<std::size_t>(node)]);
  for (const Index s : m_places.looseSprings[i])
    mass +=
      halfMassOfLine(field.at(m_places.point.col(s)).density,
                     m_places.springGeometry(s, field.model().thickness, net).section, net.restLength[s]);
  if (mass > 0.0) return mass;
  SpringNet copy = net;
  const auto applied = applyTissue(field.model(), copy);
  return applied ? copy.mass[node] : 0.0;
}

void TissueExplainer::explainNode(const TissueField& field, const SpringNet& net,
                                  TissueExplanation& why) const
{
  const Index node = why.thing.index;
  const auto place = static_cast<std::size_t>(node);
  const TissueModel& model = field.model();
  const TissueParameters tissue = field.at(why.place);
  const double dualArea = m_places.dualArea[node];
  why.id = static_cast<Index>(net.nodeId[place]);
  why.isFixed = net.fixed[place] != 0;
  why.isOnSurface = dualArea > 0.0;
  const double volume = m_places.volumeOf(node);
  if (!why.isOnSurface && !(volume > 0.0)) {
    why.values.push_back({&kLineMass, net.mass[node], massOff(field, net, node)});
    return;
  }
  if (volume > 0.0) {
    why.values.push_back({&kVolumeMass, net.mass[node], massOfVolume(tissue, volume)});
    why.geometry.push_back({"volume", "V", "m^3", {"volume", "Volumen"}, volume, 1e-9, "mm³"});
    if (!why.isOnSurface) return;
  } else {
    why.values.push_back({&kSurfaceMass, net.mass[node], massOfSurface(tissue, model.thickness, dualArea)});
  }
  why.learned = learnedOfNode(model, net, node);
  const bool isLearned = !why.learned.reasons.empty();
  const AnchorNumbers anchor = learned(anchorNumbers(tissue, dualArea), why.learned.factor);
  why.values.push_back({isLearned ? &kLearnedAnchor : &kAnchor,
                        anchorOf(net, node, net.anchors.stiffness, false), anchor.stiffness});
  why.values.push_back(
    {&kAnchorViscosity, anchorOf(net, node, net.anchors.viscosity, false), anchor.viscosity});
  why.geometry.push_back(area("area", "A", "area", "Fläche", dualArea));
  if (!(volume > 0.0))
    why.geometry.push_back(lengthOf("thickness", "h", "wall thickness", "Wanddicke", model.thickness));
  if (isLearned) why.geometry.push_back(learnedFact(why.learned.factor));
  addBands(net, node, tissue, dualArea, why);
}

TissueExplanation TissueExplainer::explain(const TissueField& field, const SpringNet& net,
                                           ExplainedThing thing, bool followsTissue) const
{
  if (thing.kind == ExplainedThing::Kind::Tissue) return explainTissue(field, thing.index);
  ESM_ASSERT(net.springCount() == m_places.springs && net.nodeCount() == m_places.nodes);
  const bool isSpring = thing.kind == ExplainedThing::Kind::Spring;
  TissueExplanation why;
  why.thing = thing;
  why.followsTissue = followsTissue;
  why.place = m_places.point.col(isSpring ? thing.index : m_places.springs + thing.index);
  if (isSpring)
    explainSpring(field, net, why);
  else
    explainNode(field, net, why);
  std::vector<TissueLayer> layers = field.layersAt(why.place);
  addParameters(field.blended(layers), why);
  addLayers(field, std::move(layers), why);
  return why;
}

TissueExplanation explainTissue(const TissueField& field, int region)
{
  TissueExplanation why;
  why.thing = {ExplainedThing::Kind::Tissue, region};
  std::vector<TissueLayer> layers = {field.layerOf(region)};
  addParameters(field.blended(layers), why);
  addLayers(field, std::move(layers), why);
  return why;
}

} // namespace esm
