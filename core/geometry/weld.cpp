// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/weld.h"

#include "core/base/large_pages.h"
#include "core/geometry/distance.h"
#include "core/geometry/doubles_filter.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace esm {

namespace {

std::uint64_t hashOf(const Eigen::Vector3d& p)
{
  std::uint64_t h = 0;
  for (int k = 0; k < 3; ++k) {
    h = (h ^ std::bit_cast<std::uint64_t>(p[k])) * 0x9e3779b97f4a7c15ull; // 2^64 / golden ratio
    h ^= h >> 29;
  }
  return h;
}

/// Open-addressing hash from a point in space (a position, a grid cell) to a number. The slots hold only
/// places in a dense list: the list is in the order of first appearance, so in a file with any order the
/// next look is near the last one.
class PointTable {
public:
  PointTable() : m_slots(kFirstSize, kNoIndex) {}

  /// The number stored under `key`; if there was none, `value` is stored and returned.
  Index& findOrAdd(const Eigen::Vector3d& key, Index value)
  {
    if (2 * m_entries.size() >= m_slots.size()) grow();
    Index& slot = slotOf(key);
    if (slot == kNoIndex) {
      slot = static_cast<Index>(m_entries.size());
      m_entries.push_back({key, value});
    }
    return m_entries[static_cast<std::size_t>(slot)].value;
  }

  /// The number stored under `key`, or kNoIndex.
  Index find(const Eigen::Vector3d& key)
  {
    const Index slot = slotOf(key);
    return slot == kNoIndex ? kNoIndex : m_entries[static_cast<std::size_t>(slot)].value;
  }

private:
  static constexpr std::size_t kFirstSize = 1024; // a power of two, as all later sizes
  struct Entry {
    Eigen::Vector3d key;
    Index value;
  };

  Index& slotOf(const Eigen::Vector3d& key)
  {
    const std::size_t mask = m_slots.size() - 1;
    std::size_t i = hashOf(key) >> 20 & mask;
    while (m_slots[i] != kNoIndex && m_entries[static_cast<std::size_t>(m_slots[i])].key != key)
      i = (i + 1) & mask;
    return m_slots[i];
  }
  void grow()
  {
    m_slots.assign(4 * m_slots.size(), kNoIndex);
    for (std::size_t i = 0; i < m_entries.size(); ++i) slotOf(m_entries[i].key) = static_cast<Index>(i);
  }

  std::vector<Index> m_slots; ///< places in `m_entries`, or kNoIndex
  std::vector<Entry> m_entries;
};

std::size_t placeOf(const Eigen::Vector3d& p)
{
  return hashOf(p + Eigen::Vector3d::Zero()) >> 20; // -0 becomes 0
}

/// Vertices kept so far, found again by equal position: open addressing over the kept vertices themselves. In
/// a file without order nearly every look misses the caches, so `foresee` fetches the memory of some looks
/// ahead.
class ExactFinder {
public:
  explicit ExactFinder(const Eigen::Matrix3Xd& kept)
    : m_kept(kept),
      m_slots(largeVector(
        std::bit_ceil(std::max<std::size_t>(1024, static_cast<std::size_t>(kept.cols()) / 3)), kNoIndex))
  {}

  static constexpr Index kAhead = 32;

  /// For the `count` <= kAhead vertices that are looked for next.
  void foresee(Index vertex, Index count)
  {
    if (2 * (m_count + kAhead) >= m_slots.size()) grow();
    const std::size_t mask = m_slots.size() - 1;
    for (Index i = 0; i < count; ++i) {
      m_hash[i] = placeOf(m_kept.col(vertex + i));
      __builtin_prefetch(&m_slots[m_hash[i] & mask]);
    }
    for (Index i = 0; i < count; ++i)
      if (const Index slot = m_slots[m_hash[i] & mask]; slot != kNoIndex)
        __builtin_prefetch(m_kept.data() + 3 * std::ptrdiff_t{slot});
    m_next = 0;
  }

  /// The kept vertex at `p`, or `next`, which is then kept there. Vertices come in the order foreseen.
  Index findOrKeep(const Eigen::Vector3d& p, Index next)
  {
    const std::size_t mask = m_slots.size() - 1;
    std::size_t i = m_hash[m_next++] & mask;
    if (!p.allFinite()) return next;
    while (m_slots[i] != kNoIndex && m_kept.col(m_slots[i]) != p) i = (i + 1) & mask;
    if (m_slots[i] == kNoIndex) {
      m_slots[i] = next;
      ++m_count;
    }
    return m_slots[i];
  }

private:
  void grow()
  {
    std::vector<Index> old = largeVector(4 * m_slots.size(), kNoIndex);
    old.swap(m_slots);
    const std::size_t mask = m_slots.size() - 1;
    for (const Index vertex : old) {
      if (vertex == kNoIndex) continue;
      std::size_t i = placeOf(m_kept.col(vertex)) & mask;
      while (m_slots[i] != kNoIndex) i = (i + 1) & mask;
      m_slots[i] = vertex;
    }
  }

  const Eigen::Matrix3Xd& m_kept; ///< kept vertices at their new places, then those to come; not owned
  std::vector<Index> m_slots;     ///< kept vertices, or kNoIndex; a power of two of them
  std::size_t m_count = 0;
  std::array<std::size_t, kAhead> m_hash{}; ///< of the vertices foreseen
  std::size_t m_next = 0;
};

/// Vertices kept so far, found again within a distance. Cells are four tolerances wide, so a ball touches
/// at most two of them along each axis; the vertices of a cell form a chain, newest first, and lie further
/// than the tolerance apart, so chains stay short.
class NearFinder {
public:
  NearFinder(const Eigen::Matrix3Xd& kept, double tolerance) : m_kept(kept), m_tolerance(tolerance) {}

