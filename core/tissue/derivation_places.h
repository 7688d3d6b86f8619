// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/grouped.h"
#include "core/tissue/tissue_model.h"

#include <cstdint>
#include <vector>

namespace esm {

/// What a net's geometry makes of the tissue at a spring.
struct SpringGeometry {
  double area = 0.0;       ///< of the wall's edges A, of others a [m^2]
  double perModulus = 0.0; ///< k / E [m]
  double section = 0.0;    ///< of lines that carry mass a, else 0 [m^2]
  bool isWall = false;     ///< an edge of the wall: E h A / L^2; else E a / L
};

/// The formulas of applyTissue(), for all who write or explain numbers.
struct SpringNumbers {
  double stiffness = 0.0, viscosity = 0.0, lawParameter = 0.0;
};
inline bool cubicFromStiffening(const TissueModel& model) noexcept
{
  return model.law == SpringLaw::Cubic && comesFromRules(model.rules, &TissueParameters::stiffening);
}
inline SpringNumbers springNumbers(const TissueParameters& tissue, double perModulus,
                                   bool cubicFromStiffening) noexcept
{
  const double k = tissue.youngsModulus * perModulus, b = tissue.stiffening;
  return {k, tissue.viscosity * k, cubicFromStiffening ? b * b / 6.0 : b};
}
/// The last factor, see LearnedLayer.
inline SpringNumbers learned(const SpringNumbers& from, double factor, double lawShift) noexcept
{
  return {from.stiffness * factor, from.viscosity * factor, from.lawParameter + lawShift};
}
inline double massOfSurface(const TissueParameters& tissue, double thickness, double dualArea) noexcept
{
  return tissue.density * thickness * dualArea;
}
inline double massOfVolume(const TissueParameters& tissue, double volume) noexcept
{
  return tissue.density * volume;
}
struct AnchorNumbers {
  double stiffness = 0.0, viscosity = 0.0;
};
inline AnchorNumbers anchorNumbers(const TissueParameters& tissue, double dualArea) noexcept
{
  const double k = tissue.anchoring * dualArea;
  return {k, tissue.viscosity * k};
}
inline AnchorNumbers learned(const AnchorNumbers& from, double factor) noexcept
{
  return {from.stiffness * factor, from.viscosity * factor};
}
/// Of a band of the support layer, see AnchorSet::bandLength.
inline AnchorNumbers bandNumbers(const TissueParameters& tissue, double dualArea, double length) noexcept
{
  const double k = tissue.youngsModulus * dualArea / length;
  return {k, tissue.viscosity * k};
}
inline double halfMassOfLine(double density, double section, double length) noexcept
{
  return 0.5 * density * section * length;
}

/// Where tissue is asked for, and what the net's geometry makes of it. A place is a spring's midpoint (0 to
/// S - 1) or a node (S to S + N - 1), at rest.
struct DerivationPlaces {
  explicit DerivationPlaces(const SpringNet& net);
  /// Sections depend on the wall's thickness, which can be edited.
  void setThickness(double thickness, const SpringNet& net);
  SpringGeometry springGeometry(Index spring, double thickness, const SpringNet& net) const;
  /// Whether a node has tissue of its own; else that of its lines.
  bool hasTissue(Index node) const noexcept { return dualArea[node] > 0.0 || volumeOf(node) > 0.0; }
  double volumeOf(Index node) const noexcept { return volume.size() > 0 ? volume[node] : 0.0; }

  Index springs = 0, nodes = 0;
  Eigen::Matrix3Xd point;         ///< 3 x (S + N) [m]
  Eigen::ArrayXd dualArea;        ///< per node [m^2]
  Eigen::ArrayXd volume;          ///< SpringNet::volume [m^3]
  Eigen::ArrayXd edgeArea;        ///< per spring [m^2]
  Eigen::ArrayXd perModulus;      ///< per spring, k / E [m]
  Eigen::ArrayXd section;         ///< per spring of those that carry mass, else 0 [m^2]
  std::vector<Index> loose;       ///< nodes off the surface without a volume, ascending
  Grouped<Index> looseSprings;    ///< by place in `loose`: the springs whose mass they share
  std::vector<Index> looseOfNode; ///< place in `loose`, kNoIndex for others; empty without loose nodes
};

/// The places that a region's weight is above 0 at, ascending.
struct Reach {
  std::vector<Index> place;
  std::vector<double> weight; ///< in (0, 1]
};
Reach reachOf(const RegionShape& shape, const Eigen::Matrix3Xd& points);

/// Looks places up in a reach, ascending: next to each other or far apart, either way at the price of what is asked.
class ReachCursor {
public:
  explicit ReachCursor(const Reach& reach) noexcept : m_reach(reach) {}
  double weightAt(Index place) noexcept; ///< 0 outside the reach

private:
  const Reach& m_reach;
  std::size_t m_next = 0;
};

/// The places that an edit touches, as flags and as a list: to look through the list costs nothing for all the
/// others. What happens to it, happens for regions from the bottom up: a place is in it where the blend of all
/// below has changed (the base tissue: everywhere or nowhere).
class TouchedPlaces {
public:
  TouchedPlaces() = default;
  explicit TouchedPlaces(Index places) : m_flag(static_cast<std::size_t>(places), 0) {}

  void clear();
  void addAll();
  void add(Index place);
  void addReach(const Reach& reach);
  /// A region as it was: it hides changes below where its weight is 1.
  void hideUnder(const Reach& reach);
  /// A region that has moved but kept its parameters.
  void addMoved(const Reach& before, const Reach& after);

  bool has(Index place) const noexcept { return m_flag[static_cast<std::size_t>(place)] != 0; }
  /// Ascending, until the next change.
  const std::vector<Index>& sorted();
  std::int64_t looks() const noexcept { return m_looks; } ///< at places, since clear(): the work of it all

private:
  std::vector<std::uint8_t> m_flag;
  std::vector<Index> m_list; ///< all that were added, once each while their flag is set
  bool m_isSorted = true;
  std::int64_t m_looks = 0;
};

} // namespace esm
