// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/extent.h"
#include "core/structure/support_parts.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace esm::support {

namespace {

constexpr double kMostLatticeNodes = 2e6;
constexpr double kLeastDistance = 0.35; ///< of a lattice node from the surface's nodes, in cells
constexpr double kReach = 1.5;          ///< as far the surface looks for lattice nodes, in cells
constexpr std::size_t kTies = 4;        ///< at most, of a node of the surface

/// The body-centred cubic lattice in half cells: all coordinates even (corners) or all odd (middles).
class Lattice {
public:
  using Place = std::array<int, 3>;
  Lattice(const Eigen::Vector3d& origin, double cell) : m_origin(origin), m_half(0.5 * cell) {}
  Eigen::Vector3d pointAt(const Place& p) const
  {
    return m_origin + m_half * Eigen::Vector3d(p[0], p[1], p[2]);
  }
  Place nearestHalf(const Eigen::Vector3d& point) const
  {
    const Eigen::Vector3d p = (point - m_origin) / m_half;
    return {static_cast<int>(std::lround(p[0])), static_cast<int>(std::lround(p[1])),
            static_cast<int>(std::lround(p[2]))};
  }
  Index at(const Place& p) const
  {
    const auto found = m_nodes.find(p);
    return found == m_nodes.end() ? kNoIndex : found->second;
  }
  void add(const Place& p) { m_nodes.emplace(p, static_cast<Index>(m_nodes.size())); }
  const std::map<Place, Index>& nodes() const { return m_nodes; }

private:
  Eigen::Vector3d m_origin;
  double m_half;
  std::map<Place, Index> m_nodes;
};

bool isLatticePlace(const Lattice::Place& p)
{
  return (p[0] & 1) == (p[1] & 1) && (p[1] & 1) == (p[2] & 1);
}

template <class Visit>
void forEachAround(const Lattice::Place& middle, int reach, const Visit& visit)
{
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j)
      for (int k = -reach; k <= reach; ++k) {
        const Lattice::Place place = {middle[0] + i, middle[1] + j, middle[2] + k};
        if (isLatticePlace(place)) visit(place);
      }
}

double meanEdge(const SpringNet& net)
{
  double sum = 0.0, count = 0.0;
  for (Index s = 0; s < net.springCount(); ++s)
    if (net.kind[static_cast<std::size_t>(s)] == SpringKind::Edge) {
      sum += net.restLength[s];
      count += 1.0;
    }
  return count > 0.0 ? sum / count : 0.0;
}

} // namespace

