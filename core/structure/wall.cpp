// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/text_number.h"
#include "core/geometry/edge_table.h"
#include "core/structure/support_parts.h"
#include "core/structure/wall_cells.h"
#include "core/structure/wall_offset.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace esm::support {

namespace {

constexpr int kMostChosenLayers = 4; ///< that are chosen; who wants more says so
constexpr double kMostWallNodes = 2e6;
constexpr double kQuadSides =
  1.3; ///< two triangles are a quad if its second diagonal is at most so much longer

/// Makes the springs of a wall whose sheets of nodes lie one below the other.
class WallBuilder {
public:
  WallBuilder(const SpringNet& net, const OutwardSurface& surface, const WallOffset& offset, int layers)
    : m_net(net), m_triangles(surface.triangles()), m_offset(offset), m_layers(layers)
  {
    m_number.assign(offset.isOn.size(), kNoIndex);
    for (std::size_t node = 0; node < offset.isOn.size(); ++node)
      if (offset.isOn[node]) {
        m_number[node] = static_cast<Index>(m_surfaceNodes.size());
        m_surfaceNodes.push_back(static_cast<Index>(node));
      }
    layer.nodes.resize(3, static_cast<Eigen::Index>(m_surfaceNodes.size()) * layers);
    for (int sheet = 1; sheet <= layers; ++sheet)
      for (const Index node : m_surfaceNodes)
        layer.nodes.col(at(node, sheet) - net.nodeCount()) = place(node, sheet);
    layer.volume.setZero(layer.nodes.cols());
    layer.surfaceVolume.setZero(net.nodeCount());
    layer.surfaceSection.setZero(net.springCount());
    for (Index s = 0; s < net.springCount(); ++s)
      m_springOf.emplace(pairKey(net.ends(0, s), net.ends(1, s)), s);
    findQuads();
  }

  bool fill(WorkControl* control)
  {
    for (Index t = 0; t < static_cast<Index>(m_triangles.cols()); ++t) {
      if (t % 64 == 0 && stopWanted(control)) return false;
      for (int below = 1; below <= m_layers; ++below) fillCell(t, below);
    }
    return true;
  }

  double meanCell() const { return m_volume > 0.0 ? m_errorSum / m_volume : 0.0; }
  double volume() const { return m_volume; }
  Layer layer;

private:
  struct Bond {
    Index a, b;
    SpringKind kind;
  };

  Index at(Index node, int sheet) const
  {
    return sheet == 0 ? node
                      : m_net.nodeCount() + (sheet - 1) * static_cast<Index>(m_surfaceNodes.size()) +
                          m_number[static_cast<std::size_t>(node)];
  }
  Eigen::Vector3d place(Index node, int sheet) const
  {
    return m_net.restPosition.col(node) + (static_cast<double>(sheet) / m_layers) * m_offset.depth.col(node);
  }

  /// Place of side c of a triangle among all sides.
  static std::size_t sideOf(Index t, int c) noexcept
  {
    return 3 * static_cast<std::size_t>(t) + static_cast<std::size_t>(c);
  }

  /// For each side of a triangle the corner beyond it, if both triangles together look like a quad.
  void findQuads()
  {
    Mesh mesh;
    mesh.position = m_net.restPosition;
    mesh.triangles = m_triangles;
    const EdgeTable edges = findEdges(mesh);
    std::vector<std::pair<Index, Index>> cornersOf(static_cast<std::size_t>(edges.ends.cols()),
                                                   {kNoIndex, kNoIndex});
    const auto count = static_cast<Index>(m_triangles.cols());
    const auto edgeAt = [&](Index t, int c) { return edges.edgeOfSide[sideOf(t, c)]; };
    for (Index t = 0; t < count; ++t)
      for (int c = 0; c < 3; ++c)
        if (const Index edge = edgeAt(t, c); edge != kNoIndex) {
          auto& [first, second] = cornersOf[static_cast<std::size_t>(edge)];
          (first == kNoIndex ? first : second) = m_triangles((c + 2) % 3, t);
        }
    m_beyond.assign(3 * static_cast<std::size_t>(count), kNoIndex);
    for (Index t = 0; t < count; ++t)
      for (int c = 0; c < 3; ++c) {
        const Index edge = edgeAt(t, c);
        if (edge == kNoIndex) continue;
        const auto& [first, second] = cornersOf[static_cast<std::size_t>(edge)];
        if (second == kNoIndex || first == second) continue;
        const auto length = [&](Index a, Index b) {
          return (m_net.restPosition.col(a) - m_net.restPosition.col(b)).norm();
        };
        if (length(first, second) <= kQuadSides * length(edges.ends(0, edge), edges.ends(1, edge)))
          m_beyond[sideOf(t, c)] = first == m_triangles((c + 2) % 3, t) ? second : first;
      }
  }

