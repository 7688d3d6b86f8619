// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/learning/static_slopes.h"

#include "tests/core/learning/blocks.h"
#include "tests/support/dice.h"
#include "tests/support/nets.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace esm;
using namespace esm::test;
using namespace esm::learning;

/// Derivative at 0 of a smooth function, by central differences over h, h/2, h/4, h/8 extrapolated after
/// Richardson: what is left is of order h^8.
template <class Function>
double richardson(const Function& f, double h)
{
  constexpr int kRows = 4;
  double table[kRows][kRows];
  for (int row = 0; row < kRows; ++row, h *= 0.5) {
    table[row][0] = (f(h) - f(-h)) / (2.0 * h);
    double factor = 4.0;
    for (int k = 1; k <= row; ++k, factor *= 4.0)
      table[row][k] = table[row][k - 1] + (table[row][k - 1] - table[row - 1][k - 1]) / (factor - 1.0);
  }
  return table[kRows - 1][kRows - 1];
}

struct Scene {
  SpringNet net;
  Loads loads;
  NodeArray weights; ///< L = weights . x
};

Scene sceneOf(SpringLaw law)
{
  Scene scene{unevenBlock({}, law, 11), {}, {}};
  SpringNet& net = scene.net;
  for (const Index node : {47, 61, 66, 79})
    addAnchor(net, node, net.restPosition.col(node).array() + 2e-3, 2.0 + node % 5);
  for (Index s = 0; s < net.springCount();
       s += 17) { // pulled or slack for certain: no kink within differences
    net.tensionOnly[at(s)] = 1;
    net.restLength[s] *= s % 2 == 0 ? 0.93 : 1.07;
  }
  scene.loads.gravity = {0.0, 0.0, -9.81};
  scene.loads.forces = {sharedForce(nodesNear(net, {0.02, 0.015, 0.03}, 0.012), {0.15, 0.05, -0.3})};
  PrescribedMotion hold;
  hold.nodes = {20, 24};
  hold.displacement.time = {0.0};
  hold.displacement.value = Eigen::Vector3d(1e-3, -5e-4, 5e-4);
  scene.loads.motions = {hold};
  Dice dice(5);
  for (Index i = 0; i < net.nodeCount(); ++i) scene.weights.push_back(toLanes(dice.vector(1.0)));
  return scene;
}

/// L with the numbers changed by `amount` along `direction` (relative to them where they are factors).
double valueAt(const Scene& scene, const Statics& start, NetQuantity quantity,
               const Eigen::ArrayXd& direction, double amount)
{
  SpringNet net = scene.net;
  numbersOf(net, quantity) += amount * direction;
  Statics statics(net, scene.loads);
  statics.setPlace(start.place());
  EXPECT_EQ(statics.solve({1e-15, 30, 1.0}).outcome, StaticsOutcome::Balanced);
  double change = 0.0; // L less its value at the start, so that no digits are lost
  for (std::size_t i = 0; i < scene.weights.size(); ++i)
    change += dot(scene.weights[i], statics.place()[i] - start.place()[i]);
  return change;
}

/// Two directions to check a quantity along: every number by chance, and every third.
std::vector<Eigen::ArrayXd> directionsOf(const SpringNet& net, NetQuantity quantity)
{
  const Eigen::ArrayXd& numbers = numbersOf(net, quantity);
  Dice dice(23);
  Eigen::ArrayXd all(numbers.size()), some = Eigen::ArrayXd::Zero(numbers.size());
  for (double& entry : all) entry = dice.uniform(-1.0, 1.0);
  if (quantity != NetQuantity::LawParameter) all *= numbers;
  for (Eigen::Index i = 0; i < numbers.size(); i += 3) some[i] = std::abs(all[i]);
  return {all, some};
}

double stepOf(NetQuantity quantity)
{
  return quantity == NetQuantity::RestLength ? 1e-3 : quantity == NetQuantity::LawParameter ? 0.5 : 0.04;
}

