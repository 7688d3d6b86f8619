// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/net/parameter_patch.h"
#include "core/tissue/derivation_places.h"
#include "core/tissue/tissue_model.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace esm {

/// Keeps a net's parameters at what a tissue model says while the model is edited, at the price of what an
/// edit touches. applyTissue() is the same in one go; both give the same bits.
///
/// Remembered is what edits leave alone: the net's geometry (areas, sections, midpoints) and, for each
/// region, the places it reaches with their weights. An update infers the words anew (a handful of
/// inferences) and compares: a place is touched if a region that it sees, or the base tissue that it sees,
/// has other parameters or another weight there. What lies wholly under a later region (weight 1) sees
/// nothing of what is below. Touched springs and nodes are written anew, all others keep their numbers and are
/// not looked at, unless a shape moves: then all places are asked whether they are in it.
///
/// What has really changed comes out as a ParameterPatch for others who hold the same net.
///
/// The net must be the one of create(), with its topology and rest positions; whoever changes these, or
/// writes parameters of his own, creates anew. One thread at a time.
class TissueDerivation {
public:
  /// All that can fail of create(); `net` has the tissue after the first update(), which writes everything.
  static Result<TissueDerivation> prepare(const TissueModel& model, const SpringNet& net);
  /// Writes everything, as applyTissue(). Errors: as there; `net` is then as before.
  static Result<TissueDerivation> create(const TissueModel& model, SpringNet& net);
  /// Writes what the edit touches. springsChanged and nodesChanged of the report count what was derived.
  /// @param patch  becomes what is another number now than before; may be null.
  /// Errors: those of TissueField::create(); everything is then as before.
  Result<DerivationReport> update(const TissueModel& model, SpringNet& net, ParameterPatch* patch = nullptr);
  /// The same with the model compiled already: cannot fail.
  const DerivationReport& update(TissueField field, SpringNet& net, ParameterPatch* patch = nullptr);

  const DerivationReport& report() const noexcept { return m_report; } ///< of the last create() or update()
  ApplyReport account(const SpringNet& net) const; ///< the same with sums over the whole net
  const TissueField& field() const noexcept { return m_field; }

private:
  TissueDerivation(TissueField field, const SpringNet& net);
  using Reaches = std::vector<std::shared_ptr<const Reach>>; ///< one per compiled region

  Reaches reachesOf(const TissueField& field);
  void markWhatDiffers(const TissueField& field, const Reaches& reaches);
  void setThickness(double thickness, const SpringNet& net);
  void deriveTouched(SpringNet& net, ParameterPatch* patch);
  void deriveSprings(SpringNet& net, ParameterPatch* patch);
  void deriveNodes(SpringNet& net, ParameterPatch* patch);
  double massOfLines(Index node, const SpringNet& net) const;
  void fillLoneMasses(SpringNet& net, ParameterPatch* patch) const;
  void deriveAnchors(SpringNet& net, ParameterPatch* patch);
  void placeAnchors(SpringNet& net);
  Index placeOfNode(Index node) const noexcept { return m_places.springs + node; }

  DerivationPlaces m_places;
  LearnedNumbers m_learned;
  TissueField m_field;
  Reaches m_reaches;
  TouchedPlaces m_touched;
  Eigen::ArrayXd m_modulus;                      ///< per spring [Pa]
  Eigen::ArrayXd m_springDensity;                ///< per spring, of those that carry mass [kg/m^3]
  Eigen::ArrayXd m_anchoring, m_anchorViscosity; ///< per node [N/m], [N s/m]
  struct Band {
    Index node;
    Eigen::Vector3d point;
    double length;
    AnchorNumbers numbers = {};
  };
  std::vector<Band> m_bands;         ///< of the support layer; they come after tissue's own anchors
  Grouped<Index> m_bandsOfNode;      ///< places in m_bands; empty without bands
  std::vector<Index> m_lone;         ///< nodes to which nothing belongs, ascending
  std::vector<Index> m_anchorOfNode; ///< place among the net's anchors, kNoIndex
  bool m_isFirst = true;             ///< nothing is written yet
  bool m_anchorsChangePlaces = true; ///< a node gained or lost its anchor
  bool m_cubicFromStiffening = false;
  DerivationReport m_report;
};

} // namespace esm
