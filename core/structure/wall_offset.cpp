// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/structure/wall_offset.h"

#include "core/base/text_number.h"
#include "core/geometry/edge_table.h"
#include "core/geometry/self_intersections.h"
#include "core/net/net_builder.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace esm::support {

namespace {

constexpr double kOppositeShare = 0.4;  ///< of the way to the opposite wall
constexpr double kGrading = 0.5;        ///< of the thickness along the surface
constexpr double kLeastInnerArea = 0.1; ///< of an inner triangle, in outer ones
constexpr double kThinning = 0.8;       ///< of the thickness, where it does not fit
constexpr double kThinnestWall = 0.02;  ///< of the wished thickness: thinner makes no wall
constexpr double kLongestWay = 2.0;     ///< of a node's way at an edge or tip, in thicknesses
constexpr int kSmoothings = 4;          ///< of ways that cross, before the wall is made thinner
constexpr int kMostOffsetRounds = 60;
constexpr double kUnspoken = 0.05; ///< of the largest eigenvalue: directions that no face speaks of

/// What the work needs of the surface.
class Offset {
public:
  Offset(const SpringNet& net, const OutwardSurface& surface, double thickness, WorkControl* control)
    : m_net(net), m_surface(surface), m_thickness(thickness), m_control(control)
  {
    Mesh mesh;
    mesh.position = net.restPosition;
    mesh.triangles = surface.triangles();
    m_edges = listEdges(mesh, control).ends;
    const auto nodes = static_cast<std::size_t>(net.nodeCount());
    m_isOn.assign(nodes, 0);
    for (const Index node : mesh.triangles.reshaped()) m_isOn[static_cast<std::size_t>(node)] = 1;
    m_neighbours.resize(nodes);
    for (const auto& edge : m_edges.colwise()) {
      m_neighbours[static_cast<std::size_t>(edge[0])].push_back(edge[1]);
      m_neighbours[static_cast<std::size_t>(edge[1])].push_back(edge[0]);
    }
  }

  Result<WallOffset> make()
  {
    findWays();
    m_share = Eigen::ArrayXd::Ones(m_net.nodeCount());
    keepFromOpposite();
    for (int round = 0; round < kMostOffsetRounds; ++round) {
      if (stopWanted(m_control)) return cancelledError();
      grade();
      std::vector<std::uint8_t> bad = foldedNodes();
      if (!isAny(bad)) bad = crossingNodes();
      if (!isAny(bad)) break;
      if (round < kSmoothings)
        smooth(bad);
      else
        thin(bad);
    }
    if (stopWanted(m_control)) return cancelledError();
    return report();
  }

private:
  static bool isAny(const std::vector<std::uint8_t>& marks)
  {
    return std::find(marks.begin(), marks.end(), 1) != marks.end();
  }

  /// The shortest way after which all faces around a node lie one thickness deeper, by least squares.
  void findWays()
  {
    const auto nodes = m_net.nodeCount();
    std::vector<Eigen::Matrix3d> matrix(static_cast<std::size_t>(nodes), Eigen::Matrix3d::Zero());
    Eigen::Matrix3Xd right = Eigen::Matrix3Xd::Zero(3, nodes);
    const TriangleMatrix& triangles = m_surface.triangles();
    for (Index t = 0; t < static_cast<Index>(triangles.cols()); ++t) {
      const Eigen::Vector3d normal = m_surface.triangleNormal(t).normalized();
      for (int k = 0; k < 3; ++k) {
        const Index node = triangles(k, t);
        const Eigen::Vector3d here = m_net.restPosition.col(node);
        const Eigen::Vector3d u = m_net.restPosition.col(triangles((k + 1) % 3, t)) - here,
                              v = m_net.restPosition.col(triangles((k + 2) % 3, t)) - here;
        const double angle = std::atan2(u.cross(v).norm(), u.dot(v));
        matrix[static_cast<std::size_t>(node)] += angle * normal * normal.transpose();
        right.col(node) -= angle * m_thickness * normal;
      }
    }
    m_way = Eigen::Matrix3Xd::Zero(3, nodes);
    const Eigen::Matrix3Xd normals = m_surface.nodeNormals();
    for (Index node = 0; node < nodes; ++node) {
      if (!m_isOn[static_cast<std::size_t>(node)]) continue;
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix[static_cast<std::size_t>(node)]);
      Eigen::Vector3d way = Eigen::Vector3d::Zero();
      for (int k = 0; k < 3; ++k)
        if (solver.eigenvalues()[k] > kUnspoken * solver.eigenvalues()[2])
          way += solver.eigenvectors().col(k) *
                 (solver.eigenvectors().col(k).dot(right.col(node)) / solver.eigenvalues()[k]);
      const double length = way.norm();
      if (!(way.dot(normals.col(node)) < -0.3 * length)) // a tip or a fold: no face decides
        way = -m_thickness * normals.col(node);
      else if (length > kLongestWay * m_thickness)
        way *= kLongestWay * m_thickness / length;
      m_way.col(node) = way;
    }
  }

