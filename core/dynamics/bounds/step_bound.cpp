// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/bounds/step_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace esm {
namespace {

constexpr int kLooksBetween = 2;  ///< two measurements, see StepBound::sharpen()
constexpr std::size_t kHub = 128; ///< springs of a node, see StepBound::sumHub()

/// y = factor y + diagonal z
ESM_CPU_CLONES void addDiagonal(std::size_t count, const double* factor, const double* diagonal,
                                const Lanes* z, Lanes* y) noexcept
{
  for (std::size_t i = 0; i < count; ++i) y[i] = y[i] * factor[i] + z[i] * diagonal[i];
}

bool isDamped(const FastestMode& mode) noexcept
{
  return mode.damping > 0.0 && std::isfinite(mode.damping);
}

/// What the sums know of measureUndamped().
double undampedSum(const FastestMode& mode, double share) noexcept
{
  return mode.undamped + (1.0 - share) * mode.stiffness;
}

} // namespace

void StepBound::prepare(bool findsDecay) noexcept
{
  m_findsDecay = findsDecay;
  m_isLaidOut = false;
  m_stiffnessSharpness = m_dampingSharpness = Sharpness{};
  m_decayShare = 0.0; // the first guess is that nothing decays faster than it swings
  m_sinceMeasured = kLooksBetween;
}

void StepBound::layOut(const System& system)
{
  const auto& ends = system.forces().springEnds();
  m_springsOf.build(system.nodeCount(), [&](const auto& add) {
    for (std::size_t s = 0; s < ends.size(); ++s)
      for (const Index node : {ends[s].a, ends[s].b}) add(node, static_cast<std::uint32_t>(s));
  });
  m_isLaidOut = true;
}

void StepBound::makeRoom(const System& system)
{
  const std::size_t springs = system.forces().springEnds().size();
  m_tangents.resize(springs);
  for (auto* array : {&m_rootStiffness, &m_rootViscosity, &m_rowStiffness, &m_rowViscosity})
    array->resize(springs);
  m_nodes.resize(system.nodeCount());
}

void StepBound::freeRoom()
{
  m_tangents = std::vector<SpringTangent>();
  for (auto* array : {&m_rootStiffness, &m_rootViscosity, &m_rowStiffness, &m_rowViscosity, &m_undamped,
                      &m_rootInverseMass, &m_diagonal, &m_turning})
    *array = std::vector<double>();
  m_nodes = std::vector<NodeSums>();
  m_springs = SpringMatrix();
  m_scaled = NodeArray();
  m_pressure.clear();
  m_lanczos = Lanczos();
}

/// Nothing is done without pressure.
void StepBound::sumPressure(const System& system, const NodeArray& x)
{
  const Pressure& pressure = system.forces().pressure();
  m_pressureStiffness = 0.0;
  m_pressure.resize(pressure.bodyCount());
  m_turning.assign(pressure.isEmpty() ? 0 : m_nodes.size(), 0.0);
  for (std::size_t body = 0; body < m_pressure.size(); ++body) {
    NodeArray& column = m_pressure[body];
    column.assign(m_nodes.size(), Lanes{0, 0, 0, 0});
    pressure.addGradient(body, x.data(), column.data());
    const double root = std::sqrt(pressure.stiffness(body));
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
      column[i] *= root * std::sqrt(system.inverseMass()[i]);
      m_pressureStiffness += dot(column[i], column[i]);
    }
    pressure.boundTurning(
      body, x.data(), [this](Index node, double most) { m_turning[static_cast<std::size_t>(node)] += most; });
  }
}

