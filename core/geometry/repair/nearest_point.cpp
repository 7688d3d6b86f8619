// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/repair/nearest_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace esm {

namespace {

/// Single precision of the boxes and of the point is taken off their distance: no box is passed over wrongly.
constexpr float kSlack = 1e-6f;

/// Puts two zero bits before each of the ten low ones.
std::uint32_t spread(std::uint32_t x)
{
  x = (x | (x << 16)) & 0x030000ffu;
  x = (x | (x << 8)) & 0x0300f00fu;
  x = (x | (x << 4)) & 0x030c30c3u;
  return (x | (x << 2)) & 0x09249249u;
}

/// The largest float that is no larger.
float roundedDown(double x)
{
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) <= x ? f : std::nextafter(f, -std::numeric_limits<float>::infinity());
}

struct Key {
  std::uint32_t code;
  Index triangle;
};

/// By code; equal codes keep their order (radix sort, three digits).
void sortKeys(std::vector<Key>& keys)
{
  std::vector<Key> other(keys.size());
  for (int shift = 0; shift < 30; shift += 10) {
    std::array<std::size_t, 1025> start{};
    for (const Key& key : keys) ++start[(key.code >> shift & 1023u) + 1];
    for (std::size_t d = 1; d < start.size(); ++d) start[d] += start[d - 1];
    for (const Key& key : keys) other[start[key.code >> shift & 1023u]++] = key;
    keys.swap(other);
  }
}

} // namespace

/// Ericson, Real-Time Collision Detection (2005), 5.1.5; the sides are taken one by one where there is no
/// area.
Eigen::Vector3d nearestOnTriangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                  const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const Eigen::Vector3d ab = b - a, ac = c - a, ap = p - a;
  const Eigen::Vector3d normal = ab.cross(ac);
  const double area2 = normal.squaredNorm();
  if (area2 > 0.0) {
    const double v = normal.dot(ap.cross(ac)) / area2, w = normal.dot(ab.cross(ap)) / area2;
    if (v >= 0.0 && w >= 0.0 && v + w <= 1.0) return a + v * ab + w * ac;
  }
  const auto onSide = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& side) -> Eigen::Vector3d {
    const double length2 = side.squaredNorm();
    const double t = length2 > 0.0 ? std::clamp((p - from).dot(side) / length2, 0.0, 1.0) : 0.0;
    return from + t * side;
  };
  Eigen::Vector3d best = onSide(a, ab);
  for (const Eigen::Vector3d& other : {onSide(b, c - b), onSide(c, -ac)})
    if ((other - p).squaredNorm() < (best - p).squaredNorm()) best = other;
  return best;
}

std::vector<Index> spatialOrder(const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles)
{
  const auto count = static_cast<Index>(triangles.cols());
  if (count == 0) return {};
  const auto middle = [&](Index t) -> Eigen::Vector3d {
    return position.col(triangles(0, t)) + position.col(triangles(1, t)) + position.col(triangles(2, t));
  };
  Eigen::Vector3d low = middle(0), high = low;
  for (Index t = 1; t < count; ++t) {
    low = low.cwiseMin(middle(t));
    high = high.cwiseMax(middle(t));
  }
  const double size = (high - low).maxCoeff();
  const double scale = size > 0.0 ? 1023.0 / size : 0.0;
  std::vector<Key> keys(at(count));
  for (Index t = 0; t < count; ++t) {
    const Eigen::Vector3d cell = (middle(t) - low) * scale;
    std::uint32_t code = 0;
    for (int k = 0; k < 3; ++k)
      code |= spread(cell[k] > 0.0 ? static_cast<std::uint32_t>(std::min(cell[k], 1023.0)) : 0u) << k;
    keys[at(t)] = {code, t};
  }
  sortKeys(keys);
  std::vector<Index> order(at(count));
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = keys[i].triangle;
  return order;
}

NearestPoint::NearestPoint(const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles)
  : m_position(position), m_triangles(triangles)
{
  constexpr float kFar = std::numeric_limits<float>::infinity();
  Boxes none;
  for (auto& axis : none.low) axis.fill(kFar);
  for (auto& axis : none.high) axis.fill(-kFar);
  // Level 0 has a box per four triangles, each further level one per eight boxes.
  Index boxes = (static_cast<Index>(triangles.cols()) + kLeafSize - 1) / kLeafSize;
  for (Index level = 0; boxes > 0; ++level) {
    const auto start = static_cast<Index>(m_boxes.size());
    m_levelStart.push_back(start);
    m_boxes.resize(m_boxes.size() + at((boxes + kWidth - 1) / kWidth), none);
    for (Index i = 0; i < boxes; ++i) {
      Boxes& into = m_boxes[at(start + i / kWidth)];
      const auto lane = at(i % kWidth);
      const auto take = [&](int axis, float low, float high) {
        auto& from = into.low[static_cast<std::size_t>(axis)][lane];
        auto& to = into.high[static_cast<std::size_t>(axis)][lane];
        from = std::min(from, low);
        to = std::max(to, high);
      };
      if (level == 0) {
        const Index end = std::min((i + 1) * kLeafSize, static_cast<Index>(triangles.cols()));
        for (Index c = 3 * kLeafSize * i; c < 3 * end; ++c)
          for (int axis = 0; axis < 3; ++axis) {
            const double x = position(axis, triangles.data()[c]);
            take(axis, roundedDown(x), -roundedDown(-x));
          }
      } else {
        const Boxes& below = m_boxes[at(m_levelStart[at(level - 1)] + i)];
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (std::size_t k = 0; k < below.low[axis].size(); ++k)
            take(static_cast<int>(axis), below.low[axis][k], below.high[axis][k]);
      }
    }
    if (boxes == 1) break;
    boxes = (boxes + kWidth - 1) / kWidth;
  }
}

std::array<float, NearestPoint::kWidth> NearestPoint::squaredDistances(const Boxes& boxes,
                                                                       const Eigen::Vector3f& p) const
{
  std::array<float, kWidth> squared{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float x = p[static_cast<Eigen::Index>(axis)];
    for (std::size_t k = 0; k < squared.size(); ++k) {
      const float outside =
        std::max(std::max(boxes.low[axis][k] - x, x - boxes.high[axis][k]) - kSlack, 0.0f);
      squared[k] += outside * outside;
    }
  }
  return squared;
}

Eigen::Vector3d NearestPoint::areaVector(Index t) const
{
  const Eigen::Vector3d a = m_position.col(m_triangles(0, t)), u = m_position.col(m_triangles(1, t)) - a,
                        v = m_position.col(m_triangles(2, t)) - a;
  return u.cross(v);
}

} // namespace esm