  void keepFromOpposite()
  {
    const TriangleMatrix& triangles = m_surface.triangles();
    for (Index node = 0; node < m_net.nodeCount(); ++node) {
      const double length = m_way.col(node).norm();
      if (!(length > 0.0)) continue;
      const Eigen::Vector3d inwards = m_way.col(node) / length;
      const auto isOwn = [&](Index t) { return (triangles.col(t).array() == node).any(); };
      const RayHit hit = m_surface.tree().firstHit(m_net.restPosition.col(node), inwards, 1e-9 * m_thickness,
                                                   std::numeric_limits<double>::infinity(), isOwn);
      if (hit.triangle != kNoIndex && m_surface.triangleNormal(hit.triangle).dot(inwards) > 0.0)
        m_share[node] = std::min(1.0, kOppositeShare * hit.distance / length);
    }
  }

  /// The thickest wall below the present one whose thickness changes gradually: a shortest way over the edges.
  void grade()
  {
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (Index node = 0; node < m_net.nodeCount(); ++node)
      if (m_isOn[static_cast<std::size_t>(node)] && m_share[node] < 1.0) queue.emplace(m_share[node], node);
    while (!queue.empty()) {
      const auto [share, node] = queue.top();
      queue.pop();
      if (share > m_share[node]) continue;
      for (const Index next : m_neighbours[static_cast<std::size_t>(node)]) {
        const double way = (m_net.restPosition.col(next) - m_net.restPosition.col(node)).norm();
        const double most = share + kGrading * way / m_thickness;
        if (!(most < m_share[next])) continue;
        m_share[next] = most;
        queue.emplace(most, next);
      }
    }
  }

  Eigen::Vector3d inner(Index node) const
  {
    return m_net.restPosition.col(node) + m_share[node] * m_way.col(node);
  }

  /// Corners of prisms whose inner triangle is turned over or nearly gone.
  std::vector<std::uint8_t> foldedNodes() const
  {
    std::vector<std::uint8_t> bad(m_isOn.size(), 0);
    const TriangleMatrix& triangles = m_surface.triangles();
    for (Index t = 0; t < static_cast<Index>(triangles.cols()); ++t) {
      const Eigen::Vector3d outer = m_surface.triangleNormal(t);
      if (!(outer.squaredNorm() > 0.0)) continue;
      const Eigen::Vector3d a = inner(triangles(0, t)), b = inner(triangles(1, t)),
                            c = inner(triangles(2, t));
      if ((b - a).cross(c - a).dot(outer) >= kLeastInnerArea * outer.squaredNorm()) continue;
      for (int k = 0; k < 3; ++k)
        if (m_share[triangles(k, t)] > kThinnestWall) bad[static_cast<std::size_t>(triangles(k, t))] = 1;
    }
    return bad;
  }

