// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/tissue_model.h"

#include "tests/core/tissue/field_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace esm {
namespace {

using test::fieldOf;

Region region(const Eigen::Vector3d& centre, double radius, double hardness, double falloff = 0.3)
{
  Region result;
  result.name = "spot";
  result.ellipsoid.centre = centre;
  result.ellipsoid.semiAxes.setConstant(radius);
  result.falloff = falloff;
  result.inputs.assign(defaultTissue().inputs.size(), 0.5);
  result.inputs[0] = hardness;
  return result;
}

double modulusOf(double hardness)
{
  TissueModel model = defaultTissue();
  model.inputs[0] = hardness;
  return fieldOf(model).base().youngsModulus;
}

const Eigen::Vector3d kX = Eigen::Vector3d::UnitX();

TEST(TissueField, OutsideARegionIsExactlyTheBase)
{
  TissueModel model = defaultTissue();
  const TissueField plain = fieldOf(model);
  model.regions.push_back(region({0, 0, 0}, 0.01, 0.9));
  const TissueField field = fieldOf(model);
  for (const double x : {0.01, 0.0101, 0.5}) {
    const TissueParameters there = field.at(x * kX);
    EXPECT_EQ(there.youngsModulus, plain.base().youngsModulus);
    EXPECT_EQ(there.viscosity, plain.base().viscosity);
    EXPECT_EQ(there.anchoring, plain.base().anchoring);
  }
}

// 1e-12: one exponential and one logarithm.
TEST(TissueField, TheCoreOfARegionHasItsOwnTissue)
{
  TissueModel model = defaultTissue();
  model.regions.push_back(region({0, 0, 0}, 0.01, 0.9));
  const TissueField field = fieldOf(model);
  EXPECT_NEAR(field.at({0, 0, 0}).youngsModulus / modulusOf(0.9), 1.0, 1e-12);
  EXPECT_NEAR(field.at(0.0069 * kX).youngsModulus / modulusOf(0.9), 1.0, 1e-12);
  // Halfway through the falloff (0.7 to 1 of the radius) both have equal weight: the geometric mean.
  EXPECT_NEAR(field.at(0.0085 * kX).youngsModulus / std::sqrt(modulusOf(0.9) * modulusOf(0.5)), 1.0, 1e-12);
}

// No seam: smoothstep has slope at most 1.5 / falloff, so a step of 1/1000 of the radius changes the
// logarithm by at most 1.5 / 0.3 / 1000 of the whole.
TEST(TissueField, IsContinuousAcrossTheBorder)
{
  TissueModel model = defaultTissue();
  model.regions.push_back(region({0, 0, 0}, 0.01, 0.9));
  const TissueField field = fieldOf(model);
  const double whole = std::log(modulusOf(0.9) / modulusOf(0.5));
  for (int i = 0; i < 1200; ++i) {
    const double here = field.at(i * 1e-5 * kX).youngsModulus;
    const double there = field.at((i + 1) * 1e-5 * kX).youngsModulus;
    EXPECT_LE(std::abs(std::log(there / here)), 1.5 / 0.3 / 1000 * whole * 1.001) << i;
    EXPECT_LE(there, here * (1.0 + 1e-12)) << "it only falls from the hard core outward";
  }
}

TEST(TissueField, ALaterRegionCoversAnEarlierOne)
{
  TissueModel model = defaultTissue();
  model.regions = {region({0, 0, 0}, 0.01, 0.9), region({0, 0, 0}, 0.02, 0.1)};
  EXPECT_NEAR(fieldOf(model).at({0, 0, 0}).youngsModulus / modulusOf(0.1), 1.0, 1e-12);
  std::swap(model.regions[0], model.regions[1]);
  EXPECT_NEAR(fieldOf(model).at({0, 0, 0}).youngsModulus / modulusOf(0.9), 1.0, 1e-12);
  model.regions[1].enabled = false;
  EXPECT_NEAR(fieldOf(model).at({0, 0, 0}).youngsModulus / modulusOf(0.1), 1.0, 1e-12);
}

TEST(TissueField, ARotatedEllipsoidReachesAlongItsOwnAxes)
{
  TissueModel model = defaultTissue();
  model.regions.push_back(region({0, 0, 0}, 0.01, 0.9, 0.0));
  model.regions[0].ellipsoid.semiAxes = {0.03, 0.01, 0.01};
  model.regions[0].ellipsoid.rotation = Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitZ());
  const TissueField field = fieldOf(model);
  EXPECT_GT(field.at({0, 0.02, 0}).youngsModulus, field.base().youngsModulus * 2);
  EXPECT_EQ(field.at({0.02, 0, 0}).youngsModulus, field.base().youngsModulus);
}

