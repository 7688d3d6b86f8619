// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Where a net would be in balance is found from where it is, and known as long as it is balance.
#include "core/dynamics/rest/equilibrium.h"
#include "tests/core/dynamics/skip_nets.h"
#include "tests/support/physics.h"

#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace esm::test {
namespace {

struct Search {
  System system;
  MotionState motion;
  Equilibrium equilibrium;
  StepReport report;

  Search(const SpringNet& net, const Loads& loads, NodeArray places) : system(net, loads)
  {
    motion.x = std::move(places);
    motion.v.assign(motion.x.size(), Lanes{0, 0, 0, 0});
    system.enter(motion, true);
  }
  double find(Equilibrium::Aim aim) { return equilibrium.find(system, motion, aim, report); }
};

constexpr double kEverything = std::numeric_limits<double>::infinity();

/// A weight of 2 kg on a spring of 1 m, its other end at the origin, `angle` aside.
constexpr double kWeight = 20.0, kStiffness = 3e6, kLength = 1.0 + kWeight / kStiffness;
Search pendulum(double angle)
{
  SpringNet net = chain(2);
  net.fixed[0] = 1;
  net.mass.setConstant(2.0);
  net.stiffness[0] = kStiffness;
  Loads loads;
  loads.gravity = {0.0, 0.0, -10.0};
  return {
    net, loads, {Lanes{0, 0, 0, 0}, Lanes{kLength * std::sin(angle), 0, -kLength * std::cos(angle), 0}}};
}

/// Three nodes in a row, the outer ones held 2 m apart, springs of 1.2 m between them: the middle one stands
/// aside by a root of 1.2^2 - 1.
Search column(double aside)
{
  SpringNet net = chain(3);
  net.fixed[0] = net.fixed[2] = 1;
  net.restLength.setConstant(1.2);
  return {net, {}, {Lanes{0, 0, 0, 0}, Lanes{1, aside, 0, 0}, Lanes{2, 0, 0, 0}}};
}

} // namespace

// A spring that its weight stretches by 7 micrometres, up to 17 degrees aside: the first step is along the
// tangent of the circle and stretches it by up to 5 cm. By the same stiffness the next one would be thousands
// of times as long.
TEST(Equilibrium, IsFoundWhereStiffSpringsTurn)
{
  for (const double angle : {1e-3, 0.02, 0.1, 0.3}) {
    SCOPED_TRACE(angle);
    Search search = pendulum(angle);
    const double way = search.find({1e-12, kEverything, kEverything});
    ASSERT_TRUE(search.equilibrium.isKnown());
    const Lanes place = search.equilibrium.place()[1];
    EXPECT_NEAR(place[0], 0.0, 1e-6);
    EXPECT_NEAR(place[2], -kLength, 1e-6);
    EXPECT_NEAR(std::sqrt(way), 2.0 * kLength * std::sin(angle / 2.0), 2e-6);
  }
}

// Links of a chain that hangs in a zigzag: straight down, each longer by what hangs below it over k.
TEST(Equilibrium, IsFoundWhereAChainSwings)
{
  constexpr Index kLinks = 10;
  constexpr double k = 1e5;
  SpringNet net = chain(kLinks + 1);
  net.fixed[0] = 1;
  net.mass.setConstant(1.0);
  net.stiffness.setConstant(k);
  Loads loads;
  loads.gravity = {0.0, 0.0, -10.0};
  NodeArray places;
  for (Index i = 0; i <= kLinks; ++i) places.push_back(Lanes{i % 2 ? 0.1 : 0.0, 0.03 * i, -1.0 * i, 0});
  Search search(net, loads, places);
  search.find({1e-12, kEverything, kEverything});
  ASSERT_TRUE(search.equilibrium.isKnown());
  double height = 0.0;
  for (Index i = 1; i <= kLinks; ++i) {
    height -= 1.0 + 10.0 * (kLinks + 1 - i) / k;
    const Lanes place = search.equilibrium.place()[static_cast<std::size_t>(i)];
    EXPECT_NEAR(place[0], 0.0, 2e-6) << i;
    EXPECT_NEAR(place[1], 0.0, 2e-6) << i;
    EXPECT_NEAR(place[2], height, 2e-6) << i;
  }
}

