// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The sparse factor against what linear algebra says, with Eigen's dense solvers as witnesses.
#include "core/base/hash.h"
#include "core/linear/block_cholesky.h"
#include "core/linear/preconditioned_cg.h"
#include "tests/support/physics.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace esm::test {
namespace {

using Vectors = NodeArray;

/// A matrix by blocks, with the same as a dense one.
struct Example {
  Index nodes = 0;
  std::vector<NodePair> pairs;
  NodeBlocks diagonal, coupling;
  Eigen::MatrixXd dense;
};

NodeBlock toBlock(const Eigen::Matrix3d& m)
{
  NodeBlock block;
  for (int c = 0; c < 3; ++c) block.column[c] = toLanes(m.col(c));
  return block;
}

/// Random springs u u^T between the pairs, on a diagonal of `mass`.
Example springMatrix(Index nodes, std::vector<NodePair> pairs, double mass, std::uint32_t seed)
{
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
  Example example{nodes, std::move(pairs), {}, {}, mass * Eigen::MatrixXd::Identity(3 * nodes, 3 * nodes)};
  for (const NodePair& pair : example.pairs) {
    const Eigen::Vector3d u(uniform(), uniform(), uniform());
    const Eigen::Matrix3d k = u * u.transpose() + 0.1 * Eigen::Matrix3d::Identity();
    example.coupling.push_back(toBlock(-k));
    example.dense.block<3, 3>(3 * pair.a, 3 * pair.a) += k;
    example.dense.block<3, 3>(3 * pair.b, 3 * pair.b) += k;
    example.dense.block<3, 3>(3 * pair.a, 3 * pair.b) -= k;
    example.dense.block<3, 3>(3 * pair.b, 3 * pair.a) -= k;
  }
  for (Index i = 0; i < nodes; ++i)
    example.diagonal.push_back(toBlock(example.dense.block<3, 3>(3 * i, 3 * i)));
  return example;
}

std::vector<NodePair> gridPairs(Index side)
{
  std::vector<NodePair> pairs;
  for (Index j = 0; j < side; ++j)
    for (Index i = 0; i < side; ++i) {
      const Index here = j * side + i;
      if (i + 1 < side) pairs.push_back({here, here + 1});
      if (j + 1 < side) pairs.push_back({here + side, here});
      if (i + 1 < side && j + 1 < side) pairs.push_back({here, here + side + 1});
    }
  return pairs;
}

std::vector<NodePair> randomPairs(Index nodes, int count, std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::vector<NodePair> pairs;
  while (static_cast<int>(pairs.size()) < count) {
    const auto a = static_cast<Index>(random() % static_cast<std::uint32_t>(nodes)),
               b = static_cast<Index>(random() % static_cast<std::uint32_t>(nodes));
    if (a != b) pairs.push_back({a, b});
  }
  return pairs;
}

Vectors rightSide(Index nodes)
{
  Vectors vector;
  for (Index i = 0; i < nodes; ++i) vector.push_back(Lanes{1.0 + i % 7, 0.5 * (i % 3) - 1.0, 2.0 - i % 5, 0});
  return vector;
}

/// |A x - b| / |b| of the sparse solution.
double relativeResidual(const Example& example)
{
  BlockCholesky cholesky;
  cholesky.analyze(example.nodes, example.pairs);
  if (!cholesky.factor(example.diagonal.data(), example.coupling.data())) return 1e300;
  Vectors x = rightSide(example.nodes);
  const Eigen::VectorXd b = stacked(x);
  cholesky.solve(x.data());
  return (example.dense * stacked(x) - b).norm() / b.norm();
}

} // namespace

// Condition numbers here are below 1e5, so a backward stable factor leaves 1e-16 times a modest growth.
TEST(BlockCholesky, SolvesGridsOfManySizes)
{
  for (const Index side : {1, 2, 3, 5, 8, 13, 20})
    EXPECT_LT(relativeResidual(springMatrix(side * side, gridPairs(side), 0.1, 3)), 1e-13) << side;
}

// Graphs without structure: some sparse and in pieces, some nearly full; pairs come more than once.
TEST(BlockCholesky, SolvesRandomGraphs)
{
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const auto nodes = static_cast<Index>(2 + 7 * seed % 83);
    const int pairs = static_cast<int>(seed % 6) * nodes / 2;
    EXPECT_LT(relativeResidual(springMatrix(nodes, randomPairs(nodes, pairs, seed), 0.3, seed)), 1e-12)
      << "seed " << seed;
  }
}

// Sylvester's law of inertia: as many negative pivots as negative eigenvalues.
TEST(BlockCholesky, CountsNegativeEigenvalues)
{
  for (const double shift : {0.05, 0.4, 1.0, 3.0, 30.0}) {
    Example example = springMatrix(36, gridPairs(6), 0.1, 8);
    for (NodeBlock& block : example.diagonal)
      for (int axis = 0; axis < 3; ++axis) block.column[axis][axis] -= shift;
    example.dense -= shift * Eigen::MatrixXd::Identity(108, 108);
    const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(example.dense).eigenvalues();
    BlockCholesky cholesky;
    cholesky.analyze(example.nodes, example.pairs);
    ASSERT_TRUE(cholesky.factor(example.diagonal.data(), example.coupling.data()));
    EXPECT_EQ(cholesky.negativePivots(), (values.array() < 0.0).count()) << shift;
    EXPECT_EQ(cholesky.negativePivots() == 0, shift == 0.05) << "the sweep must cross zero";
    Vectors x = rightSide(example.nodes);
    const Eigen::VectorXd b = stacked(x);
    cholesky.solve(x.data());
    // Without exchange of pivots rounding may grow, here by less than 1e5.
    EXPECT_LT((example.dense * stacked(x) - b).norm() / b.norm(), 1e-10) << shift;
  }
}