Result<Layer> makeLattice(const SpringNet& net, const SupportOptions& options, WorkControl* control)
{
  const OutwardSurface surface(net, control);
  if (stopWanted(control)) return cancelledError();
  if (!surface.isClosed())
    return Error{ErrorCode::InvalidValue,
                 "a lattice needs a closed surface to lie in; fill its holes, or choose struts"};
  const double cell = options.latticeCell > 0.0 ? options.latticeCell : 2.0 * meanEdge(net);
  const Eigen::AlignedBox3d box = boxOf(net.restPosition);
  const Eigen::Vector3d low = box.min(), high = box.max();
  const Eigen::Vector3d cells = (high - low) / cell;
  if (!(2.0 * (cells.array() + 1.0).prod() < kMostLatticeNodes))
    return Error{ErrorCode::InvalidValue, "the lattice's cell is too small: it would have millions of nodes"};

  Lattice lattice(0.5 * (low + high), cell); // a corner in the middle of the box
  const Lattice::Place from = lattice.nearestHalf(low), to = lattice.nearestHalf(high);
  std::map<Lattice::Place, std::vector<Index>> surfaceNear; // nodes by the half cell that they lie in
  const Eigen::Matrix3Xd normals = surface.nodeNormals();
  for (Index node = 0; node < net.nodeCount(); ++node)
    if (normals.col(node).squaredNorm() > 0.5)
      surfaceNear[lattice.nearestHalf(net.restPosition.col(node))].push_back(node);

  const auto isFarEnough = [&](const Eigen::Vector3d& point) {
    const Lattice::Place middle = lattice.nearestHalf(point);
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k)
          if (const auto near = surfaceNear.find({middle[0] + i, middle[1] + j, middle[2] + k});
              near != surfaceNear.end())
            for (const Index node : near->second)
              if ((net.restPosition.col(node) - point).norm() < kLeastDistance * cell) return false;
    return true;
  };
  const auto none = [](Index) { return false; };
  for (int i = from[0]; i <= to[0]; ++i) {
    if (stopWanted(control)) return cancelledError();
    for (int j = from[1]; j <= to[1]; ++j)
      for (int k = from[2]; k <= to[2]; ++k) {
        const Lattice::Place place = {i, j, k};
        if (!isLatticePlace(place)) continue;
        const Eigen::Vector3d point = lattice.pointAt(place);
        if (isFarEnough(point) && surface.tree().crossings(point, kObliqueDirection, none) % 2 == 1)
          lattice.add(place);
      }
  }
  Layer layer;
  const Index first = net.nodeCount();
  layer.nodes.resize(3, static_cast<Eigen::Index>(lattice.nodes().size()));
  layer.volume = Eigen::ArrayXd::Constant(layer.nodes.cols(), 0.5 * cell * cell * cell);
  for (const auto& [place, node] : lattice.nodes()) layer.nodes.col(node) = lattice.pointAt(place);
  if (layer.nodes.cols() == 0)
    return Error{ErrorCode::EmptyResult,
                 "no node of the lattice fits into the body; choose a smaller cell, or struts"};

  const auto isFree = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, Index own) {
    return surface.tree()
             .firstHit(
               a, b - a, 1e-9, 1.0 - 1e-9,
               [&](Index t) { return own != kNoIndex && (surface.triangles().col(t).array() == own).any(); })
             .triangle == kNoIndex;
  };
  // Springs in all directions alike that are as stiff as a solid have six times its volume, for each holds
  // only along itself: section times length, 6 cell^3 / 2 for a node's halves of 8 springs sqrt(3)/2 cell and
  // 6 cell long.
  const double section = 3.0 * cell * cell / (2.0 * std::sqrt(3.0) + 3.0);
  constexpr std::array<Lattice::Place, 7> kBonds = {
    {{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}};
  for (const auto& [place, node] : lattice.nodes()) {
    if (stopWanted(control)) return cancelledError();
    for (const Lattice::Place& bond : kBonds) {
      const Index other = lattice.at({place[0] + bond[0], place[1] + bond[1], place[2] + bond[2]});
      if (other != kNoIndex && isFree(layer.nodes.col(node), layer.nodes.col(other), kNoIndex))
        layer.struts.push_back({first + std::min(node, other), first + std::max(node, other), section});
    }
  }
  std::vector<Strut> ties;
  for (Index node = 0; node < net.nodeCount(); ++node) {
    if (node % 64 == 0 && stopWanted(control)) return cancelledError();
    if (!(normals.col(node).squaredNorm() > 0.5)) continue;
    const Eigen::Vector3d here = net.restPosition.col(node);
    std::vector<std::pair<double, Index>> near;
    forEachAround(lattice.nearestHalf(here), static_cast<int>(2.0 * kReach) + 1,
                  [&](const Lattice::Place& place) {
                    const Index other = lattice.at(place);
                    if (other == kNoIndex) return;
                    const double away = (layer.nodes.col(other) - here).norm();
                    if (away < kReach * cell) near.emplace_back(away, other);
                  });
    std::sort(near.begin(), near.end());
    std::size_t found = 0;
    for (const auto& [away, other] : near) {
      if (found == kTies) break;
      if (!isFree(here, layer.nodes.col(other), node)) continue;
      ties.push_back({node, first + other, 0.0});
      ++found;
    }
    if (found == 0) layer.unsupported.push_back(node);
  }
  shareSections(net, ties);
  layer.struts.insert(layer.struts.end(), ties.begin(), ties.end());
  return layer;
}

} // namespace esm::support