/// Row sums over nodes, scaled by the masses' roots: sum k (1/m_i + 1/sqrt(m_i m_j)).
void StepBound::sumNodes(const System& system)
{
  const auto& inverseMass = system.inverseMass();
  std::fill(m_nodes.begin(), m_nodes.end(), NodeSums{});
  for (const ForceModel::Anchor& anchor : system.forces().anchors()) {
    NodeSums& node = m_nodes[static_cast<std::size_t>(anchor.node)];
    node.stiffness += anchor.stiffness;
    node.damping += anchor.viscosity;
  }
  for (const ToolSpring& tool : system.tools()) {
    NodeSums& node = m_nodes[static_cast<std::size_t>(tool.node)];
    node.stiffness += tool.stiffness;
    node.damping += tool.viscosity;
  }
  for (std::size_t i = 0; i < m_turning.size(); ++i) m_nodes[i].stiffness += m_turning[i];
  const auto& massDrag = system.forces().massDrag();
  for (std::size_t i = 0; i < m_nodes.size(); ++i) {
    m_nodes[i].total = m_nodes[i].stiffness;
    m_nodes[i].stiffness *= inverseMass[i];
    m_nodes[i].damping = (m_nodes[i].damping + (massDrag.empty() ? 0.0 : massDrag[i])) * inverseMass[i];
  }
  const auto& ends = system.forces().springEnds();
  for (std::size_t s = 0; s < ends.size(); ++s) {
    const auto a = static_cast<std::size_t>(ends[s].a), b = static_cast<std::size_t>(ends[s].b);
    const double axial = std::max(m_tangents[s].axial, 0.0), lateral = std::abs(m_tangents[s].lateral);
    const double cross = std::sqrt(inverseMass[a] * inverseMass[b]);
    for (const std::size_t i : {a, b}) {
      const double weight = inverseMass[i] + cross;
      m_nodes[i].axial += axial * weight;
      m_nodes[i].lateral += lateral * weight;
      m_nodes[i].viscous += m_tangents[s].viscous * weight;
      m_nodes[i].total += axial;
    }
  }
}

/// Row sums of |G|, which sees the angles between springs.
void StepBound::sumSprings(const System& system)
{
  const auto& inverseMass = system.inverseMass();
  for (std::size_t s = 0; s < m_tangents.size(); ++s) {
    m_rootStiffness[s] = std::sqrt(std::max(m_tangents[s].axial, 0.0));
    m_rootViscosity[s] = std::sqrt(m_tangents[s].viscous);
    m_rowStiffness[s] = m_rowViscosity[s] = 0.0;
  }
  for (std::size_t i = 0; i < m_nodes.size(); ++i) {
    if (inverseMass[i] == 0.0) continue;
    const std::span<const std::uint32_t> springs = m_springsOf[i];
    if (springs.size() > kHub) {
      sumHub(springs, m_rootStiffness, inverseMass[i], m_rowStiffness);
      sumHub(springs, m_rootViscosity, inverseMass[i], m_rowViscosity);
      continue;
    }
    sumPairs(springs, inverseMass[i]);
  }
}

/// The rows of a node pair by pair, on what its springs have gathered side by side: struts make many pairs.
void StepBound::sumPairs(std::span<const std::uint32_t> springs, double inverseMass)
{
  struct Row {
    double x[kHub], y[kHub], z[kHub], root[kHub], rootViscosity[kHub], stiffness[kHub], viscosity[kHub];
  } row;
  const std::size_t count = springs.size();
  for (std::size_t p = 0; p < count; ++p) {
    const std::uint32_t e = springs[p];
    const Eigen::Vector3d& u = m_tangents[e].direction;
    row.x[p] = u.x();
    row.y[p] = u.y();
    row.z[p] = u.z();
    row.root[p] = m_rootStiffness[e];
    row.rootViscosity[p] = m_rootViscosity[e];
    row.stiffness[p] = m_rowStiffness[e];
    row.viscosity[p] = m_rowViscosity[e];
  }
  for (std::size_t p = 0; p < count; ++p) {
    double k[kHub], c[kHub];
    for (std::size_t q = 0; q <= p; ++q) {
      const double cosine =
        std::abs(row.x[p] * row.x[q] + row.y[p] * row.y[q] + row.z[p] * row.z[q]) * inverseMass;
      k[q] = cosine * row.root[p] * row.root[q];
      c[q] = cosine * row.rootViscosity[p] * row.rootViscosity[q];
    }
    for (std::size_t q = 0; q < p; ++q) {
      row.stiffness[q] += k[q];
      row.viscosity[q] += c[q];
    }
    for (std::size_t q = 0; q <= p; ++q) {
      row.stiffness[p] += k[q];
      row.viscosity[p] += c[q];
    }
  }
  for (std::size_t p = 0; p < count; ++p) {
    m_rowStiffness[springs[p]] = row.stiffness[p];
    m_rowViscosity[springs[p]] = row.viscosity[p];
  }
}

