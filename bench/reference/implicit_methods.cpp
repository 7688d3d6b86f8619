// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Linearised implicit Euler (Baraff and Witkin, Large Steps in Cloth Simulation, 1998), solved by conjugate
// gradients with 3 x 3 block Jacobi or by sparse Cholesky; and fast mass springs (Liu, Bargteil, O'Brien,
// Kavan 2013), written as in Liu, Bouaziz, Kavan 2017 so that nonlinear springs and dampers fit in:
// x -= A^-1 grad, A constant, which for linear springs is the alternation of local and global steps.
#include "bench/reference/condensed_matrix.h"
#include "bench/reference/method.h"

#include <Eigen/Dense>

#include <cmath>

namespace esm::bench {
namespace {

/// (M + h D + h^2 K) dv = h (f - h K v), v += dv, x += h v
class BaraffWitkin : public Method {
public:
  void prepare(FastNet& net, double setting, const Scales&) override
  {
    m_steps = static_cast<int>(setting);
    m_right.resize(net.nodeCount());
    m_change.assign(net.nodeCount(), Vec4{0, 0, 0, 0});
  }

  bool frame(FastNet& net, double t0, double t1, bool, Nodes& x, Nodes& v) override
  {
    const double h = (t1 - t0) / m_steps;
    for (int step = 0; step < m_steps; ++step) {
      net.forces(t0 + (step + 1) * h, x.data(), v.data(), m_right.data());
      net.tangents(x, m_tangents);
      for (Vec4& force : m_right) force = -force;
      addStiffnessTimes(net, m_tangents, 0.0, h, v.data(), m_right.data());
      for (std::size_t i = 0; i < x.size(); ++i) m_right[i] *= net.held(i) ? 0.0 : -h;
      if (!solve(net, h)) return false;
      for (std::size_t i = 0; i < x.size(); ++i) {
        if (!net.held(i)) v[i] += m_change[i];
        x[i] += v[i] * h;
      }
    }
    return true;
  }

protected:
  virtual bool solve(FastNet& net, double h) = 0;

  int m_steps = 1;
  std::vector<FastNet::Tangent> m_tangents;
  Nodes m_right, m_change;
};

class BaraffWitkinCholesky final : public BaraffWitkin {
public:
  void prepare(FastNet& net, double setting, const Scales& scales) override
  {
    BaraffWitkin::prepare(net, setting, scales);
    m_matrix.analyse(net);
  }

private:
  bool solve(FastNet& net, double h) override
  {
    if (!m_matrix.factor(net, m_tangents, h, h * h)) return false;
    m_matrix.solve(m_right, m_change);
    return true;
  }
  CondensedMatrix m_matrix;
};

class BaraffWitkinPcg final : public BaraffWitkin {
private:
  /// Starts from the last change of velocity, ends at a thousandth of the right-hand side.
  bool solve(FastNet& net, double h) override
  {
    const std::size_t count = net.nodeCount();
    makePreconditioner(net, h);
    m_product.resize(count);
    m_residual.resize(count);
    m_scaled.resize(count);
    m_search.resize(count);
    multiply(net, h, m_change, m_product);
    for (std::size_t i = 0; i < count; ++i) m_residual[i] = m_right[i] - m_product[i];
    const double goal = 1e-6 * product(m_right, m_right);
    precondition(m_residual, m_scaled);
    m_search = m_scaled;
    double old = product(m_residual, m_scaled);
    for (int iteration = 0; iteration < 1000 && product(m_residual, m_residual) > goal; ++iteration) {
      multiply(net, h, m_search, m_product);
      const double alpha = old / product(m_search, m_product);
      if (!std::isfinite(alpha)) return false;
      for (std::size_t i = 0; i < count; ++i) {
        m_change[i] += m_search[i] * alpha;
        m_residual[i] -= m_product[i] * alpha;
      }
      precondition(m_residual, m_scaled);
      const double next = product(m_residual, m_scaled), beta = next / old;
      for (std::size_t i = 0; i < count; ++i) m_search[i] = m_scaled[i] + m_search[i] * beta;
      old = next;
    }
    return true;
  }

  void multiply(const FastNet& net, double h, const Nodes& p, Nodes& y) const
  {
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = p[i] * net.mass()[i];
    addStiffnessTimes(net, m_tangents, h, h * h, p.data(), y.data());
    for (std::size_t i = 0; i < y.size(); ++i)
      if (net.held(i)) y[i] = p[i];
  }

  void makePreconditioner(const FastNet& net, double h)
  {
    m_blocks.assign(net.nodeCount(), Eigen::Matrix3d::Zero());
    for (std::size_t i = 0; i < m_blocks.size(); ++i) m_blocks[i].diagonal().setConstant(net.mass()[i]);
    for (const FastNet::Anchor& anchor : net.anchors())
      m_blocks[static_cast<std::size_t>(anchor.node)].diagonal().array() +=
        h * anchor.viscosity + h * h * anchor.stiffness;
    for (std::size_t s = 0; s < m_tangents.size(); ++s) {
      const FastNet::Tangent& tangent = m_tangents[s];
      const Eigen::Vector3d u(tangent.u[0], tangent.u[1], tangent.u[2]);
      const double lateral = h * h * tangent.lateral;
      Eigen::Matrix3d block = (h * h * tangent.axial + h * tangent.viscous - lateral) * u * u.transpose();
      block.diagonal().array() += lateral;
      m_blocks[static_cast<std::size_t>(net.springs()[s].a)] += block;
      m_blocks[static_cast<std::size_t>(net.springs()[s].b)] += block;
    }
    for (Eigen::Matrix3d& block : m_blocks) block = block.inverse().eval();
  }

