// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/edge_table.h"

#include "core/base/assert.h"
#include "core/base/large_pages.h"
#include "core/geometry/first_appearance.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>
#include <utility>

namespace esm {

namespace {

/// The edges found so far, each in the bucket of its smaller vertex. A bucket has room for all sides that
/// have this vertex as their smaller one, so it lies in one or two lines of the cache and is searched in the
/// order of appearance; that of a hub is a hash table with open addressing, so that no mesh makes the search
/// slow.
class EdgeBuckets {
public:
  /// @param sides visits all sides: sides(visit) calls visit(a, b, side) for each with a != b, in order
  template <class Sides>
  EdgeBuckets(Index vertexCount, const Sides& sides)
    : m_start(largeVector<std::uint32_t>(static_cast<std::size_t>(vertexCount) + 1, 0))
  {
    sides([start = m_start.data()](Index a, Index b, Index) {
      ++start[std::min(a, b)];
      return true;
    });
    std::uint32_t total = 0;
    for (std::uint32_t& start : m_start) {
      const std::uint32_t size = start;
      start = total;
      total += size > kSearchLimit ? std::bit_ceil(2 * size) : size;
    }
    m_entries = std::make_unique_for_overwrite<Entry[]>(total);
    zeroInLargePages(m_entries.get(), total * sizeof(Entry));
  }

  /// Fetches the memory of a later findOrAdd(a, b): first where the bucket is, then the bucket.
  void foreseePlace(Index a, Index b) const { __builtin_prefetch(m_start.data() + std::min(a, b)); }
  void foreseeBucket(Index a, Index b) const
  {
    const Entry* const bucket = m_entries.get() + m_start[static_cast<std::size_t>(std::min(a, b))];
    __builtin_prefetch(bucket);
    __builtin_prefetch(bucket + 5); // as a rule it begins somewhere in a line of eight
  }

  /// The number of the edge between a and b; `next` if it was none yet and now is.
  Index findOrAdd(Index a, Index b, Index next)
  {
    const auto [low, high] = std::minmax(a, b);
    const std::uint32_t* const bucket = m_start.data() + low;
    Entry* const from = m_entries.get() + bucket[0];
    Entry* const to = m_entries.get() + bucket[1];
    Entry* entry = from;
    if (to - from > static_cast<std::ptrdiff_t>(kSearchLimit)) {
      const std::uint64_t hash =
        static_cast<std::uint64_t>(high) * 0x9e3779b97f4a7c15ull; // 2^64 / golden ratio
      entry += (hash >> 20) & static_cast<std::uint64_t>(to - from - 1);
    }
    while (entry->high != high) {
      if (entry->high == kFree) {
        *entry = {high, next};
        break;
      }
      if (++entry == to) entry = from;
    }
    return entry->edge;
  }

private:
  static constexpr std::uint64_t kSearchLimit = 24; ///< sides of one vertex
  static constexpr Index kFree = 0;                 ///< no edge leads up to vertex 0
  struct Entry {
    Index high, edge;
  };
  std::vector<std::uint32_t> m_start; ///< per vertex, where its entries begin
  std::unique_ptr<Entry[]> m_entries;
};

constexpr int kTetrahedronEdges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

/// Calls visit(a, b, side) for each side of a triangle, then each segment, then each side of a tetrahedron,
/// with two different ends, until it returns false. The three sides of triangle t are 3 t, 3 t + 1, 3 t + 2.
template <class Visit>
void visitSides(const Mesh& mesh, const Visit& visit)
{
  const Index triangleSides = 3 * mesh.triangleCount();
  const Index* corner = mesh.triangles.data();
  for (Index side = 0; side < triangleSides; side += 3, corner += 3) {
    const Index a = corner[0], b = corner[1], c = corner[2];
    if (a != b && !visit(a, b, side)) return;
    if (b != c && !visit(b, c, side + 1)) return;
    if (c != a && !visit(c, a, side + 2)) return;
  }
  const Index* end = mesh.segments.data();
  for (Index s = 0; s < mesh.segmentCount(); ++s, end += 2)
    if (end[0] != end[1] && !visit(end[0], end[1], triangleSides + s)) return;
  const Index others = triangleSides + mesh.segmentCount();
  for (Index t = 0; t < mesh.tetrahedronCount(); ++t)
    for (int k = 0; k < 6; ++k) {
      const Index a = mesh.tetrahedra(kTetrahedronEdges[k][0], t),
                  b = mesh.tetrahedra(kTetrahedronEdges[k][1], t);
      if (a != b && !visit(a, b, others + 6 * t + k)) return;
    }
}

/// Each triangle once per edge, even if two of its sides are the same edge (corners a a b).
void countTriangles(EdgeTable& table)
{
  constexpr std::size_t kAhead = 48;
  table.triangleCount = largeVector(static_cast<std::size_t>(table.ends.cols()), Index{0});
  const std::vector<Index>& edge = table.edgeOfSide;
  for (std::size_t t = 0; t + 2 < edge.size(); t += 3) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (t + c + kAhead < edge.size() && edge[t + c + kAhead] != kNoIndex)
        __builtin_prefetch(table.triangleCount.data() + edge[t + c + kAhead], 1);
      const Index e = edge[t + c];
      const bool counted = (c > 0 && e == edge[t]) || (c > 1 && e == edge[t + 1]);
      if (e != kNoIndex && !counted) ++table.triangleCount[static_cast<std::size_t>(e)];
    }
  }
}

