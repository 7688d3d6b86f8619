// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/learning/experiment.h"

#include "tests/core/learning/blocks.h"
#include "tests/support/dice.h"
#include "tests/support/nets.h"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

namespace {

using namespace esm;
using namespace esm::test;
using namespace esm::learning;

TissueModel tissueWith(const std::string& region, const Eigen::Vector3d& centre, double radius)
{
  TissueModel tissue = defaultTissue();
  Region part;
  part.name = region;
  part.ellipsoid.centre = centre;
  part.ellipsoid.semiAxes.setConstant(radius);
  part.inputs = tissue.inputs;
  tissue.regions.push_back(part);
  return tissue;
}

ParameterSet setOf(const char* block, const SpringNet& net, const TissueModel& tissue)
{
  auto parameters = findBlock(block)->make({net, tissue});
  EXPECT_TRUE(parameters) << block;
  return ParameterSet(net, std::move(*parameters));
}

// Springs of a wall are classes of their own: each kind has a name, in both languages, and is kept.
TEST(Parameters, EveryKindOfSpringIsAClassWithAName)
{
  LearnedLayer layer;
  layer.questions.byKind = true;
  for (const Language language : {Language::English, Language::German}) {
    std::set<std::string> names;
    for (int kind = 0; kind < kSpringKindCount; ++kind) {
      LearnedFactor factor;
      factor.of.kind = kind;
      layer.factors = {factor};
      EXPECT_TRUE(checkLearned(layer)) << kind;
      names.insert(classText(factor.of, layer.questions, language));
    }
    EXPECT_EQ(names.size(), static_cast<std::size_t>(kSpringKindCount));
    EXPECT_FALSE(names.contains(""));
  }
  layer.factors.front().of.kind = kSpringKindCount;
  EXPECT_FALSE(checkLearned(layer));
}

TEST(Parameters, ClassesPartAllSprings)
{
  const SpringNet net = block({7, 4, 4});
  const TissueModel tissue = defaultTissue();
  const ParameterSet set = setOf("classes", net, tissue);
  EXPECT_GT(set.count(), 5);
  std::set<Index> seen;
  for (const Parameter& parameter : set.parameters())
    for (const Parameter::Share& share : parameter.shares) EXPECT_TRUE(seen.insert(share.index).second);
  EXPECT_EQ(static_cast<Index>(seen.size()), net.springCount());
}

// Classes are questions to geometry: a body that is turned and moved, or twice as finely meshed, has the same ones.
TEST(Parameters, ATurnedBodyHasTheSameClasses)
{
  const SpringNet net = block({7, 4, 4});
  SpringNet turned = net;
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()));
  turned.restPosition =
    (turn.toRotationMatrix() * net.restPosition).colwise() + Eigen::Vector3d(0.3, -0.2, 0.1);
  SpringQuestions questions = usualQuestions();
  for (double& border : questions.normalBorders)
    border += 0.1; // angles of a lattice lie on 0, 45, 54.7 and 90 degrees
  EXPECT_EQ(answersOf(questions, net), answersOf(questions, turned));
}

TEST(Parameters, SpringsAcrossAndAlongTheSurfaceAreToldApart)
{
  const SpringNet net = block({9, 5, 3});
  SpringQuestions questions;
  questions.normalBorders = {30.0, 60.0};
  questions.axisBorders = {30.0, 60.0};
  const std::vector<SpringClass> classes = answersOf(questions, net);
  int looked = 0;
  for (Index s = 0; s < net.springCount(); ++s) {
    const Index a = net.ends(0, s), b = net.ends(1, s);
    const Eigen::Vector3d d = (net.restPosition.col(b) - net.restPosition.col(a)).cwiseAbs();
    const auto inner = [&](Index i) { // nearer to top and bottom than to the sides
      const Eigen::Vector3d p = net.restPosition.col(i) / 0.01;
      return p.x() > 1.5 && p.x() < 6.5 && p.y() > 1.5 && p.y() < 2.5;
    };
    if (!inner(a) || !inner(b) || std::abs(d.norm() - 0.01) > 1e-9) continue;
    EXPECT_EQ(classes[at(s)].normal, d.z() > 0.005 ? 0 : 2);
    EXPECT_EQ(classes[at(s)].axis, d.x() > 0.005 ? 0 : 2);
    ++looked;
  }
  EXPECT_GT(looked, 15);
}

