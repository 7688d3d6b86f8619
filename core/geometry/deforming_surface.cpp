// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/deforming_surface.h"

#include "core/geometry/nearest_weights.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace esm {

namespace {

constexpr Index kLeaf = 4;
constexpr std::size_t kDeepest = 64; ///< halving: 2^64 triangles

double squaredDistance(const Eigen::Vector3d& point, const Eigen::Vector3d& low, const Eigen::Vector3d& high)
{
  return (low - point).cwiseMax(point - high).cwiseMax(0.0).squaredNorm();
}

/// Whether the stretch from + t way, t in [0, most], meets the box.
bool meets(const Eigen::Vector3d& low, const Eigen::Vector3d& high, const Eigen::Vector3d& from,
           const Eigen::Vector3d& way, double most)
{
  double begin = 0.0, end = most;
  for (int axis = 0; axis < 3; ++axis) {
    if (way[axis] == 0.0) {
      if (from[axis] < low[axis] || from[axis] > high[axis]) return false;
      continue;
    }
    double enter = (low[axis] - from[axis]) / way[axis], leave = (high[axis] - from[axis]) / way[axis];
    if (enter > leave) std::swap(enter, leave);
    begin = std::max(begin, enter);
    end = std::min(end, leave);
  }
  return begin <= end * (1.0 + 1e-12);
}

struct Hit {
  double t;
  Eigen::Vector3d weight;
};

/// Moeller and Trumbore 1997.
std::optional<Hit> hit(const Eigen::Vector3d& from, const Eigen::Vector3d& way, const Eigen::Vector3d& a,
                       const Eigen::Vector3d& b, const Eigen::Vector3d& c, bool onlyFront)
{
  const Eigen::Vector3d u = b - a, v = c - a, normal = u.cross(v);
  const double slope = -normal.dot(way);
  if (slope == 0.0 || (onlyFront && slope < 0.0)) return std::nullopt;
  const Eigen::Vector3d apart = from - a, turned = way.cross(apart);
  const double t = normal.dot(apart) / slope;
  const double second = -v.dot(turned) / slope, third = u.dot(turned) / slope;
  constexpr double kRounding = 1e-9; // a way through a shared edge hits one of its triangles at least
  if (t < 0.0 || t > 1.0 || second < -kRounding || third < -kRounding || second + third > 1.0 + kRounding)
    return std::nullopt;
  Eigen::Vector3d weight(1.0 - second - third, second, third);
  weight = weight.cwiseMax(0.0);
  return Hit{t, weight / weight.sum()};
}

} // namespace

