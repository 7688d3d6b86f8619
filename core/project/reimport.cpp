// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/reimport.h"

#include "core/base/hash.h"
#include "core/geometry/pair_key.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace esm {

namespace {

using Place = std::array<double, 3>;

struct PlaceHash {
  std::size_t operator()(const Place& place) const { return hashBytes(place.data(), sizeof place); }
};

Place placeOf(const SpringNet& net, Index node)
{
  // -0 is where 0 is.
  return {net.restPosition(0, node) + 0.0, net.restPosition(1, node) + 0.0, net.restPosition(2, node) + 0.0};
}

bool sameTopology(const SpringNet& a, const SpringNet& b)
{
  return a.nodeCount() == b.nodeCount() && a.springCount() == b.springCount() &&
         a.triangleCount() == b.triangleCount() && a.ends == b.ends && a.triangles == b.triangles;
}

/// Whether places say that the numbers are the same: most nodes have stayed where they were, and none of them
/// has another number now. (Polygons may be cut in another way when a corner has moved.)
bool sameNumbers(const std::vector<Index>& newOf, Index newCount)
{
  std::size_t same = 0, other = 0;
  for (std::size_t i = 0; i < newOf.size(); ++i) {
    same += newOf[i] == static_cast<Index>(i);
    other += newOf[i] != kNoIndex && newOf[i] != static_cast<Index>(i);
  }
  return static_cast<Index>(newOf.size()) == newCount && other == 0 && 2 * same > newOf.size();
}

/// For each old node the new one at its place, or kNoIndex.
std::vector<Index> matchPlaces(const SpringNet& old, const SpringNet& now)
{
  std::vector<Index> newOf(static_cast<std::size_t>(old.nodeCount()), kNoIndex);
  std::unordered_map<Place, Index, PlaceHash> at; // a place that two nodes share goes to the first
  for (Index node = 0; node < now.nodeCount(); ++node) at.emplace(placeOf(now, node), node);
  for (Index node = 0; node < old.nodeCount(); ++node)
    if (const auto found = at.find(placeOf(old, node)); found != at.end()) {
      newOf[static_cast<std::size_t>(node)] = found->second;
      at.erase(found); // each new node once
    }
  return newOf;
}

/// For each old node the new one that it is, or kNoIndex.
std::vector<Index> matchNodes(const SpringNet& old, const SpringNet& now)
{
  std::vector<Index> newOf = matchPlaces(old, now);
  if (sameTopology(old, now) || sameNumbers(newOf, now.nodeCount()))
    for (std::size_t i = 0; i < newOf.size(); ++i) newOf[i] = static_cast<Index>(i);
  return newOf;
}

/// Gives new items the ids of the old ones that they are, and fresh ones to the rest.
template <class Id>
void carryIds(const std::vector<Id>& old, const std::vector<Index>& newOf, std::vector<Id>& ids)
{
  Index next = 0;
  for (const Id id : old) next = std::max(next, static_cast<Index>(id) + 1);
  std::vector<std::uint8_t> known(ids.size(), 0);
  for (std::size_t i = 0; i < old.size(); ++i)
    if (newOf[i] != kNoIndex) {
      ids[static_cast<std::size_t>(newOf[i])] = old[i];
      known[static_cast<std::size_t>(newOf[i])] = 1;
    }
  for (std::size_t i = 0; i < ids.size(); ++i)
    if (!known[i]) ids[i] = Id{next++};
}

/// For each old spring the new one between the same nodes, or kNoIndex.
std::vector<Index> matchSprings(const SpringNet& old, const SpringNet& now,
                                const std::vector<Index>& newOfNode)
{
  std::unordered_map<std::uint64_t, Index> between;
  for (Index s = 0; s < now.springCount(); ++s) between.emplace(pairKey(now.ends(0, s), now.ends(1, s)), s);
  std::vector<Index> newOf(static_cast<std::size_t>(old.springCount()), kNoIndex);
  for (Index s = 0; s < old.springCount(); ++s) {
    const Index a = newOfNode[static_cast<std::size_t>(old.ends(0, s))];
    const Index b = newOfNode[static_cast<std::size_t>(old.ends(1, s))];
    if (a == kNoIndex || b == kNoIndex) continue;
    if (const auto found = between.find(pairKey(a, b)); found != between.end()) {
      newOf[static_cast<std::size_t>(s)] = found->second;
      between.erase(found);
    }
  }
  return newOf;
}

class Carrier {
public:
  Carrier(const Project& before, Reimported& result, const std::vector<Index>& newOf)
    : m_old(before.net), m_result(result), m_now(result.project.net), m_newOf(newOf)
  {}