  void precondition(const Nodes& from, Nodes& to) const
  {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Eigen::Matrix3d& block = m_blocks[i];
      for (int row = 0; row < 3; ++row)
        to[i][row] = block(row, 0) * from[i][0] + block(row, 1) * from[i][1] + block(row, 2) * from[i][2];
      to[i][3] = 0.0;
    }
  }

  static double product(const Nodes& a, const Nodes& b)
  {
    Vec4 sum = {0, 0, 0, 0};
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum[0] + sum[1] + sum[2];
  }

  std::vector<Eigen::Matrix3d> m_blocks;
  Nodes m_product, m_residual, m_scaled, m_search;
};

/// Implicit Euler as the minimum of a potential; ten iterations with the factor of the first step.
class FastMassSprings final : public Method {
public:
  void prepare(FastNet& net, double setting, const Scales&) override
  {
    m_steps = static_cast<int>(setting);
    m_force.resize(net.nodeCount());
  }

  bool frame(FastNet& net, double t0, double t1, bool changed, Nodes& x, Nodes& v) override
  {
    const double h = (t1 - t0) / m_steps;
    if (changed && !factor(net, h)) return false;
    Eigen::MatrixXd right(static_cast<Eigen::Index>(x.size()), 3), step(right.rows(), 3);
    for (int s = 0; s < m_steps; ++s) {
      m_x0 = x;
      m_v0 = v;
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += v[i] * h;
      for (int iteration = 0; iteration < 10; ++iteration) {
        for (std::size_t i = 0; i < x.size(); ++i) v[i] = net.held(i) ? m_v0[i] : (x[i] - m_x0[i]) / h;
        net.forces(t0 + (s + 1) * h, x.data(), v.data(), m_force.data());
        for (std::size_t i = 0; i < x.size(); ++i) {
          const Vec4 rest = m_force[i] - (v[i] - m_v0[i]) * (net.mass()[i] / h);
          for (int axis = 0; axis < 3; ++axis)
            right(static_cast<Eigen::Index>(i), axis) = net.held(i) ? 0.0 : rest[axis];
        }
        step = m_factor.solve(right);
        for (std::size_t i = 0; i < x.size(); ++i)
          for (int axis = 0; axis < 3; ++axis) x[i][axis] += step(static_cast<Eigen::Index>(i), axis);
      }
      for (std::size_t i = 0; i < x.size(); ++i)
        if (!net.held(i)) v[i] = (x[i] - m_x0[i]) / h;
    }
    return true;
  }

private:
  /// M/h^2 + sum (k + c/h) (e_b - e_a)(e_b - e_a)^T, one for all three coordinates.
  bool factor(const FastNet& net, double h)
  {
    std::vector<Eigen::Triplet<double>> entries;
    const auto isFree = [&](int node) { return !net.held(static_cast<std::size_t>(node)); };
    for (int i = 0; i < static_cast<int>(net.nodeCount()); ++i)
      entries.emplace_back(i, i, net.mass()[static_cast<std::size_t>(i)] / (h * h));
    for (const FastNet::Anchor& anchor : net.anchors())
      if (isFree(anchor.node))
        entries.emplace_back(anchor.node, anchor.node, anchor.stiffness + anchor.viscosity / h);
    for (const FastNet::Spring& spring : net.springs()) {
      const double weight = spring.stiffness + spring.viscosity / h;
      if (isFree(spring.a)) entries.emplace_back(spring.a, spring.a, weight);
      if (isFree(spring.b)) entries.emplace_back(spring.b, spring.b, weight);
      if (isFree(spring.a) && isFree(spring.b)) entries.emplace_back(spring.b, spring.a, -weight);
    }
    const auto count = static_cast<Eigen::Index>(net.nodeCount());
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    m_factor.compute(matrix);
    return m_factor.info() == Eigen::Success;
  }

  int m_steps = 1;
  Nodes m_force, m_x0, m_v0;
#if defined(ESM_BENCH_CHOLMOD)
  Eigen::CholmodDecomposition<Eigen::SparseMatrix<double>> m_factor;
#else
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> m_factor;
#endif
};

} // namespace

std::unique_ptr<Method> makeBaraffWitkinPcg()
{
  return std::make_unique<BaraffWitkinPcg>();
}

std::unique_ptr<Method> makeBaraffWitkinCholesky()
{
  return std::make_unique<BaraffWitkinCholesky>();
}

std::unique_ptr<Method> makeFastMassSprings()
{
  return std::make_unique<FastMassSprings>();
}

} // namespace esm::bench
