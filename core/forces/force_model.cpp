// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/force_model.h"

#include "core/base/assert.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace esm {
namespace {

/// b = 0 makes the exponential law linear, and a = 0 the cubic one; the linear kernel is cheaper and does not
/// divide by b. Below 1e-9 the two laws differ by less than rounding for strains up to 1e-7/b.
SpringLaw effectiveLaw(SpringLaw law, double parameter) noexcept
{
  if (law == SpringLaw::Exponential && std::abs(parameter) < 1e-9) return SpringLaw::Linear;
  if (law == SpringLaw::Cubic && parameter == 0.0) return SpringLaw::Linear;
  return law;
}

void append(SpringBatch& batch, const SpringNet& net, Index s)
{
  batch.a.push_back(net.ends(0, s));
  batch.b.push_back(net.ends(1, s));
  batch.restLength.push_back(net.restLength[s]);
  batch.stiffness.push_back(net.stiffness[s]);
  batch.viscosity.push_back(net.viscosity[s]);
  batch.parameter.push_back(net.lawParameter[s]);
  batch.spring.push_back(s);
}

void pad(SpringBatch& batch)
{
  batch.count = batch.a.size();
  while (batch.a.size() % 4 != 0) {
    batch.a.push_back(0);
    batch.b.push_back(0);
    batch.restLength.push_back(1.0);
    batch.stiffness.push_back(0.0);
    batch.viscosity.push_back(0.0);
    batch.parameter.push_back(batch.law == SpringLaw::Table ? 0.0 : 1.0);
  }
}

} // namespace

ForceModel::ForceModel(const SpringNet& net, const Eigen::Vector3d& gravity)
  : m_springCount(static_cast<std::size_t>(net.springCount()))
{
  std::array<SpringBatch, 16> bins; // law x tension-only x damped
  for (Index s = 0; s < net.springCount(); ++s) {
    if (net.stiffness[s] == 0.0 && net.viscosity[s] == 0.0) continue;
    const auto place = static_cast<std::size_t>(s);
    const SpringLaw law = effectiveLaw(net.law[place], net.lawParameter[s]);
    const bool tensionOnly = net.tensionOnly[place] != 0, damped = net.viscosity[s] > 0.0;
    SpringBatch& bin = bins[static_cast<std::size_t>(law) * 4 + (tensionOnly ? 2u : 0u) + (damped ? 1u : 0u)];
    bin.law = law;
    bin.tensionOnly = tensionOnly;
    bin.damped = damped;
    append(bin, net, s);
  }
  for (SpringBatch& bin : bins) {
    if (bin.a.empty()) continue;
    if (bin.law == SpringLaw::Table) bin.tables = net.tables;
    pad(bin);
    m_nonlinear = m_nonlinear || bin.law != SpringLaw::Linear;
    for (std::size_t i = 0; i < bin.count; ++i) m_ends.push_back({bin.a[i], bin.b[i]});
    m_activeSprings += static_cast<std::int64_t>(bin.count);
    m_batches.push_back(std::move(bin));
  }
  for (Index node = 0; node < net.nodeCount(); ++node) m_weight.push_back(toLanes(net.mass[node] * gravity));
  for (Index i = 0; i < net.anchors.count(); ++i) {
    const double k = net.anchors.stiffness[i], c = net.anchors.viscosity[i];
    if (k > 0.0 || c > 0.0)
      m_anchors.push_back(
        {net.anchors.node[static_cast<std::size_t>(i)], toLanes(net.anchors.point.col(i)), k, c});
  }
  if (net.massDamping.size() > 0 && net.massDamping.maxCoeff() > 0.0) {
    const Eigen::ArrayXd drag = net.massDamping * net.mass;
    m_massDrag.assign(drag.begin(), drag.end());
  }
}

