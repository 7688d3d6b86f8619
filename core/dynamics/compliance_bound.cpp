// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/compliance_bound.h"

#include <algorithm>

namespace esm {
namespace {

/// product += diagonal p. @return p.product
ESM_CPU_CLONES double addDiagonal(std::size_t count, const double* diagonal, const Lanes* p,
                                  Lanes* product) noexcept
{
  Lanes sum = {0, 0, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    product[i] += p[i] * diagonal[i];
    sum += p[i] * product[i];
  }
  return sumLanes(sum);
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

void ComplianceBound::prepare(const System& system, const NodeArray& x, double inertia)
{
  const std::size_t nodes = system.nodeCount();
  for (NodeArray* array : {&m_residual, &m_direction, &m_product, &m_still})
    array->assign(nodes, Lanes{0, 0, 0, 0});
  system.forces().springTangents(x.data(), m_still.data(), m_tangents);
  m_springs.assign(system.forces().batches(), [this](std::size_t s) {
    return SpringMatrix::Block{m_tangents[s].direction, m_tangents[s].axial, m_tangents[s].lateral};
  });
  m_diagonal.resize(nodes);
  for (std::size_t i = 0; i < nodes; ++i) m_diagonal[i] = inertia * system.mass()[i];
  for (const Anchor& anchor : system.forces().anchors())
    m_diagonal[static_cast<std::size_t>(anchor.node)] += anchor.stiffness;
  for (const ToolSpring& tool : system.tools())
    m_diagonal[static_cast<std::size_t>(tool.node)] += tool.stiffness;
  m_metNegative = false;
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
}

/// Product with the direction. @return the curvature there.
double ComplianceBound::multiply(const System& system) noexcept
{
  std::fill(m_product.begin(), m_product.end(), Lanes{0, 0, 0, 0});
  m_springs.addProduct(system.forces().batches(), m_direction.data(), m_product.data());
  return addDiagonal(m_product.size(), m_diagonal.data(), m_direction.data(), m_product.data());
}

double ComplianceBound::below(const System& system, const NodeArray& b, double enough, int most,
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
  double square = takeOff(nodes, step, m_product.data(), m_inverse.data(), m_residual.data());
  turn(nodes, 0.0, m_residual.data(), m_inverse.data(), m_direction.data());
  for (int i = 0; i < most && square > 0.0 && bound <= enough; ++i) {
    const double curvature = multiply(system);
    m_metNegative = !(curvature > 0.0);
    if (m_metNegative) break;
    step = square / curvature;
    bound += step * square;
    const double next = takeOff(nodes, step, m_product.data(), m_inverse.data(), m_residual.data());
    turn(nodes, next / square, m_residual.data(), m_inverse.data(), m_direction.data());
    square = next;
  }
  return bound;
}

} // namespace esm
