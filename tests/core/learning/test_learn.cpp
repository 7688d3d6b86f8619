// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/learning/learn.h"

#include "core/tissue/explain_text.h"
#include "core/tissue/tissue_derivation.h"
#include "tests/core/learning/blocks.h"

#include <gmock/gmock.h>

#include <cmath>

namespace {

using namespace esm;
using namespace esm::test;
using namespace esm::learning;

/// A block with tissue from words, and the same with other factors, by which recordings are made.
class Learn : public testing::Test {
protected:
  Learn() : net(block({8, 4, 4})), tissue(defaultTissue())
  {
    net.kind.assign(at(net.springCount()), SpringKind::Line); // edges inside would have no area
    EXPECT_TRUE(applyTissue(tissue, net));
    truth = tissue;
    truth.learned.questions.normalBorders = {40.0};
    LearnedFactor across, along;
    across.of.normal = 0;
    across.value = std::log(1.8);
    along.of.normal = 1;
    along.value = std::log(0.7);
    truth.learned.factors = {across, along};
    settings.questions = truth.learned.questions;
    training = {recorded("pull", {0.05, 0.015, 0.03}, {0.1, 0.05, 0.2}),
                recorded("drag", {0.02, 0.015, 0.03}, {0.2, -0.1, 0.0}),
                recorded("poke", {0.03, 0.0, 0.02}, {0.0, 0.15, 0.0})};
    validation = {recorded("other", {0.07, 0.015, 0.03}, {0.1, 0.1, 0.1})};
  }

  Recording recorded(const char* name, const Eigen::Vector3d& place, const Eigen::Vector3d& direction) const
  {
    SpringNet hidden = net;
    EXPECT_TRUE(applyTissue(truth, hidden));
    Recording recording;
    recording.name = name;
    // Loads that bend the tissue of the default words as much as the block of the other tests.
    recording.loads.forces = {sharedForce(nodesNear(net, place, 0.012), load * direction)};
    Statics statics(hidden, recording.loads);
    EXPECT_EQ(statics.solve().outcome, StaticsOutcome::Balanced) << name;
    recording.position.resize(3, net.nodeCount());
    copyNodes(statics.place(), recording.position);
    for (Index i = 0; i < net.nodeCount(); ++i) recording.markers.push_back(Marker::ofNode(i));
    return recording;
  }

