// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/repair/nearest_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>

namespace esm {

namespace {

constexpr Index kLeafSize = 4;

std::size_t at(Index i)
{
  return static_cast<std::size_t>(i);
}

/// Puts two zero bits before each of the ten low ones.
std::uint32_t spread(std::uint32_t x)
{
  x = (x | (x << 16)) & 0x030000ffu;
  x = (x | (x << 8)) & 0x0300f00fu;
  x = (x | (x << 4)) & 0x030c30c3u;
  return (x | (x << 2)) & 0x09249249u;
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
      code |= spread(static_cast<std::uint32_t>(std::clamp(cell[k], 0.0, 1023.0))) << k;
    keys[at(t)] = {code, t};
  }
  sortKeys(keys);
  std::vector<Index> order(at(count));
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = keys[i].triangle;
  return order;
}

NearestPoint::NearestPoint(const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles)
  : m_position(position), m_triangles(triangles), m_order(spatialOrder(position, triangles))
{
  const auto count = static_cast<Index>(m_order.size());
  Index leaves = 1;
  while (leaves * kLeafSize < count) leaves *= 2;
  m_firstLeaf = leaves - 1;
  m_boxes.resize(at(2 * leaves - 1));
  for (Index i = 0; i < count; ++i) {
    Box& box = m_boxes[at(m_firstLeaf + i / kLeafSize)];
    for (int k = 0; k < 3; ++k) {
      const auto corner = position.col(triangles(k, m_order[at(i)]));
      box.low = box.low.cwiseMin(corner);
      box.high = box.high.cwiseMax(corner);
    }
  }
  for (Index i = m_firstLeaf - 1; i >= 0; --i) {
    const Box &left = m_boxes[at(2 * i + 1)], &right = m_boxes[at(2 * i + 2)];
    m_boxes[at(i)].low = left.low.cwiseMin(right.low);
    m_boxes[at(i)].high = left.high.cwiseMax(right.high);
  }
}

/// Infinite for empty boxes.
double NearestPoint::squaredDistance(const Box& box, const Eigen::Vector3d& p) const
{
  const Eigen::Vector3d below = box.low - p, above = p - box.high;
  return below.cwiseMax(above).cwiseMax(0.0).squaredNorm();
}

Eigen::Vector3d NearestPoint::find(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) const
{
  struct Entry {
    Index box;
    double squared;
  };
  std::array<Entry, 64> stack; // two per level at most
  std::size_t depth = 0;
  stack[depth++] = {0, squaredDistance(m_boxes[0], p)};
  Eigen::Vector3d nearest = p;
  double least = std::numeric_limits<double>::infinity();
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (!(entry.squared < least)) continue;
    if (entry.box < m_firstLeaf) {
      Entry left{2 * entry.box + 1, 0.0}, right{2 * entry.box + 2, 0.0};
      left.squared = squaredDistance(m_boxes[at(left.box)], p);
      right.squared = squaredDistance(m_boxes[at(right.box)], p);
      if (left.squared < right.squared) std::swap(left, right); // the nearer one is looked at first
      if (left.squared < least) stack[depth++] = left;
      if (right.squared < least) stack[depth++] = right;
      continue;
    }
    const auto begin = static_cast<std::size_t>(entry.box - m_firstLeaf) * kLeafSize;
    for (std::size_t i = begin; i < std::min(begin + kLeafSize, m_order.size()); ++i) {
      const Index* corner = m_triangles.data() + 3 * std::ptrdiff_t{m_order[i]};
      const Eigen::Vector3d a = m_position.col(corner[0]), b = m_position.col(corner[1]),
                            c = m_position.col(corner[2]);
      const Eigen::Vector3d point = nearestOnTriangle(p, a, b, c);
      const double squared = (point - p).squaredNorm();
      if (squared < least && (b - a).cross(c - a).dot(normal) >= 0.0) {
        least = squared;
        nearest = point;
      }
    }
  }
  return nearest;
}

} // namespace esm