  std::vector<Bond> bondsOf(Index t, int below) const
  {
    const int above = below - 1;
    std::vector<Bond> bonds;
    for (int c = 0; c < 3; ++c) {
      const Index a = m_triangles(c, t), b = m_triangles((c + 1) % 3, t), tip = m_triangles((c + 2) % 3, t);
      bonds.push_back({at(a, above), at(a, below), SpringKind::WallAcross});
      addPair(bonds, a, b, above, below, SpringKind::WallEdge);
      if (const Index beyond = m_beyond[sideOf(t, c)]; beyond != kNoIndex)
        addPair(bonds, tip, beyond, above, below, SpringKind::WallDiagonal);
    }
    return bonds;
  }
  /// The two springs in the layers and the two across.
  void addPair(std::vector<Bond>& bonds, Index a, Index b, int above, int below, SpringKind inLayer) const
  {
    bonds.push_back({at(a, above), at(b, above), inLayer});
    bonds.push_back({at(a, below), at(b, below), inLayer});
    bonds.push_back({at(a, above), at(b, below), SpringKind::WallBrace});
    bonds.push_back({at(b, above), at(a, below), SpringKind::WallBrace});
  }

  Eigen::Vector3d placeOf(Index node) const
  {
    return node < m_net.nodeCount() ? Eigen::Vector3d(m_net.restPosition.col(node))
                                    : Eigen::Vector3d(layer.nodes.col(node - m_net.nodeCount()));
  }

  void fillCell(Index t, int below)
  {
    const double volume = shareVolume(t, below);
    if (!(volume > 0.0)) return;
    std::vector<Bond> bonds = bondsOf(t, below);
    std::erase_if(bonds,
                  [this](const Bond& bond) { return !((placeOf(bond.b) - placeOf(bond.a)).norm() > 0.0); });
    CellSprings springs;
    springs.way.resize(3, static_cast<Eigen::Index>(bonds.size()));
    for (std::size_t i = 0; i < bonds.size(); ++i) {
      springs.way.col(static_cast<Eigen::Index>(i)) = placeOf(bonds[i].b) - placeOf(bonds[i].a);
      springs.isInLayer.push_back(bonds[i].kind == SpringKind::WallEdge ||
                                  bonds[i].kind == SpringKind::WallDiagonal);
    }
    const CellShares shares = shareCell(springs, normalOf(t, below));
    m_errorSum += volume * shares.error;
    m_volume += volume;
    for (std::size_t i = 0; i < bonds.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      addTo(bonds[i], shares.share[column] * volume / springs.way.col(column).norm());
    }
  }

  void addTo(const Bond& bond, double section)
  {
    const std::uint64_t key = pairKey(bond.a, bond.b);
    if (const auto old = m_springOf.find(key); old != m_springOf.end()) {
      layer.surfaceSection[old->second] += section;
      return;
    }
    const auto [found, isNew] = m_strutOf.emplace(key, layer.struts.size());
    if (isNew)
      layer.struts.push_back({std::min(bond.a, bond.b), std::max(bond.a, bond.b), 0.0, 1.0, bond.kind});
    layer.struts[found->second].section += section;
  }

