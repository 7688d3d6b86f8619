// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Solutions with the stiffness, and bounds of them, without a factor.
#include "core/dynamics/system/stiffness_cg.h"
#include "tests/core/dynamics/skip_nets.h"

#include <Eigen/Dense>

#include <cmath>
#include <limits>

namespace esm::test {
namespace {

/// K of a bedded net whose springs have their rest length, dense.
Eigen::MatrixXd stiffnessOf(const SpringNet& net)
{
  Eigen::MatrixXd k = axialMatrix(net, net.stiffness);
  for (Index a = 0; a < net.anchors.count(); ++a)
    k.block<3, 3>(3 * net.anchors.node[static_cast<std::size_t>(a)],
                  3 * net.anchors.node[static_cast<std::size_t>(a)]) +=
      net.anchors.stiffness[a] * Eigen::Matrix3d::Identity();
  return k;
}

/// b.K^-1 b
double exactCompliance(const SpringNet& net, const NodeArray& b)
{
  const Eigen::VectorXd load = stacked(b);
  return load.dot(stiffnessOf(net).ldlt().solve(load));
}

} // namespace

// Each iteration comes nearer to b.K^-1 b, from below; as many as there are eigenvalues reach it, up to
// rounding. What pushes at held nodes moves nothing.
TEST(StiffnessCg, RisesToTheCompliance)
{
  SpringNet net = beddedSheet(4);
  for (Index i = 0; i < net.nodeCount(); ++i) net.mass[i] *= 1.0 + 0.3 * (i % 4);
  System system(net, {});
  MotionState motion = startOf(net);
  system.enter(motion, true);
  NodeArray b(motion.x.size());
  for (std::size_t i = 0; i < b.size(); ++i)
    b[i] = Lanes{std::sin(1.0 + 2.0 * static_cast<double>(i)), std::cos(static_cast<double>(i)), 0.3, 0.0};
  const double exact = exactCompliance(net, b), enough = std::numeric_limits<double>::infinity();
  StiffnessCg bound;
  bound.prepare(system, motion.x, 0.0);
  double before = 0.0;
  for (const int most : {1, 2, 4, 8, 16}) {
    const double found = bound.below(system, b, enough, most);
    EXPECT_GT(found, before) << most;
    EXPECT_LE(found, exact * (1.0 + 1e-12)) << most;
    before = found;
  }
  EXPECT_GT(before, 0.9 * exact);
  EXPECT_NEAR(bound.below(system, b, enough, 200), exact, 1e-9 * exact);
  EXPECT_LT(bound.below(system, b, 1e-3 * exact, 200), 0.9 * exact); // enough is enough

  net.fixed.assign(static_cast<std::size_t>(net.nodeCount()), 1);
  net.fixed[0] = 0;
  system = System(net, {});
  system.enter(motion, true);
  bound.prepare(system, motion.x, 0.0);
  for (std::size_t i = 1; i < b.size(); ++i) b[i] = Lanes{1e3, 1e3, 1e3, 0};
  const double alone = bound.below(system, b, enough, 200);
  EXPECT_GT(alone, 0.0);
  EXPECT_LT(alone, dot(b[0], b[0]) / net.anchors.stiffness[0] * (1.0 + 1e-12));
}

// A pressed column gives way sidewards: nothing bounds how far.
TEST(StiffnessCg, SeesWhatIsUnstable)
{
  SpringNet column = chain(3);
  column.fixed[0] = column.fixed[2] = 1;
  column.restLength.setConstant(1.2);
  System system(column, {});
  MotionState motion;
  motion.x = {Lanes{0, 0, 0, 0}, Lanes{1, 0, 0, 0}, Lanes{2, 0, 0, 0}};
  motion.v.assign(3, Lanes{0, 0, 0, 0});
  system.enter(motion, true);
  StiffnessCg bound;
  bound.prepare(system, motion.x, 0.0);
  const NodeArray sidewards = {Lanes{0, 0, 0, 0}, Lanes{0, 1, 0, 0}, Lanes{0, 0, 0, 0}};
  EXPECT_EQ(bound.below(system, sidewards, 1.0, 16), 0.0);
  EXPECT_TRUE(bound.metNegative());
  EXPECT_EQ(bound.below(system, sidewards, 1.0, 16, &sidewards), 0.0);
  EXPECT_TRUE(bound.metNegative());
  const NodeArray along = {Lanes{0, 0, 0, 0}, Lanes{1, 0, 0, 0}, Lanes{0, 0, 0, 0}};
  EXPECT_GT(bound.below(system, along, 1.0, 16), 0.0);
  EXPECT_FALSE(bound.metNegative());
}

// Along K^-1 b itself the bound is what it bounds, at once; along anything else it is no more.
TEST(StiffnessCg, LooksWhereItIsTold)
{
  const SpringNet net = beddedSheet(4);
  System system(net, {});
  MotionState motion = startOf(net);
  system.enter(motion, true);
  StiffnessCg bound;
  bound.prepare(system, motion.x, 0.0);
  const double enough = std::numeric_limits<double>::infinity();
  NodeArray b(motion.x.size()), solution = b, other = b;
  b[5] = Lanes{0.3, 1.0, -0.5, 0.0};
  const Eigen::VectorXd way = stiffnessOf(net).ldlt().solve(stacked(b));
  for (std::size_t i = 0; i < b.size(); ++i) {
    const auto place = 3 * static_cast<Eigen::Index>(i);
    solution[i] = Lanes{7.0 * way[place], 7.0 * way[place + 1], 7.0 * way[place + 2], 0.0};
    other[i] = Lanes{1.0, static_cast<double>(i), 0.0, 0.0};
  }
  const double exact = exactCompliance(net, b);
  EXPECT_NEAR(bound.below(system, b, enough, 0, &solution), exact, 1e-12 * exact); // rounding
  EXPECT_LT(bound.below(system, b, enough, 0, &other), 0.5 * exact);
  EXPECT_LE(bound.below(system, b, enough, 200, &other), exact * (1.0 + 1e-9));
  EXPECT_NEAR(bound.below(system, b, enough, 200, &other), exact, 1e-9 * exact);
}

// Half of a sheet a million times as stiff as the other one: few iterations find most of what the soft one
// gives. With the masses as preconditioner eight found a ten-thousandth.
TEST(StiffnessCg, SeesSoftPartsBesideStiffOnes)
{
  SpringNet net = beddedSheet(8);
  for (Index s = 0; s < net.springCount(); ++s)
    if (net.ends.col(s).maxCoeff() < net.nodeCount() / 2) net.stiffness[s] *= 1e6;
  System system(net, {});
  MotionState motion = startOf(net);
  system.enter(motion, true);
  NodeArray b(motion.x.size());
  for (std::size_t i = 0; i < b.size(); ++i) // velocities without a pattern, times the masses
    b[i] = Lanes{std::sin(1.0 + 2.0 * static_cast<double>(i * i)), std::cos(3.0 * static_cast<double>(i)),
                 std::sin(5.0 * static_cast<double>(i)), 0.0} *
           net.mass[static_cast<Index>(i)];
  StiffnessCg bound;
  bound.prepare(system, motion.x, 0.0);
  const double exact = exactCompliance(net, b);
  const double found = bound.below(system, b, std::numeric_limits<double>::infinity(), 8);
  EXPECT_GT(found, 0.4 * exact);
  EXPECT_LE(found, exact);
}

// The solution is the one that a dense factor finds, to a hundredth.
TEST(StiffnessCg, SolvesAsAFactorDoes)
{
  SpringNet net = beddedSheet(12);
  net.fixed[7] = 1;
  System system(net, {});
  MotionState motion = startOf(net);
  system.enter(motion, true);
  NodeArray vector(motion.x.size());
  for (std::size_t i = 0; i < vector.size(); ++i)
    vector[i] = Lanes{std::sin(0.1 * static_cast<double>(i)), std::cos(static_cast<double>(i)), 0.3, 0.0};
  Eigen::MatrixXd k = stiffnessOf(net);
  Eigen::VectorXd load = stacked(vector);
  k.middleRows<3>(21).setZero();
  k.middleCols<3>(21).setZero();
  k.block<3, 3>(21, 21).setIdentity();
  load.segment<3>(21).setZero();
  const Eigen::VectorXd exact = k.ldlt().solve(load);
  StiffnessCg gradients;
  gradients.prepare(system, motion.x, 0.0);
  const NodeArray given = vector;
  EXPECT_EQ(gradients.solve(system, vector, 1000), StiffnessCg::Result::Solved);
  EXPECT_LT((stacked(vector) - exact).norm(), 1e-2 * exact.norm());
  EXPECT_EQ(toVector(vector[7]), Eigen::Vector3d::Zero());
  vector = given;
  EXPECT_EQ(gradients.solve(system, vector, 3), StiffnessCg::Result::TooSlow);
  vector.assign(vector.size(), Lanes{0, 0, 0, 0});
  EXPECT_EQ(gradients.solve(system, vector, 3), StiffnessCg::Result::Solved);
}

// A straight column under pressure is in balance, so that no force points where it would fall; one under
// tension falls nowhere.
TEST(StiffnessCg, SeesThatABalanceIsUnstable)
{
  for (const bool isPressed : {true, false}) {
    SpringNet column = chain(20);
    column.fixed.front() = column.fixed.back() = 1;
    column.restLength.setConstant(isPressed ? 1.2 : 0.8);
    System system(column, {});
    MotionState motion = startOf(column);
    system.enter(motion, true);
    StiffnessCg gradients;
    gradients.prepare(system, motion.x, 0.0);
    EXPECT_EQ(gradients.givesWay(system), isPressed);
    NodeArray along(motion.x.size(), Lanes{1, 0, 0, 0});
    EXPECT_EQ(gradients.solve(system, along, 1000), StiffnessCg::Result::Solved);
    NodeArray aside(motion.x.size(), Lanes{0, 1, 0, 0});
    EXPECT_EQ(gradients.solve(system, aside, 1000) == StiffnessCg::Result::GivesWay, isPressed);
  }
}

} // namespace esm::test
