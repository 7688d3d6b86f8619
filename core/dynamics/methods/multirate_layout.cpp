// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/multirate_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace esm {
namespace {

constexpr int kMostClasses = 13;            ///< 4096 ticks of the fastest in a base step
constexpr double kLongestStep = 1.0 / 60.0; ///< [s]
/// Share of the limit of a class by itself that is used: row sums bound it well from above, but the classes
/// also act on each other.
constexpr double kStepShare = 0.8;
/// Time per spring with a rate of its own (kSpringCost in multirate.cpp) over that in a Verlet step, nodes
/// included.
constexpr double kCostOverVerlet = 2.3;

/// Largest step for w2 [1/s^2] and g [1/s] by Verlet's limit h^2 w2 / 4 + 3/5 h g < 1.
double limit(double stiffness, double damping) noexcept
{
  const double linear = 0.6 * damping;
  return kStepShare * 2.0 / (linear + std::sqrt(linear * linear + stiffness));
}

void append(SpringBatch& to, const SpringBatch& from, std::size_t i)
{
  to.a.push_back(from.a[i]);
  to.b.push_back(from.b[i]);
  to.restLength.push_back(from.restLength[i]);
  to.stiffness.push_back(from.stiffness[i]);
  to.viscosity.push_back(from.viscosity[i]);
  to.parameter.push_back(from.parameter[i]);
  to.spring.push_back(from.spring[i]);
}

} // namespace

MultirateLayout::Plan MultirateLayout::plan(const System& system)
{
  const auto& inverseMass = system.inverseMass();
  std::vector<double> stiffness(inverseMass.size(), 0.0), viscosity(inverseMass.size(), 0.0);
  for (const SpringBatch& batch : system.forces().batches())
    for (std::size_t i = 0; i < batch.count; ++i)
      for (const Index node : {batch.a[i], batch.b[i]}) {
        stiffness[static_cast<std::size_t>(node)] += batch.stiffness[i];
        viscosity[static_cast<std::size_t>(node)] += batch.viscosity[i];
      }
  // In a triangle net the largest eigenvalue is about 1.3 times a node's sum.
  const auto nodeLimit = [&](Index node) {
    const auto i = static_cast<std::size_t>(node);
    return inverseMass[i] > 0.0
             ? limit(1.3 * stiffness[i] * inverseMass[i], 1.3 * viscosity[i] * inverseMass[i])
             : kLongestStep;
  };
  std::vector<double> limits; // by spring
  for (const SpringBatch& batch : system.forces().batches())
    for (std::size_t i = 0; i < batch.count; ++i)
      limits.push_back(std::min(nodeLimit(batch.a[i]), nodeLimit(batch.b[i])));
  double shortest = kLongestStep;
  for (const double stable : limits) shortest = std::min(shortest, stable);
  std::array<double, kMostClasses> count{}; // springs that need shortest * 2^c
  for (const double stable : limits) {
    const double octave = std::floor(std::log2(stable / shortest) + 1e-9);
    count[static_cast<std::size_t>(std::clamp(octave, 0.0, kMostClasses - 1.0))] += 1.0;
  }
  const auto cost = [&](int base) { // per `shortest`, slower classes joined to `base`
    double sum = 0.0;
    for (int c = 0; c < kMostClasses; ++c)
      sum += std::ldexp(count[static_cast<std::size_t>(c)], -std::min(c, base));
    return sum;
  };
  int base = 0;
  while (base + 1 < kMostClasses && cost(base) > 1.1 * cost(kMostClasses - 1) &&
         std::ldexp(shortest, base + 1) <= kLongestStep)
    ++base;
  // Verlet would step with all springs at `shortest`, undivided by kStepShare, and has less to do per spring.
  const bool pays = kCostOverVerlet * cost(base) < kStepShare * static_cast<double>(limits.size());
  return {std::ldexp(shortest, base), std::ldexp(cost(base), base), pays};
}

void MultirateLayout::build(const System& system, const NodeArray& x, const NodeArray& v, double step)
{
  m_step = step;
  measure(system, x, v);
  m_linksOf.build(system.nodeCount(), [&](const auto& add) {
    for (std::size_t link = 0; link < m_links.size(); ++link)
      for (const Index node : {m_links[link].a, m_links[link].b})
        if (node != kNoIndex) add(node, static_cast<std::uint32_t>(link));
  });
  assignLevels(system);
  fillClasses(system);
}

bool MultirateLayout::isOutgrown(const System& system, const NodeArray& x, const NodeArray& v)
{
  const std::size_t before = m_links.size();
  measure(system, x, v);
  if (m_links.size() != before) return true;
  for (std::size_t link = 0; link < m_links.size(); ++link)
    if (!fits(system, link, m_level[link])) return true;
  return false;
}

void MultirateLayout::measure(const System& system, const NodeArray& x, const NodeArray& v)
{
  const ForceModel& forces = system.forces();
  forces.springTangents(x.data(), v.data(), m_tangents);
  m_links.clear();
  for (std::size_t s = 0; s < m_tangents.size(); ++s) {
    const SpringTangent& tangent = m_tangents[s];
    m_links.push_back({forces.springEnds()[s].a, forces.springEnds()[s].b, std::max(tangent.axial, 0.0),
                       std::abs(tangent.lateral), tangent.viscous, tangent.direction});
  }
  const Eigen::Vector3d all = Eigen::Vector3d::Zero();
  for (const Anchor& anchor : forces.anchors())
    m_links.push_back({anchor.node, kNoIndex, anchor.stiffness, 0.0, anchor.viscosity, all});
  for (std::size_t i = 0; i < forces.massDrag().size(); ++i)
    m_links.push_back({static_cast<Index>(i), kNoIndex, 0.0, 0.0, forces.massDrag()[i], all});
  for (const ToolSpring& tool : system.tools())
    m_links.push_back({tool.node, kNoIndex, tool.stiffness, 0.0, tool.viscosity, all});
}

