// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/quality/linear_net.h"

#include "core/forces/pressure.h"
#include "core/geometry/union_find.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace esm {

namespace {

/// Multiplications of a factor, a second or two; fewer where struts make gradients quick.
constexpr double kMostWork = 4e9, kMostWorkBraced = 2e8;
constexpr double kBraced = 4.0; ///< springs per node, from which on a net is braced: a skin has three
constexpr std::size_t kMostNumbers = 40000000; ///< in a factor

NodeBlock blockOf(const Eigen::Matrix3d& matrix)
{
  NodeBlock block;
  for (int column = 0; column < 3; ++column) block.column[column] = toLanes(matrix.col(column));
  return block;
}

Eigen::Matrix3d skew(const Eigen::Vector3d& r)
{
  Eigen::Matrix3d matrix;
  matrix << 0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0;
  return matrix;
}

/// Of a symmetric matrix; what is zero but for rounding stays zero.
template <int size>
Eigen::Matrix<double, size, size> pseudoInverse(const Eigen::Matrix<double, size, size>& matrix)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, size, size>> solver(matrix);
  Eigen::Matrix<double, size, 1> inverse = solver.eigenvalues();
  const double least = size * std::numeric_limits<double>::epsilon() * inverse.cwiseAbs().maxCoeff();
  for (double& value : inverse) value = std::abs(value) > least ? 1.0 / value : 0.0;
  return solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
}

double dotOf(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b)
{
  return a.cwiseProduct(b).sum();
}

} // namespace

LinearNet::LinearNet(const SpringNet& net, const Eigen::ArrayXd& stiffness, bool withAnchors)
  : m_net(net),
    m_stiffness(stiffness),
    m_direction(3, net.springCount()),
    m_blockOf(static_cast<std::size_t>(net.nodeCount()), kNoIndex),
    m_diagonal(static_cast<std::size_t>(net.nodeCount()), Eigen::Matrix3d::Zero())
{
  for (Index node = 0; node < net.nodeCount(); ++node)
    if (!net.fixed[static_cast<std::size_t>(node)]) {
      m_blockOf[static_cast<std::size_t>(node)] = static_cast<Index>(m_nodeOf.size());
      m_nodeOf.push_back(node);
    }
  for (Index s = 0; s < net.springCount(); ++s) {
    const Index a = net.ends(0, s), b = net.ends(1, s);
    m_direction.col(s) = (net.restPosition.col(b) - net.restPosition.col(a)).normalized();
    const Eigen::Matrix3d block = stiffness[s] * m_direction.col(s) * m_direction.col(s).transpose();
    m_diagonal[static_cast<std::size_t>(a)] += block;
    m_diagonal[static_cast<std::size_t>(b)] += block;
    const Index blockA = m_blockOf[static_cast<std::size_t>(a)],
                blockB = m_blockOf[static_cast<std::size_t>(b)];
    if (blockA == kNoIndex || blockB == kNoIndex) continue;
    m_pairs.push_back({blockA, blockB});
    m_coupling.push_back(blockOf(-block));
  }
  for (Index i = 0; withAnchors && i < net.anchors.count(); ++i)
    m_diagonal[static_cast<std::size_t>(net.anchors.node[static_cast<std::size_t>(i)])] +=
      net.anchors.stiffness[i] * Eigen::Matrix3d::Identity();
  const Pressure pressure(net);
  NodeArray rest(static_cast<std::size_t>(net.nodeCount()));
  copyNodes(net.restPosition, rest);
  for (std::size_t body = 0; body < pressure.bodyCount(); ++body) {
    NodeArray gradient(rest.size(), Lanes{0, 0, 0, 0});
    pressure.addGradient(body, rest.data(), gradient.data());
    PressureColumn& column = m_pressure.emplace_back();
    column.gradient.resize(3, net.nodeCount());
    copyNodes(gradient, column.gradient);
    column.stiffness = pressure.stiffness(body);
  }
}

void LinearNet::addSupport(Index node, const Eigen::Vector3d& axis, double k)
{
  m_diagonal[static_cast<std::size_t>(node)] += k * axis * axis.transpose();
}

