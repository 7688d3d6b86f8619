// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/region_edit.h"
#include "core/tissue/tissue_derivation.h"
#include "tests/core/tissue/test_nets.h"

#include <cstring>
#include <functional>
#include <random>

namespace esm {
namespace {

/// An organ with struts inside, a node that hangs on struts alone and one that hangs on nothing.
SpringNet organ()
{
  Mesh mesh = test::ellipsoidMesh({0.04, 0.025, 0.02}, 2);
  const Eigen::Index surface = mesh.position.cols();
  mesh.position.conservativeResize(3, surface + 2);
  mesh.position.col(surface) = Eigen::Vector3d(0.005, 0.0, 0.001);
  mesh.position.col(surface + 1) = Eigen::Vector3d(0.015, 0.0, 0.0);
  mesh.segments.resize(2, 12);
  for (Index i = 0; i < 10; ++i) mesh.segments.col(i) << i * 7, static_cast<Index>(surface);
  mesh.segments.col(10) << static_cast<Index>(surface),
    static_cast<Index>(surface) + 1; // a cord in the middle
  mesh.segments.col(11) << 0, 11;
  return test::netOf(mesh);
}

void expectSameBits(const Eigen::ArrayXd& a, const Eigen::ArrayXd& b, const char* what)
{
  ASSERT_EQ(a.size(), b.size()) << what;
  EXPECT_EQ(std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)), 0) << what;
}

void expectSameNet(const SpringNet& a, const SpringNet& b)
{
  expectSameBits(a.stiffness, b.stiffness, "stiffness");
  expectSameBits(a.viscosity, b.viscosity, "viscosity");
  expectSameBits(a.lawParameter, b.lawParameter, "law parameter");
  expectSameBits(a.mass, b.mass, "mass");
  expectSameBits(a.anchors.stiffness, b.anchors.stiffness, "anchor stiffness");
  expectSameBits(a.anchors.viscosity, b.anchors.viscosity, "anchor viscosity");
  ASSERT_EQ(a.anchors.node, b.anchors.node);
  EXPECT_EQ(a.anchors.point, b.anchors.point);
  EXPECT_EQ(a.law, b.law);
}

/// A patch names nobody who keeps all his numbers.
void expectOnlyDifferences(const ParameterPatch& patch, const SpringNet& before)
{
  for (const ParameterPatch::Spring& spring : patch.springs)
    EXPECT_TRUE(before.stiffness[spring.spring] != spring.stiffness ||
                before.viscosity[spring.spring] != spring.viscosity ||
                before.lawParameter[spring.spring] != spring.lawParameter ||
                before.law[static_cast<std::size_t>(spring.spring)] != spring.law);
  for (const ParameterPatch::Node& node : patch.nodes) EXPECT_NE(before.mass[node.node], node.mass);
  for (const ParameterPatch::Anchor& anchor : patch.anchors)
    EXPECT_TRUE(before.anchors.stiffness[anchor.anchor] != anchor.stiffness ||
                before.anchors.viscosity[anchor.anchor] != anchor.viscosity);
}

class Dice {
public:
  explicit Dice(unsigned seed) : m_random(seed) {}
  double uniform(double low, double high)
  {
    return low + (high - low) * 0x1p-32 * static_cast<double>(m_random());
  }
  int below(int n) { return static_cast<int>(m_random() % static_cast<unsigned>(n)); }
  Region region(const TissueModel& model)
  {
    Region region;
    region.ellipsoid.centre = {uniform(-0.04, 0.04), uniform(-0.025, 0.025), uniform(-0.02, 0.02)};
    region.ellipsoid.semiAxes = {uniform(0.003, 0.05), uniform(0.003, 0.05), uniform(0.003, 0.05)};
    region.ellipsoid.rotation =
      Eigen::Quaterniond(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), 0.3).normalized();
    region.falloff = below(4) == 0 ? 0.0 : uniform(0.0, 1.0);
    region.profile = FalloffProfile(below(3));
    region.insideOut = below(5) == 0;
    if (below(3) == 0) region.mirror = MirrorPlane{{uniform(-0.01, 0.01), 0, 0}, {1.0, uniform(-1, 1), 0.0}};
    for (std::size_t i = 0; i < model.rules.inputs.size(); ++i) region.inputs.emplace_back(uniform(0, 1));
    return region;
  }

private:
  std::mt19937 m_random;
};

