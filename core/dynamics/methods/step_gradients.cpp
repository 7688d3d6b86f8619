// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/step_gradients.h"

#include "core/forces/spring_pass.h"
#include "core/linear/gradient_sweeps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace esm {
namespace {

constexpr std::size_t kLatest = 4;

/// Of symmetric blocks, by their adjugate; 0 for held nodes. @return 0, or NaN where one is not finite.
ESM_CPU_CLONES double invert(std::size_t count, const double* inverseMass, const Lanes* straight,
                             const Lanes* mixed, NodeBlock* inverse) noexcept
{
  double probe = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!(inverseMass[i] > 0.0)) {
      inverse[i] = NodeBlock{};
      continue;
    }
    const double xx = straight[i][0], yy = straight[i][1], zz = straight[i][2];
    const double xy = mixed[i][0], xz = mixed[i][1], yz = mixed[i][2];
    const double axx = yy * zz - yz * yz, axy = xz * yz - xy * zz, axz = xy * yz - xz * yy;
    const double over = 1.0 / (xx * axx + xy * axy + xz * axz);
    probe += over * 0.0;
    const Lanes columns[3] = {Lanes{axx, axy, axz, 0} * over,
                              Lanes{axy, xx * zz - xz * xz, xy * xz - xx * yz, 0} * over,
                              Lanes{axz, xy * xz - xx * yz, xx * yy - xy * xy, 0} * over};
    for (std::size_t k = 0; k < 3; ++k) inverse[i].column[k] = columns[k];
  }
  return probe;
}

} // namespace

void StepGradients::prepare(const System& system)
{
  const std::size_t nodes = system.nodeCount();
  for (NodeArray* array : {&m_residual, &m_direction, &m_product, &m_scaled, &m_straight, &m_mixed})
    array->assign(nodes, Lanes{0, 0, 0, 0});
  m_springs.prepare(system.forces());
  m_diagonal.assign(nodes, 0.0);
  m_inverse.assign(nodes, {});
  m_pressure.resize(system.forces().pressure().bodyCount());
  for (PressureColumn& column : m_pressure) column.gradient.assign(nodes, Lanes{0, 0, 0, 0});
}

bool StepGradients::set(const System& system, const NodeArray& x, const NodeArray& v, double h)
{
  const ForceModel& forces = system.forces();
  const std::vector<double>& drag = forces.massDrag();
  for (std::size_t i = 0; i < m_diagonal.size(); ++i)
    m_diagonal[i] = system.mass()[i] + (drag.empty() ? 0.0 : h * drag[i]);
  const auto hold = [&](Index node, double viscosity, double stiffness) {
    m_diagonal[static_cast<std::size_t>(node)] += h * viscosity + h * h * stiffness;
  };
  for (const Anchor& anchor : forces.anchors()) hold(anchor.node, anchor.viscosity, anchor.stiffness);
  for (const ToolSpring& tool : system.tools()) hold(tool.node, tool.viscosity, tool.stiffness);
  system.sweepNodes([&](std::size_t first, std::size_t count) noexcept {
    for (std::size_t i = first; i < first + count; ++i) {
      const double own = m_diagonal[i];
      m_straight[i] = Lanes{own, own, own, 0};
      m_mixed[i] = Lanes{0, 0, 0, 0};
    }
  });
  m_springs.assignTangents(forces, x.data(), v.data(), {h, h * h}, system.workers());
  m_springs.addDiagonal(forces, m_straight.data(), m_mixed.data(), system.workers());
  const Pressure& pressure = forces.pressure();
  for (std::size_t body = 0; body < m_pressure.size(); ++body) {
    PressureColumn& column = m_pressure[body];
    std::fill(column.gradient.begin(), column.gradient.end(), Lanes{0, 0, 0, 0});
    pressure.addGradient(body, x.data(), column.gradient.data());
    for (std::size_t i = 0; i < m_inverse.size(); ++i)
      if (!system.isFree(i)) column.gradient[i] = Lanes{0, 0, 0, 0};
    column.stiffness = h * h * pressure.stiffness(body);
  }
  return system.sumNodes([&](std::size_t first, std::size_t count) noexcept {
    return invert(count, system.inverseMass().data() + first, m_straight.data() + first,
                  m_mixed.data() + first, m_inverse.data() + first);
  }) == 0.0;
}

/// m_product = A m_direction. @return the curvature in that direction.
double StepGradients::multiply(System& system) noexcept
{
  system.solverWork += kPerIteration * static_cast<double>(system.forces().activeSprings());
  system.sweepNodes([&](std::size_t first, std::size_t count) noexcept {
    std::fill_n(m_product.data() + first, count, Lanes{0, 0, 0, 0});
  });
  m_springs.addProduct(system.forces(), m_direction.data(), m_product.data(), system.workers());
  for (const PressureColumn& column : m_pressure) {
    double along = 0.0;
    for (std::size_t i = 0; i < m_direction.size(); ++i) along += dot(column.gradient[i], m_direction[i]);
    advanceNodes(m_product.size(), column.stiffness * along, m_product.data(), column.gradient.data(),
                 m_product.data());
  }
  return system.sumNodes([&](std::size_t first, std::size_t count) noexcept {
    return addDiagonal(count, m_diagonal.data() + first, m_direction.data() + first,
                       m_product.data() + first);
  });
}

StepGradients::Solved StepGradients::solve(System& system, NodeArray& vector, const NodeArray* first,
                                           double smallPart, int most) noexcept
{
  const std::size_t nodes = m_inverse.size();
  m_residual.swap(vector);
  std::fill(vector.begin(), vector.end(), Lanes{0, 0, 0, 0});
  std::fill(m_direction.begin(), m_direction.end(), Lanes{0, 0, 0, 0});
  double step = 0.0, all = 0.0; // what the terms lower the potential by
  if (first != nullptr) {
    double slope = 0.0;
    for (std::size_t i = 0; i < nodes; ++i) {
      if (!system.isFree(i)) continue;
      m_direction[i] = (*first)[i];
      slope += dot(m_direction[i], m_residual[i]);
    }
    const double curvature = multiply(system);
    if (curvature > 0.0) step = slope / curvature;
    all = step * slope;
  }
  if (step == 0.0) std::fill(m_product.begin(), m_product.end(), Lanes{0, 0, 0, 0}); // 0 times what it holds
  const auto take = [&](double length) {
    return system.sumNodes([&](std::size_t i, std::size_t count) noexcept {
      return takeStep(count, length, m_direction.data() + i, m_product.data() + i, m_inverse.data() + i,
                      vector.data() + i, m_residual.data() + i, m_scaled.data() + i);
    });
  };
  double square = take(step);
  m_direction = m_scaled; // same size: no allocation
  std::array<double, kLatest> latest;
  latest.fill(std::numeric_limits<double>::infinity());
  Solved solved;
  while (solved.iterations < most && square > 0.0 && !system.isExhausted()) {
    const double curvature = multiply(system);
    if (!(curvature > 0.0)) break; // rounding
    const double term = square * square / curvature;
    const double next = take(square / curvature), turn = next / square;
    system.sweepNodes([&](std::size_t i, std::size_t count) noexcept {
      advanceNodes(count, turn, m_scaled.data() + i, m_direction.data() + i, m_direction.data() + i);
    });
    square = next;
    all += term;
    latest[static_cast<std::size_t>(solved.iterations++) % kLatest] = term;
    solved.left = std::min(std::accumulate(latest.begin(), latest.end(), 0.0) / all, 1.0);
    if (solved.left <= smallPart) break;
  }
  if (!(square > 0.0)) solved.left = 0.0;
  return solved;
}

} // namespace esm