/// The rows of a node with many springs, which pair by pair took the square of their number: with weights w
/// the sum of w |u_e.u_f| over f is at most the root of (sum of w) (u_e.A u_e), A the sum of w u u^T.
void StepBound::sumHub(std::span<const std::uint32_t> springs, const std::vector<double>& weight,
                       double inverseMass, std::vector<double>& rows) const
{
  Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();
  double sum = 0.0;
  for (const std::uint32_t f : springs) {
    directions += weight[f] * m_tangents[f].direction * m_tangents[f].direction.transpose();
    sum += weight[f];
  }
  for (const std::uint32_t e : springs) {
    const Eigen::Vector3d& u = m_tangents[e].direction;
    rows[e] += inverseMass * weight[e] * std::sqrt(sum * std::max(u.dot(directions * u), 0.0));
  }
}

/// What the modes owe to the dampers, see FastestMode.
void StepBound::weighDamping(const System& system, FastestMode& mode)
{
  double least = std::numeric_limits<double>::infinity();
  const auto owes = [&](double k, double c) {
    if (!(k > 0.0)) return 0.0;
    if (!(c > 0.0)) return k;
    least = std::min(least, c / k);
    return 0.0;
  };
  const auto& inverseMass = system.inverseMass();
  m_undamped.assign(m_nodes.size(), 0.0);
  const auto& ends = system.forces().springEnds();
  for (std::size_t s = 0; s < ends.size(); ++s) {
    const auto a = static_cast<std::size_t>(ends[s].a), b = static_cast<std::size_t>(ends[s].b);
    const double k = owes(m_tangents[s].axial, m_tangents[s].viscous) + std::abs(m_tangents[s].lateral);
    const double cross = std::sqrt(inverseMass[a] * inverseMass[b]);
    m_undamped[a] += k * (inverseMass[a] + cross);
    m_undamped[b] += k * (inverseMass[b] + cross);
  }
  const auto single = [&](Index node, double k, double c) {
    const auto i = static_cast<std::size_t>(node);
    m_undamped[i] += owes(k, c) * inverseMass[i];
  };
  for (const Anchor& anchor : system.forces().anchors())
    single(anchor.node, anchor.stiffness, anchor.viscosity);
  for (const ToolSpring& tool : system.tools()) single(tool.node, tool.stiffness, tool.viscosity);
  for (std::size_t i = 0; i < m_turning.size(); ++i) m_undamped[i] += m_turning[i] * inverseMass[i];
  for (const double undamped : m_undamped) mode.undamped = std::max(mode.undamped, undamped);
  mode.undamped += m_pressureStiffness;
  mode.leastDamping = std::isfinite(least) ? least : 0.0;
}