/// One edit such as a person makes in the window.
void editOnce(TissueModel& model, Dice& dice)
{
  auto& regions = model.regions;
  const auto any = [&] { return static_cast<std::size_t>(dice.below(static_cast<int>(regions.size()))); };
  const int kind = regions.empty() ? 0 : dice.below(12);
  if (kind == 0 || regions.size() < 3)
    regions.insert(regions.begin() + dice.below(static_cast<int>(regions.size()) + 1), dice.region(model));
  else if (kind == 1 || regions.size() > 6)
    regions.erase(regions.begin() + dice.below(static_cast<int>(regions.size())));
  else if (kind == 2)
    std::swap(regions[any()], regions[any()]);
  else if (kind == 3)
    regions[any()].enabled = dice.below(2) == 0;
  else if (kind == 4)
    regions[any()].ellipsoid.centre[0] += 0.002;
  else if (kind == 5)
    regions[any()].falloff = dice.uniform(0, 1);
  else if (kind == 6)
    model.thickness = dice.uniform(0.001, 0.004);
  else if (kind == 7)
    model.law = SpringLaw(dice.below(3));
  else if (kind == 8)
    model.rules.rules[static_cast<std::size_t>(dice.below(30))].weight = dice.uniform(0, 1);
  else if (kind == 9)
    model.inputs[static_cast<std::size_t>(dice.below(7))] = dice.uniform(0, 1);
  else
    regions[any()].inputs[static_cast<std::size_t>(dice.below(7))] = dice.uniform(0, 1);
}

// The reason to trust it: after each of many random edits, alone and some at once, the net is, bit for bit,
// the one that a derivation from nothing gives, report and all.
TEST(TissueDerivation, EqualsTheFullDerivationAfterAnyEdit)
{
  for (const bool rulesGiveAll : {true, false}) {
    Dice dice(rulesGiveAll ? 5 : 6);
    TissueModel model = defaultTissue();
    if (!rulesGiveAll) { // a rule base of former days: three outputs, and anchoring that may be nothing at
                         // all
      model.rules.outputs.resize(3);
      std::erase_if(model.rules.rules, [&](const fuzzy::Rule& rule) {
        return !model.rules.findOutput(rule.consequents[0].variable);
      });
      fuzzy::Variable& anchoring = model.rules.outputs[2];
      anchoring = {"anchoring", {"anchoring", ""}, "Pa/m", 0.0, 1.0, 0.0, false, {}};
      anchoring.terms.push_back({"some", {"some", ""}, fuzzy::Shape::Triangle, {0.2, 0.5, 0.8}});
      std::erase_if(model.rules.rules,
                    [](const fuzzy::Rule& rule) { return rule.consequents[0].variable == "anchoring"; });
      const auto rule = fuzzy::parseRule("IF shiftability IS medium THEN anchoring IS some", model.rules);
      model.rules.rules.resize(29, std::get<fuzzy::Rule>(rule));
      model.rules.rules.push_back(std::get<fuzzy::Rule>(rule));
    }
    SpringNet net = organ();
    auto derivation = TissueDerivation::create(model, net);
    ASSERT_TRUE(derivation) << derivation.error().detail;
    SpringNet follower = net; // hears of the edits by their patches alone
    for (int edit = 0; edit < 150; ++edit) {
      for (int more = dice.below(3); more >= 0; --more) editOnce(model, dice); // one to three at once
      SpringNet fresh = organ();
      const auto full = applyTissue(model, fresh);
      ParameterPatch patch;
      const auto updated = derivation->update(model, net, &patch);
      ASSERT_TRUE(updated) << updated.error().detail;
      expectSameNet(net, fresh);
      const ApplyReport report = derivation->account(net);
      EXPECT_EQ(report.minYoungsModulus, full->minYoungsModulus);
      EXPECT_EQ(report.maxYoungsModulus, full->maxYoungsModulus);
      EXPECT_EQ(report.totalMass, full->totalMass);
      const Status good = checkPatch(patch, follower);
      ASSERT_TRUE(good) << good.error().detail;
      expectOnlyDifferences(patch, follower);
      patch.applyTo(follower);
      expectSameNet(follower, fresh);
      if (HasFailure()) FAIL() << "edit " << edit;
    }
  }
}

/// Springs that have other numbers in the two nets.
Index differingSprings(const SpringNet& a, const SpringNet& b)
{
  return static_cast<Index>(
    (a.stiffness != b.stiffness || a.viscosity != b.viscosity || a.lawParameter != b.lawParameter).count());
}

struct Count {
  Index derived = 0, changed = 0;
};
Count countEdit(TissueModel model, const std::function<void(TissueModel&)>& edit)
{
  SpringNet net = organ();
  auto derivation = TissueDerivation::create(model, net);
  EXPECT_EQ(derivation->report().springsChanged, net.springCount());
  const SpringNet before = net;
  edit(model);
  const auto report = derivation->update(model, net);
  EXPECT_TRUE(report);
  return {report->springsChanged, differingSprings(before, net)};
}

TissueModel twoRegions()
{
  TissueModel model = defaultTissue();
  for (const double x : {0.03, -0.03}) {
    Region region;
    region.ellipsoid.centre = {x, 0, 0};
    region.ellipsoid.semiAxes.setConstant(0.02);
    region.inputs = model.inputs;
    region.inputs[0] = x > 0 ? 0.9 : 0.1;
    model.regions.push_back(region);
  }
  return model;
}

