// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/tissue_units.h"

#include "core/base/text_number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

namespace esm {

namespace {

constexpr double kProbeRadius = 0.005; ///< [m]
constexpr double kProbeForce = 1.0;    ///< [N]

/// What a physician reads for a parameter in SI units.
struct Shown {
  double TissueParameters::*parameter;
  double perUnit; ///< SI units in one shown unit
  const char* unit;
  const char *english, *german;
};
constexpr Shown kShown[] = {
  {&TissueParameters::youngsModulus, 1e3, "kPa", "stiffness", "Steifigkeit"},
  {&TissueParameters::viscosity, 1e-3, "ms", "viscosity", "Viskosität"},
  {&TissueParameters::anchoring, 1e6, "kPa/mm", "anchoring", "Verankerung"},
  {&TissueParameters::density, 1e3, "g/cm³", "density", "Dichte"},
  {&TissueParameters::stiffening, 1.0, "", "stiffening", "Versteifung"},
  {&TissueParameters::ruptureStrain, 1e-2, "%", "rupture strain", "Reißdehnung"},
  {&TissueParameters::volumeRatio, 1.0, "", "volume stiffness", "Volumensteifigkeit"},
};

const Shown& shown(double TissueParameters::*parameter)
{
  return *std::find_if(std::begin(kShown), std::end(kShown) - 1,
                       [&](const Shown& candidate) { return candidate.parameter == parameter; });
}

/// Three significant digits without exponent; whole numbers from 100 on.
std::string threeDigits(double value, Language language)
{
  if (!std::isfinite(value)) return "–";
  int decimals = 2;
  if (value != 0.0) {
    const double rounded = *parseDouble(formatDouble(value, 3)); // 99.96 is shown as 100
    decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(std::abs(rounded)))), 0, 9);
  }
  char buffer[400];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals);
  std::string text(buffer, end.ptr);
  if (language == Language::German) std::replace(text.begin(), text.end(), '.', ',');
  return text;
}

std::string withUnit(const std::string& number, const char* unit)
{
  return *unit ? number + "\u00a0" + unit : number;
}

} // namespace

double dampingRatio(double retardationTime) noexcept
{
  return std::numbers::pi * kDampingFrequency * retardationTime;
}

double retardationTime(double dampingRatio) noexcept
{
  return dampingRatio / (std::numbers::pi * kDampingFrequency);
}

double poissonRatio(double volumeRatio) noexcept
{
  return (3.0 * volumeRatio - 2.0) / (6.0 * volumeRatio + 2.0);
}

Deflection deflectionUnder1N(const TissueParameters& tissue) noexcept
{
  const double nu = poissonRatio(tissue.volumeRatio);
  const double depth = kProbeForce * (1.0 - nu * nu) / (2.0 * kProbeRadius * tissue.youngsModulus);
  return {depth, depth <= kProbeRadius};
}

ShownUnit shownUnit(double TissueParameters::*parameter) noexcept
{
  const Shown& how = shown(parameter);
  return {how.perUnit, how.unit};
}

std::string shownNumber(double value, const ShownUnit& unit, Language language)
{
  return withUnit(threeDigits(value / unit.perUnit, language), unit.unit);
}

std::string shownValue(double value, double TissueParameters::*parameter, Language language)
{
  return shownNumber(value, shownUnit(parameter), language);
}

std::string shownDeflection(const Deflection& deflection, Language language)
{
  const double depth = deflection.isLinear ? deflection.depth : kProbeRadius;
  return (deflection.isLinear ? "" : ">\u00a0") + withUnit(threeDigits(1e3 * depth, language), "mm");
}

std::string shownName(double TissueParameters::*parameter, Language language)
{
  const Shown& how = shown(parameter);
  return language == Language::German ? how.german : how.english;
}

} // namespace esm
