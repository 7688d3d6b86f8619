// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/presets.h"
#include "core/tissue/tissue_units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace esm {
namespace {

TissueParameters tissueOf(const TissuePreset& preset)
{
  TissueModel model = defaultTissue();
  auto inputs = withPreset(preset, model.rules, model.inputs);
  if (!inputs) {
    ADD_FAILURE() << inputs.error().detail;
    return {};
  }
  model.inputs = *inputs;
  const auto field = TissueField::create(model);
  EXPECT_TRUE(field->allOutputsFromRules()) << preset.id;
  return field->base();
}

// Words are coarse: half a decade of stiffness from one to the next, so the nearest is within 1.8 of every
// value. The tolerances are those within which two laboratories agree on one tissue, or wider.
TEST(TissuePresets, WordsLeadToTheMeasuredTissue)
{
  ASSERT_EQ(tissuePresets().size(), 12U);
  for (const TissuePreset& preset : tissuePresets()) {
    const TissueParameters tissue = tissueOf(preset);
    EXPECT_GT(tissue.youngsModulus, preset.youngsModulus.typical / 2.0) << preset.id;
    EXPECT_LT(tissue.youngsModulus, preset.youngsModulus.typical * 2.0) << preset.id;
    EXPECT_NEAR(dampingRatio(tissue.viscosity), preset.damping.typical, 0.15) << preset.id;
    EXPECT_NEAR(tissue.density / preset.density.typical, 1.0, 0.03) << preset.id;
    EXPECT_NEAR(tissue.ruptureStrain / preset.ruptureStrain.typical, 1.0, 0.30) << preset.id;
  }
}

// What is measured stiffer by more than 10 % is never made softer.
TEST(TissuePresets, KeepTheOrderOfStiffness)
{
  for (const TissuePreset& a : tissuePresets())
    for (const TissuePreset& b : tissuePresets())
      if (b.youngsModulus.typical > 1.1 * a.youngsModulus.typical) {
        EXPECT_GE(tissueOf(b).youngsModulus, tissueOf(a).youngsModulus) << a.id << " and " << b.id;
      }
}

TEST(TissuePresets, SayWhereEveryNumberComesFrom)
{
  std::set<std::string> ids;
  for (const TissuePreset& preset : tissuePresets()) {
    EXPECT_TRUE(ids.insert(preset.id).second);
    EXPECT_EQ(findPreset(preset.id), &preset);
    for (const fuzzy::Names* names : {&preset.name, &preset.remark}) {
      EXPECT_FALSE(names->english.empty()) << preset.id;
      EXPECT_FALSE(names->german.empty()) << preset.id;
    }
    for (const Measurement* m :
         {&preset.youngsModulus, &preset.density, &preset.damping, &preset.ruptureStrain}) {
      EXPECT_LE(m->low, m->typical) << preset.id;
      EXPECT_LE(m->typical, m->high) << preset.id;
      EXPECT_FALSE(m->method.german.empty());
      EXPECT_TRUE(m->isEstimate || *m->source != '\0') << preset.id << ": measured, but by whom?";
    }
  }
  EXPECT_EQ(findPreset("bone"), nullptr);
}

TEST(TissuePresets, ChangeOnlyWhatTheySpeakOf)
{
  const TissueModel model = defaultTissue();
  auto inputs = model.inputs;
  inputs[2] = 0.1; // shiftability: the organ's bed
  const auto changed = withPreset(tissuePresets()[1], model.rules, inputs);
  ASSERT_TRUE(changed);
  EXPECT_EQ((*changed)[2], inputs[2]);
  EXPECT_NE((*changed)[0], inputs[0]);
}

// A rule base without the words gets no half preset but a reason.
TEST(TissuePresets, RefuseARuleBaseOfOtherWords)
{
  TissueModel model = defaultTissue();
  model.rules.inputs[0].terms.erase(model.rules.inputs[0].terms.begin() + 1); // doughy
  const auto liver = withPreset(*findPreset("liver"), model.rules, model.inputs);
  ASSERT_FALSE(liver);
  EXPECT_NE(liver.error().detail.find("doughy"), std::string::npos) << liver.error().detail;
  model.rules.inputs.pop_back();
  const auto skin = withPreset(*findPreset("skin"), model.rules, model.inputs);
  ASSERT_FALSE(skin);
  EXPECT_NE(skin.error().detail.find("'wall'"), std::string::npos) << skin.error().detail;
}

// tan(0.63 rad) = 0.73 is liver's loss tangent, half of it its damping ratio; back and forth loses nothing.
TEST(TissueUnits, DampingRatioIsHalfTheLossTangent)
{
  const double tau = std::tan(0.63) / (2.0 * 3.14159265358979323846 * kDampingFrequency);
  EXPECT_NEAR(dampingRatio(tau), 0.365, 1e-3);
  EXPECT_NEAR(retardationTime(dampingRatio(tau)) / tau, 1.0, 1e-15);
}

// K/mu = 2 (1 + nu) / (3 (1 - 2 nu)), so 2/3 is nu = 0 and 5/3 is nu = 1/4.
TEST(TissueUnits, PoissonRatioFollowsTheModuli)
{
  EXPECT_NEAR(poissonRatio(2.0 / 3.0), 0.0, 1e-15);
  EXPECT_NEAR(poissonRatio(5.0 / 3.0), 0.25, 1e-15);
  EXPECT_NEAR(poissonRatio(1e9), 0.5, 1e-9);
}

// By hand: E = 30 kPa, nu = 1/4: (1 - 1/16) / (2 x 0.005 m x 30 kPa) = 3.125 mm.
TEST(TissueUnits, DeflectionUnderOneNewton)
{
  TissueParameters tissue;
  tissue.youngsModulus = 30e3;
  tissue.volumeRatio = 5.0 / 3.0;
  EXPECT_NEAR(deflectionUnder1N(tissue).depth, 3.125e-3, 1e-12);
  EXPECT_EQ(shownDeflection(deflectionUnder1N(tissue), Language::English), "3.12\u00a0mm");
  tissue.youngsModulus = 1e3;
  EXPECT_FALSE(deflectionUnder1N(tissue).isLinear);
  EXPECT_EQ(shownDeflection(deflectionUnder1N(tissue), Language::German), ">\u00a05,00\u00a0mm");
}

TEST(TissueUnits, AreThoseOfPhysicians)
{
  using P = TissueParameters;
  EXPECT_EQ(shownValue(6380.0, &P::youngsModulus, Language::English), "6.38\u00a0kPa");
  EXPECT_EQ(shownValue(6380.0, &P::youngsModulus, Language::German), "6,38\u00a0kPa");
  EXPECT_EQ(shownValue(1.18e6, &P::youngsModulus, Language::German), "1180\u00a0kPa");
  EXPECT_EQ(shownValue(1052.0, &P::density, Language::German), "1,05\u00a0g/cm³");
  EXPECT_EQ(shownValue(1.9e-3, &P::viscosity, Language::English), "1.90\u00a0ms");
  EXPECT_EQ(shownValue(1e5, &P::anchoring, Language::English), "0.100\u00a0kPa/mm");
  EXPECT_EQ(shownValue(0.54, &P::ruptureStrain, Language::English), "54.0\u00a0%");
  EXPECT_EQ(shownValue(3.0, &P::stiffening, Language::English), "3.00");
  EXPECT_EQ(shownValue(0.0, &P::stiffening, Language::English), "0.00");
  EXPECT_EQ(shownValue(std::nan(""), &P::density, Language::English), "–\u00a0g/cm³");
}

// The names on show are those of the rules.
TEST(TissueUnits, NamesAreThoseOfTheRuleBase)
{
  const fuzzy::RuleBase rules = defaultRules();
  for (const TissueOutput& output : kTissueOutputs)
    for (const Language language : {Language::English, Language::German})
      EXPECT_EQ(shownName(output.value, language), rules.findOutput(output.id)->name.in(language));
}

} // namespace
} // namespace esm