// Exactly those springs are derived whose numbers change, and the report says how many.
TEST(TissueDerivation, DerivesWhatAnEditTouchesAndNoMore)
{
  const TissueModel model = twoRegions();
  const Index all = organ().springCount();
  const Count word = countEdit(model, [](TissueModel& m) { m.regions[0].inputs[0] = 0.8; });
  EXPECT_EQ(word.derived, word.changed);
  EXPECT_GT(word.derived, 10);
  EXPECT_LT(word.derived, all / 2);

  // The base shows everywhere but in the cores of both regions.
  const Count base = countEdit(model, [](TissueModel& m) { m.inputs[0] = 0.4; });
  EXPECT_EQ(base.derived, base.changed);
  EXPECT_LT(base.derived, all);
  EXPECT_GT(base.derived, all / 3);

  // A region that moves touches where its weight changes, not its core.
  const Count moved = countEdit(model, [](TissueModel& m) { m.regions[0].ellipsoid.centre[0] += 0.0005; });
  EXPECT_EQ(moved.derived, moved.changed);
  EXPECT_LT(moved.derived, word.derived);

  EXPECT_EQ(countEdit(model, [](TissueModel& m) { m.thickness *= 2; }).derived, all);
}

// Names, locks and what is drawn mean nothing to tissue; neither does what lies wholly under another region.
TEST(TissueDerivation, DerivesNothingForWhatTissueDoesNotSee)
{
  TissueModel model = twoRegions();
  const auto derived = [&](const std::function<void(TissueModel&)>& edit) {
    return countEdit(model, edit).derived;
  };
  EXPECT_EQ(derived([](TissueModel& m) {
              m.regions[0].name = "left";
              m.regions[1].locked = true;
              m.regions[1].visible = false;
            }),
            0);
  EXPECT_EQ(derived([](TissueModel& m) { m.density = 900.0; }), 0) << "the rules give the density";
  EXPECT_EQ(derived([](TissueModel& m) { m.rules.rules[0].note = "why"; }), 0);
  EXPECT_EQ(derived([](TissueModel& m) { std::swap(m.rules.rules[0], m.rules.rules[1]); }), 0);

  Region cover = model.regions[0];
  cover.ellipsoid.semiAxes.setConstant(0.04);
  cover.falloff = 0.1;
  model.regions.push_back(cover);
  EXPECT_EQ(derived([](TissueModel& m) { m.regions[0].inputs[0] = 0.5; }), 0) << "all of it is covered";
  EXPECT_EQ(derived([](TissueModel& m) { m.regions.erase(m.regions.begin()); }), 0);
  model.regions[0].enabled = false;
  EXPECT_EQ(derived([](TissueModel& m) { m.regions[0].inputs[0] = 0.5; }), 0);
}

/// A tube of so many rings, 1 mm apart, of 20 nodes each.
SpringNet tube(Index rings)
{
  return test::netOf(test::tubeMesh(rings, 20, 0.001, 0.0032));
}

// Counted, not timed: what a slider of one region looks at does not grow with the net around it, nor with the other
// regions, below and above. A full derivation looks at all.
TEST(TissueDerivation, ASliderCostsByWhatItTouches)
{
  std::int64_t seen[2];
  Index derived[2];
  for (const int size : {0, 1}) {
    SpringNet net = tube(size == 0 ? 200 : 1600);
    TissueModel model = defaultTissue();
    for (const double radius :
         {0.1, 0.005, 9.0}) { // one in the middle; one around all of it, which nearly covers it
      Region region;
      region.ellipsoid.centre = {0.1, 0, 0};
      region.ellipsoid.semiAxes = {radius, 0.02, 0.02};
      region.inputs = model.inputs;
      region.falloff = radius < 1.0 ? 0.2 : 1.0;
      model.regions.push_back(region);
    }
    auto derivation = TissueDerivation::create(model, net);
    ASSERT_TRUE(derivation);
    EXPECT_GE(derivation->report().placesSeen, net.springCount() + net.nodeCount());
    model.regions[1].inputs[0] = 0.9;
    ParameterPatch patch;
    const auto report = derivation->update(model, net, &patch);
    ASSERT_TRUE(report);
    seen[size] = report->placesSeen;
    derived[size] = report->springsChanged;
    EXPECT_EQ(std::ssize(patch.springs), report->springsChanged);
    EXPECT_LE(report->placesSeen, 4 * (report->springsChanged + report->nodesChanged));
  }
  EXPECT_GT(derived[0], 400);
  EXPECT_EQ(derived[0], derived[1]);
  EXPECT_EQ(seen[0], seen[1]);
}

// A model that cannot be leaves net and derivation as they were: the next good edit is right again.
TEST(TissueDerivation, OnErrorEverythingIsAsBefore)
{
  TissueModel model = twoRegions();
  SpringNet net = organ();
  auto derivation = TissueDerivation::create(model, net);
  const SpringNet before = net;
  TissueModel wrong = model;
  wrong.regions[0].inputs[0] = 0.3;
  wrong.regions[1].ellipsoid.semiAxes[0] = -1.0;
  EXPECT_FALSE(derivation->update(wrong, net));
  expectSameNet(net, before);
  model.inputs[0] = 0.7;
  EXPECT_TRUE(derivation->update(model, net));
  SpringNet fresh = organ();
  EXPECT_TRUE(applyTissue(model, fresh));
  expectSameNet(net, fresh);
}

} // namespace
} // namespace esm
