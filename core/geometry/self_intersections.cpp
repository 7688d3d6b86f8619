// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/self_intersections.h"

#include "core/geometry/triangle_shape.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace esm {

namespace {

constexpr Index kPairLeafSize = 4;

struct Box {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = -low;
  void take(const Box& other)
  {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  bool meets(const Box& other) const
  {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

/// A binary tree of boxes over triangles, split at the median of the longest side, and the walk over all
/// pairs of leaves that meet.
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
      Box box;
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d corner = mesh.position.col(mesh.triangles(k, t));
        box.take({corner, corner});
      }
      if (!box.low.allFinite() || !box.high.allFinite()) continue;
      m_order.push_back(static_cast<Index>(m_boxes.size()));
      m_triangle.push_back(t);
      m_boxes.push_back(box);
    }
  }

  SelfIntersections run()
  {
    if (m_order.empty()) return {};
    m_nodes.reserve(m_order.size());
    m_nodes.emplace_back();
    split(0, 0, static_cast<Index>(m_order.size()));
    if (!isOver()) walk();
    std::sort(m_found.pairs.begin(), m_found.pairs.end(), [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first < b.first : a.second < b.second;
    });
    return std::move(m_found);
  }

private:
  using Clock = std::chrono::steady_clock;
  struct Node { ///< a leaf has `count` items from `first` on, an inner node the children first, first + 1
    Box box;
    Index first = 0, count = 0;
  };

  const Box& boxOf(Index i) const
  {
    return m_boxes[static_cast<std::size_t>(m_order[static_cast<std::size_t>(i)])];
  }

  void split(Index node, Index first, Index count)
  {
    Box box;
    for (Index i = first; i < first + count; ++i) box.take(boxOf(i));
    Node& here = m_nodes[static_cast<std::size_t>(node)];
    here.box = box;
    here.first = first;
    here.count = count;
    if (count <= kPairLeafSize || isOver()) return;
    int axis = 0;
    (box.high - box.low).maxCoeff(&axis);
    const auto begin = m_order.begin() + first;
    const auto centre = [&](Index i) {
      const Box& of = m_boxes[static_cast<std::size_t>(i)];
      return of.low[axis] + of.high[axis];
    };
    std::nth_element(begin, begin + count / 2, begin + count, [&](Index a, Index b) {
      return centre(a) != centre(b) ? centre(a) < centre(b) : a < b;
    });
    const auto child = static_cast<Index>(m_nodes.size());
    here.first = child;
    here.count = 0;
    m_nodes.resize(m_nodes.size() + 2);
    split(child, first, count / 2);
    split(child + 1, first + count / 2, count - count / 2);
  }

  void walk()
  {
    std::vector<std::pair<Index, Index>> stack{{0, 0}};
    while (!stack.empty() && !isOver()) {
      const auto [one, two] = stack.back();
      stack.pop_back();
      const Node &a = m_nodes[static_cast<std::size_t>(one)], &b = m_nodes[static_cast<std::size_t>(two)];
      if (one != two && !a.box.meets(b.box)) continue;
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

  static double sizeOf(const Node& node) { return (node.box.high - node.box.low).maxCoeff(); }

  void testLeaves(const Node& a, const Node& b, bool same)
  {
    for (Index i = a.first; i < a.first + a.count; ++i)
      for (Index j = same ? i + 1 : b.first; j < b.first + b.count; ++j) {
        if (!boxOf(i).meets(boxOf(j))) continue;
        const auto number = [this](Index k) {
          return m_triangle[static_cast<std::size_t>(m_order[static_cast<std::size_t>(k)])];
        };
        const auto [first, second] = std::minmax({number(i), number(j)});
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
  std::vector<Box> m_boxes;      ///< of the sound triangles
  std::vector<Index> m_triangle; ///< their numbers
  std::vector<Index> m_order;    ///< of m_boxes, by the tree
  std::vector<Node> m_nodes;
  SelfIntersections m_found;
};

} // namespace

SelfIntersections findSelfIntersections(const Mesh& mesh, double seconds, std::size_t most,
                                        WorkControl* control)
{
  return PairSearch(mesh, seconds, most, control).run();
}

} // namespace esm
