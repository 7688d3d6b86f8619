// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Pairs of steps and residuals against the dense formula of BFGS, and what theory says of it.
#include "core/dynamics/methods/secant_pairs.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

namespace esm::test {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

NodeArray toNodes(const Vector& values)
{
  NodeArray nodes;
  for (Eigen::Index i = 0; i < values.size(); i += 3) nodes.push_back(toLanes(values.segment<3>(i)));
  return nodes;
}

Vector toValues(const NodeArray& nodes)
{
  Vector values(3 * static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    values.segment<3>(3 * static_cast<Eigen::Index>(i)) = toVector(nodes[i]);
  return values;
}

class SecantPairsTest : public testing::Test {
protected:
  Vector randomVector(Eigen::Index size)
  {
    Vector values(size);
    for (double& value : values) value = static_cast<double>(m_random()) / 2147483648.0 - 1.0;
    return values;
  }
  Matrix randomPositive(Eigen::Index size)
  {
    Matrix root(size, size);
    for (Eigen::Index c = 0; c < size; ++c) root.col(c) = randomVector(size);
    return root * root.transpose() + Matrix::Identity(size, size);
  }
  /// The answer to a residual with the factor of `old`.
  static Vector answer(SecantPairs& pairs, const Matrix& old, const Vector& residual)
  {
    NodeArray nodes = toNodes(residual);
    pairs.fold(nodes);
    nodes = toNodes(old.llt().solve(toValues(nodes)));
    pairs.unfold(nodes);
    return toValues(nodes);
  }

private:
  std::mt19937 m_random{7};
};

/// (I - s y^T / s.y) H (I - y s^T / s.y) + s s^T / s.y, of one pair after the other.
Matrix denseInverse(const Matrix& old, const std::vector<std::pair<Vector, Vector>>& pairs)
{
  const Matrix identity = Matrix::Identity(old.rows(), old.cols());
  Matrix inverse = old.inverse();
  for (const auto& [step, drop] : pairs) {
    const Matrix turn = identity - step * drop.transpose() / step.dot(drop);
    inverse = turn * inverse * turn.transpose() + step * step.transpose() / step.dot(drop);
  }
  return inverse;
}

} // namespace

// Tolerance: rounding of a dozen sums, times the condition numbers (some hundreds) of small random matrices.
TEST_F(SecantPairsTest, AreTheDenseFormulaOfTheLastOnes)
{
  constexpr Eigen::Index kSize = 30;
  const Matrix old = randomPositive(kSize), now = randomPositive(kSize);
  SecantPairs pairs;
  std::vector<std::pair<Vector, Vector>> kept;
  const auto compare = [&] {
    const Vector residual = randomVector(kSize), exact = denseInverse(old, kept) * residual;
    EXPECT_LT((answer(pairs, old, residual) - exact).norm(), 1e-11 * exact.norm()) << kept.size();
  };
  compare();
  for (std::size_t i = 0; i < SecantPairs::kMost + 3; ++i) {
    const Vector change = randomVector(kSize), before = randomVector(kSize), step = 0.5 * change;
    pairs.add(toNodes(change), 0.5, toNodes(before), toNodes(before - now * step));
    kept.emplace_back(step, now * step);
    if (kept.size() > SecantPairs::kMost) kept.erase(kept.begin());
    compare();
  }
  // Along this one the matrix would be negative; it costs the oldest its place.
  const Vector change = randomVector(kSize), before = randomVector(kSize);
  pairs.add(toNodes(change), 1.0, toNodes(before), toNodes(before + now * change));
  kept.erase(kept.begin());
  compare();
  pairs.clear();
  kept.clear();
  compare();
}

// On a quadratic function, with exact line searches, BFGS is done after as many steps as there are unknowns,
// whatever positive matrix it starts from (Dixon 1972; Nocedal and Wright, Numerical Optimization, 6.1).
TEST_F(SecantPairsTest, LeadToTheGoalInAsManyStepsAsThereAreUnknowns)
{
  constexpr Eigen::Index kSize = 6;
  static_assert(SecantPairs::kMost + 1 >= kSize);
  const Matrix old = randomPositive(kSize), now = randomPositive(kSize);
  SecantPairs pairs;
  const Vector first = randomVector(kSize);
  Vector residual = first;
  for (Eigen::Index i = 0; i < kSize; ++i) {
    EXPECT_GT(residual.norm(), 1e-6 * first.norm()) << "done before its time: the example is too easy";
    const Vector change = answer(pairs, old, residual);
    const double fraction = change.dot(residual) / change.dot(now * change);
    const Vector next = residual - fraction * (now * change);
    pairs.add(toNodes(change), fraction, toNodes(residual), toNodes(next));
    residual = next;
  }
  EXPECT_LT(residual.norm(), 1e-10 * first.norm());
}

} // namespace esm::test
