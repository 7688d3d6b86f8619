// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Whatever the parameters: the state stays finite, energy does not come from nowhere, a frame has its price,
// and the user hears what is wrong. The sweep over 10,000 seeds is in test_stress_sweep.cpp.
#include "bench/scenes.h"
#include "tests/support/nets.h"
#include "tests/support/physics.h"
#include "tests/support/stress_run.h"

namespace esm::test {
namespace {

SolverSettings windowSettings()
{
  SolverSettings settings;
  settings.tolerance = 1e-2;
  settings.effort = 5e5; // a frame of a display, 4 ms
  settings.workLimit = 0.0;
  return settings;
}

bool contains(const std::string& text, const char* part)
{
  return text.find(part) != std::string::npos;
}

} // namespace

// Growth: the engine takes 2 % of the energy about for an inaccuracy (5 % in explicit steps at their limit,
// whose fastest modes beat), counted over the whole run. It sees work that goes to and fro within a frame, of
// which the book here sees only the balance: hence twice as much. Cost: three efforts are tried, half of one
// is the descent's, and the last iteration under way is finished.
TEST(Stress, RandomNetsGainNoEnergyAndKeepTheirPrice)
{
  const StressSummary summary = sweepStress(0, 300, windowSettings(), 0.1, 4.0);
  EXPECT_EQ(summary.cases, 300);
  EXPECT_GE(summary.solvers.size(), 5u) << "the sweep must reach nets for all kinds of methods";
  RecordProperty("growth", std::to_string(summary.growth));
  RecordProperty("cost", std::to_string(summary.frameCost));
}

// The last resort gains nothing but rounding errors, at steps of a whole frame, whatever happens to the net.
TEST(Stress, DescentGainsNoEnergyAtAll)
{
  SolverSettings settings = windowSettings();
  settings.solver = "descent";
  settings.fixedStep = 1.0 / 60.0;
  const StressSummary summary = sweepStress(0, 1000, settings, 1e-12, 1.0);
  EXPECT_EQ(summary.cases, 1000);
}

// And it moves: a mass on a soft spring swings as implicit Euler has it, x_n = (1 + w^2 h^2)^(-n/2) in
// amplitude.
TEST(Stress, DescentIsImplicitEulerWhereThatIsEasy)
{
  SpringNet net = chain(2, 1.0, 4.0); // w = 2/s
  net.fixed[0] = 1;
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, 2);
  net.initialVelocity(0, 1) = 0.1;
  const double h = 0.01;
  Simulation simulation = simulate(net, {}, fixedSteps("descent", h));
  double x = 0.0, v = 0.1;
  for (int step = 0; step < 100; ++step) {
    advanceWell(simulation, h);
    v = (v - h * 4.0 * x) / (1.0 + h * h * 4.0);
    x += h * v;
    ASSERT_NEAR(simulation.state().position(0, 1) - 1.0, x, 1e-12) << "step " << step;
  }
}

// A damped net that nobody works at only loses energy. It is under tension and takes steps beyond 2 c/k,
// which stages allow: each frame is a run of its own, and what happens where two runs meet must be as stable
// as a step within one. (Energies are of whole steps, the method's own is not: a thousandth is left for
// that.)
TEST(Stress, ShortRunsOfLongStepsLoseEnergy)
{
  bench::Scene scene = bench::tube();
  SpringNet& net = scene.net;
  net.initialVelocity = 1e-3 * Eigen::Matrix3Xd::Random(3, net.nodeCount());
  const double step = 1.0 / 60.0 / 16.0;
  ASSERT_GT(step, 2.0 * (net.viscosity / net.stiffness).maxCoeff());
  Simulation simulation = simulate(net, {}, fixedSteps("chebyshev", step));
  double least = std::numeric_limits<double>::infinity();
  for (int frame = 0; frame < 90; ++frame) {
    advanceWell(simulation, 16 * step);
    const Energies now = simulation.energies();
    const double energy = now.kinetic + now.elastic;
    ASSERT_LT(energy, 1.001 * least) << "frame " << frame;
    least = std::min(least, energy);
  }
}

// The tube of the bench, a million times stiffer: each frame is affordable, and the net stays where it is
// held.
TEST(Stress, TubeAMillionTimesStifferStaysBoundedAtItsPrice)
{
  bench::Scene scene = bench::tube();
  scene.net.stiffness *= 1e6;
  const SolverSettings settings = windowSettings();
  Simulation simulation = simulate(scene.net, scene.loads, settings);
  EXPECT_TRUE(contains(simulation.why(), "the engine went implicit")) << simulation.why();
  EXPECT_TRUE(contains(simulation.why(), "N/m on ") && contains(simulation.why(), " us")) << simulation.why();
  for (int frame = 0; frame < 30; ++frame) {
    const StepReport report = simulation.advance(1.0 / 60.0);
    ASSERT_TRUE(report.good()) << simulation.why();
    EXPECT_LE(static_cast<double>(report.springsEvaluated), 4.0 * settings.effort) << "frame " << frame;
    ASSERT_LT((simulation.state().position - scene.net.restPosition).cwiseAbs().maxCoeff(), 0.1);
  }
}

// Stiffness over six decades, and a tolerance whose first checks fail by far: the guess that follows asks for
// steps too small to be checked within the effort. It must not stay: plain steps at their limit, with a check
// now and then, keep this tolerance, and cost a fifth.
TEST(Stress, AGuessThatNobodyCanCheckDoesNotLast)
{
  const bench::Scene scene = bench::stiff();
  SolverSettings settings;
  settings.tolerance = 7e-5;
  settings.effort = 6e7;
  Simulation simulation = simulate(scene.net, scene.loads, settings);
  StepReport report;
  for (int frame = 0; frame < 4; ++frame) report = simulation.advance(1.0 / 60.0);
  ASSERT_TRUE(report.good()) << simulation.why();
  const double plain = scene.net.springCount() / 60.0 / simulation.stableStep();
  EXPECT_LT(static_cast<double>(report.springsEvaluated), 2.0 * plain);
}

// Where no step is good and affordable, why() names the node, the step that it would need, and the way out.
TEST(Stress, WhyNamesCauseAndCureOfDampedSteps)
{
  int heard = 0;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const StressResult result = runStress(stressCase(seed), windowSettings());
    if (result.solver != "descent") continue;
    ++heard;
    EXPECT_TRUE(contains(result.why, "damped steps that gain no energy")) << result.why;
    EXPECT_TRUE(contains(result.why, "lower the stiffness or the loads, raise the masses")) << result.why;
    EXPECT_TRUE(contains(result.why, "springs at node ") || contains(result.why, "no spring limits"))
      << result.why;
    EXPECT_TRUE(result.sum.rough) << "the report must say that the tolerance was given up";
  }
  EXPECT_GT(heard, 0);
}

} // namespace esm::test