// On its crown a column is in balance, and stays there no longer than nobody breathes; aside of it the true
// stiffness points back to the crown.
TEST(Equilibrium, IsWhereAColumnHasGivenWay)
{
  Search crowned = column(0.0);
  for (const bool byFactor : {false, true}) {
    EXPECT_EQ(crowned.equilibrium.takesFactor(crowned.system), byFactor);
    EXPECT_EQ(crowned.find({1e-12, kEverything, kEverything}), kEverything);
    EXPECT_FALSE(crowned.equilibrium.isKnown());
  }
  for (const double aside : {0.1, 0.3, 0.9}) {
    SCOPED_TRACE(aside);
    Search search = column(aside);
    search.find({1e-12, kEverything, kEverything});
    EXPECT_EQ(search.equilibrium.takesFactor(search.system), aside < 0.6);
    if (aside < 0.6) { // gradients know no way from there, a factor does
      EXPECT_FALSE(search.equilibrium.isKnown());
      search.find({1e-12, kEverything, kEverything});
    }
    ASSERT_TRUE(search.equilibrium.isKnown());
    EXPECT_NEAR(search.equilibrium.place()[1][0], 1.0, 1e-6);
    EXPECT_NEAR(search.equilibrium.place()[1][1], std::sqrt(1.44 - 1.0), 1e-6);
  }
}

// A row of links that are too long for it, each node bedded, thrown about: full steps lead nowhere, parts of
// them do. Energy rises from there, whichever way the nodes move.
TEST(Equilibrium, IsFoundWhereFullStepsLeadNowhere)
{
  constexpr Index kNodes = 12;
  SpringNet net = chain(kNodes);
  net.fixed[0] = net.fixed[kNodes - 1] = 1;
  net.restLength.setConstant(1.02);
  net.stiffness.setConstant(1e4);
  for (Index i = 0; i < kNodes; ++i) addAnchor(net, i, net.restPosition.col(i), 10.0);
  NodeArray places;
  for (Index i = 0; i < kNodes; ++i)
    places.push_back(
      Lanes{1.0 * i, i == 0 || i == kNodes - 1 ? 0.0 : 0.3 * std::sin(7.0 * i * i + 4.0), 0.0, 0});
  Search search(net, {}, places);
  search.find({1e-8, kEverything, kEverything}); // by gradients
  search.find({1e-8, kEverything, kEverything}); // by a factor
  ASSERT_TRUE(search.equilibrium.isKnown());
  const NodeArray& place = search.equilibrium.place();
  const double least = search.system.storedEnergy(place);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> little(-0.01, 0.01);
  for (int trial = 0; trial < 50; ++trial) {
    NodeArray aside = place;
    for (std::size_t i = 1; i + 1 < aside.size(); ++i)
      for (int axis = 0; axis < 3; ++axis) aside[i][axis] += little(random);
    EXPECT_GT(search.system.storedEnergy(aside), least);
  }
}

// Where it is too far nobody waits for it, nor longer than it may cost; what has been seen of the way is
// told.
TEST(Equilibrium, IsNotLookedForAtAnyPrice)
{
  Search far = pendulum(0.3);
  EXPECT_NEAR(far.find({1e-12, 0.01, kEverything}), std::pow(kLength * std::tan(0.3), 2), 0.02);
  EXPECT_FALSE(far.equilibrium.isKnown());
  Search dear = pendulum(0.3);
  EXPECT_EQ(dear.find({1e-12, kEverything, 0.0}), kEverything);
  EXPECT_FALSE(dear.equilibrium.isKnown());
  Search near = pendulum(1e-6); // one step does
  near.find({1e-12, kEverything, 0.0});
  EXPECT_TRUE(near.equilibrium.isKnown());
}

// It stays known while the net swings about it, and no longer than its loads and springs stay.
TEST(Equilibrium, IsKnownAsLongAsForcesBalanceThere)
{
  Search search = pendulum(0.02);
  search.find({1e-12, kEverything, kEverything});
  ASSERT_TRUE(search.equilibrium.isKnown());
  const std::int64_t before = search.report.springsEvaluated;
  search.motion.x[1][0] = 0.5;
  EXPECT_TRUE(search.equilibrium.holds(search.system, 1.0, search.report));
  EXPECT_EQ(search.report.springsEvaluated, before + 1);
  const ToolSpring tool{1, {0, 0.1, -1}, {0, 0, 0}, 1e-3, 0.0};
  search.system.setTools({&tool, 1}, search.motion.x, search.motion.time);
  EXPECT_FALSE(search.equilibrium.holds(search.system, 1.0, search.report));
  EXPECT_FALSE(search.equilibrium.isKnown());
}

} // namespace esm::test
