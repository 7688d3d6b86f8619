// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/system/stiffness_cg.h"

#include "core/linear/gradient_sweeps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace esm {
namespace {

/// solve() ends when the latest terms together are a small enough part of all.
constexpr std::size_t kLatest = 8;
constexpr double kSmallPart = 1e-4; // of b.K^-1 b: a hundredth of the solution
constexpr int kGivingLooks = 24;    ///< iterations of givesWay()

/// Three numbers from -1 to 1 without a pattern, the same ones everywhere.
Lanes scattered(std::size_t i) noexcept
{
  const std::uint32_t bits = static_cast<std::uint32_t>(i + 1) * 2654435761u;
  const auto part = [bits](int shift) { return static_cast<double>((bits >> shift) & 1023u) / 511.5 - 1.0; };
  return Lanes{part(2), part(12), part(22), 0.0};
}

/// r -= step product. @return r.D^-1 r over the free nodes
ESM_CPU_CLONES double takeOff(std::size_t count, double step, const Lanes* product, const double* inverse,
                              Lanes* r) noexcept
{
  Lanes sum = {0, 0, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    r[i] -= product[i] * step;
    sum += r[i] * r[i] * inverse[i];
  }
  return sumLanes(sum);
}

/// p = D^-1 r + keep p; 0 at held nodes
ESM_CPU_CLONES void turn(std::size_t count, double keep, const Lanes* r, const double* inverse,
                         Lanes* p) noexcept
{
  for (std::size_t i = 0; i < count; ++i) p[i] = r[i] * inverse[i] + p[i] * keep;
}

} // namespace

void StiffnessCg::prepare(const System& system, const NodeArray& x, double inertia)
{
  const std::size_t nodes = system.nodeCount();
  for (NodeArray* array : {&m_residual, &m_direction, &m_product, &m_still})
    array->assign(nodes, Lanes{0, 0, 0, 0});
  system.forces().springTangents(x.data(), m_still.data(), m_tangents);
  m_springs.prepare(system.forces());
  m_springs.assign(system.forces(), [this](std::size_t s) {
    return SpringMatrix::Block{m_tangents[s].direction, m_tangents[s].axial, m_tangents[s].lateral};
  });
  m_diagonal.resize(nodes);
  for (std::size_t i = 0; i < nodes; ++i) m_diagonal[i] = inertia * system.mass()[i];
  for (const Anchor& anchor : system.forces().anchors())
    m_diagonal[static_cast<std::size_t>(anchor.node)] += anchor.stiffness;
  for (const ToolSpring& tool : system.tools())
    m_diagonal[static_cast<std::size_t>(tool.node)] += tool.stiffness;
  m_metNegative = false;
  m_products = 0;
  m_inverse = m_diagonal;
  const auto& ends = system.forces().springEnds();
  for (std::size_t s = 0; s < ends.size(); ++s) { // the mean over directions
    const SpringTangent& tangent = m_tangents[s];
    const double held = (std::max(tangent.axial, 0.0) + 2.0 * std::max(tangent.lateral, 0.0)) / 3.0;
    m_inverse[static_cast<std::size_t>(ends[s].a)] += held;
    m_inverse[static_cast<std::size_t>(ends[s].b)] += held;
  }
  for (std::size_t i = 0; i < nodes; ++i)
    m_inverse[i] = system.isFree(i) && m_inverse[i] > 0.0 ? 1.0 / m_inverse[i] : 0.0;
  m_hasNegative = std::any_of(m_tangents.begin(), m_tangents.end(), [](const SpringTangent& tangent) {
    return std::min(tangent.axial, tangent.lateral) < 0.0;
  });
  if (nodes > System::kLarge) m_tangents = std::vector<SpringTangent>();
}

/// Product with the direction. @return the curvature there.
double StiffnessCg::multiply(const System& system) noexcept
{
  ++m_products;
  std::fill(m_product.begin(), m_product.end(), Lanes{0, 0, 0, 0});
  m_springs.addProduct(system.forces(), m_direction.data(), m_product.data());
  return addDiagonal(m_product.size(), m_diagonal.data(), m_direction.data(), m_product.data());
}

/// One iteration. @return the term that it adds to b.K^-1 b [J]; 0 if curvature is negative.
double StiffnessCg::iterate(const System& system, NodeArray* solution) noexcept
{
  const double curvature = multiply(system);
  m_metNegative = !(curvature > 0.0);
  if (m_metNegative) return 0.0;
  const double before = m_square, step = before / curvature;
  const std::size_t nodes = m_residual.size();
  if (solution) advanceNodes(nodes, step, solution->data(), m_direction.data(), solution->data());
  m_square = takeOff(nodes, step, m_product.data(), m_inverse.data(), m_residual.data());
  turn(nodes, m_square / before, m_residual.data(), m_inverse.data(), m_direction.data());
  return step * before;
}

double StiffnessCg::below(const System& system, const NodeArray& b, double enough, int most,
                          const NodeArray* first)
{
  const std::size_t nodes = b.size();
  double bound = 0.0, step = 0.0;
  m_metNegative = false;
  m_residual = b; // same size: no allocation
  if (first) {
    double slope = 0.0;
    for (std::size_t i = 0; i < nodes; ++i) {
      m_direction[i] = system.isFree(i) ? (*first)[i] : Lanes{0, 0, 0, 0};
      slope += dot(m_direction[i], b[i]);
    }
    const double curvature = multiply(system);
    m_metNegative = curvature < 0.0;
    if (m_metNegative) return 0.0;
    if (curvature > 0.0) step = slope / curvature;
    bound = step * slope;
  }
  m_square = takeOff(nodes, step, m_product.data(), m_inverse.data(), m_residual.data());
  turn(nodes, 0.0, m_residual.data(), m_inverse.data(), m_direction.data());
  for (int i = 0; i < most && m_square > 0.0 && bound <= enough && !m_metNegative; ++i)
    bound += iterate(system, nullptr);
  return bound;
}

StiffnessCg::Result StiffnessCg::solve(const System& system, NodeArray& vector, int most)
{
  below(system, vector, 0.0, 0); // begins
  std::fill(vector.begin(), vector.end(), Lanes{0, 0, 0, 0});
  std::array<double, kLatest> latest{};
  double all = 0.0;
  for (int i = 0; i < most && m_square > 0.0; ++i) {
    const double term = iterate(system, &vector);
    if (m_metNegative) return Result::GivesWay;
    all += term;
    latest[static_cast<std::size_t>(i) % kLatest] = term;
    const bool isSmall = std::accumulate(latest.begin(), latest.end(), 0.0) <= kSmallPart * all;
    if (isSmall && i + 1 >= static_cast<int>(kLatest)) return Result::Solved;
  }
  return m_square == 0.0 ? Result::Solved : Result::TooSlow;
}

/// From a pattern without a preferred direction: what pulls at a net in balance may well have no part in the
/// direction in which it would fall.
bool StiffnessCg::givesWay(const System& system, const NodeArray* former)
{
  m_metNegative = false;
  if (!m_hasNegative) return false;
  NodeArray pattern(m_inverse.size());
  for (std::size_t i = 0; i < pattern.size(); ++i)
    pattern[i] = m_inverse[i] > 0.0 ? scattered(i) * std::sqrt(1.0 / m_inverse[i]) : Lanes{0, 0, 0, 0};
  below(system, pattern, std::numeric_limits<double>::infinity(), former ? 2 * kGivingLooks : kGivingLooks,
        former);
  return m_metNegative;
}

} // namespace esm
