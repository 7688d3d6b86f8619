// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/contact/press_area.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace esm {

namespace {

constexpr int kLeastRings = 6, kMostRings = 48;
constexpr double kRingsPerEdge = 4.0; ///< the nodes' shares are smooth by then
constexpr int kMostPieces = 256;      ///< triangles that a ray crosses
constexpr double kInside = 1e-9;      ///< of a triangle: rays begin so far from its rim [1]
constexpr double kHertzMoment = 0.4;  ///< mean square distance from the middle, of the radius squared [1]

double meanEdge(const TriangleMatrix& triangles, const Eigen::Matrix3Xd& position)
{
  double sum = 0.0;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k)
      sum += (position.col(triangles((k + 1) % 3, t)) - position.col(triangles(k, t))).norm();
  return triangles.cols() > 0 ? sum / (3.0 * static_cast<double>(triangles.cols())) : 0.0;
}

/// Part of the force within a distance from the middle, both of the whole [1].
double hertzWithin(double distance)
{
  return 1.0 - std::pow(1.0 - distance * distance, 1.5);
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// By side of a triangle, the triangle behind it that is wound alike.
std::vector<Index> neighboursOf(const TriangleMatrix& triangles, const EdgeTable& edges)
{
  std::vector<Index> first(static_cast<std::size_t>(edges.surfaceEdges), kNoIndex);
  std::vector<Index> neighbour(edges.edgeOfSide.size(), kNoIndex);
  for (std::size_t side = 0; side < edges.edgeOfSide.size(); ++side) {
    const Index edge = edges.edgeOfSide[side];
    if (edge == kNoIndex || edges.triangleCount[edge] != 2) continue;
    Index& other = first[static_cast<std::size_t>(edge)];
    if (other == kNoIndex) {
      other = static_cast<Index>(side);
      continue;
    }
    const auto begin = [&](Index s) { return triangles(s % 3, s / 3); };
    if (begin(other) == begin(static_cast<Index>(side))) continue;
    neighbour[side] = other / 3;
    neighbour[static_cast<std::size_t>(other)] = static_cast<Index>(side / 3);
  }
  return neighbour;
}

} // namespace

PressAreaFinder::PressAreaFinder(const TriangleMatrix& triangles, const Eigen::Matrix3Xd& position,
                                 const EdgeTable& edges, double radius)
  : m_triangles(triangles),
    m_position(position),
    m_neighbour(neighboursOf(triangles, edges)),
    m_radius(radius),
    m_share(static_cast<std::size_t>(position.cols()), 0.0)
{
  const double edge = meanEdge(triangles, position);
  const double wanted = edge > 0.0 ? std::ceil(kRingsPerEdge * radius / edge) : 0.0;
  const int rings = static_cast<int>(std::clamp(wanted, double(kLeastRings), double(kMostRings)));
  const int pairs = rings; // on the outer rings the points lie within an edge of each other
  for (int i = 0; i < pairs; ++i) {
    const double angle = std::numbers::pi * i / pairs;
    m_ways.emplace_back(std::cos(angle), std::sin(angle));
    m_ways.emplace_back(-m_ways.back());
  }
  for (int i = 0; i < rings; ++i)
    m_rings.push_back(
      {(i + 0.5) / rings, (hertzWithin((i + 1.0) / rings) - hertzWithin(double(i) / rings)) / (2.0 * pairs)});
  m_rays.resize(m_ways.size());
}

PressAreaFinder::Corner PressAreaFinder::corner(Index node) const
{
  const Eigen::Vector3d from = m_position.col(node) - m_centre;
  return {{m_right.dot(from), m_up.dot(from)}, m_normal.dot(from)};
}

