// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/force_model.h"

#include "core/base/assert.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace esm {
namespace {

/// Time of a triangle's pressure, in units of passCost().
constexpr double kTriangleCost = 1.4;

/// Springs of more tables than that are not sorted by them: a batch each would be dearer than looking them
/// up.
constexpr std::size_t kFewTables = 32;

/// Of a damped spring against a linear one, measured. Exponential ones take 1.4 by now; with that eight uteri
/// took 4 % more passes at 1e-2 where nobody knows the end, the one of the bench for real time a fifth more.
double lawCost(SpringLaw law) noexcept
{
  switch (law) {
  case SpringLaw::Linear:
    return 1.0;
  case SpringLaw::Cubic:
    return 1.1;
  case SpringLaw::Exponential:
    return 1.9;
  case SpringLaw::Table:
    return 2.0; // of ten points
  }
  return 1.0;
}

/// Springs that do anything, by the lower of their ends: neighbours in memory are touched together.
std::vector<Index> activeByLowerEnd(const SpringNet& net)
{
  std::vector<Index> order;
  order.reserve(static_cast<std::size_t>(net.springCount()));
  for (Index s = 0; s < net.springCount(); ++s)
    if (net.stiffness[s] != 0.0 || net.viscosity[s] != 0.0) order.push_back(s);
  const auto lower = [&](Index s) { return std::min(net.ends(0, s), net.ends(1, s)); };
  std::stable_sort(order.begin(), order.end(), [&](Index s, Index t) { return lower(s) < lower(t); });
  return order;
}

} // namespace

SpringLaw effectiveLaw(SpringLaw law, double parameter) noexcept
{
  if (law == SpringLaw::Exponential && std::abs(parameter) < 1e-9) return SpringLaw::Linear;
  if (law == SpringLaw::Cubic && parameter == 0.0) return SpringLaw::Linear;
  return law;
}

ForceModel::ForceModel(const SpringNet& net, const Eigen::Vector3d& gravity)
  : m_springCount(static_cast<std::size_t>(net.springCount()))
{
  const NetDivision division(net, activeByLowerEnd(net));
  m_firstPart = division.firstPart;
  const auto tables = std::make_shared<std::vector<TableLines>>(net.tables.begin(), net.tables.end());
  for (std::size_t p = 0; p < division.partCount(); ++p) {
    const std::size_t firstBatch = m_batches.size(), damper = m_damperSize;
    addBatches(net, tables,
               std::span(division.springs.begin() + static_cast<std::ptrdiff_t>(division.first[p]),
                         division.first[p + 1] - division.first[p]));
    m_parts.push_back({firstBatch, m_batches.size(), damper});
  }
  m_passCost += 0.1 * static_cast<double>(net.nodeCount());
  compileNodes(net, gravity, division.ranges);
  m_pressure = Pressure(net);
  m_passCost += kTriangleCost * static_cast<double>(m_pressure.triangleCount());
}

void ForceModel::compileNodes(const SpringNet& net, const Eigen::Vector3d& gravity, const NodeRanges& ranges)
{
  m_anchors.clear();
  m_anchors.reserve(net.anchors.node.size());
  for (Index i = 0; i < net.anchors.count(); ++i) {
    const double k = net.anchors.stiffness[i], c = net.anchors.viscosity[i];
    if (k > 0.0 || c > 0.0)
      m_anchors.push_back(
        {toLanes(net.anchors.point.col(i)), k, c, net.anchors.node[static_cast<std::size_t>(i)], i});
  }
  if (ranges.count() > 1)
    std::stable_sort(m_anchors.begin(), m_anchors.end(),
                     [](const Anchor& a, const Anchor& b) { return a.node < b.node; });
  m_massDrag.clear();
  if (net.massDamping.size() > 0 && net.massDamping.maxCoeff() > 0.0) {
    const Eigen::ArrayXd drag = net.massDamping * net.mass;
    m_massDrag.assign(drag.begin(), drag.end());
  }
  m_nodeForces = NodeForces(net, gravity, m_anchors, m_massDrag, ranges);
}

/// The springs of one part, by kind; those of few tables table by table.
void ForceModel::addBatches(const SpringNet& net, const SharedTables& tables, std::span<const Index> springs)
{
  const std::size_t groups = tables->size() <= kFewTables ? std::max<std::size_t>(tables->size(), 1) : 1;
  std::vector<std::vector<Index>> bins(16 * groups); // law x tension-only x damped x table
  for (const Index s : springs) {
    const auto place = static_cast<std::size_t>(s);
    const SpringLaw law = effectiveLaw(net.law[place], net.lawParameter[s]);
    const std::size_t kind = static_cast<std::size_t>(law) * 4 + (net.tensionOnly[place] != 0 ? 2u : 0u) +
                             (net.viscosity[s] > 0.0 ? 1u : 0u);
    const bool isSorted = law == SpringLaw::Table && groups > 1;
    bins[kind * groups + (isSorted ? static_cast<std::size_t>(net.lawParameter[s]) : 0)].push_back(s);
  }
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    if (bins[bin].empty()) continue;
    const std::size_t kind = bin / groups;
    SpringBatch batch;
    batch.law = static_cast<SpringLaw>(kind / 4);
    batch.tensionOnly = kind % 4 >= 2;
    batch.damped = kind % 2 == 1;
    if (batch.law == SpringLaw::Table) batch.tables = tables;
    for (const Index s : bins[bin]) batch.append(net, s);
    batch.finish(static_cast<std::size_t>(net.nodeCount()));
    m_nonlinear = m_nonlinear || batch.law != SpringLaw::Linear;
    for (std::size_t i = 0; i < batch.count; ++i) m_ends.push_back({batch.a[i], batch.b[i]});
    m_activeSprings += static_cast<std::int64_t>(batch.count);
    m_damperSize += esm::damperSize(batch);
    m_passCost += static_cast<double>(batch.count) * (lawCost(batch.law) - (batch.damped ? 0.0 : 0.35));
    m_batches.push_back(std::move(batch));
  }
}