/// The smallest corner of a triangle and the two others, whatever their order.
std::pair<Index, std::uint64_t> triangleKey(const Index* corner)
{
  const auto [low, high] = std::minmax({corner[0], corner[1], corner[2]});
  // The middle one is what the sum has left; 64 bits, for the sum of three may pass 2^31.
  const std::int64_t middle = std::int64_t{corner[0]} + corner[1] + corner[2] - low - high;
  return {low, (static_cast<std::uint64_t>(middle) << 32) | static_cast<std::uint64_t>(high)};
}

/// EdgeTable::repeated; of no use if stopped.
std::vector<Index> findRepeated(const Mesh& mesh, const EdgeTable& edges, WorkControl* control)
{
  // Triangles over the same vertices share their three edges. If an earlier one was the first user of all
  // three, that tells, and they are numbered in a row; if not, some edge has a third user. So only triangles
  // at such edges, and those without three edges, have to be compared with each other.
  const Index count = mesh.triangleCount();
  const auto usersOf = [&edges](Index edge) { return edges.triangleCount[static_cast<std::size_t>(edge)]; };
  const bool crowded = std::any_of(edges.triangleCount.begin(), edges.triangleCount.end(),
                                   [](Index users) { return users > 2; });
  std::vector<Index> firstUser = largeVector(edges.triangleCount.size(), kNoIndex), repeated, doubtful;
  Index known = 0; // edges so far; they are numbered by their first appearance
  for (Index t = 0; t < count; ++t) {
    if (stopWantedAt(static_cast<std::size_t>(t), static_cast<std::size_t>(count), control)) return {};
    const Index* const edge = edges.edgeOfSide.data() + 3 * std::ptrdiff_t{t};
    const Index knownBefore = known;
    for (int k = 0; k < 3; ++k)
      if (edge[k] == known) firstUser[static_cast<std::size_t>(known++)] = t;
    const Index low = std::min(std::min(edge[0], edge[1]), edge[2]);
    const Index high = std::max(std::max(edge[0], edge[1]), edge[2]);
    if (low == kNoIndex ||
        (crowded && (usersOf(edge[0]) > 2 || usersOf(edge[1]) > 2 || usersOf(edge[2]) > 2))) {
      doubtful.push_back(t);
    } else if (high < knownBefore && high - low == 2) {
      const auto user = firstUser.begin() + low;
      if (user[0] == user[1] && user[1] == user[2]) repeated.push_back(t);
    }
  }
  if (doubtful.empty()) return repeated;
  const auto keyOf = [&](Index i) {
    return triangleKey(mesh.triangles.data() + 3 * std::ptrdiff_t{doubtful[static_cast<std::size_t>(i)]});
  };
  const std::vector<Index> first =
    firstAppearances<std::uint64_t>(static_cast<Index>(doubtful.size()), mesh.vertexCount(), keyOf, control);
  for (std::size_t i = 0; i < first.size(); ++i)
    if (first[i] != static_cast<Index>(i)) repeated.push_back(doubtful[i]);
  std::sort(repeated.begin(), repeated.end());
  return repeated;
}

} // namespace

EdgeTable findEdges(const Mesh& mesh, WorkControl* control)
{
  ESM_ASSERT(3 * std::int64_t{mesh.triangleCount()} + mesh.segmentCount() +
               6 * std::int64_t{mesh.tetrahedronCount()} <
             kMostSides);
  const Index triangleSides = 3 * mesh.triangleCount();
  const Index sides = triangleSides + mesh.segmentCount() + 6 * mesh.tetrahedronCount();
  EdgeBuckets buckets(mesh.vertexCount(), [&mesh](const auto& visit) { visitSides(mesh, visit); });
  if (stopWanted(control)) return {};

  EdgeTable table;
  table.edgeOfSide = largeVector(static_cast<std::size_t>(triangleSides), kNoIndex);
  table.ends.resize(2, sides); // most of it is never touched
  useLargePages(table.ends);
  Index edges = 0;
  bool surfaceDone = false;
  // Triangles without order miss the caches with every side; their buckets are fetched some triangles ahead.
  constexpr Index kAhead = 3 * 12;
  const auto foresee = [&](Index side) {
    if (side + 2 * kAhead + 2 >= triangleSides) return;
    const Index* c = mesh.triangles.data() + side + 2 * kAhead;
    for (int k = 0; k < 3; ++k) buckets.foreseePlace(c[k], c[(k + 1) % 3]);
    c = mesh.triangles.data() + side + kAhead;
    for (int k = 0; k < 3; ++k) buckets.foreseeBucket(c[k], c[(k + 1) % 3]);
  };
  visitSides(mesh, [&](Index a, Index b, Index side) {
    if (stopWantedAt(static_cast<std::size_t>(side), static_cast<std::size_t>(sides), control)) return false;
    if (side % 3 == 0) foresee(side);
    const Index edge = buckets.findOrAdd(a, b, edges);
    if (side >= triangleSides && !std::exchange(surfaceDone, true)) table.surfaceEdges = edges;
    if (edge == edges) {
      table.ends(0, edges) = std::min(a, b);
      table.ends(1, edges++) = std::max(a, b);
    }
    if (side < triangleSides) table.edgeOfSide[static_cast<std::size_t>(side)] = edge;
    return true;
  });
  if (stopWanted(control)) return {};
  if (!surfaceDone) table.surfaceEdges = edges;
  table.ends.conservativeResize(Eigen::NoChange, edges);
  countTriangles(table);
  table.repeated = findRepeated(mesh, table, control);
  if (stopWanted(control)) return {};
  return table;
}

} // namespace esm
