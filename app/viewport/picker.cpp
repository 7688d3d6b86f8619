// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/picker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace esm {

namespace {

struct Candidate {
  Index node = kNoIndex; ///< or spring, by its middle
  double pixels = 0.0;   ///< from the click
  double depth = 0.0;    ///< [m]
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

std::optional<double> hitTriangle(const Ray& ray, const Eigen::Matrix3Xd& position,
                                  const Eigen::Ref<const Eigen::Vector3<Index>>& corners)
{
  return hitTriangle(ray, position.col(corners[0]), position.col(corners[1]), position.col(corners[2]));
}

bool holds(const Eigen::Ref<const Eigen::Vector3<Index>>& triangle, Index node)
{
  return (triangle.array() == node).any();
}

/// Of those that are seen the one nearest to the click, if it belongs to what is in front there.
Index frontMost(const Camera& camera, const Eigen::Matrix3Xd& position, const std::vector<Candidate>& seen,
                double radius)
{
  if (seen.empty()) return kNoIndex;
  const auto front = std::min_element(
    seen.begin(), seen.end(), [](const Candidate& a, const Candidate& b) { return a.depth < b.depth; });
  const double limit = front->depth + kSameFront * radius * camera.metresPerPixel(position.col(front->node));
  for (const Candidate& candidate : seen) // nearest to the click first
    if (candidate.depth <= limit) return candidate.node;
  return front->node;
}

/// Of that one of those triangles which is in front under the click, the corner nearest to it.
Index nearestCorner(const Camera& camera, const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles,
                    const std::vector<Index>& among, const Eigen::Vector2d& pixel)
{
  const Ray ray = camera.rayThrough(pixel);
  double closest = std::numeric_limits<double>::infinity();
  Index front = kNoIndex;
  for (const Index t : among) {
    const auto hit = hitTriangle(ray, position, triangles.col(t));
    if (!hit || !(*hit < closest)) continue;
    closest = *hit;
    front = t;
  }
  if (front == kNoIndex) return kNoIndex;
  const std::array<Index, 3> corners{triangles(0, front), triangles(1, front), triangles(2, front)};
  const auto distance = [&](Index node) { return (camera.project(position.col(node)).pixel - pixel).norm(); };
  return std::ranges::min(corners, {}, distance);
}

/// Which triangles are seen in which square of the screen, within a box.
class ScreenTiles {
public:
  ScreenTiles(const Camera& camera, const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles,
              const Eigen::AlignedBox2d& box)
    : m_corner(box.min()), m_columns(countOf(box.sizes().x())), m_rows(countOf(box.sizes().y()))
  {
    m_tiles.resize(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows));
    const Projector project = camera.projector();
    for (Index t = 0; t < static_cast<Index>(triangles.cols()); ++t) {
      Eigen::AlignedBox2d seen;
      for (int corner = 0; corner < 3; ++corner) {
        const Eigen::Vector2d pixel = project(position.col(triangles(corner, t))).pixel;
        if (pixel.allFinite())
          seen.extend(pixel);
        else
          seen.extend(box); // reaches behind the eye: may be anywhere
      }
      add(t, seen);
    }
  }
  const std::vector<Index>& at(const Eigen::Vector2d& pixel) const
  {
    return m_tiles[tile(placeOf(pixel.x() - m_corner.x(), m_columns),
                        placeOf(pixel.y() - m_corner.y(), m_rows))];
  }

private:
  static constexpr double kSize = 16.0; ///< [pixels]
  static int countOf(double size) { return static_cast<int>(std::clamp(size / kSize, 0.0, 1000.0)) + 1; }
  static int placeOf(double from, int count)
  {
    return static_cast<int>(std::clamp(from / kSize, 0.0, static_cast<double>(count - 1)));
  }
  std::size_t tile(int column, int row) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) +
           static_cast<std::size_t>(column);
  }
  void add(Index triangle, const Eigen::AlignedBox2d& seen)
  {
    const Eigen::Vector2d low = seen.min() - m_corner, high = seen.max() - m_corner;
    if (high.x() < 0.0 || high.y() < 0.0 || low.x() > kSize * m_columns || low.y() > kSize * m_rows) return;
    for (int row = placeOf(low.y(), m_rows); row <= placeOf(high.y(), m_rows); ++row)
      for (int column = placeOf(low.x(), m_columns); column <= placeOf(high.x(), m_columns); ++column)
        m_tiles[tile(column, row)].push_back(triangle);
  }

  Eigen::Vector2d m_corner;
  int m_columns, m_rows;
  std::vector<std::vector<Index>> m_tiles;
};