// The learned layer says in the tissue what the parameters say in the fit.
TEST(Parameters, TheLayerGivesTheSameNumbersAsTheParameters)
{
  SpringNet net = block({7, 4, 4});
  TissueModel tissue = tissueWith("stiff", {0.05, 0.015, 0.015}, 0.02);
  ASSERT_TRUE(applyTissue(tissue, net));
  Dice dice(3);
  for (const char* id : {"global", "classes", "regions", "springs", "law", "anchors"}) {
    const ParameterSet set = setOf(id, net, tissue);
    std::vector<double> theta(at(set.count()));
    for (double& value : theta) value = dice.uniform(-0.5, 0.8);
    SpringNet byParameters = net;
    set.apply(theta, byParameters);
    TissueModel learned = tissue;
    learned.learned = layerOf(set, usualQuestions(), theta);
    ASSERT_TRUE(checkLearned(learned.learned)) << id;
    SpringNet byTissue = net;
    ASSERT_TRUE(applyTissue(learned, byTissue));
    const auto agree = [](const Eigen::ArrayXd& a, const Eigen::ArrayXd& b) {
      return a.size() == b.size() &&
             ((a - b).abs() <= 1e-14 * (a.abs() + 1.0)).all(); // an exponential, a product
    };
    EXPECT_TRUE(agree(byParameters.stiffness, byTissue.stiffness)) << id;
    EXPECT_TRUE(agree(byParameters.lawParameter, byTissue.lawParameter)) << id;
    EXPECT_TRUE(agree(byParameters.anchors.stiffness, byTissue.anchors.stiffness)) << id;
    EXPECT_FALSE(agree(net.stiffness, byTissue.stiffness) && agree(net.lawParameter, byTissue.lawParameter) &&
                 agree(net.anchors.stiffness, byTissue.anchors.stiffness))
      << id << " must change something";
  }
}

TEST(Parameters, RegionsWithoutNamesOfTheirOwnAreRefused)
{
  const SpringNet net = block({});
  TissueModel tissue = tissueWith("", {0.02, 0.0, 0.0}, 0.02);
  EXPECT_FALSE(findBlock("regions")->make({net, tissue}));
  tissue.regions[0].name = "a";
  EXPECT_TRUE(findBlock("regions")->make({net, tissue}));
  tissue.regions.push_back(tissue.regions[0]);
  EXPECT_FALSE(findBlock("regions")->make({net, tissue}));
}

Recording pulled(const SpringNet& net)
{
  Recording recording;
  recording.name = "pull";
  recording.loads.forces = {sharedForce(nodesNear(net, {0.06, 0.015, 0.03}, 0.015), {0.1, 0.05, 0.1})};
  Statics statics(net, recording.loads);
  EXPECT_EQ(statics.solve().outcome, StaticsOutcome::Balanced);
  for (Index i = 0; i < net.nodeCount(); i += 2) recording.markers.push_back(Marker::ofNode(i));
  recording.position.resize(3, static_cast<Eigen::Index>(recording.markers.size()));
  for (std::size_t m = 0; m < recording.markers.size(); ++m)
    recording.position.col(static_cast<Eigen::Index>(m)) = toVector(statics.place()[2 * m]);
  return recording;
}

// Three ways to one slope: the adjoint pulled back, J^T r, and differences of the error itself.
TEST(Parameters, PulledBackGradientIsThatOfTheSlopesAndOfDifferences)
{
  SpringNet net = unevenBlock({7, 4, 4}, SpringLaw::Exponential, 2);
  const TissueModel tissue = tissueWith("part", {0.04, 0.015, 0.02}, 0.02);
  const Recording recording = pulled(net);
  for (const char* id : {"global", "classes", "regions", "law"}) {
    const ParameterSet set = setOf(id, net, tissue);
    auto experiment = Experiment::create(net, recording);
    ASSERT_TRUE(experiment);
    std::vector<double> theta(at(set.count()));
    Dice dice(9);
    for (double& value : theta) value = dice.uniform(0.05, 0.3);
    SpringNet tried = net;
    const auto lossAt = [&](const std::vector<double>& where) {
      set.apply(where, tried);
      const auto trial = experiment->respond(tried);
      EXPECT_TRUE(trial.isBalanced());
      return 0.5 * trial.error * trial.error;
    };
    lossAt(theta);
    experiment->accept();
    NetGradient gradient(tried);
    experiment->addGradient(tried, gradient);
    std::vector<double> pulledBack(theta.size(), 0.0);
    set.pullBack(tried, gradient, pulledBack);
    experiment->findSlopes(tried, set);
    const Eigen::VectorXd bySlopes = experiment->slopes().transpose() * experiment->residual();
    const double size = bySlopes.norm();
    for (std::size_t j = 0; j < theta.size(); ++j) {
      EXPECT_NEAR(pulledBack[j], bySlopes[static_cast<Eigen::Index>(j)], 1e-11 * size) << id;
      if (j > 2) continue;
      std::vector<double> more = theta, less = theta;
      const double h = std::string(id) == "law" ? 1e-2 : 1e-3;
      more[j] += h;
      less[j] -= h;
      const double measured = (lossAt(more) - lossAt(less)) / (2.0 * h);
      EXPECT_NEAR(pulledBack[j], measured, 1e-5 * size) << id; // of order h^2
    }
  }
}

} // namespace