  double load = 0.3;
  SpringNet net;
  TissueModel tissue, truth;
  LearnSettings settings;
  std::vector<Recording> training, validation;
};

TEST_F(Learn, WhatIsLearnedReachesTheNetThroughTheTissue)
{
  const auto result = learn(tissue, net, training, validation, settings);
  ASSERT_TRUE(result) << result.error().detail;
  EXPECT_TRUE(result->hasHelped);
  EXPECT_LE(result->validationAfter, 5e-3);
  EXPECT_EQ(result->layer.recordings, 3);
  TissueModel taught = tissue;
  taught.learned = result->layer;
  SpringNet byTissue = net, hidden = net;
  ASSERT_TRUE(applyTissue(taught, byTissue));
  ASSERT_TRUE(applyTissue(truth, hidden));
  EXPECT_LE((byTissue.stiffness / hidden.stiffness - 1.0).abs().maxCoeff(), 0.01);
}

// The chain of "why?" multiplies to the spring's number, to the bit, and says where the factor is from.
TEST_F(Learn, WhyTellsTheFactorOfASpring)
{
  TissueModel taught = truth;
  taught.learned.recordings = 12;
  taught.learned.factors[0].deviation = std::log(1.08);
  SpringNet shown = net;
  ASSERT_TRUE(applyTissue(taught, shown));
  const auto field = TissueField::create(taught);
  ASSERT_TRUE(field);
  const TissueExplainer explainer(shown);
  int told = 0;
  for (Index s = 0; s < shown.springCount(); s += 7) {
    const TissueExplanation why = explainer.explain(*field, shown, {ExplainedThing::Kind::Spring, s});
    EXPECT_EQ(why.values[0].fromTissue, shown.stiffness[s]);
    EXPECT_EQ(why.values[1].fromTissue, shown.viscosity[s]);
    const std::string sentence = sentenceOf(why, taught, Language::English);
    EXPECT_THAT(sentence, testing::HasSubstr("learned (12 recordings; all springs, "));
    if (why.learned.factor < 1.0) continue;
    ++told;
    EXPECT_THAT(sentence, testing::HasSubstr("× 1.8 learned"));
    EXPECT_THAT(sentence, testing::HasSubstr("± 8\u00a0%"));
    EXPECT_THAT(sentenceOf(why, taught, Language::German),
                testing::HasSubstr("× 1,8 gelernt (12 Aufnahmen; alle Federn"));
  }
  EXPECT_GT(told, 0);
  const TissueExplanation without =
    explainer.explain(*TissueField::create(tissue), net, {ExplainedThing::Kind::Spring, 0});
  EXPECT_THAT(sentenceOf(without, tissue, Language::English), testing::Not(testing::HasSubstr("learned")));
}

// A layer that comes and goes by TissueDerivation leaves the numbers of applyTissue(), to the bit.
TEST_F(Learn, UpdatesWithALayerAreThoseOfAFreshDerivation)
{
  Region part;
  part.name = "part";
  part.ellipsoid.centre = {0.03, 0.015, 0.03};
  part.ellipsoid.semiAxes.setConstant(0.02);
  part.inputs = tissue.inputs;
  TissueModel model = tissue;
  model.regions = {part};
  SpringNet followed = net;
  auto derivation = TissueDerivation::create(model, followed);
  ASSERT_TRUE(derivation);
  const auto expectFresh = [&](const char* what) {
    ASSERT_TRUE(derivation->update(model, followed)) << what;
    SpringNet fresh = net;
    ASSERT_TRUE(applyTissue(model, fresh));
    EXPECT_TRUE((followed.stiffness == fresh.stiffness).all()) << what;
    EXPECT_TRUE((followed.lawParameter == fresh.lawParameter).all()) << what;
    EXPECT_TRUE((followed.anchors.stiffness == fresh.anchors.stiffness).all()) << what;
  };
  model.learned = truth.learned;
  expectFresh("a layer comes");
  LearnedFactor ofRegion, bed;
  ofRegion.region = "part";
  ofRegion.value = 0.5;
  bed.quantity = LearnedQuantity::Anchor;
  bed.value = -0.7;
  model.learned.factors.push_back(ofRegion);
  model.learned.factors.push_back(bed);
  expectFresh("more factors");
  model.regions[0].ellipsoid.centre.x() += 0.01;
  expectFresh("its region moves");
  model.inputs[0] = 0.9;
  expectFresh("a slider moves");
  model.learned = {};
  expectFresh("the layer goes");
}

TEST_F(Learn, GradientsOfAllBlocksAreThoseOfDifferences)
{
  settings.what = {"global", "classes", "law", "anchors"};
  const auto checks = checkGradient(tissue, net, training, settings);
  ASSERT_TRUE(checks) << checks.error().detail;
  ASSERT_EQ(checks->size(), 4u);
  for (const GradientCheck& check : *checks) {
    EXPECT_LE(check.relativeError(), 1e-8) << check.block; // forces of 1e-12 over steps of 1e-2
    std::printf("%s: %.1e\n", check.block.c_str(), check.relativeError());
  }
}

TEST_F(Learn, WhatCannotBeLearnedIsSaid)
{
  settings.what = {"colour"};
  auto refused = learn(tissue, net, training, validation, settings);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().detail, testing::HasSubstr("global, classes, regions"));
  settings.what = {"regions"};
  refused = learn(tissue, net, training, validation, settings);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().detail, testing::HasSubstr("no region"));
  settings.what = {"classes"};
  refused = learn(tissue, net, {}, validation, settings);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().detail, testing::HasSubstr("no recording"));
}

} // namespace