  Eigen::Vector3d normalOf(Index t, int below) const
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int sheet : {below - 1, below}) {
      const Eigen::Vector3d a = place(m_triangles(0, t), sheet);
      sum += (place(m_triangles(1, t), sheet) - a).cross(place(m_triangles(2, t), sheet) - a);
    }
    return sum.normalized();
  }

  /// Adds a prism's volume to its nodes: of cross sections s on the way down a third to each corner, 1 - s above
  /// and s below. Simpson's rule is exact for it. @return the volume
  double shareVolume(Index t, int below)
  {
    Eigen::Matrix3d top, bottom;
    for (int k = 0; k < 3; ++k) {
      top.col(k) = place(m_triangles(k, t), below - 1);
      bottom.col(k) = place(m_triangles(k, t), below);
    }
    const Eigen::Vector3d down = (bottom - top).rowwise().mean();
    double above = 0.0, under = 0.0;
    for (const auto& [s, weight] : {std::pair{0.0, 1.0 / 6.0}, {0.5, 4.0 / 6.0}, {1.0, 1.0 / 6.0}}) {
      const Eigen::Matrix3d middle = (1.0 - s) * top + s * bottom;
      const double area =
        -0.5 * (middle.col(1) - middle.col(0)).cross(middle.col(2) - middle.col(0)).dot(down);
      above += weight * (1.0 - s) * area;
      under += weight * s * area;
    }
    if (!(above + under > 0.0)) return 0.0;
    for (int k = 0; k < 3; ++k) {
      addVolume(at(m_triangles(k, t), below - 1), above / 3.0);
      addVolume(at(m_triangles(k, t), below), under / 3.0);
    }
    return above + under;
  }
  void addVolume(Index node, double volume)
  {
    if (node < m_net.nodeCount())
      layer.surfaceVolume[node] += volume;
    else
      layer.volume[node - m_net.nodeCount()] += volume;
  }

  const SpringNet& m_net;
  const TriangleMatrix& m_triangles;
  const WallOffset& m_offset;
  int m_layers;
  std::vector<Index> m_surfaceNodes, m_number; ///< nodes of the surface, and the place of each among them
  std::vector<Index> m_beyond;                 ///< per side of a triangle
  std::unordered_map<std::uint64_t, Index> m_springOf;
  std::unordered_map<std::uint64_t, std::size_t> m_strutOf; ///< asked only, never walked through
  double m_errorSum = 0.0, m_volume = 0.0;
};

double meanSide(const OutwardSurface& surface, const SpringNet& net)
{
  double sum = 0.0;
  for (const auto& triangle : surface.triangles().colwise())
    for (int k = 0; k < 3; ++k)
      sum += (net.restPosition.col(triangle[k]) - net.restPosition.col(triangle[(k + 1) % 3])).norm();
  return sum / (3.0 * static_cast<double>(surface.triangles().cols()));
}

std::string inMillimetres(double metres)
{
  return formatDouble(1e3 * metres, 3) + " mm";
}

} // namespace

Result<Layer> makeWall(const SpringNet& net, const SupportOptions& options, WorkControl* control)
{
  if (!(options.wallThickness > 0.0))
    return Error{ErrorCode::InvalidValue, "a wall needs a thickness above 0 m"};
  const OutwardSurface surface(net, control);
  if (stopWanted(control)) return cancelledError();
  const Result<WallOffset> offset = offsetInwards(net, surface, options.wallThickness, control);
  if (!offset) return offset.error();
  const double edge = meanSide(surface, net);
  const int layers =
    options.wallLayers > 0
      ? options.wallLayers
      : std::clamp(static_cast<int>(std::lround(options.wallThickness / edge)), 1, kMostChosenLayers);
  if (!(static_cast<double>(layers) * net.nodeCount() < kMostWallNodes))
    return Error{ErrorCode::InvalidValue,
                 "the wall would have millions of nodes; take fewer layers or a coarser mesh"};
  WallBuilder builder(net, surface, *offset, layers);
  if (!builder.fill(control)) return cancelledError();
  if (!(builder.volume() > 0.0))
    return Error{ErrorCode::EmptyResult, "the wall has no volume: the surface has no area"};
  Layer layer = std::move(builder.layer);
  layer.notes.push_back(
    "The wall is " + inMillimetres(options.wallThickness) + " thick, of " + std::to_string(layers) +
    (layers == 1 ? " layer" : " layers") + " of cells, and has " + formatDouble(1e6 * builder.volume(), 3) +
    " cm^3; its springs miss an even stiffness by " + formatDouble(100.0 * builder.meanCell(), 2) + " %.");
  if (offset->thinned > 0)
    layer.notes.push_back("At " + std::to_string(offset->thinned) +
                          " nodes the wall had to be thinner, down to " +
                          inMillimetres(offset->thinnest * options.wallThickness) +
                          ": the opposite wall is near there, or the surface bends sharply.");
  if (offset->crossing > 0)
    layer.notes.push_back(
      std::to_string(offset->crossing) +
      " triangles of the inner surface still run through others; repair the surface there.");
  return layer;
}

} // namespace esm::support
