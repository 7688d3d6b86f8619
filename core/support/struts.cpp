// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/net_builder.h"
#include "core/support/support_parts.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numbers>

namespace esm::support {

namespace {

/// Looks for the opposite wall.
class OppositeWall {
public:
  OppositeWall(const SpringNet& net, const SupportOptions& options, const OutwardSurface& surface)
    : m_net(net), m_options(options), m_surface(surface)
  {
    const Eigen::Vector3d extent =
      net.restPosition.rowwise().maxCoeff() - net.restPosition.rowwise().minCoeff();
    m_nearest = 1e-6 * extent.norm();
    m_farthest = options.longestStrut > 0.0 ? options.longestStrut : std::numeric_limits<double>::infinity();
  }

  /// The node of the surface that lies nearest to where the ray leaves the body; kNoIndex if it leaves
  /// nowhere.
  Index nodeBehind(Index node, const Eigen::Vector3d& direction) const
  {
    const Eigen::Vector3d origin = m_net.restPosition.col(node);
    const TriangleMatrix& triangles = m_surface.triangles();
    const RayHit hit =
      m_surface.tree().firstHit(origin, direction, m_nearest, std::numeric_limits<double>::infinity(),
                                [&](Index t) { return (triangles.col(t).array() == node).any(); });
    if (hit.triangle == kNoIndex || !(m_surface.triangleNormal(hit.triangle).dot(direction) > 0.0))
      return kNoIndex;
    const Eigen::Vector3d place = origin + hit.distance * direction;
    Index nearest = kNoIndex;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      const Index corner = triangles(k, hit.triangle);
      const double away = (m_net.restPosition.col(corner) - place).squaredNorm();
      if (away < least) {
        least = away;
        nearest = corner;
      }
    }
    const double length = (m_net.restPosition.col(nearest) - origin).norm();
    return length > m_nearest && length <= m_farthest ? nearest : kNoIndex;
  }

private:
  const SpringNet& m_net;
  const SupportOptions& m_options;
  const OutwardSurface& m_surface;
  double m_nearest, m_farthest;
};

/// The directions of a node's struts: along the inward normal, then around it. The ring is turned from node
/// to node by the golden angle, so that the struts of a patch look to all sides whatever the mesh.
Eigen::Matrix3Xd directionsAt(Index node, const Eigen::Vector3d& normal, const SupportOptions& options)
{
  const double goldenAngle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  Eigen::Matrix3Xd directions(3, options.strutsPerNode);
  const Eigen::Vector3d inward = -normal, side = inward.unitOrthogonal(), other = inward.cross(side);
  directions.col(0) = inward;
  const int around = options.strutsPerNode - 1;
  for (int i = 0; i < around; ++i) {
    const double angle = goldenAngle * (node % 1024) + 2.0 * std::numbers::pi * i / around;
    directions.col(1 + i) = std::cos(options.strutLean) * inward +
                            std::sin(options.strutLean) * (std::cos(angle) * side + std::sin(angle) * other);
  }
  return directions;
}

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
  std::vector<int> sharers(static_cast<std::size_t>(area.size()), 0);
  for (const Strut& strut : struts)
    for (const Index node : {strut.a, strut.b})
      if (areaOf(node) > 0.0) ++sharers[static_cast<std::size_t>(node)];
  for (Strut& strut : struts) {
    double sum = 0.0;
    int onSurface = 0;
    for (const Index node : {strut.a, strut.b})
      if (areaOf(node) > 0.0) {
        sum += areaOf(node) / sharers[static_cast<std::size_t>(node)];
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
  const OppositeWall wall(net, options, surface);
  JoinedPairs joined(net);
  Layer layer;
  std::vector<std::uint8_t> isHeld(static_cast<std::size_t>(net.nodeCount()), 0);
  for (Index node = 0; node < net.nodeCount(); ++node) {
    if (node % 64 == 0) {
      if (stopWanted(control)) return cancelledError();
      tellDone(control, static_cast<double>(node) / net.nodeCount());
    }
    if (!(normals.col(node).squaredNorm() > 0.5)) continue; // off the surface
    const Eigen::Matrix3Xd directions = directionsAt(node, normals.col(node), options);
    for (Eigen::Index i = 0; i < directions.cols(); ++i) {
      const Index opposite = wall.nodeBehind(node, directions.col(i));
      if (opposite == kNoIndex || !joined.join(node, opposite)) continue;
      layer.struts.push_back({node, opposite, 0.0});
      isHeld[static_cast<std::size_t>(node)] = isHeld[static_cast<std::size_t>(opposite)] = 1;
    }
  }
  for (Index node = 0; node < net.nodeCount(); ++node)
    if (!isHeld[static_cast<std::size_t>(node)] && normals.col(node).squaredNorm() > 0.5)
      layer.unsupported.push_back(node);
  shareSections(net, layer.struts);
  return layer;
}

} // namespace esm::support
