// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/base/work_control.h"
#include "core/net/spring_net.h"
#include "core/tissue/tissue_model.h"

#include <cstdint>

namespace esm {

/// How a net's geometry makes masses and springs of tissue, and what is known of the tissue in numbers. The
/// tissue itself (Young's modulus, density) comes from the rules and multiplies what is prepared here, see
/// applyTissue(); numbers that are given here set the rules' inputs, see tissueOf(). The defaults change
/// nothing.
struct MaterialOptions {
  /// What the tissue fills:
  ///
  ///     Wall   the surface is a wall of the tissue's thickness: mass = density thickness area
  ///     Solid  the inside of a closed surface, or tetrahedra: mass = density volume
  enum class Body : std::uint8_t { Wall, Solid } body = Body::Wall;
  EdgeFormula edges = EdgeFormula::VanGelder;
  /// Measures the net in a virtual tension test and scales all springs, so that Young's modulus means Young's
  /// modulus: pulled along its longest axis the net is as stiff as a body of its sections.
  bool fitModulus = false;
  double youngsModulus = 0.0; ///< of the base tissue [Pa], brings the fit with it; 0: as the tissue has it
  double density = 0.0;       ///< of the base tissue [kg/m^3]; 0: as the tissue has it
  double thickness = 0.0;     ///< of the wall [m]; 0: as the tissue has it
  bool operator==(const MaterialOptions&) const = default;
  bool isFitted() const noexcept { return fitModulus || youngsModulus > 0.0; }
  /// Whether setMaterial() does anything to a fresh net.
  bool concernsNet() const noexcept
  {
    return body != Body::Wall || edges != EdgeFormula::VanGelder || isFitted();
  }
};

struct MaterialReport {
  double volume = 0.0;   ///< of the tissue [m^3]
  double wallArea = 0.0; ///< of the surface [m^2]
  double scale = 1.0;    ///< of the springs' stiffness, see NetMaterial
  /// Of the tension test, before the scale: the net's stiffness over the body's; 0 without a fit.
  double measured = 0.0;
  Eigen::Vector3d axis = Eigen::Vector3d::Zero(); ///< along which it was pulled
};

/// Sets the net's material, sections and volumes as the options say; tissue then writes the numbers anew.
/// After addSupport(), since struts carry part of the load and of the mass.
///
/// Solid: the volume of closed parts (cavities taken off) is shared among the nodes by their surface and
/// struts, and sums up to it exactly; what tetrahedra have set stays.
///
/// The tension test: every node of the surface is drawn along the longest axis as far as a strain of 1 takes
/// it and is free across it, linear statics. So a solid of any shape is strained evenly, without stress
/// across, and its energy is E V / 2; that of a wall is E / 2 times the integral of its sections along the
/// axis. The springs' energy is compared with that. No end is held, where a round body's few nodes at the tip
/// would decide. A wall of cells (SupportOptions::Interior::Wall) is stiff as it should be already and not scaled.
/// @param thickness of the wall [m], TissueModel::thickness. @param control may be null.
/// Errors: InvalidValue (Solid without a closed surface, no surface), Numerics (nothing to fit), Cancelled.
/// `net` is then as before.
Result<MaterialReport> setMaterial(SpringNet& net, const MaterialOptions& options, double thickness,
                                   WorkControl* control = nullptr);

/// The tissue with the thickness, density and Young's modulus that the options give. What the rules speak of
/// is set by one input of the base tissue, within 1 %: of those that can do it, the one that changes the
/// other parameters least (hardness for the modulus, heaviness for the density, by the default rules).
/// Errors: InvalidValue for a number that is not >= 0 or that no input reaches, and those of TissueField.
Result<TissueModel> tissueOf(const MaterialOptions& options, TissueModel tissue);

} // namespace esm
