// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/triangulate.h"

#include <Eigen/Geometry>

#include <limits>

namespace esm {

namespace {

/// The polygon in the coordinates of its own plane, as a ring that shrinks by one corner per ear.
class EarClipper {
public:
  EarClipper(const Eigen::Matrix3Xd& position, std::span<const Index> corners) : m_count(corners.size())
  {
    flatten(position, corners);
    m_ring.resize(m_count);
    for (std::size_t i = 0; i < m_count; ++i)
      m_ring[i].before = (i + m_count - 1) % m_count, m_ring[i].after = (i + 1) % m_count;
    for (std::size_t i = 0; i < m_count; ++i)
      if (!(turn(m_ring[i].before, i, m_ring[i].after) > 0.0)) m_inward.push_back(i);
    for (std::size_t i = 0; i < m_count; ++i) judge(i);
  }

  template <class Append>
  void run(const Append& append)
  {
    std::size_t any = 0;
    for (std::size_t left = m_count; left > 3; --left) {
      const std::size_t ear = bestEar(any, left);
      const auto [before, after] = std::pair{m_ring[ear].before, m_ring[ear].after};
      append(before, ear, after);
      m_ring[ear].isCut = true;
      m_ring[before].after = after;
      m_ring[after].before = before;
      judge(before);
      judge(after);
      any = after;
    }
    append(m_ring[any].before, any, m_ring[any].after);
  }

private:
  struct Corner {
    std::size_t before = 0, after = 0;
    double diagonal = 0.0; ///< squared length of the cut that would take this corner off
    bool isEar = false, isCut = false;
  };

  /// Newell's normal is right for concave and slightly bent polygons too; scaled to unit size, so that
  /// products of coordinates neither overflow nor vanish.
  void flatten(const Eigen::Matrix3Xd& position, std::span<const Index> corners)
  {
    const Eigen::Vector3d origin = position.col(corners[0]);
    double size = 0.0;
    for (const Index corner : corners)
      size = std::max(size, (position.col(corner) - origin).cwiseAbs().maxCoeff());
    if (!(size > 0.0) || !std::isfinite(size)) size = 1.0;
    const auto local = [&](std::size_t i) -> Eigen::Vector3d {
      return (position.col(corners[i % m_count]) - origin) / size;
    };
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < m_count; ++i) normal += local(i).cross(local(i + 1));
    if (!(normal.norm() > 0.0)) normal = Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d side = normal.unitOrthogonal(), up = normal.normalized().cross(side);
    m_flat.resize(m_count);
    m_space.resize(m_count);
    for (std::size_t i = 0; i < m_count; ++i) {
      m_space[i] = local(i);
      m_flat[i] = {side.dot(m_space[i]), up.dot(m_space[i])};
    }
  }

  /// Twice the signed area; positive when a, b, c turn left, as the outline does on the whole.
  double turn(std::size_t a, std::size_t b, std::size_t c) const
  {
    const Eigen::Vector2d u = m_flat[b] - m_flat[a], v = m_flat[c] - m_flat[a];
    return u.x() * v.y() - u.y() * v.x();
  }

  /// Whether the corner may be cut off. If any corner lies in its triangle, one that points inwards does.
  void judge(std::size_t corner)
  {
    Corner& c = m_ring[corner];
    c.diagonal = (m_space[c.before] - m_space[c.after]).squaredNorm();
    c.isEar = turn(c.before, corner, c.after) > 0.0;
    for (auto i = m_inward.begin(); c.isEar && i != m_inward.end(); ++i) {
      if (m_ring[*i].isCut || *i == c.before || *i == corner || *i == c.after) continue;
      const bool inside = turn(c.before, corner, *i) >= 0.0 && turn(corner, c.after, *i) >= 0.0 &&
                          turn(c.after, c.before, *i) >= 0.0;
      const bool onCorner = m_flat[*i] == m_flat[c.before] || m_flat[*i] == m_flat[c.after];
      c.isEar = !inside || onCorner;
    }
  }

  std::size_t bestEar(std::size_t start, std::size_t left) const
  {
    std::size_t best = start;
    bool found = false;
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = start, k = 0; k < left; i = m_ring[i].after, ++k) {
      const Corner& c = m_ring[i];
      if (c.isEar < found || (c.isEar == found && !(c.diagonal < shortest))) continue;
      best = i;
      found = c.isEar;
      shortest = c.diagonal;
    }
    return best;
  }

  std::size_t m_count;
  std::vector<Eigen::Vector2d> m_flat;
  std::vector<Eigen::Vector3d> m_space;
  std::vector<Corner> m_ring;
  std::vector<std::size_t> m_inward; ///< corners where the whole outline does not turn left
};

} // namespace

void triangulate(const Eigen::Matrix3Xd& position, std::span<const Index> corners, std::vector<Index>& out)
{
  if (corners.size() == 3) {
    out.insert(out.end(), corners.begin(), corners.end());
    return;
  }
  std::vector<Index> outline;
  for (const Index corner : corners)
    if (outline.empty() || outline.back() != corner) outline.push_back(corner);
  while (outline.size() > 3 && outline.back() == outline.front()) outline.pop_back();
  while (outline.size() < 3) outline.push_back(outline.back()); // stays a face, a degenerate one

  const auto append = [&](std::size_t a, std::size_t b, std::size_t c) {
    out.insert(out.end(), {outline[a], outline[b], outline[c]});
  };
  if (outline.size() <= kLongPolygon) {
    EarClipper(position, outline).run(append);
    return;
  }
  for (std::size_t low = 0, high = outline.size() - 1; high - low >= 2;) {
    append(low, low + 1, high);
    ++low;
    if (high - low < 2) break;
    append(low, high - 1, high);
    --high;
  }
}

} // namespace esm