/// Whether a link is stable at step m_step / 2^level beside those of its level and the slower ones: its row
/// in Gershgorin's sum over links, as StepBound has it.
bool MultirateLayout::fits(const System& system, std::size_t link, int level) const
{
  const auto& inverseMass = system.inverseMass();
  const Link& self = m_links[link];
  double stiffness = 0.0, damping = 0.0;
  for (const Index end : {self.a, self.b}) {
    if (end == kNoIndex) continue;
    const auto node = static_cast<std::size_t>(end);
    if (inverseMass[node] == 0.0) continue;
    double rowStiffness = 0.0, rowDamping = 0.0;
    for (const std::size_t place : m_linksOf[node]) {
      if (m_level[place] > level) continue;
      const Link& other = m_links[place];
      const double cosine = place == link || other.b == kNoIndex || self.b == kNoIndex
                              ? 1.0
                              : std::abs(self.direction.dot(other.direction));
      rowStiffness += std::sqrt(self.axial * other.axial) * cosine + 2.0 * other.lateral;
      rowDamping += std::sqrt(self.viscosity * other.viscosity) * cosine;
    }
    stiffness += rowStiffness * inverseMass[node];
    damping += rowDamping * inverseMass[node];
  }
  return !(std::ldexp(m_step, -level) > limit(stiffness, damping));
}

void MultirateLayout::assignLevels(const System& system)
{
  m_level.assign(m_links.size(), 0);
  for (int level = 0; level + 1 < kMostClasses; ++level)
    for (bool moved = true; moved;) {
      moved = false;
      for (std::size_t link = 0; link < m_links.size(); ++link)
        if (m_level[link] == level && !fits(system, link, level)) {
          m_level[link] = level + 1;
          moved = true;
        }
    }
  std::vector<int> fastest(system.nodeCount(), 0);
  const auto forFreeEnds = [&](const auto& visit) {
    for (std::size_t link = 0; link < m_links.size(); ++link)
      for (const Index end : {m_links[link].a, m_links[link].b})
        if (end != kNoIndex && system.isFree(static_cast<std::size_t>(end)))
          visit(static_cast<std::size_t>(end), m_level[link]);
  };
  forFreeEnds([&](std::size_t node, int& level) { fastest[node] = std::max(fastest[node], level); });
  forFreeEnds([&](std::size_t node, int& level) { level = std::max(level, fastest[node] - 1); });
}

void MultirateLayout::fillClasses(const System& system)
{
  const ForceModel& forces = system.forces();
  const int levels = m_level.empty() ? 1 : *std::max_element(m_level.begin(), m_level.end()) + 1;
  m_classes.assign(static_cast<std::size_t>(levels), RateClass{});
  std::size_t link = 0;
  for (const SpringBatch& batch : forces.batches()) {
    std::vector<SpringBatch> parts(m_classes.size());
    for (std::size_t i = 0; i < batch.count; ++i)
      append(parts[static_cast<std::size_t>(m_level[link++])], batch, i);
    for (std::size_t c = 0; c < parts.size(); ++c) {
      SpringBatch& part = parts[c];
      if (part.a.empty()) continue;
      part.law = batch.law;
      part.damped = batch.damped;
      part.tensionOnly = batch.tensionOnly;
      part.tables = batch.tables;
      part.finish(system.nodeCount());
      m_classes[c].springs += static_cast<std::int64_t>(part.count);
      m_classes[c].batches.push_back(std::move(part));
    }
  }
  const auto classOfNext = [&]() -> RateClass& {
    return m_classes[static_cast<std::size_t>(m_level[link++])];
  };
  for (const Anchor& anchor : forces.anchors()) classOfNext().anchors.push_back(anchor);
  for (std::size_t i = 0; i < forces.massDrag().size(); ++i)
    classOfNext().anchors.push_back({Lanes{0, 0, 0, 0}, 0.0, forces.massDrag()[i], static_cast<Index>(i)});
  for (std::size_t i = 0; i < system.tools().size(); ++i) classOfNext().tools.push_back(i);

  // Which nodes feel which class. Weight and loads belong to the slowest one, which so has all nodes.
  std::vector<std::uint32_t> felt(system.nodeCount(), 1u);
  for (std::size_t l = 0; l < m_links.size(); ++l)
    for (const Index end : {m_links[l].a, m_links[l].b})
      if (end != kNoIndex) felt[static_cast<std::size_t>(end)] |= 1u << m_level[l];
  std::vector<std::uint8_t> driven(system.nodeCount(), 0);
  for (const LoadSchedule::PrescribedNode& node : system.schedule().prescribedNodes())
    if (system.schedule().isActive(node)) driven[static_cast<std::size_t>(node.node)] = 1;
  for (std::size_t c = 0; c < m_classes.size(); ++c)
    for (const bool own : {true, false}) {
      for (std::size_t i = 0; i < felt.size(); ++i) {
        if (!(felt[i] >> c & 1u)) continue;
        const bool isFastest = felt[i] >> c == 1u;
        if ((system.isFree(i) || driven[i]) && isFastest == own)
          m_classes[c].nodes.push_back(static_cast<Index>(i));
        if (own && driven[i]) m_classes[c].driven.push_back(static_cast<Index>(i));
      }
      if (own) m_classes[c].own = m_classes[c].nodes.size();
    }
}

} // namespace esm
