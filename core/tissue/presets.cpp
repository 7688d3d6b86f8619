// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/presets.h"

#include <algorithm>

namespace esm {

namespace {

using fuzzy::Names;

const Names kElastography = {"shear wave elastography, in vivo", "Scherwellen-Elastographie, in vivo"};
const Names kMre = {"magnetic resonance elastography", "Magnetresonanz-Elastographie"};
const Names kTension = {"tension", "Zugversuch"};
const Names kBiaxial = {"biaxial tension, first part of the curve", "biaxialer Zug, Anfang der Kurve"};
const Names kWeighing = {"weighing", "Wägung"};
const Names kShear = {"modulus of shear times 3", "Schubmodul mal 3"};
const Names kPhase = {"phase of shear waves, zeta = tan(delta)/2",
                      "Phase von Scherwellen, zeta = tan(delta)/2"};
const Names kTrueStrain = {"tension, logarithmic strain converted",
                           "Zugversuch, logarithmische Dehnung umgerechnet"};
const Names kGuess = {"estimate", "Schätzung"};

Measurement measured(double typical, double low, double high, const Names& method, const char* source)
{
  return {typical, low, high, method, source, false};
}

/// A source that gives a value and no spread.
Measurement measured(double value, const Names& method, const char* source)
{
  return {value, value, value, method, source, false};
}

Measurement estimate(double typical, double low, double high, const char* basis = "")
{
  return {typical, low, high, kGuess, basis, true};
}

/// Collects values of others, at rest: liver Palmeri 2008, gallbladder Karimi 2017, bile duct Duch 2004,
/// artery of the liver Holzapfel 2005.
constexpr const char* kTable = "Phys. Med. Biol. 64 (2019) 225001, table 1 (PMC6925591)";
constexpr const char* kDensities = "Kaye & Laby, medicalalgorithms.com";
constexpr const char* kStader = "Stader et al., Sci. Rep. 2024 (PMC11196258)";

/// Soft tissue of organs is near 1050 throughout.
Measurement organDensity(double typical = 1050.0)
{
  return estimate(typical, 1030.0, 1070.0);
}

std::vector<TissuePreset> makePresets()
{
  return {
    {"fat",
     {"fat", "Fettgewebe"},
     measured(2.3e3, 2.3e3, 9.1e3, kMre, "J. Mech. Behav. Biomed. Mater. 2023, 50 Hz; high: PMC4580449"),
     measured(912.0, 901.0, 923.0, kWeighing, kDensities),
     estimate(0.2, 0.1, 0.4),
     estimate(0.4, 0.3, 0.5),
     {"pressed with 1 N the layer under the skin measures 26 kPa (PMC9711973)",
      "unter 1 N Druck misst die Schicht unter der Haut 26 kPa (PMC9711973)"},
     {{"hardness", "somewhat soft"},
      {"elasticity", "medium"},
      {"heaviness", "0"},
      {"toughness", "fragile"},
      {"stretch", "mild stiffening"},
      {"wall", "solid"}}},
    {"liver",
     {"liver", "Leber"},
     measured(5.4e3, 4.2e3, 6.6e3, kShear, kTable),
     measured(1060.0, kWeighing, kTable),
     measured(0.36, 0.33, 0.40, kPhase, "Asbach et al. 2008, loss angle 0.63 rad at 35 to 60 Hz"),
     measured(0.46, kTrueStrain, kTable),
     {"its capsule tears at 18 to 76 %; a fibrotic liver is 2.5 times as stiff (Asbach et al. 2008)",
      "die Kapsel reißt bei 18 bis 76 %; eine fibrotische Leber ist 2,5-mal so steif (Asbach et al. 2008)"},
     {{"hardness", "doughy"},
      {"elasticity", "medium"},
      {"heaviness", "watery"},
      {"toughness", "normal"},
      {"stretch", "mild stiffening"},
      {"wall", "solid"}}},
    {"uterus",
     {"uterus (myometrium)", "Uterus (Myometrium)"},
     measured(6.38e3, 2.76e3, 11.31e3, kElastography, kStader),
     measured(1052.0, kWeighing, kDensities),
     estimate(0.09, 0.05, 0.125, "rise of stiffness with frequency, Kiss et al. 2006 (PMC3690800)"),
     estimate(0.5, 0.3, 0.8),
     {"pressed ex vivo at 0.1 to 100 Hz 30 to 90 kPa, a fibroid 60 to 220 kPa (Kiss et al. 2006); strength "
      "0.55 "
      "to 2.07 MPa (Pearsall & Roberts 1978)",
      "ex vivo gedrückt bei 0,1 bis 100 Hz 30 bis 90 kPa, ein Myom 60 bis 220 kPa (Kiss et al. 2006); "
      "Festigkeit 0,55 bis 2,07 MPa (Pearsall & Roberts 1978)"},
     {{"hardness", "rather soft"},
      {"elasticity", "elastic"},
      {"heaviness", "watery"},
      {"toughness", "normal"},
      {"stretch", "mild stiffening"},
      {"wall", "thick"}}},
    {"muscle",
     {"skeletal muscle, passive", "Skelettmuskel, passiv"},
     measured(7.22e3, 5.11e3, 9.39e3, kElastography, kStader),
     measured(1047.0, 1038.0, 1056.0, kWeighing, kDensities),
     estimate(0.25, 0.15, 0.35),
     estimate(0.5, 0.4, 0.6),
     {"under a load of 5 to 30 N 62 to 440 kPa (PMC9711973)",
      "unter 5 bis 30 N Last 62 bis 440 kPa (PMC9711973)"},
     {{"hardness", "rather soft"},
      {"elasticity", "medium"},
      {"heaviness", "watery"},
      {"toughness", "normal"},
      {"stretch", "strong stiffening"},
      {"wall", "solid"}}},
    {"ovary",
     {"ovary", "Ovar"},
     estimate(10e3, 5e3, 15e3),
     organDensity(),
     estimate(0.1, 0.05, 0.2),
     estimate(0.5, 0.3, 0.8),
     {"mostly elastic; creeps with times of 1 s and 20 to 40 s (animals)",
      "überwiegend elastisch; kriecht mit Zeiten von 1 s und 20 bis 40 s (Tiere)"},
     {{"hardness", "rather soft"},
      {"elasticity", "elastic"},
      {"heaviness", "watery"},
      {"toughness", "normal"},
      {"stretch", "mild stiffening"},
      {"wall", "solid"}}},
    {"endometrium",
     {"endometrium", "Endometrium"},
     measured(18e3, 5e3, 36e3, kElastography,
              "PMC8242144: 26.2 kPa proliferative, 12.5 kPa secretory; their geometric mean"),
     organDensity(),
     estimate(0.1, 0.05, 0.2),
     estimate(0.4, 0.2, 0.6),
     {"softer in the second half of the cycle", "weicher in der zweiten Zyklushälfte"},
     {{"hardness", "medium"},
      {"elasticity", "elastic"},
      {"heaviness", "watery"},
      {"toughness", "fragile"},
      {"stretch", "mild stiffening"},
      {"wall", "thin"}}},
    {"fallopian_tube",
     {"fallopian tube", "Eileiter"},
     estimate(35e3, 20e3, 60e3),
     organDensity(),
     estimate(0.2, 0.1, 0.3),
     estimate(0.5, 0.3, 0.8),
     {"the human tube is not studied sufficiently (Seraj et al. 2024); by atomic force microscopy the rat's "
      "mucosa has 317 kPa and more (Jafarbeglou et al. 2022)",
      "der menschliche Eileiter ist nicht hinreichend untersucht (Seraj et al. 2024); im "
      "Rasterkraftmikroskop hat "
      "die Schleimhaut der Ratte 317 kPa und mehr (Jafarbeglou et al. 2022)"},
     {{"hardness", "medium"},
      {"elasticity", "elastic"},
      {"heaviness", "watery"},
      {"toughness", "normal"},
      {"stretch", "mild stiffening"},
      {"wall", "hollow"}}},
    {"small_bowel",
     {"small bowel (ileum)", "Dünndarm (Ileum)"},
     measured(235e3, 163e3, 337e3, kBiaxial, "Terry et al. 2014, pig; geometric mean of along and across"),
     organDensity(1040.0),
     estimate(0.15, 0.1, 0.3),
     measured(1.4, kTension, "Egorov et al., J. Biomech. 35 (2002) 1417, human, across"),
     {"further on in the curve 1.4 to 2.2 MPa", "im weiteren Verlauf der Kurve 1,4 bis 2,2 MPa"},
     {{"hardness", "rather hard"},
      {"elasticity", "elastic"},
      {"heaviness", "watery"},
      {"toughness", "extremely tough"},
      {"stretch", "strong stiffening"},
      {"wall", "hollow"}}},
    {"gallbladder",
     {"gallbladder", "Gallenblase"},
     measured(255e3, 230e3, 280e3, kShear, kTable),
     measured(1060.0, kWeighing, kTable),
     estimate(0.15, 0.1, 0.3),
     measured(0.54, 0.14, 1.07, kTrueStrain, kTable),
     {"stretched within milliseconds 9 MPa (pig)", "in Millisekunden gedehnt 9 MPa (Schwein)"},
     {{"hardness", "rather hard"},
      {"elasticity", "elastic"},
      {"heaviness", "watery"},
      {"toughness", "normal"},
      {"stretch", "strong stiffening"},
      {"wall", "hollow"}}},
    {"bile_duct",
     {"bile duct", "Gallengang"},
     measured(500e3, 300e3, 700e3, kShear, kTable),
     measured(1060.0, kWeighing, kTable),
     estimate(0.15, 0.1, 0.3),
     estimate(0.5, 0.3, 0.8),
     {"its stress rises exponentially with strain (PMC493277)",
      "die Spannung steigt exponentiell mit der Dehnung (PMC493277)"},
     {{"hardness", "rather hard"},
      {"elasticity", "elastic"},
      {"heaviness", "watery"},
      {"toughness", "normal"},
      {"stretch", "strong stiffening"},
      {"wall", "thin"}}},
    {"vessel_wall",
     {"vessel wall (artery)", "Gefäßwand (Arterie)"},
     measured(630e3, 490e3, 770e3, kShear, kTable),
     measured(1050.0, kWeighing, kTable),
     estimate(0.15, 0.1, 0.2),
     measured(0.88, kTrueStrain, kTable),
     {"of the liver's artery", "der Leberarterie"},
     {{"hardness", "somewhat hard"},
      {"elasticity", "elastic"},
      {"heaviness", "watery"},
      {"toughness", "tough"},
      {"stretch", "strong stiffening"},
      {"wall", "thin"}}},
    {"skin",
     {"skin", "Haut"},
     measured(1.18e6, 0.3e6, 2.06e6, kTension, "Ni Annaidh et al. 2012, arXiv 1302.3022, first slope"),
     measured(1150.0, 1110.0, 1190.0, kWeighing, kDensities),
     estimate(0.3, 0.2, 0.4),
     measured(0.54, 0.37, 0.71, kTension, "Ni Annaidh et al. 2012, arXiv 1302.3022"),
     {"further on in the curve 83 MPa; strength 21.6 MPa",
      "im weiteren Verlauf der Kurve 83 MPa; Festigkeit 21,6 MPa"},
     {{"hardness", "hard"},
      {"elasticity", "medium"},
      {"heaviness", "dense"},
      {"toughness", "normal"},
      {"stretch", "strong stiffening"},
      {"wall", "thick"}}},
  };
}

} // namespace

const std::vector<TissuePreset>& tissuePresets()
{
  static const std::vector<TissuePreset> presets = makePresets();
  return presets;
}

const TissuePreset* findPreset(std::string_view id) noexcept
{
  for (const TissuePreset& preset : tissuePresets())
    if (preset.id == id) return &preset;
  return nullptr;
}

Result<std::vector<fuzzy::InputValue>> withPreset(const TissuePreset& preset, const fuzzy::RuleBase& rules,
                                                  std::vector<fuzzy::InputValue> inputs)
{
  inputs.resize(rules.inputs.size());
  for (const TissuePreset::Finding& finding : preset.findings) {
    const auto variable =
      std::find_if(rules.inputs.begin(), rules.inputs.end(),
                   [&](const fuzzy::Variable& candidate) { return candidate.id == finding.input; });
    const auto refuse = [&](const std::string& why) {
      return Error{ErrorCode::InvalidValue,
                   "the preset '" + preset.name.english + "' needs the program's own rule base: " + why};
    };
    if (variable == rules.inputs.end())
      return refuse(std::string("there is no input '") + finding.input + "'");
    auto value = fuzzy::parseInput(finding.words, *variable);
    if (const auto* fault = std::get_if<fuzzy::RuleTextError>(&value))
      return refuse(std::string("'") + finding.words + "' of " + finding.input + ": " + fault->message);
    inputs[static_cast<std::size_t>(variable - rules.inputs.begin())] =
      std::get<fuzzy::InputValue>(std::move(value));
  }
  return inputs;
}

} // namespace esm
