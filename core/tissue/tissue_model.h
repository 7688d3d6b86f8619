// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/fuzzy/inference.h"
#include "core/fuzzy/rule_base.h"
#include "core/net/spring_net.h"
#include "core/tissue/learned_layer.h"
#include "core/tissue/region.h"
#include "core/tissue/tissue_parameters.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace esm {

/// Words and numbers from which every spring gets its parameters (rule 3 of the house: the one path).
struct TissueModel {
  fuzzy::RuleBase rules;                 ///< with the required of kTissueOutputs, others as it likes
  std::vector<fuzzy::InputValue> inputs; ///< of the base tissue, one per rule base input
  std::vector<Region> regions;           ///< a later one covers an earlier one
  double thickness = 0.002;              ///< of the wall [m], > 0
  double density = 1050.0;               ///< [kg/m^3], > 0; idle if the rule base has the output density
  SpringLaw law = SpringLaw::Exponential;
  double lawParameter = 3.0; ///< [1], see SpringLaw (Table is not offered here); idle if there is stiffening
  LearnedLayer learned;      ///< what recordings have taught, the last factor
};

/// Whether the rule base speaks of a parameter, so that the number in the model is idle.
bool comesFromRules(const fuzzy::RuleBase& rules, double TissueParameters::*value) noexcept;

/// The rule base that a new project starts with: seven inputs in [0, 1], seven outputs on log scales, 36
/// rules: 28 about one input, 8 about two. Names in both languages. Sources and the whole table:
/// docs/TISSUE.md.
///
///     hardness       soft, doughy, rather soft, medium, firm, rather hard, hard
///                    weich, teigig, ziemlich weich, mittel, derb, ziemlich hart, hart
///     elasticity     inelastic, a little elastic, medium, elastic, highly elastic
///                    unelastisch, wenig elastisch, mittel, elastisch, hochelastisch
///     shiftability   fixed, hardly shiftable, medium, shiftable, free
///                    fest, kaum verschieblich, mittel, verschieblich, frei
///     heaviness      fatty, watery, dense                fettig, wasserreich, dicht
///     toughness      fragile, normal, tough              brüchig, normal, zäh
///     stretch        without, mild, strong stiffening    ohne, milde, starke Versteifung
///     wall           hollow, thin, thick, solid          hohl, dünnwandig, dickwandig, massiv
///
/// Harder is stiffer, more elastic is less sluggish, more shiftable is less held, heavier is denser, tougher
/// tears later, whatever the other inputs say, and every value of the inputs fires a rule for every output.
/// The volume stiffness rises from hollow to solid, but for a dip of a few per cent between "thick" and
/// "solid".
fuzzy::RuleBase defaultRules();
/// defaultRules(), inputs at their defaults, no regions.
TissueModel defaultTissue();

/// Tissue of one place before it is made plain numbers.
struct TissueBlend {
  LogParameters logs;
  int pure = -1; ///< -1: the base tissue alone, i >= 0: compiled region i alone, kMixed: blended
  static constexpr int kMixed = -2;
  /// A region of that weight over what is there. Weight 1 hides all below, exactly.
  void cover(int region, double weight, const LogParameters& regionLogs) noexcept
  {
    if (weight == 0.0) return;
    pure = weight == 1.0 ? region : kMixed;
    if (weight == 1.0)
      logs = regionLogs;
    else
      logs += weight * (regionLogs - logs);
  }
};

/// What lies at a place, for "why?": the base tissue at the bottom, then the regions over it.
struct TissueLayer {
  int region = -1;     ///< into TissueModel::regions; -1 is the base tissue
  double weight = 1.0; ///< (0, 1], of the region's shape; what it leaves goes to those below
  double share = 1.0;  ///< [0, 1] of the blend; the shares of one place sum to 1
  LogParameters logs;
  fuzzy::Inference inference;
};

/// A TissueModel compiled: one inference per region, then cheap per place. Any thread.
class TissueField {
public:
  /// Errors: InvalidValue (rule base, inputs, region shapes), the detail names the region.
  static Result<TissueField> create(const TissueModel& model);

  /// Parameters at a place: base tissue, then each enabled region in order blends log-parameters by its
  /// weight.
  TissueParameters at(const Eigen::Vector3d& point) const noexcept;
  const TissueParameters& base() const noexcept { return m_base; }
  bool allOutputsFromRules() const noexcept; ///< false: some output took its default, see layersAt()