/// Whether a triangle lies between the target and the eye. `owns` says by its three nodes which ones do not
/// count. @pre the target is seen in the box of the tiles
template <class Owns>
bool hidden(const Camera& camera, const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles,
            const ScreenTiles& tiles, const Eigen::Vector3d& target, Owns&& owns)
{
  const Eigen::Vector2d pixel = camera.project(target).pixel;
  const Ray ray = camera.rayThrough(pixel);
  const double reach = (target - ray.origin).norm();
  const double closest = reach - kSlack * camera.metresPerPixel(target);
  for (const Index t : tiles.at(pixel)) {
    if (owns(triangles.col(t))) continue;
    const auto hit = hitTriangle(ray, position, triangles.col(t));
    if (hit && *hit < closest) return true;
  }
  return false;
}

Eigen::AlignedBox2d boxAround(const Eigen::Vector2d& pixel, double radius)
{
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(radius);
  return {pixel - reach, pixel + reach};
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
  const ScreenTiles tiles(camera, position, triangles, boxAround(pixel, radius));
  for (const Candidate& candidate : candidates(camera, position, pixel, radius))
    if (!hidden(camera, position, triangles, tiles, position.col(candidate.node),
                [&](const auto& triangle) { return holds(triangle, candidate.node); }))
      seen.push_back(candidate);
  return seen.empty() ? nearestCorner(camera, position, triangles, tiles.at(pixel), pixel)
                      : frontMost(camera, position, seen, radius);
}

Index pickSpring(const Camera& camera, const Eigen::Matrix3Xd& position, const SegmentMatrix& ends,
                 const TriangleMatrix& triangles, const Eigen::Vector2d& pixel, double radius,
                 const std::function<bool(Index)>& shown)
{
  Eigen::Matrix3Xd middle(3, ends.cols());
  for (Eigen::Index s = 0; s < ends.cols(); ++s)
    middle.col(s) = 0.5 * (position.col(ends(0, s)) + position.col(ends(1, s)));
  std::vector<Candidate> seen;
  const ScreenTiles tiles(camera, position, triangles, boxAround(pixel, radius));
  for (const Candidate& candidate : candidates(camera, middle, pixel, radius)) {
    if (shown && !shown(candidate.node)) continue;
    const Index a = ends(0, candidate.node), b = ends(1, candidate.node);
    const auto owns = [&](const auto& triangle) { return holds(triangle, a) && holds(triangle, b); };
    if (!hidden(camera, position, triangles, tiles, middle.col(candidate.node), owns))
      seen.push_back(candidate);
  }
  return frontMost(camera, middle, seen, radius);
}

std::vector<Index> nodesInBox(const Camera& camera, const Eigen::Matrix3Xd& position,
                              const TriangleMatrix& triangles, const Eigen::AlignedBox2d& pixels)
{
  std::vector<Index> found;
  if (pixels.isEmpty()) return found;
  const ScreenTiles tiles(camera, position, triangles, pixels);
  const Projector project = camera.projector();
  for (Index node = 0; node < static_cast<Index>(position.cols()); ++node) {
    const Eigen::Vector2d pixel = project(position.col(node)).pixel;
    if (!pixel.allFinite() || !pixels.contains(pixel)) continue;
    if (!hidden(camera, position, triangles, tiles, position.col(node),
                [&](const auto& triangle) { return holds(triangle, node); }))
      found.push_back(node);
  }
  return found;
}

} // namespace esm