void checkSlopes(SpringLaw law, NetQuantity quantity)
{
  const Scene scene = sceneOf(law);
  Statics statics(scene.net, scene.loads);
  ASSERT_EQ(statics.solve({1e-15, 60, 1.0}).outcome, StaticsOutcome::Balanced);
  StaticSlopes slopes(statics, scene.net);
  NetGradient gradient(scene.net);
  NodeArray byPlace = scene.weights;
  slopes.addGradient(byPlace, gradient);
  double worst = 0.0;
  for (const Eigen::ArrayXd& direction : directionsOf(scene.net, quantity)) {
    const double exact = (gradient[quantity] * direction).sum();
    ASSERT_NE(exact, 0.0);
    // A table's kinks must not lie within the differences.
    const double h = law == SpringLaw::Table ? 0.025 * stepOf(quantity) : stepOf(quantity);
    const double measured =
      richardson([&](double amount) { return valueAt(scene, statics, quantity, direction, amount); }, h);
    worst = std::max(worst, std::abs(exact - measured) / std::abs(measured));
    std::vector<NumberChange> changes;
    for (Index i = 0; i < direction.size(); ++i) changes.push_back({quantity, i, direction[i]});
    NodeArray change;
    slopes.changeOfPlace(changes, change);
    double along = 0.0; // of free nodes alone: weights of held ones meet no change
    for (std::size_t i = 0; i < change.size(); ++i) along += dot(change[i], scene.weights[i]);
    EXPECT_NEAR(along, exact, 1e-12 * std::abs(exact)); // one matrix, from its two sides
  }
  // Richardson's own error: forces to 1e-15, over steps of 1e-2 to 1e-4.
  EXPECT_LE(worst, 1e-9) << nameOf(quantity) << " of law " << static_cast<int>(law);
  std::printf("%s of law %d: %.1e\n", nameOf(quantity), static_cast<int>(law), worst);
}

TEST(StaticSlopes, ByStiffnessAreThoseOfDifferences)
{
  for (const SpringLaw law : {SpringLaw::Linear, SpringLaw::Cubic, SpringLaw::Exponential, SpringLaw::Table})
    checkSlopes(law, NetQuantity::Stiffness);
}

TEST(StaticSlopes, ByLawParameterAreThoseOfDifferences)
{
  for (const SpringLaw law : {SpringLaw::Cubic, SpringLaw::Exponential})
    checkSlopes(law, NetQuantity::LawParameter);
}

TEST(StaticSlopes, ByRestLengthAreThoseOfDifferences)
{
  for (const SpringLaw law : {SpringLaw::Linear, SpringLaw::Cubic, SpringLaw::Exponential, SpringLaw::Table})
    checkSlopes(law, NetQuantity::RestLength);
}

TEST(StaticSlopes, ByAnchorStiffnessAreThoseOfDifferences)
{
  for (const SpringLaw law : {SpringLaw::Linear, SpringLaw::Exponential})
    checkSlopes(law, NetQuantity::AnchorStiffness);
}

// The exponential law with b = 0 is computed by the linear one; its slope by b is still there.
TEST(StaticSlopes, ByAnExponentThatIsZeroAreThoseBesideIt)
{
  SpringNet net = chain(2, 0.5, 40.0);
  net.fixed[0] = 1;
  net.law[0] = SpringLaw::Exponential;
  Loads loads;
  loads.forces = {sharedForce({1}, {4.0, 0.0, 0.0})};
  const auto placeFor = [&](double b) {
    net.lawParameter[0] = b;
    Statics statics(net, loads);
    EXPECT_EQ(statics.solve({1e-15, 60, 1.0}).outcome, StaticsOutcome::Balanced);
    return statics.place()[1][0];
  };
  const double measured = richardson(placeFor, 0.1);
  net.lawParameter[0] = 0.0;
  Statics statics(net, loads);
  ASSERT_EQ(statics.solve().outcome, StaticsOutcome::Balanced);
  StaticSlopes slopes(statics, net);
  NodeArray change;
  const NumberChange byB{NetQuantity::LawParameter, 0, 1.0};
  slopes.changeOfPlace({&byB, 1}, change);
  EXPECT_NEAR(change[1][0], measured, 1e-9 * std::abs(measured));
}

// What a gradient costs beside the forward that it belongs to: for each kind of number and for all of them at once.
TEST(StaticSlopes, GradientOfAllNumbersCostsOneSolution)
{
  const Scene scene = sceneOf(SpringLaw::Exponential);
  SpringNet net = scene.net;
  Statics statics(net, scene.loads);
  ASSERT_EQ(statics.solve().outcome, StaticsOutcome::Balanced);
  net.stiffness *= 1.01;
  statics.setParameters(net);
  const StaticAnswer warm = statics.solve();
  ASSERT_EQ(warm.outcome, StaticsOutcome::Balanced);
  const StaticsCost before = statics.cost();
  StaticSlopes slopes(statics, net);
  NetGradient gradient(net);
  NodeArray byPlace = scene.weights;
  slopes.addGradient(byPlace, gradient);
  EXPECT_EQ(statics.cost().factorizations - before.factorizations, 0);
  EXPECT_EQ(statics.cost().solves - before.solves, 1);
  // Even if the factor at the place were counted to it, half of a warm forward.
  EXPECT_GE(warm.cost.factorizations - 1, 2);
  EXPECT_GE(warm.cost.solves, 2);
}

} // namespace