TEST(BlockCholesky, RefusesSingularAndInfiniteMatrices)
{
  Example example = springMatrix(9, gridPairs(3), 0.1, 1);
  BlockCholesky cholesky;
  cholesky.analyze(example.nodes, example.pairs);
  const Example good = example;
  example.diagonal[4] = NodeBlock{};
  for (std::size_t p = 0; p < example.pairs.size(); ++p)
    if (example.pairs[p].a == 4 || example.pairs[p].b == 4) example.coupling[p] = NodeBlock{};
  EXPECT_FALSE(cholesky.factor(example.diagonal.data(), example.coupling.data()));
  example = good;
  example.coupling[2].column[1][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(cholesky.factor(example.diagonal.data(), example.coupling.data()));
  EXPECT_TRUE(cholesky.factor(good.diagonal.data(), good.coupling.data())) << "and it recovers";
}

// What was in the factor before leaves no trace: the same numbers give the same bits.
TEST(BlockCholesky, SameInputGivesSameBits)
{
  const Example one = springMatrix(400, gridPairs(20), 0.1, 5),
                other = springMatrix(400, gridPairs(20), 7.0, 6);
  BlockCholesky cholesky;
  cholesky.analyze(one.nodes, one.pairs);
  Vectors results[2] = {rightSide(400), rightSide(400)};
  for (Vectors& result : results) {
    ASSERT_TRUE(cholesky.factor(other.diagonal.data(), other.coupling.data()));
    ASSERT_TRUE(cholesky.factor(one.diagonal.data(), one.coupling.data()));
    cholesky.solve(result.data());
  }
  EXPECT_EQ(hashBytes(results[0].data(), 400 * sizeof(Lanes)),
            hashBytes(results[1].data(), 400 * sizeof(Lanes)));
}

// Dissection of an n x n grid leaves O(n^3) work; by rows it would be n^4. 31/4 n^3 products of blocks are
// George's (1973) figure for the nine-point grid, squares of lengths count about three times as much.
TEST(BlockCholesky, OrderOfEliminationKeepsGridsCheap)
{
  for (const Index side : {20, 40, 80}) {
    BlockCholesky cholesky;
    cholesky.analyze(side * side, gridPairs(side));
    const double blocks = cholesky.factorWork() / 27.0;
    EXPECT_LT(blocks, 31.0 / 4.0 * 3.0 * side * side * side) << side;
  }
}

// Two ways to one solution; and gradients tell when the matrix is not positive definite.
// A hub with arms of two: as it goes last, each arm costs as much as if it were alone. Laid out pair by pair this
// took ten billion steps, which the time limit of a test does not allow.
TEST(BlockCholesky, AHubOfManyArmsCostsNoMoreThanItsArms)
{
  constexpr Index kArms = 100'000;
  std::vector<NodePair> pairs;
  for (Index i = 0; i < kArms; ++i) {
    pairs.push_back({0, 1 + 2 * i});
    pairs.push_back({1 + 2 * i, 2 + 2 * i});
  }
  BlockCholesky cholesky, alone;
  ASSERT_TRUE(cholesky.analyze(1 + 2 * kArms, pairs));
  ASSERT_TRUE(alone.analyze(3, {{0, 1}, {1, 2}}));
  EXPECT_LT(cholesky.factorWork(), 2.0 * kArms * alone.factorWork());
}

TEST(PreconditionedCg, AgreesWithTheFactor)
{
  Example example = springMatrix(400, gridPairs(20), 0.1, 12);
  PreconditionedCg gradients;
  gradients.prepare(example.nodes, example.pairs);
  ASSERT_TRUE(gradients.setMatrix(example.diagonal.data(), example.coupling.data()));
  BlockCholesky cholesky;
  cholesky.analyze(example.nodes, example.pairs);
  ASSERT_TRUE(cholesky.factor(example.diagonal.data(), example.coupling.data()));
  Vectors direct = rightSide(400), iterated = direct;
  cholesky.solve(direct.data());
  EXPECT_EQ(gradients.solve(iterated.data(), 1e-12, 400), PreconditionedCg::Result::Converged);
  EXPECT_LT((stacked(direct) - stacked(iterated)).norm(), 1e-10 * stacked(direct).norm());
  iterated = rightSide(400);
  EXPECT_EQ(gradients.solve(iterated.data(), 1e-12, 3), PreconditionedCg::Result::TooSlow);
  for (NodeBlock& block : example.diagonal)
    for (int axis = 0; axis < 3; ++axis) block.column[axis][axis] -= 0.15;
  if (gradients.setMatrix(example.diagonal.data(), example.coupling.data())) {
    iterated = rightSide(400);
    EXPECT_EQ(gradients.solve(iterated.data(), 1e-12, 400), PreconditionedCg::Result::Indefinite);
  }
  example.diagonal[3].column[0][0] = -1.0;
  EXPECT_FALSE(gradients.setMatrix(example.diagonal.data(), example.coupling.data()));
}

TEST(BlockCholesky, OrderNamesEachNodeOnce)
{
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const auto nodes = static_cast<Index>(1 + 11 * seed);
    std::vector<NodePair> pairs;
    if (nodes > 1) pairs = randomPairs(nodes, static_cast<int>(seed) * 8, seed);
    std::vector<Index> order = eliminationOrder(nodes, pairs);
    std::sort(order.begin(), order.end());
    ASSERT_EQ(order.size(), static_cast<std::size_t>(nodes));
    for (Index i = 0; i < nodes; ++i) ASSERT_EQ(order[static_cast<std::size_t>(i)], i);
  }
}

} // namespace esm::test
