// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/repair/loop_triangulation.h"

#include <Eigen/Geometry>

#include <limits>

namespace esm {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::size_t kLargestWhole = 200;

using Triangles = std::vector<std::array<Index, 3>>;

class LoopTriangulation {
public:
  LoopTriangulation(const std::vector<Eigen::Vector3d>& points,
                    const std::function<bool(Index, Index)>& isAllowed)
    : m_points(points), m_isAllowed(isAllowed)
  {
    double length = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
      length += (points[i] - points[i == 0 ? points.size() - 1 : i - 1]).norm();
    m_diagonalWeight = 1e-3 * length; // area counts first, diagonals decide between equal areas
  }

  /// @param loop  places, at least three. @return false if it cannot be done.
  bool add(const std::vector<Index>& loop, Triangles& triangles)
  {
    if (loop.size() <= kLargestWhole) return addWhole(loop, triangles);
    std::size_t first = 0, last = 0;
    if (!findCut(loop, first, last)) return false;
    std::vector<Index> inner(loop.begin() + static_cast<std::ptrdiff_t>(first),
                             loop.begin() + static_cast<std::ptrdiff_t>(last) + 1),
      outer(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first) + 1);
    outer.insert(outer.end(), loop.begin() + static_cast<std::ptrdiff_t>(last), loop.end());
    return add(inner, triangles) && add(outer, triangles);
  }

private:
  const Eigen::Vector3d& point(Index place) const { return m_points[at(place)]; }

  /// The diagonal that is shortest for what it cuts off, among those that leave a quarter on each side.
  bool findCut(const std::vector<Index>& loop, std::size_t& first, std::size_t& last) const
  {
    double best = kNever;
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + n / 4; j < n && j - i <= n - n / 4; ++j) {
        const double length = (point(loop[i]) - point(loop[j])).squaredNorm();
        if (length < best && m_isAllowed(loop[i], loop[j])) {
          best = length;
          first = i;
          last = j;
        }
      }
    return best < kNever;
  }

  /// cost(i, j): the best of the part of the loop from i to j, closed by the diagonal i-j.
  bool addWhole(const std::vector<Index>& loop, Triangles& triangles)
  {
    const std::size_t n = loop.size();
    m_cost.assign(n * n, 0.0);
    m_middle.assign(n * n, 0);
    for (std::size_t span = 2; span < n; ++span)
      for (std::size_t i = 0; i + span < n; ++i) {
        const std::size_t j = i + span;
        double& cost = m_cost[i * n + j];
        cost = kNever;
        const bool isWhole = i == 0 && j == n - 1; // that side is an edge of the loop
        if (!isWhole && !m_isAllowed(loop[i], loop[j])) continue;
        const double diagonal = isWhole ? 0.0 : m_diagonalWeight * (point(loop[i]) - point(loop[j])).norm();
        for (std::size_t k = i + 1; k < j; ++k) {
          const double parts = m_cost[i * n + k] + m_cost[k * n + j];
          if (!(parts < cost)) continue;
          const double whole = parts + diagonal + area(loop[i], loop[k], loop[j]);
          if (whole < cost) {
            cost = whole;
            m_middle[i * n + j] = k;
          }
        }
      }
    if (!(m_cost[n - 1] < kNever)) return false;
    collect(loop, triangles);
    return true;
  }
  void collect(const std::vector<Index>& loop, Triangles& triangles) const
  {
    const std::size_t n = loop.size();
    std::vector<std::array<std::size_t, 2>> spans{{0, n - 1}};
    while (!spans.empty()) {
      const auto [i, j] = spans.back();
      spans.pop_back();
      if (j - i < 2) continue;
      const std::size_t k = m_middle[i * n + j];
      triangles.push_back({loop[i], loop[k], loop[j]});
      spans.push_back({i, k});
      spans.push_back({k, j});
    }
  }
  /// A triangle without area joins nothing: never, so that points on a line are spread over real triangles.
  double area(Index a, Index b, Index c) const
  {
    const Eigen::Vector3d u = point(b) - point(a), v = point(c) - point(a);
    const double twice = u.cross(v).norm();
    return twice > 1e-6 * u.norm() * v.norm() ? 0.5 * twice : kNever;
  }

  const std::vector<Eigen::Vector3d>& m_points;
  const std::function<bool(Index, Index)>& m_isAllowed;
  double m_diagonalWeight = 0.0;
  std::vector<double> m_cost;
  std::vector<std::size_t> m_middle;
};

} // namespace

std::vector<std::array<Index, 3>> triangulateLoop(const std::vector<Eigen::Vector3d>& points,
                                                  const std::function<bool(Index, Index)>& isAllowed)
{
  if (points.size() < 3) return {};
  std::vector<Index> loop(points.size());
  for (std::size_t i = 0; i < loop.size(); ++i) loop[i] = static_cast<Index>(i);
  Triangles triangles;
  if (!LoopTriangulation(points, isAllowed).add(loop, triangles)) return {};
  return triangles;
}

} // namespace esm
