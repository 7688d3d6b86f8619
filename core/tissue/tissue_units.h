// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/types.h"
#include "core/tissue/tissue_parameters.h"

#include <string>

namespace esm {

/// Tissue in the words and units of physicians, in both languages.

/// tan(delta) is measured near this frequency by elastography. [Hz]
inline constexpr double kDampingFrequency = 50.0;

/// Damping ratio zeta of tissue of that retardation time tau [s]. A spring and a damper in parallel
/// (Kelvin-Voigt) have tan(delta) = omega tau, and zeta = tan(delta) / 2 near resonance, so at 50 Hz
/// zeta = pi f tau. Twice the frequency is damped twice as much: a model, not a property of tissue.
double dampingRatio(double retardationTime) noexcept;
double retardationTime(double dampingRatio) noexcept;

/// Poisson's ratio from K/mu: (3 r - 2) / (6 r + 2), 0.5 without end.
double poissonRatio(double volumeRatio) noexcept;

/// How far a flat round probe of 10 mm diameter (a fingertip) goes in under 1 N.
struct Deflection {
  double depth = 0.0;   ///< [m]
  bool isLinear = true; ///< false: deeper than the probe's radius, so that the number says "very soft" only
};
/// Rigid cylinder with a flat end on a half space of linear elastic tissue:
///
///     depth = F (1 - nu^2) / (2 a E),   F = 1 N, a = 5 mm
///
/// Source: Sneddon, Int. J. Eng. Sci. 3 (1965) 47-57. An organ much thicker than the probe is wide, not
/// stiffening and not shifting as a whole; a thin wall over a cavity gives way further.
Deflection deflectionUnder1N(const TissueParameters& tissue) noexcept;

/// The unit in which physicians read a parameter.
struct ShownUnit {
  double perUnit = 1.0; ///< SI units in one
  const char* unit = "";
};
ShownUnit shownUnit(double TissueParameters::*parameter) noexcept;
/// Three significant digits without exponent, an unbreakable space before the unit: "31.6 kPa".
std::string shownNumber(double value, const ShownUnit& unit, Language language);

/// A parameter as it is shown: "31.6 kPa" / "31,6 kPa", "1.05 g/cm³", "1.9 ms", "55 %", "0.1 kPa/mm". Three
/// significant digits, an unbreakable space before the unit, decimal comma in German.
std::string shownValue(double value, double TissueParameters::*parameter, Language language);
std::string shownDeflection(const Deflection& deflection, Language language); ///< "2.7 mm", "> 5 mm"
/// The parameter's name: "stiffness" / "Steifigkeit".
std::string shownName(double TissueParameters::*parameter, Language language);

} // namespace esm
