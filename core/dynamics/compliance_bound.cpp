// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/compliance_bound.h"

#include <limits>

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

/// r -= step product. @return r.M^-1 r over the free nodes
ESM_CPU_CLONES double takeOff(std::size_t count, double step, const Lanes* product, const double* inverseMass,
                              Lanes* r) noexcept
{
  Lanes sum = {0, 0, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    r[i] -= product[i] * step;
    sum += r[i] * r[i] * inverseMass[i];
  }
  return sumLanes(sum);
}

/// p = M^-1 r + keep p; 0 at held nodes
ESM_CPU_CLONES void turn(std::size_t count, double keep, const Lanes* r, const double* inverseMass,
                         Lanes* p) noexcept
{
  for (std::size_t i = 0; i < count; ++i) p[i] = r[i] * inverseMass[i] + p[i] * keep;
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
}

double ComplianceBound::below(const System& system, const NodeArray& b, double enough, int most)
{
  const std::size_t nodes = b.size();
  const double* inverseMass = system.inverseMass().data();
  m_residual = b; // same size: no allocation
  double square = takeOff(nodes, 0.0, m_product.data(), inverseMass, m_residual.data());
  turn(nodes, 0.0, m_residual.data(), inverseMass, m_direction.data());
  double bound = 0.0;
  for (int i = 0; i < most && square > 0.0 && bound <= enough; ++i) {
    std::fill(m_product.begin(), m_product.end(), Lanes{0, 0, 0, 0});
    m_springs.addProduct(system.forces().batches(), m_direction.data(), m_product.data());
    const double curvature = addDiagonal(nodes, m_diagonal.data(), m_direction.data(), m_product.data());
    if (!(curvature > 0.0)) return std::numeric_limits<double>::infinity();
    const double step = square / curvature;
    bound += step * square;
    const double next = takeOff(nodes, step, m_product.data(), inverseMass, m_residual.data());
    turn(nodes, next / square, m_residual.data(), inverseMass, m_direction.data());
    square = next;
  }
  return bound;
}

} // namespace esm
