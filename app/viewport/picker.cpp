// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/picker.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace esm {

namespace {

struct Candidate {
  Index node = kNoIndex;
  double pixels = 0.0; ///< from the click
  double depth = 0.0;  ///< [m]
};

constexpr std::size_t kMaxTested = 64; ///< nearest candidates; more are there only when zoomed far out
constexpr double kSlack = 0.5;     ///< a triangle hides a node only if it lies this much before it [pixels]
constexpr double kSameFront = 6.0; ///< depth that still counts as "in front", in pick radii

/// Nodes within the radius, nearest to the click first.
std::vector<Candidate> candidates(const Camera& camera, const Eigen::Matrix3Xd& position,
                                  const Eigen::Vector2d& pixel, double radius)
{
  std::vector<Candidate> found;
  const Projector project = camera.projector();
  for (Eigen::Index i = 0; i < position.cols(); ++i) {
    const ScreenPoint at = project(position.col(i));
    const double pixels = (at.pixel - pixel).norm();
    if (pixels <= radius) found.push_back({static_cast<Index>(i), pixels, at.depth}); // false for NaN
  }
  std::sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    return a.pixels != b.pixels ? a.pixels < b.pixels : a.depth < b.depth;
  });
  if (found.size() > kMaxTested) found.resize(kMaxTested);
  return found;
}

/// Whether a triangle that does not own the node lies between it and the eye.
bool hidden(const Camera& camera, const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles,
            Index node)
{
  const Eigen::Vector3d target = position.col(node);
  const Ray ray = camera.rayThrough(camera.project(target).pixel);
  const double reach = (target - ray.origin).norm();
  const double closest = reach - kSlack * camera.metresPerPixel(target);
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const Index a = triangles(0, t), b = triangles(1, t), c = triangles(2, t);
    if (a == node || b == node || c == node) continue;
    const auto hit = hitTriangle(ray, position.col(a), position.col(b), position.col(c));
    if (hit && *hit < closest) return true;
  }
  return false;
}

} // namespace

std::optional<double> hitTriangle(const Ray& ray, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  const Eigen::Vector3d& c)
{
  const Eigen::Vector3d ab = b - a, ac = c - a;
  const Eigen::Vector3d p = ray.direction.cross(ac);
  const double determinant = ab.dot(p);
  if (std::abs(determinant) <= 1e-12 * ab.norm() * ac.norm()) return std::nullopt;
  const Eigen::Vector3d fromA = ray.origin - a;
  const double u = fromA.dot(p) / determinant;
  if (u < 0.0 || u > 1.0) return std::nullopt;
  const Eigen::Vector3d q = fromA.cross(ab);
  const double v = ray.direction.dot(q) / determinant;
  if (v < 0.0 || u + v > 1.0) return std::nullopt;
  const double along = ac.dot(q) / determinant;
  if (along <= 0.0) return std::nullopt;
  return along;
}

Index pickNode(const Camera& camera, const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles,
               const Eigen::Vector2d& pixel, double radius)
{
  std::vector<Candidate> seen;
  for (const Candidate& candidate : candidates(camera, position, pixel, radius))
    if (!hidden(camera, position, triangles, candidate.node)) seen.push_back(candidate);
  if (seen.empty()) return kNoIndex;

  const auto front = std::min_element(
    seen.begin(), seen.end(), [](const Candidate& a, const Candidate& b) { return a.depth < b.depth; });
  const double limit = front->depth + kSameFront * radius * camera.metresPerPixel(position.col(front->node));
  for (const Candidate& candidate : seen) // nearest to the click first
    if (candidate.depth <= limit) return candidate.node;
  return front->node;
}

} // namespace esm