/// Largest eigenvalue of the blend of M^-1/2 D M^-1/2 and M^-1/2 K M^-1/2. Where K adds, pressed and
/// softening springs count as if they were stiff, as in the sums: they may be so in the next moment. Where it
/// is taken away, they count as what they are.
double StepBound::measure(const System& system, Blend blend)
{
  constexpr int kProducts = 16;
  constexpr double kMargin = 1.02; // Ritz values come from below
  const ForceModel& forces = system.forces();
  m_springs.prepare(forces);
  m_springs.assign(forces, [&](std::size_t s) {
    const SpringTangent& tangent = m_tangents[s];
    return SpringMatrix::Block{
      tangent.direction, blend.damping * tangent.viscous + blend.stiffness * std::max(tangent.axial, 0.0),
      std::abs(blend.stiffness * tangent.lateral)};
  });
  const std::size_t nodes = m_nodes.size();
  m_rootInverseMass.resize(nodes);
  m_scaled.resize(nodes);
  m_diagonal.resize(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    m_rootInverseMass[i] = std::sqrt(system.inverseMass()[i]);
    m_diagonal[i] = blend.damping * m_nodes[i].damping + blend.stiffness * m_nodes[i].stiffness;
  }
  const auto multiply = [&](const NodeArray& z, NodeArray& y) {
    scaleNodes(nodes, m_rootInverseMass.data(), z.data(), m_scaled.data());
    std::fill(y.begin(), y.end(), Lanes{0, 0, 0, 0});
    m_springs.addProduct(forces, m_scaled.data(), y.data(), system.workers());
    addDiagonal(nodes, m_rootInverseMass.data(), m_diagonal.data(), z.data(), y.data());
    for (const NodeArray& column : m_pressure) {
      double along = 0.0;
      for (std::size_t i = 0; i < m_nodes.size(); ++i) along += dot(column[i], z[i]);
      for (std::size_t i = 0; i < m_nodes.size(); ++i) y[i] += column[i] * (blend.stiffness * along);
    }
  };
  return kMargin * m_lanczos.largestEigenvalue(nodes, kProducts, multiply);
}

/// See the class. With f(q) the largest eigenvalue of M^-1 (D - K/q), any q >= sqrt(stiffness) with f(q) <= q
/// is a bound, too: the mode of the fastest root r has f(q) >= q from its slower root on, which is at most
/// sqrt(stiffness), up to r. So a guess is tried before the long way down from `damping`. Nothing that
/// oscillates is slower than sqrt(stiffness): no need to know more exactly.
double StepBound::measureDecay(const System& system, const FastestMode& mode)
{
  constexpr int kMostRounds = 5;
  constexpr double kFirmness = 0.9; ///< share of the stiffness that will stay in the next moments
  constexpr double kRoom = 1.05;    ///< for the guess
  const double slowest = std::sqrt(mode.stiffness);
  const auto bound = [&](double q) { return std::max(measure(system, {1.0, -kFirmness / q}), 0.0); };
  double decay = mode.damping;
  if (const double guess = kRoom * std::max(slowest, m_decayShare * mode.damping); guess < decay)
    if (const double next = bound(guess); next <= guess) decay = next;
  for (int round = 0; round < kMostRounds && decay > slowest; ++round) {
    const double next = bound(decay);
    if (!(next < 0.97 * decay)) break;
    decay = next;
  }
  return decay;
}

/// Largest eigenvalue of M^-1 (K - share D/leastDamping), where it is below the row sums. These are twice as
/// large where taut springs without dampers (or the tension across damped ones) meet; each per cent of it is
/// a step.
double StepBound::measureUndamped(const System& system, const FastestMode& mode, double share)
{
  constexpr double kOfSpread = 0.004; ///< of all eigenvalues, that Ritz values of these may be off
  const double perDamping = share / mode.leastDamping, room = kOfSpread * perDamping * mode.damping;
  const double sum = undampedSum(mode, share);
  if (!(room < sum)) return sum;
  const double measured = std::max(measure(system, {-perDamping, 1.0}), 0.0) + room;
  return std::min(sum, measured); // not a number: the sums
}

