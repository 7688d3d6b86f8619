// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

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
/// nothing of what is below. Touched springs and nodes are written anew, all others keep their numbers.
///
/// The net must be the one of create(), with its topology and rest positions; whoever changes these, or
/// writes parameters of his own, creates anew. One thread at a time.
class TissueDerivation {
public:
  /// Writes everything, as applyTissue(). Errors: as there; `net` is then as before.
  static Result<TissueDerivation> create(const TissueModel& model, SpringNet& net);
  /// Writes what the edit touches. springsChanged and nodesChanged of the report count what was derived.
  /// Errors: those of TissueField::create(); everything is then as before.
  Result<ApplyReport> update(const TissueModel& model, SpringNet& net);
  /// The same with the model compiled already: cannot fail.
  const ApplyReport& update(TissueField field, SpringNet& net);

  const ApplyReport& report() const noexcept { return m_report; } ///< of the last create() or update()
  const TissueField& field() const noexcept { return m_field; }

private:
  TissueDerivation(TissueField field, const SpringNet& net);
  using Reaches = std::vector<std::shared_ptr<const Reach>>; ///< one per compiled region

  Reaches reachesOf(const TissueField& field) const;
  void markWhatDiffers(const TissueField& field, const Reaches& reaches);
  void deriveTouched(SpringNet& net);
  void deriveSprings(SpringNet& net);
  void deriveNodes(SpringNet& net);
  void deriveBands();
  void deriveAnchors(SpringNet& net);
  void writeSpring(Index spring, const TissueParameters& tissue, SpringNet& net);
  void fillLoneMasses(SpringNet& net) const;
  std::size_t placeOfNode(Index node) const noexcept
  {
    return static_cast<std::size_t>(m_places.springs) + static_cast<std::size_t>(node);
  }

  DerivationPlaces m_places;
  TissueField m_field;
  Reaches m_reaches;
  std::vector<std::uint8_t> m_touched;           ///< per place
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
  std::vector<Index> m_anchorOfNode; ///< place among the net's anchors, kNoIndex
  bool m_anchorsChangePlaces = true; ///< a node gained or lost its anchor
  bool m_cubicFromStiffening = false;
  ApplyReport m_report;
};

} // namespace esm
