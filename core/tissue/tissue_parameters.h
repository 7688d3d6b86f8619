// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>

namespace esm {

/// What tissue is, free of any mesh: so that refining a mesh does not change how soft the organ is.
struct TissueParameters {
  double youngsModulus = 0.0; ///< E [Pa]
  double viscosity = 0.0;     ///< retardation time tau = c/k of every spring and anchor [s]
  double anchoring = 0.0;     ///< stiffness of the bed that holds the organ, per area of surface [Pa/m]
  double density = 0.0;       ///< [kg/m^3]
  double stiffening = 0.0;    ///< b of the exponential law: tangent stiffness grows as exp(b strain) [1]
  double ruptureStrain = 0.0; ///< e/L at which it tears [1]
  double volumeRatio = 0.0;   ///< bulk over shear modulus K/mu [1]
};

/// One output of the rule base that tissue understands. Rule bases from before an optional output existed
/// go without it; all places then have one value.
struct TissueOutput {
  const char* id;
  double TissueParameters::*value;
  bool required;
};
inline constexpr int kTissueOutputCount = 7;
inline constexpr std::array<TissueOutput, kTissueOutputCount> kTissueOutputs = {{
  {"youngs_modulus", &TissueParameters::youngsModulus, true},
  {"viscosity", &TissueParameters::viscosity, true},
  {"anchoring", &TissueParameters::anchoring, true},
  {"density", &TissueParameters::density, false},
  {"stiffening", &TissueParameters::stiffening, false},
  {"rupture_strain", &TissueParameters::ruptureStrain, false},
  {"volume_ratio", &TissueParameters::volumeRatio, false},
}};

/// Which parameters are asked for, bit i for kTissueOutputs[i]: an exponential each.
inline constexpr unsigned kAllParameters = 0b1111111, kSpringParameters = 0b0010011,
                          kNodeParameters = 0b0001110;

/// Natural logarithms of the parameters in the order of kTissueOutputs: what regions blend.
using LogParameters = Eigen::Array<double, kTissueOutputCount, 1>;

} // namespace esm