// The shares sum to 1 and blend the inferences' logarithms to the value that at() gives.
TEST(TissueField, ExplainsWhereANumberComesFrom)
{
  TissueModel model = defaultTissue();
  model.regions = {region({0, 0, 0}, 0.01, 0.9), region({9, 9, 9}, 0.01, 0.3),
                   region({0.01, 0, 0}, 0.01, 0.1)};
  const TissueField field = fieldOf(model);
  const Eigen::Vector3d place(0.0085, 0.0, 0.004);
  model.regions[2].ellipsoid.centre[0] = 0.017;
  const TissueField moved = fieldOf(model);
  const std::vector<TissueLayer> layers = moved.layersAt(place);
  ASSERT_EQ(layers.size(), 3U);
  EXPECT_EQ(layers[0].region, -1);
  EXPECT_EQ(layers[1].region, 0);
  EXPECT_EQ(layers[2].region, 2);
  double sum = 0.0, logarithm = 0.0;
  for (const TissueLayer& layer : layers) {
    sum += layer.share;
    logarithm += layer.share * std::log10(layer.inference.outputs[0].value);
  }
  EXPECT_NEAR(sum, 1.0, 1e-14);
  EXPECT_NEAR(std::pow(10.0, logarithm) / moved.at(place).youngsModulus, 1.0, 1e-12);
  EXPECT_EQ(moved.blended(layers).youngsModulus, moved.at(place).youngsModulus);
  EXPECT_EQ(field.layersAt({1, 0, 0}).size(), 1U);
}

TEST(TissueField, SaysWhetherRulesGaveEveryOutput)
{
  TissueModel model = defaultTissue();
  EXPECT_TRUE(fieldOf(model).allOutputsFromRules());
  model.rules.rules.erase(model.rules.rules.begin(), model.rules.rules.begin() + 7); // those of stiffness
  const TissueField field = fieldOf(model);
  EXPECT_FALSE(field.allOutputsFromRules());
  EXPECT_NEAR(field.base().youngsModulus / model.rules.outputs[0].defaultValue, 1.0, 1e-12);
}

TEST(TissueField, AnOutputMayBeZero)
{
  TissueModel model = defaultTissue();
  fuzzy::Variable& anchoring = model.rules.outputs[2];
  anchoring = {"anchoring", {"anchoring", ""}, "Pa/m", 0.0, 1.0, 0.0, false, {}};
  std::erase_if(model.rules.rules,
                [](const fuzzy::Rule& rule) { return rule.consequents[0].variable == "anchoring"; });
  const TissueField field = fieldOf(model);
  EXPECT_EQ(field.at({0, 0, 0}).anchoring, 0.0);
}

TEST(TissueField, RefusesImpossibleModelsAndNamesTheCulprit)
{
  const double nan = std::nan("");
  struct Fault {
    const char* expected;
    std::function<void(TissueModel&)> make;
  };
  const Fault faults[] = {
    {"no output 'viscosity'",
     [](TissueModel& m) {
       m.rules.outputs[1].id = "x";
       m.rules.rules.clear();
     }},
    {"rule 1", [](TissueModel& m) { m.rules.rules[0].weight = 2.0; }},
    {"the base tissue has 6 inputs", [](TissueModel& m) { m.inputs.pop_back(); }},
    {"input 'hardness'", [nan](TissueModel& m) { m.inputs[0] = nan; }},
    {"term 'hrad'",
     [](TissueModel& m) {
       m.inputs[0] = fuzzy::Word{"hrad", {}};
     }},
    {"thickness", [](TissueModel& m) { m.thickness = 0.0; }},
    {"density", [nan](TissueModel& m) { m.density = nan; }},
    {"table", [](TissueModel& m) { m.law = SpringLaw::Table; }},
    {"parameter of the force law", [](TissueModel& m) { m.lawParameter = -1.0; }},
    {"region 1 'spot': every semi-axis", [](TissueModel& m) { m.regions[0].ellipsoid.semiAxes[1] = 0.0; }},
    {"region 1 'spot': the centre", [nan](TissueModel& m) { m.regions[0].ellipsoid.centre[1] = nan; }},
    {"region 1 'spot': the rotation", [](TissueModel& m) { m.regions[0].ellipsoid.rotation.w() = 2.0; }},
    {"region 1 'spot': the falloff", [](TissueModel& m) { m.regions[0].falloff = 1.5; }},
    {"region 1 'spot': the mirror",
     [](TissueModel& m) {
       m.regions[0].mirror = MirrorPlane{{0, 0, 0}, {0, 0, 0}};
     }},
    {"'density' must lie above 0",
     [](TissueModel& m) {
       m.rules.outputs[3].logarithmic = false;
       m.rules.outputs[3].minimum = 0.0;
     }},
    {"region 1 'spot' has 0 inputs", [](TissueModel& m) { m.regions[0].inputs.clear(); }},
  };
  for (const Fault& fault : faults) {
    TissueModel model = defaultTissue();
    model.regions.push_back(region({0, 0, 0}, 0.01, 0.9));
    fault.make(model);
    const auto field = TissueField::create(model);
    ASSERT_FALSE(field) << fault.expected;
    EXPECT_EQ(field.error().code, ErrorCode::InvalidValue);
    EXPECT_NE(field.error().detail.find(fault.expected), std::string::npos) << field.error().detail;
  }
}

} // namespace
} // namespace esm