  // === The same in pieces, for those who remember weights (TissueDerivation)
  struct CompiledRegion {
    RegionShape shape;
    LogParameters logs;
    TissueParameters own; ///< where its weight is 1
    int index = -1;       ///< into TissueModel::regions
  };
  const TissueModel& model() const noexcept { return m_model; }
  const std::vector<CompiledRegion>& regions() const noexcept { return m_regions; } ///< the enabled ones
  TissueBlend baseBlend() const noexcept { return {m_baseLogs, -1}; }
  /// @param wanted those that are not may stay at any value.
  TissueParameters plain(const TissueBlend& blend, unsigned wanted = kAllParameters) const noexcept;

  // === The same as an account, for "why?" and "what if?" (explain.h)
  std::vector<TissueLayer> layersAt(const Eigen::Vector3d& point) const; ///< those with a share, bottom first
  /// @param region -1 for the base tissue, or one that may also be off: its tissue alone.
  TissueLayer layerOf(int region) const;
  /// The layers' blend: at(point) for layersAt(point), bit for bit.
  TissueParameters blended(const std::vector<TissueLayer>& layers) const noexcept;
  LogParameters logsOf(const fuzzy::Inference& inference) const;
  const fuzzy::Engine& engine() const noexcept { return *m_engine; }
  /// Place among RuleBase::outputs of kTissueOutputs[parameter]; -1: the rules do not speak of it.
  int outputOf(int parameter) const noexcept { return m_output[static_cast<std::size_t>(parameter)]; }

private:
  TissueField() = default;
  TissueParameters fromLogs(const LogParameters& logs, unsigned wanted) const noexcept;

  TissueModel m_model;
  std::optional<fuzzy::Engine> m_engine;        ///< there once created
  std::array<int, kTissueOutputCount> m_output; ///< place among RuleBase::outputs, -1: not there
  TissueParameters m_constant;                  ///< of those outputs that are not there
  fuzzy::Inference m_baseInference;
  LogParameters m_baseLogs;
  TissueParameters m_base;
  std::vector<CompiledRegion> m_regions;
  std::vector<fuzzy::Inference> m_regionInferences;
};

/// What a derivation had to do.
struct DerivationReport {
  Index springsChanged = 0, nodesChanged = 0; ///< that were derived
  std::int64_t placesSeen = 0;                ///< springs and nodes that were looked at to find these
};
struct ApplyReport : DerivationReport {
  double minYoungsModulus = 0.0, maxYoungsModulus = 0.0; ///< over springs [Pa]
  double totalMass = 0.0;                                ///< [kg]
};

/// Writes stiffness, viscosity, law, mass and anchors of every spring and node, from the tissue at the
/// spring's midpoint (rest) and the net's geometry:
///
///     edges    k = E h A / L^2        A the area of the adjoining triangles (Van Gelder 1998, in 2D
///                                     times the thickness h), see also EdgeFormula
///     lines    k = E a / L            a the mean dual area of both ends, so that the struts of a wall
///                                     together have its section; if one end lies off the surface the
///                                     other's; off it altogether pi/4 h^2, a round cord as thick as
///                                     the wall
///     springs with a section of their own (SpringNet::section, struts and edges of solids)
///              k = E section / L
///     nodes    m = density h A_dual   of nodes with a volume (SpringNet::volume) density volume; off the
///     surface density a L / 2 of each of its lines instead;
///                                     without springs the smallest mass of the others
///     law      the exponential law has b = stiffening, the cubic one a = b^2 / 6, which is the term of
///              third order in the exponential's series (its term of second order has no counterpart)
///     anchors  k = anchoring A_dual   on the surface only, at the rest position
///     bands    k = E A_dual / length  of the support layer (AnchorSet::bandLength)
///     all      c = tau k, and springs k times the scale of NetMaterial
///     learned  k and anchors times, b plus what LearnedLayer says, last of all (b: exponential law only)
///
/// Anchors that the net had are replaced, but for bands; those of zero anchoring are left out. Topology, rest
/// shape, fixed flags, ids and tables stay. Every mass is above 0. To follow edits at the price of what they
/// touch: TissueDerivation. Errors: those of TissueField::create, or a surface without area (detail says what
/// to do); `net` is then as before.
Result<ApplyReport> applyTissue(const TissueModel& model, SpringNet& net);

} // namespace esm