bool LinearNet::factor(double shift)
{
  if (m_nodeOf.empty()) return false;
  m_shift = shift;
  const double mostWork =
    static_cast<double>(m_pairs.size()) > kBraced * freeCount() ? kMostWorkBraced : kMostWork;
  if (!m_isIterative && m_cholesky.nodeCount() == 0)
    m_isIterative =
      !m_cholesky.analyze(freeCount(), m_pairs, kMostNumbers) || m_cholesky.factorWork() > mostWork;
  if (m_isIterative) return shift >= 0.0;
  NodeBlocks diagonal;
  for (const Index node : m_nodeOf) diagonal.push_back(blockOf(blockAt(node)));
  if (!m_cholesky.factor(diagonal.data(), m_coupling.data())) return false;
  if (m_pressure.empty()) return true;
  const auto rank = static_cast<Eigen::Index>(m_pressure.size());
  Eigen::MatrixXd gram(rank, rank);
  Eigen::VectorXd stiffness(rank);
  for (PressureColumn& column : m_pressure) column.solved = solveByFactor(column.gradient);
  for (Eigen::Index i = 0; i < rank; ++i) {
    const PressureColumn& column = m_pressure[static_cast<std::size_t>(i)];
    stiffness[i] = column.stiffness;
    for (Eigen::Index j = 0; j < rank; ++j)
      gram(i, j) = dotOf(column.gradient, m_pressure[static_cast<std::size_t>(j)].solved);
  }
  m_update.set(gram, stiffness);
  return true;
}

Eigen::Matrix3d LinearNet::blockAt(Index node) const
{
  return m_diagonal[static_cast<std::size_t>(node)] +
         m_shift * m_net.mass[node] * Eigen::Matrix3d::Identity();
}

Eigen::Matrix3Xd LinearNet::solveByGradients(const Eigen::Matrix3Xd& force) const
{
  constexpr int kMostIterations = 3000;
  constexpr double kTolerance = 1e-8; ///< of the force
  std::vector<Eigen::Matrix3d> inverse(static_cast<std::size_t>(m_net.nodeCount()), Eigen::Matrix3d::Zero());
  for (const Index node : m_nodeOf) inverse[static_cast<std::size_t>(node)] = pseudoInverse(blockAt(node));
  const auto precondition = [&](const Eigen::Matrix3Xd& r) {
    Eigen::Matrix3Xd z(3, r.cols());
    for (Index node = 0; node < m_net.nodeCount(); ++node)
      z.col(node) = inverse[static_cast<std::size_t>(node)] * r.col(node);
    return z;
  };
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, m_net.nodeCount()), r = force;
  for (Index node = 0; node < m_net.nodeCount(); ++node)
    if (m_blockOf[static_cast<std::size_t>(node)] == kNoIndex) r.col(node).setZero();
  Eigen::Matrix3Xd z = precondition(r), p = z;
  double energy = dotOf(r, z);
  const double enough = kTolerance * kTolerance * energy;
  for (int i = 0; i < kMostIterations && energy > enough && !stopWanted(m_control); ++i) {
    Eigen::Matrix3Xd product = multiply(p) + m_shift * (p * m_net.mass.matrix().asDiagonal());
    for (Index node = 0; node < m_net.nodeCount(); ++node)
      if (m_blockOf[static_cast<std::size_t>(node)] == kNoIndex) product.col(node).setZero();
    const double curvature = dotOf(p, product);
    if (!(curvature > 0.0)) break;
    x += (energy / curvature) * p;
    r -= (energy / curvature) * product;
    z = precondition(r);
    const double next = dotOf(r, z);
    p = z + (next / energy) * p;
    energy = next;
  }
  return x;
}

Eigen::Matrix3Xd LinearNet::solve(const Eigen::Matrix3Xd& force)
{
  if (m_isIterative) return solveByGradients(force);
  Eigen::Matrix3Xd displacement = solveByFactor(force);
  if (m_pressure.empty()) return displacement;
  Eigen::VectorXd seen(static_cast<Eigen::Index>(m_pressure.size()));
  for (std::size_t i = 0; i < m_pressure.size(); ++i)
    seen[static_cast<Eigen::Index>(i)] = dotOf(m_pressure[i].gradient, displacement);
  const Eigen::VectorXd shares = m_update.shares(seen);
  for (std::size_t i = 0; i < m_pressure.size(); ++i)
    displacement -= shares[static_cast<Eigen::Index>(i)] * m_pressure[i].solved;
  return displacement;
}

Eigen::Matrix3Xd LinearNet::solveByFactor(const Eigen::Matrix3Xd& force)
{
  m_vector.resize(m_nodeOf.size());
  for (std::size_t i = 0; i < m_nodeOf.size(); ++i) m_vector[i] = toLanes(force.col(m_nodeOf[i]));
  m_cholesky.solve(m_vector.data());
  Eigen::Matrix3Xd displacement = Eigen::Matrix3Xd::Zero(3, m_net.nodeCount());
  for (std::size_t i = 0; i < m_nodeOf.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) displacement(axis, m_nodeOf[i]) = m_vector[i][axis];
  return displacement;
}

