// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/self_intersections.h"

#include "core/geometry/box_tree.h"
#include "core/geometry/triangle_shape.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

namespace esm {

namespace {

/// The walk over all pairs of leaves that meet in a tree of boxes around triangles.
class PairSearch {
public:
  PairSearch(const Mesh& mesh, double seconds, std::size_t most, WorkControl* control)
    : m_mesh(mesh), m_most(most), m_control(control)
  {
    if (seconds > 0.0)
      m_end = std::chrono::steady_clock::now() +
              std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    for (Index t = 0; t < mesh.triangleCount(); ++t) {
      if (isDegenerate(mesh, t)) continue;
      Eigen::AlignedBox3d box;
      bool isFinite = true;
      for (int k = 0; k < 3; ++k) {
        const auto corner = mesh.position.col(mesh.triangles(k, t));
        isFinite = isFinite && corner.allFinite();
        box.extend(corner);
      }
      if (!isFinite) continue;
      m_triangle.push_back(t);
      m_boxes.push_back(box);
    }
  }

  SelfIntersections run()
  {
    if (m_boxes.empty()) return {};
    m_tree.emplace(m_boxes, 0.0, [this] { return isOver(); });
    if (!isOver()) walk();
    std::sort(m_found.pairs.begin(), m_found.pairs.end(), [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first < b.first : a.second < b.second;
    });
    return std::move(m_found);
  }

private:
  using Clock = std::chrono::steady_clock;
  using Node = BoxTree::Node;

  Index itemAt(Index place) const { return m_tree->order()[at(place)]; }
  const Eigen::AlignedBox3d& boxAt(Index place) const { return m_boxes[at(itemAt(place))]; }

  void walk()
  {
    std::vector<std::pair<Index, Index>> stack{{0, 0}};
    while (!stack.empty() && !isOver()) {
      const auto [one, two] = stack.back();
      stack.pop_back();
      const Node &a = m_tree->nodes()[at(one)], &b = m_tree->nodes()[at(two)];
      if (one != two && !a.box.intersects(b.box)) continue;
      if (a.count > 0 && b.count > 0) {
        testLeaves(a, b, one == two);
      } else if (one == two) {
        for (const auto& pair : {std::pair(a.first, a.first), std::pair(a.first, a.first + 1),
                                 std::pair(a.first + 1, a.first + 1)})
          stack.push_back(pair);
      } else if (b.count > 0 || (a.count == 0 && sizeOf(a) >= sizeOf(b))) {
        stack.push_back({a.first, two});
        stack.push_back({a.first + 1, two});
      } else {
        stack.push_back({one, b.first});
        stack.push_back({one, b.first + 1});
      }
    }
  }

  static double sizeOf(const Node& node) { return node.box.sizes().maxCoeff(); }

  void testLeaves(const Node& a, const Node& b, bool same)
  {
    for (Index i = a.first; i < a.first + a.count; ++i)
      for (Index j = same ? i + 1 : b.first; j < b.first + b.count; ++j) {
        if (!boxAt(i).intersects(boxAt(j))) continue;
        const auto [first, second] = std::minmax({m_triangle[at(itemAt(i))], m_triangle[at(itemAt(j))]});
        const auto place = meetingOf(first, second);
        if (!place) continue;
        if (m_found.pairs.size() < m_most)
          m_found.pairs.push_back({first, second, *place});
        else
          m_found.isComplete = false;
      }
  }

  /// The middle of what the two triangles share, or nothing.
  std::optional<Eigen::Vector3d> meetingOf(Index first, Index second) const
  {
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l)
        if (m_mesh.triangles(k, first) == m_mesh.triangles(l, second)) return {};
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int passes = 0;
    for (const auto& [edges, face] : {std::pair(first, second), std::pair(second, first)})
      for (int k = 0; k < 3; ++k)
        if (const auto place =
              passage(m_mesh.triangles(k, edges), m_mesh.triangles((k + 1) % 3, edges), face)) {
          sum += *place;
          ++passes;
        }
    if (passes == 0) return {};
    return sum / passes;
  }

  /// Where the edge from a to b passes through a triangle, by the signs of five tetrahedra's volumes.
  std::optional<Eigen::Vector3d> passage(Index a, Index b, Index face) const
  {
    const Eigen::Vector3d origin = m_mesh.position.col(m_mesh.triangles(0, face));
    const Eigen::Vector3d p = m_mesh.position.col(a) - origin, q = m_mesh.position.col(b) - origin;
    const Eigen::Vector3d u = m_mesh.position.col(m_mesh.triangles(1, face)) - origin,
                          v = m_mesh.position.col(m_mesh.triangles(2, face)) - origin;
    const Eigen::Vector3d normal = u.cross(v);
    const double above = normal.dot(p), below = normal.dot(q);
    if (!((above > 0.0 && below < 0.0) || (above < 0.0 && below > 0.0))) return {};
    const Eigen::Vector3d along = q - p;
    const double sign = above > 0.0 ? -1.0 : 1.0; // of all three volumes, if the edge passes inside
    const double w0 = sign * along.dot((u - p).cross(v - p)), w1 = sign * along.dot((v - p).cross(-p)),
                 w2 = sign * along.dot((-p).cross(u - p));
    if (!(w0 >= 0.0 && w1 >= 0.0 && w2 >= 0.0)) return {};
    return Eigen::Vector3d(origin + p + along * (above / (above - below)));
  }

  /// Asked often; looks at the clock now and then.
  bool isOver()
  {
    if (m_isOver) return true;
    if (++m_asked % 256 != 0) return false;
    m_isOver = stopWanted(m_control) || (m_end && Clock::now() > *m_end);
    if (m_isOver) m_found.isComplete = false;
    return m_isOver;
  }

  const Mesh& m_mesh;
  std::size_t m_most;
  WorkControl* m_control;
  std::optional<Clock::time_point> m_end;
  std::uint64_t m_asked = 0;
  bool m_isOver = false;
  std::vector<Eigen::AlignedBox3d> m_boxes; ///< of the sound triangles
  std::vector<Index> m_triangle;            ///< their numbers
  std::optional<BoxTree> m_tree;
  SelfIntersections m_found;
};

} // namespace

SelfIntersections findSelfIntersections(const Mesh& mesh, double seconds, std::size_t most,
                                        WorkControl* control)
{
  return PairSearch(mesh, seconds, most, control).run();
}

} // namespace esm