  static constexpr Index kAhead = 4096;
  void foresee(Index, Index) {}

  Index findOrKeep(const Eigen::Vector3d& p, Index next)
  {
    if (!p.allFinite()) return next;
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(m_tolerance);
    const Eigen::Vector3d low = cellOf(p - reach), high = cellOf(p + reach);
    Index nearest = next;
    for (int corner = 0; corner < 8; ++corner) {
      Eigen::Vector3d cell = low;
      bool repeated = false;
      for (int k = 0; k < 3; ++k) {
        if ((corner >> k & 1) == 0) continue;
        repeated = repeated || high[k] == low[k];
        cell[k] = high[k];
      }
      if (!repeated) nearest = std::min(nearest, firstWithin(cell, p, next));
    }
    if (nearest == next) keep(p, next);
    return nearest;
  }

private:
  Eigen::Vector3d cellOf(const Eigen::Vector3d& p) const
  {
    const Eigen::Vector3d scaled = p.array() / (4.0 * m_tolerance);
    return scaled.array().floor() + 0.0; // -0 becomes 0
  }
  Index firstWithin(const Eigen::Vector3d& cell, const Eigen::Vector3d& p, Index none)
  {
    Index first = none;
    for (Index i = m_newest.find(cell); i != kNoIndex; i = m_older[static_cast<std::size_t>(i)])
      if (distance(m_kept.col(i), p) <= m_tolerance) first = i; // the chain leads to earlier ones
    return first;
  }
  void keep(const Eigen::Vector3d& p, Index vertex)
  {
    Index& newest = m_newest.findOrAdd(cellOf(p), vertex);
    m_older.resize(static_cast<std::size_t>(vertex) + 1, kNoIndex);
    if (newest != vertex) m_older[static_cast<std::size_t>(vertex)] = std::exchange(newest, vertex);
  }

  const Eigen::Matrix3Xd& m_kept; ///< kept vertices at their new places; not owned
  double m_tolerance;
  PointTable m_newest;        ///< cell -> its newest vertex
  std::vector<Index> m_older; ///< vertex -> the one before it in the same cell
};

/// Moves kept vertices to the front of `mesh.position` and returns the old-to-new map.
template <class Finder>
std::vector<Index> keepFirst(Mesh& mesh, Finder& finder, WorkControl* control)
{
  const Index count = mesh.vertexCount();
  std::vector<Index> newOf = largeVector(static_cast<std::size_t>(count), kNoIndex);
  Index kept = 0;
  for (Index first = 0; first < count; first += Finder::kAhead) {
    const Index end = std::min(count, first + Finder::kAhead);
    if (stopWantedAt(static_cast<std::size_t>(first), static_cast<std::size_t>(count), control)) break;
    finder.foresee(first, end - first);
    for (Index v = first; v < end; ++v) {
      const Eigen::Vector3d p = mesh.position.col(v);
      const Index place = finder.findOrKeep(p, kept);
      if (place == kept) mesh.position.col(kept++) = p;
      newOf[static_cast<std::size_t>(v)] = place;
    }
  }
  if (kept < count) mesh.position.conservativeResize(Eigen::NoChange, kept);
  return newOf;
}

/// Whether each vertex is at a place of its own: so it is in most files that number their vertices.
bool hasNoEqualVertices(const Mesh& mesh, std::vector<Index>& room, WorkControl* control)
{
  const auto hash = [&mesh](Index v) { return placeOf(mesh.position.col(v)); };
  const std::vector<Index> doubtful = possibleDoubles(mesh.vertexCount(), hash, room, control);
  Mesh some;
  some.position = mesh.position(Eigen::all, doubtful);
  ExactFinder finder(some.position);
  keepFirst(some, finder, control);
  return some.vertexCount() == static_cast<Index>(doubtful.size());
}

} // namespace

std::vector<Index> weldVertices(Mesh& mesh, double tolerance, WorkControl* control)
{
  std::vector<Index> newOf;
  const bool isNumbered =
    mesh.vertexCount() < std::int64_t{3} * mesh.triangleCount(); // not so where corners are vertices
  if (tolerance <= 0.0 && isNumbered) {
    reserveLarge(newOf, static_cast<std::size_t>(mesh.vertexCount()));
    newOf.resize(static_cast<std::size_t>(mesh.vertexCount()));
    if (hasNoEqualVertices(mesh, newOf, control)) {
      std::iota(newOf.begin(), newOf.end(), 0);
      return newOf;
    }
  }
  if (tolerance > 0.0) {
    NearFinder finder(mesh.position, std::min(tolerance, 1e307)); // cells of infinite width have no place
    newOf = keepFirst(mesh, finder, control);
  } else {
    ExactFinder finder(mesh.position);
    newOf = keepFirst(mesh, finder, control);
  }
  const auto renumber = [&newOf](Index& vertex) { vertex = newOf[static_cast<std::size_t>(vertex)]; };
  std::for_each(mesh.triangles.data(), mesh.triangles.data() + mesh.triangles.size(), renumber);
  std::for_each(mesh.segments.data(), mesh.segments.data() + mesh.segments.size(), renumber);
  std::for_each(mesh.tetrahedra.data(), mesh.tetrahedra.data() + mesh.tetrahedra.size(), renumber);
  std::for_each(mesh.diagonals.data(), mesh.diagonals.data() + mesh.diagonals.size(), renumber);
  return newOf;
}

} // namespace esm
