// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/distance.h"
#include "core/geometry/extent.h"
#include "core/structure/support_parts.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm::support {

namespace {

struct Middles {
  Eigen::Matrix3Xd place{3, 0}; ///< half-way to the opposite wall, per node of the surface that has one [m]
  std::vector<double> chord;    ///< as long is the way to that wall [m]
};

Middles findMiddles(const SpringNet& net, const OutwardSurface& surface, const Eigen::Matrix3Xd& normals,
                    WorkControl* control)
{
  Middles middles;
  middles.place.resize(3, net.nodeCount());
  const double nearest = 1e-6 * extentOf(net.restPosition);
  Eigen::Index count = 0;
  for (Index node = 0; node < net.nodeCount() && !stopWanted(control); ++node) {
    if (!(normals.col(node).squaredNorm() > 0.5)) continue;
    const Eigen::Vector3d origin = net.restPosition.col(node), inward = -normals.col(node);
    const RayHit hit =
      surface.tree().firstHit(origin, inward, nearest, std::numeric_limits<double>::infinity(),
                              [&](Index t) { return (surface.triangles().col(t).array() == node).any(); });
    if (hit.triangle == kNoIndex) continue;
    middles.place.col(count++) = origin + 0.5 * hit.distance * inward;
    middles.chord.push_back(hit.distance);
  }
  middles.place.conservativeResize(Eigen::NoChange, count);
  return middles;
}

/// Hubs in a row along the body, then moved to the middle of what lies nearest to each (Lloyd's algorithm).
Eigen::Matrix3Xd placeHubs(const Middles& middles, int wanted)
{
  constexpr int kRounds = 20;
  const Eigen::Vector3d centre = middles.place.rowwise().mean();
  const Eigen::Matrix3Xd away = middles.place.colwise() - centre;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(Eigen::Matrix3d(away * away.transpose()));
  const Eigen::Vector3d axis = solver.eigenvectors().col(2);
  const Eigen::VectorXd along = away.transpose() * axis;
  const double low = along.minCoeff(), length = along.maxCoeff() - low;
  if (wanted == 0) {
    std::vector<double> chords = middles.chord;
    std::nth_element(chords.begin(), chords.begin() + static_cast<std::ptrdiff_t>(chords.size() / 2),
                     chords.end());
    // The middles reach about half a chord less far than the body at each end.
    wanted = std::clamp(static_cast<int>(std::lround(length / chords[chords.size() / 2])) + 1, 1, 100);
  }
  Eigen::Matrix3Xd hubs(3, wanted);
  for (int h = 0; h < wanted; ++h) hubs.col(h) = centre + (low + length * (h + 0.5) / wanted) * axis;
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, hubs.cols());
    Eigen::ArrayXd count = Eigen::ArrayXd::Zero(hubs.cols());
    for (Eigen::Index i = 0; i < middles.place.cols(); ++i) {
      const Index hub = nearestOf(hubs, middles.place.col(i));
      sum.col(hub) += middles.place.col(i);
      count[hub] += 1.0;
    }
    for (Eigen::Index h = 0; h < hubs.cols(); ++h)
      if (count[h] > 0.0) hubs.col(h) = sum.col(h) / count[h];
  }
  return hubs;
}

} // namespace

Result<Layer> makeHubs(const SpringNet& net, const SupportOptions& options, WorkControl* control)
{
  const OutwardSurface surface(net, control);
  if (stopWanted(control)) return cancelledError();
  const Eigen::Matrix3Xd normals = surface.nodeNormals();
  const Middles middles = findMiddles(net, surface, normals, control);
  if (stopWanted(control)) return cancelledError();
  Layer layer;
  if (middles.place.cols() == 0) return layer; // nothing opposite anywhere
  layer.nodes = placeHubs(middles, options.hubs);
  const Index first = net.nodeCount();
  const auto hubs = static_cast<Index>(layer.nodes.cols());

  std::vector<Index> hubOf(static_cast<std::size_t>(net.nodeCount()), kNoIndex);
  for (Index node = 0; node < net.nodeCount(); ++node)
    if (normals.col(node).squaredNorm() > 0.5) {
      const Index hub = nearestOf(layer.nodes, net.restPosition.col(node));
      hubOf[static_cast<std::size_t>(node)] = hub;
      layer.struts.push_back({node, first + hub, 0.0});
    }
  shareSections(net, layer.struts);

  // Neighbours are joined: to each other, and by the spokes of the nodes between them to both.
  double volume = 0.0;
  for (const OutwardSurface::Part& part : surface.parts()) volume += part.volume;
  const double each = std::abs(volume) / hubs;
  layer.volume = Eigen::ArrayXd::Constant(hubs, 0.25 * each);
  JoinedPairs joined(net);
  for (const Strut& strut : layer.struts) joined.join(strut.a, strut.b);
  for (Index s = 0; s < net.springCount(); ++s) {
    const Index a = hubOf[static_cast<std::size_t>(net.ends(0, s))],
                b = hubOf[static_cast<std::size_t>(net.ends(1, s))];
    if (a == kNoIndex || b == kNoIndex || a == b) continue;
    const double length = (layer.nodes.col(a) - layer.nodes.col(b)).norm();
    if (length > 0.0 && joined.join(first + a, first + b))
      layer.struts.push_back({first + std::min(a, b), first + std::max(a, b), each / length});
  }
  return layer;
}

} // namespace esm::support