Eigen::Matrix3Xd LinearNet::multiply(const Eigen::Matrix3Xd& displacement) const
{
  Eigen::Matrix3Xd product(3, m_net.nodeCount());
  for (Index node = 0; node < m_net.nodeCount(); ++node)
    product.col(node) = m_diagonal[static_cast<std::size_t>(node)] * displacement.col(node);
  for (Index s = 0; s < m_net.springCount(); ++s) {
    const Index a = m_net.ends(0, s), b = m_net.ends(1, s);
    const Eigen::Vector3d u = m_direction.col(s);
    product.col(a) -= m_stiffness[s] * u.dot(displacement.col(b)) * u;
    product.col(b) -= m_stiffness[s] * u.dot(displacement.col(a)) * u;
  }
  for (const PressureColumn& column : m_pressure)
    product += column.stiffness * dotOf(column.gradient, displacement) * column.gradient;
  return product;
}

double LinearNet::stiffestRate() const noexcept
{
  double rate = 0.0;
  for (const Index node : m_nodeOf)
    rate = std::max(rate, m_diagonal[static_cast<std::size_t>(node)].trace() / (3.0 * m_net.mass[node]));
  return rate;
}

SlowModes slowestModes(LinearNet& net, int count, WorkControl* control)
{
  constexpr int kSpare = 4;
  constexpr double kShift = 1e-8; ///< of the stiffest rate
  SlowModes modes;
  const int size = std::min(count + kSpare, 3 * net.freeCount());
  if (size <= 0 || !net.factor(kShift * net.stiffestRate())) return modes;
  // Without a factor each round is long: a frequency within a per cent must do.
  const int kMostRounds = net.isIterative() ? 8 : 60;
  const double enough = net.isIterative() ? 1e-3 : 1e-7;
  net.watch(control);
  const RigidMotions rigid(net.net(), true);
  const Index nodes = net.net().nodeCount();
  std::vector<Eigen::Matrix3Xd> basis;
  basis.reserve(static_cast<std::size_t>(size));
  for (int k = 0; k < size; ++k) // smooth waves of several lengths: fixed, and not blind to any slow mode
    basis.push_back(Eigen::Matrix3Xd::NullaryExpr(3, nodes, [&](Eigen::Index axis, Eigen::Index node) {
      const double phase = static_cast<double>((node * 2654435761LL + 97 * axis + 31 * k) % 1009) / 1009.0;
      return net.net().fixed[static_cast<std::size_t>(node)] ? 0.0 : phase - 0.5;
    }));
  Eigen::VectorXd before = Eigen::VectorXd::Zero(size);
  for (int round = 0; round < kMostRounds; ++round) {
    if (stopWanted(control)) return {};
    std::vector<Eigen::Matrix3Xd> stiff; // K times the new basis
    for (Eigen::Matrix3Xd& u : basis) {
      Eigen::Matrix3Xd load = u * net.net().mass.matrix().asDiagonal();
      rigid.removeFromForce(load);
      u = net.solve(load);
      rigid.removeFromMotion(u);
      stiff.push_back(net.multiply(u));
    }
    Eigen::MatrixXd K(size, size), M(size, size);
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j) {
        K(i, j) = dotOf(basis[static_cast<std::size_t>(i)], stiff[static_cast<std::size_t>(j)]);
        M(i, j) = dotOf(basis[static_cast<std::size_t>(i)],
                        basis[static_cast<std::size_t>(j)] * net.net().mass.matrix().asDiagonal());
      }
    const Eigen::VectorXd scale = M.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    K = (scale.asDiagonal() * 0.5 * (K + K.transpose()) * scale.asDiagonal()).eval();
    M = (scale.asDiagonal() * 0.5 * (M + M.transpose()) * scale.asDiagonal()).eval();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ritz(K, M);
    if (ritz.info() != Eigen::Success || !ritz.eigenvectors().allFinite()) return {};
    std::vector<Eigen::Matrix3Xd> next(static_cast<std::size_t>(size), Eigen::Matrix3Xd::Zero(3, nodes));
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j)
        next[static_cast<std::size_t>(i)] +=
          ritz.eigenvectors()(j, i) * scale[j] * basis[static_cast<std::size_t>(j)];
    basis = std::move(next);
    const Eigen::VectorXd& values = ritz.eigenvalues();
    const bool settled = ((values - before).head(std::min(count, size)).cwiseAbs().array() <=
                          enough * values.head(std::min(count, size)).array().abs())
                           .all();
    before = values;
    if (settled) break;
  }
  const int found = std::min(count, size);
  modes.frequency = before.head(found).array().max(0.0).sqrt() / (2.0 * std::numbers::pi);
  for (int i = 0; i < found; ++i) {
    Eigen::Matrix3Xd& shape = basis[static_cast<std::size_t>(i)];
    const double largest = shape.colwise().norm().maxCoeff();
    modes.shape.push_back(largest > 0.0 ? Eigen::Matrix3Xd(shape / largest) : shape);
  }
  return modes;
}