/// Before the springs of a part: it may be a range's own.
void ForceModel::sweepOwn(const NodeSweep& sweep, std::size_t part) const noexcept
{
  if (sweep && part < nodeRanges().count()) sweep(nodeRanges().first(part), nodeRanges().size(part));
}

double ForceModel::computeForces(const Lanes* x, const Lanes* v, Lanes* force, Lanes* damper,
                                 WorkerPool* workers, const NodeSweep& before,
                                 const Lateness& late) const noexcept
{
  double heat[NetDivision::kMostParts];
  forEachSpringPart(workers, [&](std::size_t p) noexcept {
    const Part& part = m_parts[p];
    Lanes* kept = damper != nullptr ? damper + part.damper : nullptr;
    sweepOwn(before, p);
    heat[p] = p < nodeRanges().count() ? m_nodeForces.set(p, x, v, force) : 0.0;
    for (std::size_t b = part.firstBatch; b < part.endBatch; ++b) {
      const SpringBatch& batch = m_batches[b];
      heat[p] += springLawKernel(batch.law).addForces(batch, x, v, force, kept, late);
      if (kept != nullptr) kept += esm::damperSize(batch);
    }
  });
  m_pressure.addForces(x, force);
  return std::accumulate(heat, heat + m_parts.size(), 0.0);
}

void ForceModel::addDamping(const Lanes* damper, const Lanes* v, Lanes* force, WorkerPool* workers,
                            const NodeSweep& before) const noexcept
{
  forEachSpringPart(workers, [&](std::size_t p) noexcept {
    sweepOwn(before, p);
    const Lanes* kept = damper + m_parts[p].damper;
    for (std::size_t b = m_parts[p].firstBatch; b < m_parts[p].endBatch; ++b) {
      esm::addDamping(m_batches[b], kept, v, force);
      kept += esm::damperSize(m_batches[b]);
    }
    if (p < nodeRanges().count()) m_nodeForces.addFewDampers(p, v, force);
  });
}

double ForceModel::elasticEnergy(const Lanes* x, WorkerPool* workers) const noexcept
{
  double parts[NetDivision::kMostParts];
  forEachSpringPart(workers, [&](std::size_t p) noexcept {
    parts[p] = 0.0;
    for (std::size_t b = m_parts[p].firstBatch; b < m_parts[p].endBatch; ++b)
      parts[p] += springLawKernel(m_batches[b].law).energy(m_batches[b], x);
  });
  double energy = std::accumulate(parts, parts + m_parts.size(), 0.0);
  for (const Anchor& anchor : m_anchors) {
    const Lanes away = x[anchor.node] - anchor.point;
    energy += 0.5 * anchor.stiffness * dot(away, away);
  }
  if (!m_pressure.isEmpty()) energy += m_pressure.energy(x);
  return energy;
}

double ForceModel::gravityEnergy(const Lanes* x) const noexcept
{
  double energy = 0.0;
  for (std::size_t i = 0; i < nodeCount(); ++i) energy -= dot(weight(i), x[i]);
  return energy;
}

void ForceModel::springTensions(const Lanes* x, const Lanes* v, double* tension,
                                WorkerPool* workers) const noexcept
{
  std::fill(tension, tension + m_springCount, 0.0);
  forEachBatch(workers, [&](std::size_t b) noexcept {
    springLawKernel(m_batches[b].law).tensions(m_batches[b], x, v, tension);
  });
}

double ForceModel::largestTension(const Lanes* x, const Lanes* v, WorkerPool* workers) const noexcept
{
  double parts[NetDivision::kMostParts];
  forEachSpringPart(workers, [&](std::size_t p) noexcept {
    parts[p] = 0.0;
    for (std::size_t b = m_parts[p].firstBatch; b < m_parts[p].endBatch; ++b)
      parts[p] = std::max(parts[p], springLawKernel(m_batches[b].law).tensions(m_batches[b], x, v, nullptr));
  });
  return std::accumulate(parts, parts + m_parts.size(), 0.0,
                         [](double a, double b) { return std::max(a, b); });
}

void ForceModel::springTangents(const Lanes* x, const Lanes* v, std::vector<SpringTangent>& tangents) const
{
  tangents.resize(m_ends.size());
  std::size_t place = 0;
  for (const SpringBatch& batch : m_batches)
    for (std::size_t i = 0; i < batch.count; ++i) {
      SpringTangent& tangent = tangents[place++];
      tangent = SpringTangent{};
      const Lanes d = x[batch.b[i]] - x[batch.a[i]];
      const double length = std::sqrt(dot(d, d)), e = length - batch.restLength[i];
      if (!(length >= kMinSpringLength) || (batch.tensionOnly && e <= 0.0)) continue;
      const SpringResponse response = springLawKernel(batch.law).respond(batch, i, e);
      const double c = batch.viscosity[i];
      const Eigen::Vector3d u = toVector(d) / length, w = toVector(v[batch.b[i]] - v[batch.a[i]]);
      const double rate = u.dot(w);
      tangent = {u, response.tangent, (response.tension + c * rate) / length, c,
                 (c / length) * (w - rate * u)};
    }
}

} // namespace esm