/// From triangle to triangle through their sides, as far as the area reaches at most.
void PressAreaFinder::walk(const SurfacePoint& point, const Eigen::Vector2d& direction, Ray& ray) const
{
  ray.pieces.clear();
  ray.length = 0.0;
  Piece piece;
  piece.triangle = point.triangle;
  piece.enters = point.weight;
  double height = 0.0;   // where the piece begins [m]
  Index from = kNoIndex; // the triangle before
  const double out = m_radius * m_radius;
  for (int count = 0; count < kMostPieces; ++count) {
    std::array<Corner, 3> at;
    std::array<double, 3> left;
    for (int k = 0; k < 3; ++k) {
      at[static_cast<std::size_t>(k)] = corner(m_triangles(k, piece.triangle));
      left[static_cast<std::size_t>(k)] = cross(direction, at[static_cast<std::size_t>(k)].across);
    }
    const bool isTurnedAway = cross(at[1].across - at[0].across, at[2].across - at[0].across) <= 0.0;
    int side = isTurnedAway ? 3 : 0;
    while (side < 3 && !(left[static_cast<std::size_t>(side)] < 0.0 &&
                         left[static_cast<std::size_t>((side + 1) % 3)] >= 0.0))
      ++side;
    if (side == 3) break;
    const auto a = static_cast<std::size_t>(side), b = static_cast<std::size_t>((side + 1) % 3);
    const double share = left[a] / (left[a] - left[b]); // of b, where it leaves
    piece.leaves.setZero();
    piece.leaves[side] = 1.0 - share;
    piece.leaves[(side + 1) % 3] = share;
    piece.to = std::max(piece.from, direction.dot((1.0 - share) * at[a].across + share * at[b].across));
    const double end = (1.0 - share) * at[a].height + share * at[b].height;
    // Where it leaves the sphere of the radius: |(from, height) + s (way, climb)| = radius.
    const double way = piece.to - piece.from, climb = end - height;
    ray.pieces.push_back(piece);
    if (piece.to * piece.to + end * end >= out) {
      const double square = way * way + climb * climb, half = piece.from * way + height * climb;
      const double rest = out - piece.from * piece.from - height * height;
      const double part =
        square > 0.0 ? (std::sqrt(std::max(half * half + square * rest, 0.0)) - half) / square : 1.0;
      ray.length = piece.from + std::clamp(part, 0.0, 1.0) * way;
      return;
    }
    ray.length = piece.to;
    const Index next = m_neighbour[3 * static_cast<std::size_t>(piece.triangle) + a];
    if (next == kNoIndex || next == from) break;
    from = piece.triangle;
    Piece following;
    following.triangle = next;
    following.from = piece.to;
    for (int k = 0; k < 3; ++k) {
      if (m_triangles(k, next) == m_triangles(side, piece.triangle)) following.enters[k] = 1.0 - share;
      if (m_triangles(k, next) == m_triangles((side + 1) % 3, piece.triangle)) following.enters[k] = share;
    }
    piece = following;
    height = end;
  }
  if (!ray.pieces.empty()) return;
  piece.leaves = piece.enters; // the triangle itself is turned away: a ray of no length
  ray.pieces.push_back(piece);
}

/// The points of a ray that goes so far: visit(triangle, weights of the corners, share of the force).
template <class Visit>
void PressAreaFinder::sample(const Ray& ray, double length, const Visit& visit) const
{
  std::size_t i = 0;
  for (const Ring& ring : m_rings) {
    const double at = ring.distance * length;
    while (i + 1 < ray.pieces.size() && ray.pieces[i].to < at) ++i;
    const Piece& piece = ray.pieces[i];
    const double way = piece.to - piece.from;
    const double part = way > 0.0 ? std::clamp((at - piece.from) / way, 0.0, 1.0) : 0.0;
    visit(piece.triangle, Eigen::Vector3d((1.0 - part) * piece.enters + part * piece.leaves), ring.share);
  }
}

/// How much wider than itself the load becomes on the triangles: mean square distance of their corners from
/// its points, as they share them [m^2].
double PressAreaFinder::spread() const
{
  double sum = 0.0;
  for (std::size_t r = 0; r < m_rays.size(); ++r) {
    const double length = std::min(m_rays[r].length, m_rays[r ^ 1].length);
    sample(m_rays[r], length, [&](Index triangle, const Eigen::Vector3d& weight, double share) {
      for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        sum += share * weight[k] * weight[next] *
               (m_position.col(m_triangles(k, triangle)) - m_position.col(m_triangles(next, triangle)))
                 .squaredNorm();
      }
    });
  }
  return sum;
}

void PressAreaFinder::find(const SurfacePoint& point, const Eigen::Vector3d& normal, PressedArea& area)
{
  SurfacePoint centre = point;
  centre.weight = centre.weight.cwiseMax(kInside);
  centre.weight /= centre.weight.sum();
  const Eigen::Vector3i corners = m_triangles.col(point.triangle);
  m_centre.setZero();
  for (int k = 0; k < 3; ++k) m_centre += centre.weight[k] * m_position.col(corners[k]);
  m_normal = normal;
  m_right = normal.unitOrthogonal();
  m_up = m_normal.cross(m_right);
  for (std::size_t r = 0; r < m_rays.size(); ++r) walk(centre, m_ways[r], m_rays[r]);
  const double narrower = spread() / kHertzMoment;
  const double radius = std::sqrt(std::max(m_radius * m_radius - narrower, 0.0));

  area.nodes.node.assign(corners.data(), corners.data() + 3);
  for (std::size_t r = 0; r < m_rays.size(); ++r) {
    const Ray& ray = m_rays[r];
    const double length = std::min({ray.length, m_rays[r ^ 1].length, radius});
    sample(ray, length, [&](Index triangle, const Eigen::Vector3d& weight, double share) {
      for (int k = 0; k < 3; ++k) {
        const Index node = m_triangles(k, triangle);
        double& sum = m_share[static_cast<std::size_t>(node)];
        if (sum == 0.0 && node != corners[0] && node != corners[1] && node != corners[2] && weight[k] > 0.0)
          area.nodes.node.push_back(node);
        sum += share * weight[k];
      }
    });
  }
  area.nodes.weight.clear();
  area.rise = 0.0;
  for (const Index node : area.nodes.node) {
    double& sum = m_share[static_cast<std::size_t>(node)];
    area.nodes.weight.push_back(sum);
    area.rise += sum * m_normal.dot(m_centre - m_position.col(node));
    sum = 0.0;
  }
}

} // namespace esm