RigidMotions::RigidMotions(const SpringNet& net, bool withAnchors)
  : m_net(net), m_part(static_cast<std::size_t>(net.nodeCount()), kNoIndex)
{
  UnionFind sets(net.nodeCount());
  for (Index s = 0; s < net.springCount(); ++s) sets.join(net.ends(0, s), net.ends(1, s));
  for (Index node = 0; node < net.nodeCount(); ++node) {
    const Index root = sets.root(node);
    Index& part = m_part[static_cast<std::size_t>(node)];
    if (root == node) {
      part = partCount();
      m_loose.push_back(1);
    } else {
      part = m_part[static_cast<std::size_t>(root)]; // the smallest member comes first
    }
    if (net.fixed[static_cast<std::size_t>(node)]) m_loose[static_cast<std::size_t>(part)] = 0;
  }
  for (Index i = 0; withAnchors && i < net.anchors.count(); ++i)
    if (net.anchors.stiffness[i] > 0.0)
      m_loose[static_cast<std::size_t>(partOf(net.anchors.node[static_cast<std::size_t>(i)]))] = 0;

  const auto parts = static_cast<std::size_t>(partCount());
  std::vector<double> mass(parts, 0.0);
  m_centre.assign(parts, Eigen::Vector3d::Zero());
  for (Index node = 0; node < net.nodeCount(); ++node) {
    const auto part = static_cast<std::size_t>(partOf(node));
    mass[part] += net.mass[node];
    m_centre[part] += net.mass[node] * net.restPosition.col(node);
  }
  for (std::size_t part = 0; part < parts; ++part) m_centre[part] /= mass[part];
  std::vector<Eigen::Matrix<double, 6, 6>> inertia(parts, Eigen::Matrix<double, 6, 6>::Zero());
  for (Index node = 0; node < net.nodeCount(); ++node) {
    const auto part = static_cast<std::size_t>(partOf(node));
    Eigen::Matrix<double, 3, 6> motion;
    motion << Eigen::Matrix3d::Identity(), -skew(net.restPosition.col(node) - m_centre[part]);
    inertia[part] += net.mass[node] * motion.transpose() * motion;
  }
  for (const auto& matrix : inertia) // a line of nodes does not resist being turned about itself
    m_inverseInertia.push_back(pseudoInverse(matrix));
}

Eigen::Vector3d RigidMotions::motionOf(const Motion6& motion, Index node) const
{
  const Eigen::Vector3d r = m_net.restPosition.col(node) - m_centre[static_cast<std::size_t>(partOf(node))];
  return motion.head<3>() + motion.tail<3>().cross(r);
}

std::vector<RigidMotions::Motion6> RigidMotions::coefficients(const Eigen::Matrix3Xd& impulse) const
{
  std::vector<Motion6> sums(m_loose.size(), Motion6::Zero());
  for (Index node = 0; node < m_net.nodeCount(); ++node) {
    const auto part = static_cast<std::size_t>(partOf(node));
    const Eigen::Vector3d r = m_net.restPosition.col(node) - m_centre[part], p = impulse.col(node);
    sums[part].head<3>() += p;
    sums[part].tail<3>() += r.cross(p);
  }
  for (std::size_t part = 0; part < sums.size(); ++part)
    sums[part] = m_loose[part] ? Motion6(m_inverseInertia[part] * sums[part]) : Motion6(Motion6::Zero());
  return sums;
}

void RigidMotions::removeFromMotion(Eigen::Matrix3Xd& motion) const
{
  const std::vector<Motion6> rigid = coefficients(motion * m_net.mass.matrix().asDiagonal());
  for (Index node = 0; node < m_net.nodeCount(); ++node)
    motion.col(node) -= motionOf(rigid[static_cast<std::size_t>(partOf(node))], node);
}

void RigidMotions::removeFromForce(Eigen::Matrix3Xd& force) const
{
  const std::vector<Motion6> rigid = coefficients(force);
  for (Index node = 0; node < m_net.nodeCount(); ++node)
    force.col(node) -= m_net.mass[node] * motionOf(rigid[static_cast<std::size_t>(partOf(node))], node);
}

} // namespace esm
