// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/explain.h"

#include "core/base/text_number.h"
#include "core/tissue/explain_text.h"
#include "tests/core/tissue/field_of.h"
#include "tests/core/tissue/test_nets.h"

#include <gtest/gtest.h>

#include <cmath>

namespace esm {
namespace {

using test::ellipsoidMesh;
using test::fieldOf;
using test::meshOf;
using test::netOf;
using ThingKind = ExplainedThing::Kind;

Region ball(const char* name, const Eigen::Vector3d& centre, double radius, double hardness)
{
  Region region;
  region.name = name;
  region.ellipsoid.centre = centre;
  region.ellipsoid.semiAxes.setConstant(radius);
  region.inputs = defaultTissue().inputs;
  region.inputs[0] = hardness;
  return region;
}

/// All that regions can be: fading into each other, mirrored, inside-out, off, hard-edged over others.
TissueModel richTissue()
{
  TissueModel model = defaultTissue();
  model.inputs[0] = 0.37;
  model.inputs[1] = fuzzy::Word{"elastic", {fuzzy::Hedge::Somewhat}};
  model.regions = {ball("Wall", {0.01, 0, 0}, 0.02, 0.81), ball("Twins", {0.02, 0.01, 0}, 0.012, 0.22),
                   ball("Outside", {0, 0, 0}, 0.035, 0.55), ball("Off", {0, 0, 0}, 1.0, 0.9),
                   ball("Cap", {0, 0, 0.02}, 0.008, 0.7)};
  model.regions[0].falloff = 0.9;
  model.regions[1].mirror = MirrorPlane{};
  model.regions[2].insideOut = true;
  model.regions[3].enabled = false;
  model.regions[4].falloff = 0.0;
  return model;
}

/// An organ with a strut inside, a stalk outside and a node to which nothing belongs.
SpringNet organ(const TissueModel& model)
{
  Mesh mesh = ellipsoidMesh({0.04, 0.025, 0.02}, 1);
  const auto n = static_cast<Index>(mesh.position.cols());
  mesh.position.conservativeResize(3, n + 3);
  mesh.position.col(n) = Eigen::Vector3d(0.06, 0.003, 0);
  mesh.position.col(n + 1) = Eigen::Vector3d(0.07, 0, 0.001);
  mesh.position.col(n + 2) = Eigen::Vector3d(0.2, 0, 0);
  mesh.segments.resize(2, 3);
  mesh.segments << 0, 3, n, 11, n, n + 1;
  SpringNet net = netOf(mesh);
  EXPECT_TRUE(applyTissue(model, net));
  return net;
}

const ExplainedValue& valueOf(const TissueExplanation& why, const char* id)
{
  const ExplainedValue* value = why.find(id);
  EXPECT_NE(value, nullptr) << id;
  return value ? *value : why.main();
}

// The explained numbers are those of the derived net, bit for bit, at every spring and node.
TEST(Explain, NumbersAreThoseOfTheNet)
{
  TissueModel models[] = {defaultTissue(), richTissue(), richTissue()};
  models[2].law = SpringLaw::Cubic;
  for (const TissueModel& model : models) {
    const SpringNet net = organ(model);
    const TissueField field = fieldOf(model);
    const TissueExplainer explainer(net);
    for (Index s = 0; s < net.springCount(); ++s) {
      const TissueExplanation why = explainer.explain(field, net, {ThingKind::Spring, s});
      EXPECT_EQ(why.main().fromTissue, net.stiffness[s]) << s;
      EXPECT_EQ(why.main().value, net.stiffness[s]) << s;
      EXPECT_EQ(valueOf(why, "viscosity").fromTissue, net.viscosity[s]) << s;
      EXPECT_EQ(valueOf(why, "law_parameter").fromTissue, net.lawParameter[s]) << s;
      double shares = 0.0;
      for (const LayerReason& layer : why.layers) shares += layer.layer.share;
      EXPECT_NEAR(shares, 1.0, 1e-12) << s;
    }
    for (Index node = 0; node < net.nodeCount(); ++node) {
      const TissueExplanation why = explainer.explain(field, net, {ThingKind::Node, node});
      const ExplainedValue& mass = valueOf(why, "mass");
      EXPECT_EQ(mass.fromTissue, net.mass[node]) << node;
      EXPECT_EQ(mass.value, net.mass[node]) << node;
      if (!why.isOnSurface) continue;
      EXPECT_EQ(valueOf(why, "anchor_stiffness").fromTissue, valueOf(why, "anchor_stiffness").value) << node;
      EXPECT_EQ(valueOf(why, "anchor_viscosity").fromTissue, valueOf(why, "anchor_viscosity").value) << node;
    }
  }
}

// The geometry that is shown gives the stiffness by the formula that is shown (rounding: 1e-14).
TEST(Explain, FormulaAndGeometryGiveTheStiffness)
{
  const TissueModel model = richTissue();
  const SpringNet net = organ(model);
  const TissueField field = fieldOf(model);
  const TissueExplainer explainer(net);
  for (Index s = 0; s < net.springCount(); ++s) {
    const TissueExplanation why = explainer.explain(field, net, {ThingKind::Spring, s});
    const double e = why.parameters[0].value;
    const bool isEdge = why.geometry.size() == 3;
    const double a = why.geometry[0].value, h = isEdge ? why.geometry[1].value : 0.0,
                 length = why.geometry.back().value;
    EXPECT_NEAR(isEdge ? e * h * a / (length * length) : e * a / length, net.stiffness[s],
                1e-14 * net.stiffness[s]);
    EXPECT_STREQ(why.main().kind->formula, isEdge ? "E h A / L^2" : "E a / L");
  }
}

// A net that keeps its file's numbers is told so, with both numbers.
TEST(Explain, NetsWithNumbersOfTheirOwnShowBoth)
{
  const TissueModel model = defaultTissue();
  SpringNet net = organ(model);
  const double derived = net.stiffness[5];
  net.stiffness[5] = 123.0;
  const TissueExplanation why =
    TissueExplainer(net).explain(fieldOf(model), net, {ThingKind::Spring, 5}, false);
  EXPECT_EQ(why.main().value, 123.0);
  EXPECT_EQ(why.main().fromTissue, derived);
  EXPECT_NE(sentenceOf(why, model, Language::English).find("keeps 123\u00a0N/m from its file"),
            std::string::npos);
}

// Leaving a rule out gives what the whole rule base gives with that rule off.
TEST(Explain, WithoutARuleIsTheRuleBaseWithItOff)
{
  TissueModel model = richTissue();
  model.inputs[0] = 0.41;
  const TissueExplanation why = explainTissue(fieldOf(model), -1);
  int rulesSeen = 0;
  for (const OutputReason& output : why.layers[0].outputs) {
    double last = 2.0;
    for (const RuleReason& rule : output.rules) {
      TissueModel off = model;
      off.rules.rules[static_cast<std::size_t>(rule.rule)].enabled = false;
      const fuzzy::Inference inference = fieldOf(off).layerOf(-1).inference;
      EXPECT_EQ(inference.outputs[static_cast<std::size_t>(output.output)].value, rule.without);
      EXPECT_LE(rule.degree, last) << "the strongest first";
      EXPECT_GT(rule.degree, 0.0);
      EXPECT_FALSE(rule.inputs.empty());
      last = rule.degree;
      ++rulesSeen;
    }
  }
  EXPECT_GE(rulesSeen, 8);
}

/// The model with a change put in.
TissueModel changed(TissueModel model, const InputChange& change)
{
  auto& inputs =
    change.region < 0 ? model.inputs : model.regions[static_cast<std::size_t>(change.region)].inputs;
  inputs[static_cast<std::size_t>(change.input)] = change.to;
  return model;
}

// Putting a suggested input in and deriving the net anew gives the wanted factor within 1 %, and what is
// said to be out of reach gives the factor that it is said to give.
TEST(Explain, SuggestedInputsDoWhatTheySay)
{
  const TissueModel model = richTissue();
  const SpringNet net = organ(model);
  const TissueField field = fieldOf(model);
  const TissueExplainer explainer(net);
  int reached = 0, outOfReach = 0;
  for (Index s = 0; s < net.springCount(); s += 9)
    for (const double factor : {0.8, 1.2, 30.0}) {
      const TissueExplanation why = explainer.explain(field, net, {ThingKind::Spring, s});
      for (const InputChange& change : changesFor(field, why, why.main(), factor)) {
        SpringNet after = net;
        ASSERT_TRUE(applyTissue(changed(model, change), after));
        const double got = after.stiffness[s] / net.stiffness[s];
        EXPECT_NEAR(got / change.factor, 1.0, 1e-12) << s;
        EXPECT_LE(change.reached ? std::abs(got / factor - 1.0) : 0.0, 0.01) << s;
        (change.reached ? reached : outOfReach) += 1;
      }
    }
  EXPECT_GT(reached, 10);
  EXPECT_GT(outOfReach, 10);
}

// Any number can be asked for: mass, anchors, the tissue's own parameters, products of two of them.
TEST(Explain, ChangesOfOtherNumbers)
{
  const TissueModel model = richTissue();
  const SpringNet net = organ(model);
  const TissueField field = fieldOf(model);
  const TissueExplanation spring = TissueExplainer(net).explain(field, net, {ThingKind::Spring, 0});
  const TissueExplanation node = TissueExplainer(net).explain(field, net, {ThingKind::Node, 0});
  const auto check = [&](const TissueExplanation& why, const char* id, auto numberOf) {
    const auto changes = changesFor(field, why, valueOf(why, id), 1.1);
    ASSERT_FALSE(changes.empty()) << id;
    EXPECT_TRUE(changes[0].reached) << id;
    SpringNet after = net;
    ASSERT_TRUE(applyTissue(changed(model, changes[0]), after));
    EXPECT_NEAR(numberOf(after) / numberOf(net), 1.1, 0.011) << id;
  };
  check(spring, "viscosity", [](const SpringNet& n) { return n.viscosity[0]; });
  check(node, "mass", [](const SpringNet& n) { return n.mass[0]; });
  check(node, "anchor_stiffness", [](const SpringNet& n) { return n.anchors.stiffness[0]; });
}

// The slope against Richardson's extrapolation of central differences through the whole derivation: 1e-8,
// which is what differences of numbers of 1e-16 at steps of 1e-4 leave.
TEST(Explain, SlopeIsTheDerivativeOfTheWholeChain)
{
  const TissueModel model = richTissue();
  const SpringNet net = organ(model);
  const TissueField field = fieldOf(model);
  const TissueExplainer explainer(net);
  int slopes = 0;
  for (Index s = 0; s < net.springCount(); s += 17) {
    const TissueExplanation why = explainer.explain(field, net, {ThingKind::Spring, s});
    for (const InputChange& change : changesFor(field, why, why.main(), 1.05)) {
      const double* from = std::get_if<double>(&change.from);
      if (!from) continue;
      ASSERT_TRUE(change.slope);
      const auto logAt = [&](double x) {
        InputChange moved = change;
        moved.to = x;
        return std::log(fieldOf(changed(model, moved)).at(why.place).youngsModulus);
      };
      const auto central = [&](double h) { return (logAt(*from + h) - logAt(*from - h)) / (2.0 * h); };
      const double richardson = (4.0 * central(1e-4) - central(2e-4)) / 3.0;
      EXPECT_NEAR(*change.slope, richardson, 1e-8 * std::max(1.0, std::abs(richardson))) << s;
      ++slopes;
    }
  }
  EXPECT_GT(slopes, 10);
}

// At the peak of a word the neighbour's rule starts from nothing: the slope is that of the side asked for.
TEST(Explain, SlopeAtAPeakIsThatOfTheSideAskedFor)
{
  const TissueModel model = defaultTissue(); // hardness 0.5, the peak of "medium"
  const TissueField field = fieldOf(model);
  const TissueExplanation why = explainTissue(field, -1);
  const auto harder = changesFor(field, why, why.main(), 1.1),
             softer = changesFor(field, why, why.main(), 0.9);
  ASSERT_FALSE(harder.empty());
  ASSERT_FALSE(softer.empty());
  EXPECT_GT(*harder[0].slope, 1.0);
  EXPECT_GT(*softer[0].slope, 1.0);
  EXPECT_GT(harder[0].to, 0.5);
  EXPECT_LT(softer[0].to, 0.5);
}

TEST(Explain, SentenceInBothLanguages)
{
  TissueModel model = defaultTissue();
  model.regions = {ball("Wall", {0, 0, 0}, 1.0, 0.9)};
  model.regions[0].falloff = 0.0;
  const SpringNet net = organ(model);
  const TissueExplanation why = TissueExplainer(net).explain(fieldOf(model), net, {ThingKind::Spring, 3});
  const std::string english = sentenceOf(why, model, Language::English),
                    german = sentenceOf(why, model, Language::German);
  EXPECT_TRUE(english.starts_with("Spring 3 has ")) << english;
  EXPECT_NE(english.find("100\u00a0% region Wall (rule 6: IF hardness IS rather hard THEN"),
            std::string::npos)
    << english;
  EXPECT_TRUE(german.starts_with("Feder 3 hat ")) << german;
  EXPECT_NE(german.find("WENN Härte IST ziemlich hart DANN Steifigkeit IST"), std::string::npos) << german;
  EXPECT_EQ(german.find('.'), german.size() - 1) << "decimal commas: " << german;
}

/// The number behind `"key": ` in JSON text, from a place on.
double numberAfter(const std::string& json, const std::string& key, std::size_t from = 0)
{
  const std::size_t start = json.find("\"" + key + "\": ", from) + key.size() + 4;
  const auto number = parseDouble(json.substr(start, json.find_first_of(",}", start) - start));
  EXPECT_TRUE(number) << key;
  return number.value_or(0.0);
}

// JSON reads back to the same bits.
TEST(Explain, JsonHoldsTheNumbersExactly)
{
  const TissueModel model = richTissue();
  const SpringNet net = organ(model);
  const TissueField field = fieldOf(model);
  const TissueExplanation why = TissueExplainer(net).explain(field, net, {ThingKind::Spring, 7});
  const ChangeList list{"stiffness", 0.8, changesFor(field, why, why.main(), 0.8)};
  const std::string json = explanationJson(why, model, &list, Language::English);
  EXPECT_EQ(numberAfter(json, "value", json.find("\"stiffness\"")), net.stiffness[7]);
  EXPECT_EQ(numberAfter(json, "area"), why.geometry[0].value);
  EXPECT_EQ(numberAfter(json, "youngs_modulus"), why.parameters[0].value);
  EXPECT_EQ(numberAfter(json, "share"), why.layers[0].layer.share);
  EXPECT_EQ(numberAfter(json, "degree"), why.layers[0].outputs[0].rules[0].degree);
  EXPECT_EQ(numberAfter(json, "to"), list.changes[0].to);
  EXPECT_EQ(json.find('\n'), std::string::npos);
}

// Names with commas, quotes and line breaks stay one cell of the table (RFC 4180).
TEST(Explain, CsvQuotesWhatItMust)
{
  TissueModel model = defaultTissue();
  model.regions = {ball("Wall, \"left\"\nside", {0, 0, 0}, 1.0, 0.9)};
  const TissueExplanation why = explainTissue(fieldOf(model), 0);
  const std::string csv = explanationCsv(why, model, nullptr, Language::English);
  EXPECT_TRUE(csv.starts_with("part,region,name,value,other,unit,text\r\n"));
  EXPECT_NE(csv.find("layer,1,share,1,1,,\"region Wall, \"\"left\"\"\nside\"\r\n"), std::string::npos) << csv;
}

} // namespace
} // namespace esm
