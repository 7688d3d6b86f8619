// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/fuzzy/inference.h"
#include "core/fuzzy/rule_base.h"
#include "core/geometry/ellipsoid.h"
#include "core/net/spring_net.h"

#include <string>
#include <vector>

namespace esm {

/// What tissue is, free of any mesh: so that refining a mesh does not change how soft the organ is.
struct TissueParameters {
  double youngsModulus = 0.0; ///< E [Pa]
  double viscosity = 0.0;     ///< retardation time tau = c/k of every spring and anchor [s]
  double anchoring = 0.0;     ///< stiffness of the bed that holds the organ, per area of surface [Pa/m]
};

/// A part of space with tissue of its own.
struct Region {
  std::string name;
  Ellipsoid ellipsoid;
  double falloff = 0.3; ///< [0, 1] share of the radius over which the region fades out, see falloffWeight()
  bool enabled = true;
  std::vector<fuzzy::InputValue> inputs; ///< one per rule base input
};

/// Words and numbers from which every spring gets its parameters (rule 3 of the house: the one path).
struct TissueModel {
  fuzzy::RuleBase rules;                 ///< outputs must include youngs_modulus, viscosity, anchoring
  std::vector<fuzzy::InputValue> inputs; ///< of the base tissue, one per rule base input
  std::vector<Region> regions;           ///< a later one covers an earlier one
  double thickness = 0.002;              ///< of the wall [m], > 0
  double density = 1050.0;               ///< [kg/m^3], > 0
  SpringLaw law = SpringLaw::Exponential;
  double lawParameter = 3.0; ///< [1], see SpringLaw (Table is not offered here)
};

/// The rule base that a new project starts with: hardness, elasticity, shiftability in [0, 1] to
/// youngs_modulus [Pa], viscosity [s], anchoring [Pa/m]. Names in both languages.
///
/// Each input has five words, such that a finding can be entered as it is spoken; hedges refine them:
///
///     hardness       soft, rather soft, medium, rather hard, hard
///                    weich, ziemlich weich, mittel, ziemlich hart, hart
///     elasticity     inelastic, a little elastic, medium, elastic, highly elastic
///                    unelastisch, wenig elastisch, mittel, elastisch, hochelastisch
///     shiftability   fixed, hardly shiftable, medium, shiftable, free
///                    fest, kaum verschieblich, mittel, verschieblich, frei
///
/// One rule per word: harder is stiffer, more elastic is less sluggish, more shiftable is less held. Each
/// output rises or falls with its input without a step back, and every value of the inputs fires a rule.
fuzzy::RuleBase defaultRules();
/// defaultRules(), inputs at their defaults, no regions.
TissueModel defaultTissue();

/// Where a number came from, for "why?".
struct RegionShare {
  int region = -1;     ///< index; -1 is the base tissue
  double weight = 0.0; ///< [0, 1]; the shares of one place sum to 1
};
struct Explanation {
  TissueParameters parameters;              ///< blended
  std::vector<RegionShare> shares;          ///< those with weight > 0, base first
  std::vector<fuzzy::Inference> inferences; ///< one per share
};

/// A TissueModel compiled: one inference per region, then cheap per place. Any thread.
class TissueField {
public:
  /// Errors: InvalidValue (rule base, inputs, region shapes), the detail names the region.
  static Result<TissueField> create(const TissueModel& model);

  /// Parameters at a place: base tissue, then each enabled region in order blends log-parameters by its
  /// weight.
  TissueParameters at(const Eigen::Vector3d& point) const noexcept;
  Explanation explain(const Eigen::Vector3d& point) const;
  const TissueParameters& base() const noexcept { return m_base; }
  bool allOutputsFromRules() const noexcept; ///< false: some output took its default, see explain()

private:
  TissueField() = default;
  struct CompiledRegion {
    Ellipsoid ellipsoid;
    double falloff = 0.0;
    Eigen::Array3d logParameters;
    int index = -1;
  };
  TissueModel m_model;
  TissueParameters m_base;
  fuzzy::Inference m_baseInference;
  Eigen::Array3d m_baseLog;
  std::vector<CompiledRegion> m_regions;
  std::vector<fuzzy::Inference> m_regionInferences;
};

struct ApplyReport {
  Index springsChanged = 0, nodesChanged = 0;
  double minYoungsModulus = 0.0, maxYoungsModulus = 0.0; ///< over springs [Pa]
  double totalMass = 0.0;                                ///< [kg]
};

/// Writes stiffness, viscosity, law, mass and anchors of every spring and node, from the tissue at the
/// spring's midpoint (rest) and the net's geometry:
///
///     edges    k = E h A / L^2        A the area of the adjoining triangles (Van Gelder 1998, in 2D
///                                     times the thickness h)
///     lines    k = E a / L            a the mean dual area of both ends, so that the struts of a wall
///                                     together have its section; if one end lies off the surface the
///                                     other's; off it altogether pi/4 h^2, a round cord as thick as
///                                     the wall
///     nodes    m = density h A_dual   off the surface density a L / 2 of each of its lines instead;
///                                     without springs the smallest mass of the others
///     anchors  k = anchoring A_dual   on the surface only, at the rest position
///     all      c = tau k
///
/// Anchors that the net had are replaced; those of zero anchoring are left out. Topology, rest shape, fixed
/// flags, ids and tables stay. Every mass is above 0.
/// Errors: those of TissueField::create, or a surface without area (detail says what to do); `net` is then as
/// before.
Result<ApplyReport> applyTissue(const TissueModel& model, SpringNet& net);

} // namespace esm