  /// Corners of inner triangles that run through inner or outer ones.
  std::vector<std::uint8_t> crossingNodes()
  {
    const TriangleMatrix& triangles = m_surface.triangles();
    const Index count = static_cast<Index>(triangles.cols()), nodes = m_net.nodeCount();
    Mesh both;
    both.position.resize(3, 2 * nodes);
    both.position.leftCols(nodes) = m_net.restPosition;
    for (Index node = 0; node < nodes; ++node) both.position.col(nodes + node) = inner(node);
    both.triangles.resize(3, 2 * count);
    both.triangles << triangles, (triangles.array() + nodes).matrix();
    std::vector<std::uint8_t> bad(m_isOn.size(), 0);
    m_crossing = 0;
    for (const SelfIntersection& pair :
         findSelfIntersections(both, 0.0, static_cast<std::size_t>(2 * count), m_control).pairs)
      for (const Index t : {pair.first, pair.second}) {
        if (pair.second < count) continue; // the outer surface is as it came
        ++m_crossing;
        for (int k = 0; k < 3; ++k)
          if (const Index node = triangles(k, t % count); m_share[node] > kThinnestWall)
            bad[static_cast<std::size_t>(node)] = 1;
      }
    return bad;
  }

  void smooth(const std::vector<std::uint8_t>& bad)
  {
    const Eigen::Matrix3Xd before = m_way;
    for (Index node = 0; node < m_net.nodeCount(); ++node) {
      if (!bad[static_cast<std::size_t>(node)]) continue;
      Eigen::Vector3d sum = before.col(node);
      for (const Index next : m_neighbours[static_cast<std::size_t>(node)]) sum += before.col(next);
      const double length = before.col(node).norm();
      if (sum.norm() > 1e-6 * length) m_way.col(node) = length * sum.normalized();
    }
  }

  void thin(const std::vector<std::uint8_t>& bad)
  {
    for (Index node = 0; node < m_net.nodeCount(); ++node)
      if (bad[static_cast<std::size_t>(node)])
        m_share[node] = std::max(kThinnestWall, kThinning * m_share[node]);
  }

  Result<WallOffset> report() const
  {
    WallOffset offset;
    offset.isOn = m_isOn;
    offset.depth = m_way * m_share.matrix().asDiagonal();
    offset.crossing = m_crossing;
    offset.thinnest = 1.0;
    const Eigen::ArrayXd area = nodeDualAreas(m_net);
    double thin = 0.0, widest = 0.0;
    for (Index node = 0; node < m_net.nodeCount(); ++node) {
      if (!m_isOn[static_cast<std::size_t>(node)]) continue;
      widest = std::max(widest, m_share[node]);
      if (m_share[node] < 0.5) thin += area[node];
      if (!(m_share[node] < 1.0)) continue;
      ++offset.thinned;
      offset.thinnest = std::min(offset.thinnest, m_share[node]);
    }
    if (thin > 0.5 * area.sum())
      return Error{ErrorCode::InvalidValue,
                   "a wall of " + formatDouble(1e3 * m_thickness, 3) +
                     " mm has no room in most of the body; choose a thinner wall (up to " +
                     formatDouble(1e3 * m_thickness * widest, 2) +
                     " mm fit at the widest place), or a lattice"};
    return offset;
  }

  const SpringNet& m_net;
  const OutwardSurface& m_surface;
  double m_thickness;
  WorkControl* m_control;
  SegmentMatrix m_edges;
  std::vector<std::uint8_t> m_isOn;
  std::vector<std::vector<Index>> m_neighbours;
  Eigen::Matrix3Xd m_way; ///< for the wished thickness [m]
  Eigen::ArrayXd m_share; ///< of it, in [0, 1]
  Index m_crossing = 0;
};

} // namespace

Result<WallOffset> offsetInwards(const SpringNet& net, const OutwardSurface& surface, double thickness,
                                 WorkControl* control)
{
  for (const OutwardSurface::Part& part : surface.parts()) {
    if (!part.isOriented)
      return Error{
        ErrorCode::InvalidValue,
        "the surface has no inside (an edge of three triangles, or one side only), so a wall cannot "
        "lie on it; repair it, or choose struts"};
    if (part.isCavity)
      return Error{ErrorCode::InvalidValue,
                   "the body has a cavity in the file, so its wall is there already; choose struts or "
                   "tetrahedra, or import the outer surface alone"};
  }
  return Offset(net, surface, thickness, control).make();
}

} // namespace esm::support
