// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/extent.h"
#include "core/net/net_builder.h"
#include "core/quality/tension_test.h"
#include "core/structure/support_parts.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace esm::support {

namespace {

/// Below this share of a hit triangle a corner gets no strut: it would cost as much as the others and hold
/// next to nothing.
constexpr double kLeastShare = 0.2;

/// Where a ray leaves the body: the corners of the triangle that it meets there, and how near it is to each.
struct Exit {
  Eigen::Vector3i corner = Eigen::Vector3i::Constant(kNoIndex);
  Eigen::Vector3d share = Eigen::Vector3d::Zero(); ///< barycentric, sum 1; all 0 if it leaves nowhere
};

/// Looks for the opposite wall.
class OppositeWall {
public:
  OppositeWall(const SpringNet& net, const OutwardSurface& surface) : m_net(net), m_surface(surface)
  {
    m_nearest = 1e-6 * extentOf(net.restPosition);
  }

  Exit behind(Index node, const Eigen::Vector3d& direction) const
  {
    const Eigen::Vector3d origin = m_net.restPosition.col(node);
    const TriangleMatrix& triangles = m_surface.triangles();
    const RayHit hit =
      m_surface.tree().firstHit(origin, direction, m_nearest, std::numeric_limits<double>::infinity(),
                                [&](Index t) { return (triangles.col(t).array() == node).any(); });
    Exit exit;
    if (hit.triangle == kNoIndex) return exit;
    const Eigen::Vector3d normal = m_surface.triangleNormal(hit.triangle);
    if (!(normal.dot(direction) > 0.0)) return exit;
    exit.corner = triangles.col(hit.triangle);
    const Eigen::Vector3d place = origin + hit.distance * direction;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d a = m_net.restPosition.col(exit.corner[(k + 1) % 3]),
                            b = m_net.restPosition.col(exit.corner[(k + 2) % 3]);
      const double share = (b - a).cross(place - a).dot(normal) / normal.squaredNorm();
      exit.share[k] = share < kLeastShare ? 0.0 : share;
    }
    exit.share /= exit.share.sum(); // one of the three is 1/3 at least
    return exit;
  }

private:
  const SpringNet& m_net;
  const OutwardSurface& m_surface;
  double m_nearest = 0.0;
};

/// The directions of a node's struts: along the inward normal, the others around it at equal angles. Where
/// the ring begins follows the body's length, so that it changes smoothly over the surface and is the same at
/// every mesh size: finer meshes then have more of the same struts.
Eigen::Matrix3Xd directionsAt(const Eigen::Vector3d& normal, const Eigen::Vector3d& lengthwise,
                              const SupportOptions& options)
{
  Eigen::Matrix3Xd directions(3, options.strutsPerNode);
  const Eigen::Vector3d inward = -normal, across = lengthwise.cross(inward);
  const Eigen::Vector3d round = across.norm() > 1e-6 ? across.normalized() : inward.unitOrthogonal(),
                        along = inward.cross(round);
  directions.col(0) = inward;
  const int around = options.strutsPerNode - 1;
  for (int i = 0; i < around; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.5) / around;
    directions.col(1 + i) = std::cos(options.strutLean) * inward +
                            std::sin(options.strutLean) * (std::cos(angle) * along + std::sin(angle) * round);
  }
  return directions;
}

/// Struts as they are found: those between the same two nodes are one.
class StrutList {
public:
  StrutList(const SpringNet& net, double longest) : m_net(net), m_longest(longest), m_present(net) {}

  /// @return false if a spring is there already, or the strut were too long.
  bool add(Index a, Index b, double weight)
  {
    if (a == b || m_present.has(a, b)) return false;
    const double length = (m_net.restPosition.col(a) - m_net.restPosition.col(b)).norm();
    if (!(length > 0.0) || (m_longest > 0.0 && length > m_longest)) return false;
    const auto [found, isNew] = m_place.try_emplace(pairKey(a, b), m_struts.size());
    if (isNew) m_struts.push_back({a, b, 0.0, 0.0});
    m_struts[found->second].weight += weight;
    return true;
  }
  std::vector<Strut> take() { return std::move(m_struts); }

private:
  const SpringNet& m_net;
  double m_longest;
  JoinedPairs m_present;
  std::unordered_map<std::uint64_t, std::size_t> m_place; ///< asked only, never walked through
  std::vector<Strut> m_struts;
};

} // namespace

JoinedPairs::JoinedPairs(const SpringNet& net)
{
  m_pairs.reserve(2 * static_cast<std::size_t>(net.springCount()));
  for (Index s = 0; s < net.springCount(); ++s) join(net.ends(0, s), net.ends(1, s));
}

void shareSections(const SpringNet& net, std::vector<Strut>& struts)
{
  const Eigen::ArrayXd area = nodeDualAreas(net);
  const auto areaOf = [&area](Index node) { return node < area.size() ? area[node] : 0.0; };
  Eigen::ArrayXd weights = Eigen::ArrayXd::Zero(area.size());
  for (const Strut& strut : struts)
    for (const Index node : {strut.a, strut.b})
      if (areaOf(node) > 0.0) weights[node] += strut.weight;
  for (Strut& strut : struts) {
    double sum = 0.0;
    int onSurface = 0;
    for (const Index node : {strut.a, strut.b})
      if (areaOf(node) > 0.0) {
        sum += areaOf(node) * strut.weight / weights[node];
        ++onSurface;
      }
    if (onSurface > 0) strut.section = sum / onSurface;
  }
}

Result<Layer> makeStruts(const SpringNet& net, const SupportOptions& options, WorkControl* control)
{
  const OutwardSurface surface(net, control);
  if (stopWanted(control)) return cancelledError();
  const Eigen::Matrix3Xd normals = surface.nodeNormals();
  const Eigen::ArrayXd area = nodeDualAreas(net);
  const Eigen::Vector3d lengthwise = longestAxis(net, area);
  const OppositeWall wall(net, surface);
  StrutList struts(net, options.longestStrut);
  Layer layer;
  std::vector<std::uint8_t> isHeld(static_cast<std::size_t>(net.nodeCount()), 0);
  for (Index node = 0; node < net.nodeCount(); ++node) {
    if (node % 64 == 0) {
      if (stopWanted(control)) return cancelledError();
      tellDone(control, static_cast<double>(node) / net.nodeCount());
    }
    if (!(normals.col(node).squaredNorm() > 0.5 && area[node] > 0.0)) continue; // off the surface
    const Eigen::Matrix3Xd directions = directionsAt(normals.col(node), lengthwise, options);
    for (Eigen::Index i = 0; i < directions.cols(); ++i) {
      const Exit exit = wall.behind(node, directions.col(i));
      for (int k = 0; k < 3; ++k)
        if (exit.share[k] > 0.0 && struts.add(node, exit.corner[k], area[node] * exit.share[k]))
          isHeld[static_cast<std::size_t>(node)] = isHeld[static_cast<std::size_t>(exit.corner[k])] = 1;
    }
  }
  for (Index node = 0; node < net.nodeCount(); ++node)
    if (!isHeld[static_cast<std::size_t>(node)] && normals.col(node).squaredNorm() > 0.5)
      layer.unsupported.push_back(node);
  layer.struts = struts.take();
  shareSections(net, layer.struts);
  return layer;
}

} // namespace esm::support