SpringSums ForceModel::computeForces(const Lanes* x, const Lanes* v, Lanes* force) const noexcept
{
  std::copy(m_weight.begin(), m_weight.end(), force);
  SpringSums sums;
  for (const SpringBatch& batch : m_batches) {
    const SpringSums part = springLawKernel(batch.law).addForces(batch, x, v, force);
    sums.heat += part.heat;
    sums.degenerate += part.degenerate;
  }
  Lanes heat = {0, 0, 0, 0};
  for (const Anchor& anchor : m_anchors) {
    const Lanes drag = v[anchor.node] * anchor.viscosity;
    force[anchor.node] -= (x[anchor.node] - anchor.point) * anchor.stiffness + drag;
    heat += drag * v[anchor.node];
  }
  for (std::size_t i = 0; i < m_massDrag.size(); ++i) {
    const Lanes drag = v[i] * m_massDrag[i];
    force[i] -= drag;
    heat += drag * v[i];
  }
  sums.heat += sumLanes(heat);
  return sums;
}

/// visit(batch, i, d, l) for every active spring, d from a to b [m], l = |d|.
template <class Visit>
void ForceModel::forEachSpring(const Lanes* x, const Visit& visit) const
{
  for (const SpringBatch& batch : m_batches)
    for (std::size_t i = 0; i < batch.count; ++i) {
      const Lanes d = x[batch.b[i]] - x[batch.a[i]];
      visit(batch, i, d, std::sqrt(dot(d, d)));
    }
}

double ForceModel::elasticEnergy(const Lanes* x) const noexcept
{
  double energy = 0.0;
  forEachSpring(x, [&](const SpringBatch& batch, std::size_t i, const Lanes&, double length) {
    const double e = length - batch.restLength[i];
    if (!(batch.tensionOnly && e <= 0.0)) energy += springLawKernel(batch.law).respond(batch, i, e).energy;
  });
  for (const Anchor& anchor : m_anchors) {
    const Lanes away = x[anchor.node] - anchor.point;
    energy += 0.5 * anchor.stiffness * dot(away, away);
  }
  return energy;
}

double ForceModel::gravityEnergy(const Lanes* x) const noexcept
{
  double energy = 0.0;
  for (std::size_t i = 0; i < m_weight.size(); ++i) energy -= dot(m_weight[i], x[i]);
  return energy;
}

void ForceModel::springTensions(const Lanes* x, const Lanes* v, double* tension) const noexcept
{
  std::fill(tension, tension + m_springCount, 0.0);
  forEachSpring(x, [&](const SpringBatch& batch, std::size_t i, const Lanes& d, double length) {
    const double e = length - batch.restLength[i];
    if (length < kMinSpringLength || (batch.tensionOnly && e <= 0.0)) return;
    const double rate = dot(v[batch.b[i]] - v[batch.a[i]], d) / length;
    tension[batch.spring[i]] =
      springLawKernel(batch.law).respond(batch, i, e).tension + batch.viscosity[i] * rate;
  });
}

double ForceModel::largestTension(const Lanes* x, const Lanes* v) const noexcept
{
  double largest = 0.0;
  forEachSpring(x, [&](const SpringBatch& batch, std::size_t i, const Lanes& d, double length) {
    const double e = length - batch.restLength[i];
    if (length < kMinSpringLength || (batch.tensionOnly && e <= 0.0)) return;
    const double rate = dot(v[batch.b[i]] - v[batch.a[i]], d) / length;
    const double tension =
      springLawKernel(batch.law).respond(batch, i, e).tension + batch.viscosity[i] * rate;
    largest = std::max(largest, std::abs(tension));
  });
  return largest;
}

void ForceModel::springTangents(const Lanes* x, const Lanes* v, std::vector<SpringTangent>& tangents) const
{
  tangents.resize(m_ends.size());
  std::size_t place = 0;
  forEachSpring(x, [&](const SpringBatch& batch, std::size_t i, const Lanes& d, double length) {
    SpringTangent& tangent = tangents[place++];
    tangent = SpringTangent{};
    const double e = length - batch.restLength[i];
    if (!(length >= kMinSpringLength) || (batch.tensionOnly && e <= 0.0)) return;
    const SpringResponse response = springLawKernel(batch.law).respond(batch, i, e);
    const double c = batch.viscosity[i];
    const Eigen::Vector3d u = toVector(d) / length, w = toVector(v[batch.b[i]] - v[batch.a[i]]);
    const double rate = u.dot(w);
    tangent = {u, response.tangent, (response.tension + c * rate) / length, c, (c / length) * (w - rate * u)};
  });
}

} // namespace esm
