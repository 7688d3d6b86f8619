// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// What the screen says of the error, and what it is.
#include "core/contact/tool_grip.h"
#include "core/runtime/told_error.h"
#include "core/tissue/tissue_model.h"

#include "tests/core/tissue/test_nets.h"

#include <gtest/gtest.h>

#include <cmath>

namespace esm {

namespace {

constexpr double kPeriod = 1.0 / 60.0;

Eigen::Matrix3Xd placesAt(double x)
{
  Eigen::Matrix3Xd places = Eigen::Matrix3Xd::Zero(3, 4);
  places.row(0).setConstant(x);
  return places;
}

} // namespace

TEST(ToldError, IsThePartThatTheErrorIsOfTheWaySinceTheHandCame)
{
  ToldError told;
  told.begin(placesAt(0.02)); // sagged so far before
  EXPECT_EQ(told.share(), 0.0);
  told.add(placesAt(0.02), 1e-5, kPeriod); // nothing has moved yet
  EXPECT_EQ(told.share(), 0.0);
  for (int frame = 0; frame < 600; ++frame) told.add(placesAt(0.021), 5e-5, kPeriod);
  EXPECT_NEAR(told.share(), 0.05, 1e-4); // 5e-5 of 1e-3; the first frame has faded to exp(-10)
  for (int frame = 0; frame < 600; ++frame) told.add(placesAt(0.021), 0.0, kPeriod);
  EXPECT_LT(told.share(), 0.05 * std::exp(-4.9)); // the root of squares that fade in a second
}

// An organ that explicit steps are too dear for, pulled by a hand; beside it the same at a tolerance of 1e-3. The
// estimate takes each damped step's error for one that lives a tenth of a second, and knows its size from checks:
// so half of the truth at least, and not ten times as much.
TEST(ToldError, OfAPullByBlocksIsAtLeastHalfOfTheTruth)
{
  const Eigen::Vector3d semiAxes(0.05, 0.04, 0.06);
  for (const double bed : {0.5, 20.0}) { // of each node [N/m]: it swings as a whole, or it is held firmly
    SpringNet net = test::netOf(test::ellipsoidMesh(semiAxes, 4));
    ASSERT_TRUE(applyTissue(defaultTissue(), net));
    const Index nodes = net.nodeCount();
    net.anchors = {};
    for (Index i = 0; i < nodes; ++i) net.anchors.node.push_back(i);
    net.anchors.point = net.restPosition;
    net.anchors.stiffness.setConstant(nodes, bed);
    net.anchors.viscosity.setConstant(nodes, 0.02 * bed);
    SolverSettings settings;
    settings.tolerance = 1e-3;
    Result<Simulation> exact = Simulation::create(net, {}, settings);
    settings.tolerance = 1e-2;
    settings.effort = 3.0e5; // about thirty passes a frame
    settings.keepsTime = true;
    Result<Simulation> rough = Simulation::create(net, {}, settings);
    ASSERT_TRUE(exact && rough);
    Eigen::Index node = 0;
    net.restPosition.row(0).maxCoeff(&node);
    const Eigen::Vector3d place = net.restPosition.col(node);
    ToolGrip grip(net, net.restPosition, static_cast<Index>(node), kGripRadius, place, 5.0);
    ToldError told;
    told.begin(net.restPosition);
    double wrong = 0.0, moved = 0.0;
    for (int frame = 1; frame <= 26; ++frame) {
      grip.moveTo(place + Eigen::Vector3d(0.01 * std::min(1.0, frame / 18.0), 0.0, 0.0),
                  Eigen::Vector3d::Zero());
      for (Simulation* one : {&*exact, &*rough}) {
        one->setTools(grip.springs(one->state()));
        ASSERT_TRUE(one->advance(kPeriod).good());
      }
      told.add(rough->state().position, rough->livingError(), kPeriod);
      wrong += (rough->state().position - exact->state().position).squaredNorm();
      moved += (exact->state().position - net.restPosition).squaredNorm();
      if (frame == 10) {
        EXPECT_EQ(rough->solverName(), "block-descent") << bed;
      }
    }
    const double truth = std::sqrt(wrong / moved);
    EXPECT_GT(truth, 2e-3) << "nothing to tell"; // above what the exact one errs
    EXPECT_GT(told.share(), 0.5 * truth) << bed;
    EXPECT_LT(told.share(), 10.0 * truth) << bed;
    RecordProperty("truth", std::to_string(truth) + " told " + std::to_string(told.share()));
  }
}

} // namespace esm