/// Twice: for all that is owed, and for the share with which that leaves to the fastest damper just what
/// `stiffness` is beyond it. Where dampers go with the springs, hardly more is undamped then: it is tension.
void StepBound::measureShares(const System& system, const FastestMode& mode)
{
  m_undampedShare = m_owedShare = m_undampedByShare = 1.0;
  if (!isDamped(mode) || !(mode.leastDamping > 0.0)) return;
  const double undamped = measureUndamped(system, mode, 1.0);
  if (mode.undamped > 0.0) m_undampedShare = undamped / mode.undamped;
  const double share = (mode.stiffness - undamped) * mode.leastDamping / mode.damping;
  if (!(share > 0.0 && share < 1.0)) return;
  m_owedShare = share;
  m_undampedByShare = measureUndamped(system, mode, share) / undampedSum(mode, share);
}

/// Measures where the sums have moved, and at every other look: how far the sums are above the eigenvalues,
/// and how much of the stiffness holds up what the dampers brake or goes without them, changes with the
/// directions, which the sums hardly tell. Of a tube that springs back the first was seen to go from 0.88 to
/// 1, the second likewise, while its sums moved by 2 %.
void StepBound::sharpen(const System& system, FastestMode& mode)
{
  const bool isDue = ++m_sinceMeasured >= kLooksBetween;
  bool isNew = isDue;
  const auto follow = [&](double& bound, Sharpness& sharpness, Blend blend) {
    if (!(bound > 0.0) || !std::isfinite(bound)) return;
    if (isDue || !(std::abs(bound - sharpness.at) <= 0.1 * sharpness.at)) {
      const double measured = measure(system, blend);
      sharpness = {std::isfinite(measured) ? std::min(1.0, measured / bound) : 1.0, bound};
      isNew = true;
    }
    bound *= sharpness.ratio;
  };
  follow(mode.stiffness, m_stiffnessSharpness, {0.0, 1.0});
  follow(mode.damping, m_dampingSharpness, {1.0, 0.0});
  if (isNew) {
    m_sinceMeasured = 0;
    m_decayShare = isDamped(mode) && m_findsDecay ? measureDecay(system, mode) / mode.damping : 1.0;
    measureShares(system, mode);
  }
  mode.decay = m_decayShare * mode.damping;
  mode.owedShare = m_owedShare;
  mode.undampedByShare = m_undampedByShare * undampedSum(mode, m_owedShare);
  mode.undamped *= m_undampedShare;
}

FastestMode StepBound::compute(const System& system, const NodeArray& x, const NodeArray& v)
{
  if (!m_isLaidOut) layOut(system);
  makeRoom(system);
  system.forces().springTangents(x.data(), v.data(), m_tangents);
  sumPressure(system, x);
  sumNodes(system);
  sumSprings(system);
  double axial = 0.0, viscous = 0.0, lateral = 0.0, anchored = 0.0, drag = 0.0;
  double nodeStiffness = 0.0, nodeDamping = 0.0, fastest = -1.0;
  for (const double row : m_rowStiffness) axial = std::max(axial, row);
  for (const double row : m_rowViscosity) viscous = std::max(viscous, row);
  FastestMode mode;
  for (std::size_t i = 0; i < m_nodes.size(); ++i) {
    const NodeSums& node = m_nodes[i];
    lateral = std::max(lateral, node.lateral);
    anchored = std::max(anchored, node.stiffness);
    drag = std::max(drag, node.damping);
    const double k = node.axial + node.lateral + node.stiffness, c = node.viscous + node.damping;
    nodeStiffness = std::max(nodeStiffness, k);
    nodeDamping = std::max(nodeDamping, c);
    const double rate = std::max(0.5 * std::sqrt(k), 0.6 * c); // as velocity Verlet weighs them
    if (rate > fastest && system.isFree(i)) {
      fastest = rate;
      mode.node = static_cast<Index>(i);
      mode.springStiffness = node.total;
    }
  }
  mode.stiffness = std::min(nodeStiffness, axial + lateral + anchored) + m_pressureStiffness;
  mode.damping = std::min(nodeDamping, viscous + drag);
  weighDamping(system, mode);
  sharpen(system, mode);
  return mode;
}

} // namespace esm
