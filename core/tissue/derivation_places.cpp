// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/derivation_places.h"

#include "core/net/net_builder.h"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace esm {

namespace {

/// Section of a line between two nodes [m^2]: the mean of their dual areas, where only one end lies on the
/// surface that one's; off it altogether a round cord as thick as the wall.
double lineSection(double areaA, double areaB, double thickness)
{
  if (areaA > 0.0 && areaB > 0.0) return 0.5 * (areaA + areaB);
  const double area = std::max(areaA, areaB);
  return area > 0.0 ? area : std::numbers::pi / 4.0 * thickness * thickness;
}

} // namespace

DerivationPlaces::DerivationPlaces(const SpringNet& net)
  : springs(net.springCount()),
    nodes(net.nodeCount()),
    point(3, springs + nodes),
    dualArea(nodeDualAreas(net)),
    volume(net.volume),
    edgeArea(edgeTriangleAreas(net)),
    perModulus(springs),
    section(Eigen::ArrayXd::Zero(springs))
{
  for (Index s = 0; s < springs; ++s) point.col(s) = net.middleOf(s);
  point.rightCols(nodes) = net.restPosition;

  for (Index node = 0; node < nodes; ++node)
    if (!hasTissue(node)) loose.push_back(node);
  if (loose.empty()) return;
  looseOfNode.assign(static_cast<std::size_t>(nodes), kNoIndex);
  for (std::size_t i = 0; i < loose.size(); ++i)
    looseOfNode[static_cast<std::size_t>(loose[i])] = static_cast<Index>(i);
  looseSprings.build(loose.size(), [&](const auto& add) {
    for (Index s = 0; s < springs; ++s)
      for (int end = 0; end < 2; ++end)
        if (const Index i = looseOfNode[static_cast<std::size_t>(net.ends(end, s))]; i != kNoIndex) add(i, s);
  });
}

SpringGeometry DerivationPlaces::springGeometry(Index spring, double thickness, const SpringNet& net) const
{
  const Index a = net.ends(0, spring), b = net.ends(1, spring);
  const double own = net.sectionOf(spring), length = net.restLength[spring];
  const double line = own > 0.0 ? own : lineSection(dualArea[a], dualArea[b], thickness);
  SpringGeometry geometry;
  geometry.isWall = net.kind[static_cast<std::size_t>(spring)] == SpringKind::Edge && !(own > 0.0);
  geometry.area = geometry.isWall ? edgeArea[spring] : line;
  if (length > 0.0)
    geometry.perModulus = geometry.isWall ? thickness * edgeArea[spring] / (length * length) : line / length;
  geometry.perModulus *= net.material.modulusScale;
  geometry.section = hasTissue(a) && hasTissue(b) ? 0.0 : line;
  return geometry;
}

void DerivationPlaces::setThickness(double thickness, const SpringNet& net)
{
  for (Index s = 0; s < springs; ++s) {
    const SpringGeometry geometry = springGeometry(s, thickness, net);
    perModulus[s] = geometry.perModulus;
    section[s] = geometry.section;
  }
}

Reach reachOf(const RegionShape& shape, const Eigen::Matrix3Xd& points)
{
  Reach reach;
  for (Index place = 0; place < static_cast<Index>(points.cols()); ++place) {
    const double weight = shape.weight(points.col(place));
    if (weight == 0.0) continue;
    reach.place.push_back(place);
    reach.weight.push_back(weight);
  }
  return reach;
}

double ReachCursor::weightAt(Index place) noexcept
{
  const std::vector<Index>& places = m_reach.place;
  std::size_t step = 1, end = m_next; // in leaps that double, then back by halves
  while (end < places.size() && places[end] < place) {
    m_next = end + 1;
    end += step;
    step *= 2;
  }
  const auto first = places.begin();
  end = std::min(end, places.size());
  const auto found = std::lower_bound(first + static_cast<std::ptrdiff_t>(m_next),
                                      first + static_cast<std::ptrdiff_t>(end), place);
  m_next = static_cast<std::size_t>(found - first);
  return m_next < places.size() && places[m_next] == place ? m_reach.weight[m_next] : 0.0;
}

void TouchedPlaces::clear()
{
  for (const Index place : m_list) m_flag[static_cast<std::size_t>(place)] = 0;
  m_list.clear();
  m_isSorted = true;
  m_looks = 0;
}

void TouchedPlaces::add(Index place)
{
  std::uint8_t& flag = m_flag[static_cast<std::size_t>(place)];
  if (flag) return;
  flag = 1;
  m_isSorted = m_isSorted && (m_list.empty() || m_list.back() < place);
  m_list.push_back(place);
}

void TouchedPlaces::addAll()
{
  m_list.resize(m_flag.size());
  std::iota(m_list.begin(), m_list.end(), 0);
  std::fill(m_flag.begin(), m_flag.end(), std::uint8_t{1});
  m_isSorted = true;
  m_looks += std::ssize(m_list);
}

void TouchedPlaces::addReach(const Reach& reach)
{
  for (const Index place : reach.place) add(place);
  m_looks += std::ssize(reach.place);
}

void TouchedPlaces::hideUnder(const Reach& reach)
{
  ReachCursor weight(reach);
  const std::vector<Index>& list = sorted();
  m_looks += std::ssize(list);
  std::erase_if(m_list, [&](Index place) {
    if (weight.weightAt(place) != 1.0) return false;
    m_flag[static_cast<std::size_t>(place)] = 0;
    return true;
  });
}

void TouchedPlaces::addMoved(const Reach& before, const Reach& after)
{
  std::size_t i = 0, j = 0;
  std::vector<Index> hidden;
  while (i < before.place.size() || j < after.place.size()) {
    const bool onlyBefore =
      j == after.place.size() || (i < before.place.size() && before.place[i] < after.place[j]);
    const bool onlyAfter =
      i == before.place.size() || (j < after.place.size() && after.place[j] < before.place[i]);
    const Index place = onlyBefore ? before.place[i] : after.place[j];
    if (onlyBefore || onlyAfter || before.weight[i] != after.weight[j])
      add(place);
    else if (after.weight[j] == 1.0 && has(place))
      hidden.push_back(place);
    i += onlyAfter ? 0 : 1;
    j += onlyBefore ? 0 : 1;
  }
  m_looks += std::ssize(before.place) + std::ssize(after.place);
  if (hidden.empty()) return;
  for (const Index place : hidden) m_flag[static_cast<std::size_t>(place)] = 0;
  std::erase_if(m_list, [&](Index place) { return !has(place); });
}

const std::vector<Index>& TouchedPlaces::sorted()
{
  if (!m_isSorted) std::sort(m_list.begin(), m_list.end());
  m_isSorted = true;
  return m_list;
}

} // namespace esm