  void carryNodes()
  {
    Index lostFixed = 0;
    if (m_old.initialVelocity.cols() > 0) m_now.initialVelocity.setZero(3, m_now.nodeCount());
    if (m_old.massDamping.size() > 0) m_now.massDamping.setZero(m_now.nodeCount());
    for (Index node = 0; node < m_old.nodeCount(); ++node) {
      const Index to = newOf(node);
      const std::uint8_t fixed = m_old.fixed[static_cast<std::size_t>(node)];
      if (to == kNoIndex) {
        lostFixed += fixed != 0;
        continue;
      }
      m_now.fixed[static_cast<std::size_t>(to)] = fixed;
      if (m_old.initialVelocity.cols() > 0) m_now.initialVelocity.col(to) = m_old.initialVelocity.col(node);
      if (m_old.massDamping.size() > 0) m_now.massDamping[to] = m_old.massDamping[node];
    }
    if (lostFixed > 0) note(std::to_string(lostFixed) + " fixed nodes are not there any more");
    carryIds(m_old.nodeId, m_newOf, m_now.nodeId);
  }

  void carrySprings()
  {
    const std::vector<Index> newOfSpring = matchSprings(m_old, m_now, m_newOf);
    Index lost = 0;
    for (std::size_t s = 0; s < newOfSpring.size(); ++s) {
      if (newOfSpring[s] == kNoIndex)
        lost += m_old.tensionOnly[s] != 0;
      else
        m_now.tensionOnly[static_cast<std::size_t>(newOfSpring[s])] = m_old.tensionOnly[s];
    }
    if (lost > 0) note(std::to_string(lost) + " tension-only springs are not there any more");
    carryIds(m_old.springId, newOfSpring, m_now.springId);
  }

  template <class Load>
  void carryLoads(const std::vector<Load>& before, std::vector<Load>& now, const std::string& what)
  {
    now.clear();
    for (std::size_t i = 0; i < before.size(); ++i) {
      Load load = before[i];
      std::vector<Index> nodes;
      for (const Index node : load.nodes)
        if (const Index to = newOf(node); to != kNoIndex) nodes.push_back(to);
      const std::size_t had = load.nodes.size();
      const std::string name = what + " " + std::to_string(i + 1);
      if (nodes.empty() && had > 0) {
        note(name + " is left out: none of its nodes is there any more");
        continue;
      }
      if (nodes.size() < had)
        note(name + " acts on " + std::to_string(nodes.size()) + " nodes instead of " + std::to_string(had));
      load.nodes = std::move(nodes);
      now.push_back(std::move(load));
    }
  }

private:
  Index newOf(Index node) const { return m_newOf[static_cast<std::size_t>(node)]; }
  void note(std::string text) { m_result.notes.push_back(std::move(text)); }

  const SpringNet& m_old;
  Reimported& m_result;
  SpringNet& m_now;
  const std::vector<Index>& m_newOf;
};

} // namespace

Result<Reimported> reimport(const Project& before, SpringNet net, ImportRecipe recipe)
{
  if (before.source.files.empty() || !before.parametersFromTissue)
    return Error{ErrorCode::InvalidValue, "the net of this project did not come from mesh files"};
  const std::vector<Index> newOf = matchNodes(before.net, net);
  Reimported result;
  result.project = before;
  result.project.net = std::move(net);
  result.project.source = std::move(recipe);
  const auto kept = std::count_if(newOf.begin(), newOf.end(), [](Index node) { return node != kNoIndex; });
  result.unchanged = static_cast<Index>(kept);
  result.added = result.project.net.nodeCount() - result.unchanged;
  result.gone = before.net.nodeCount() - result.unchanged;

  Carrier carrier(before, result, newOf);
  carrier.carryNodes();
  carrier.carrySprings();
  Loads& loads = result.project.loads;
  carrier.carryLoads(before.loads.forces, loads.forces, "force");
  carrier.carryLoads(before.loads.motions, loads.motions, "motion");
  if (const auto applied = applyTissue(result.project.tissue, result.project.net); !applied)
    return applied.error();
  return result;
}

} // namespace esm