DeformingSurface::DeformingSurface(const TriangleMatrix& triangles, const Eigen::Matrix3Xd& position)
  : m_triangles(triangles), m_position(position), m_order(static_cast<std::size_t>(triangles.cols()))
{
  if (m_order.empty()) return;
  Eigen::Matrix3Xd centre(3, triangles.cols());
  for (Index t = 0; t < triangles.cols(); ++t) {
    m_order[static_cast<std::size_t>(t)] = t;
    centre.col(t) = (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3.0;
  }
  m_boxes.reserve(m_order.size());
  m_boxes.emplace_back();
  build(0, 0, static_cast<Index>(m_order.size()), centre);
  refit(position);
}

void DeformingSurface::build(std::size_t box, Index first, Index count, const Eigen::Matrix3Xd& centre)
{
  if (count <= kLeaf) {
    m_boxes[box].first = first;
    m_boxes[box].count = count;
    return;
  }
  const auto begin = m_order.begin() + first;
  Eigen::Vector3d low = centre.col(*begin), high = low;
  for (Index i = 1; i < count; ++i) {
    low = low.cwiseMin(centre.col(begin[i]));
    high = high.cwiseMax(centre.col(begin[i]));
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const Index half = count / 2;
  std::nth_element(begin, begin + half, begin + count, [&](Index a, Index b) {
    return centre(axis, a) != centre(axis, b) ? centre(axis, a) < centre(axis, b) : a < b;
  });
  const std::size_t children = m_boxes.size();
  m_boxes[box].first = static_cast<Index>(children);
  m_boxes.resize(children + 2);
  build(children, first, half, centre);
  build(children + 1, first + half, count - half, centre);
}

void DeformingSurface::refit(const Eigen::Matrix3Xd& position) noexcept
{
  m_position = position; // same size: no allocation
  for (std::size_t b = m_boxes.size(); b-- > 0;) {
    Box& box = m_boxes[b];
    if (box.count > 0) {
      box.low = box.high = corner(m_order[static_cast<std::size_t>(box.first)], 0);
      for (Index i = 0; i < box.count; ++i)
        for (int k = 0; k < 3; ++k) {
          const Eigen::Vector3d p = corner(m_order[static_cast<std::size_t>(box.first + i)], k);
          box.low = box.low.cwiseMin(p);
          box.high = box.high.cwiseMax(p);
        }
    } else {
      const Box &left = m_boxes[static_cast<std::size_t>(box.first)],
                &right = m_boxes[static_cast<std::size_t>(box.first) + 1];
      box.low = left.low.cwiseMin(right.low);
      box.high = left.high.cwiseMax(right.high);
    }
  }
}

std::optional<SurfacePoint> DeformingSurface::nearest(const Eigen::Vector3d& point,
                                                      double within) const noexcept
{
  SurfacePoint best;
  double bound = within * within;
  std::array<std::size_t, kDeepest> stack{};
  std::size_t height = 0;
  if (!m_boxes.empty()) stack[height++] = 0;
  while (height > 0) {
    const Box& box = m_boxes[stack[--height]];
    if (squaredDistance(point, box.low, box.high) > bound) continue;
    if (box.count == 0) {
      const auto left = static_cast<std::size_t>(box.first);
      const double near = squaredDistance(point, m_boxes[left].low, m_boxes[left].high),
                   far = squaredDistance(point, m_boxes[left + 1].low, m_boxes[left + 1].high);
      stack[height++] = near <= far ? left + 1 : left; // the nearer one is looked at first
      stack[height++] = near <= far ? left : left + 1;
      continue;
    }
    for (Index i = 0; i < box.count; ++i) {
      const Index t = m_order[static_cast<std::size_t>(box.first + i)];
      const Eigen::Vector3d weight = nearestWeights(point, corner(t, 0), corner(t, 1), corner(t, 2));
      const double squared = (pointAt({t, weight}) - point).squaredNorm();
      if (squared > bound || (squared == bound && best.triangle != kNoIndex && t > best.triangle)) continue;
      bound = squared;
      best = {t, weight};
    }
  }
  if (best.triangle == kNoIndex) return std::nullopt;
  return best;
}

std::optional<SurfacePoint> DeformingSurface::firstHit(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                                       bool onlyFront) const noexcept
{
  const Eigen::Vector3d way = to - from;
  SurfacePoint best;
  double first = 1.0;
  std::array<std::size_t, kDeepest> stack{};
  std::size_t height = 0;
  if (!m_boxes.empty()) stack[height++] = 0;
  while (height > 0) {
    const Box& box = m_boxes[stack[--height]];
    if (!meets(box.low, box.high, from, way, first)) continue;
    if (box.count == 0) {
      stack[height++] = static_cast<std::size_t>(box.first) + 1;
      stack[height++] = static_cast<std::size_t>(box.first);
      continue;
    }
    for (Index i = 0; i < box.count; ++i) {
      const Index t = m_order[static_cast<std::size_t>(box.first + i)];
      const auto found = hit(from, way, corner(t, 0), corner(t, 1), corner(t, 2), onlyFront);
      if (!found || found->t > first) continue;
      if (found->t == first && best.triangle != kNoIndex && t > best.triangle) continue;
      first = found->t;
      best = {t, found->weight};
    }
  }
  if (best.triangle == kNoIndex) return std::nullopt;
  return best;
}

Eigen::Vector3d DeformingSurface::pointAt(const SurfacePoint& point) const noexcept
{
  return point.weight[0] * corner(point.triangle, 0) + point.weight[1] * corner(point.triangle, 1) +
         point.weight[2] * corner(point.triangle, 2);
}

} // namespace esm
