// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// How fast a net can move, and what the explicit methods make of it.
#include "core/dynamics/bounds/spectral_radius.h"
#include "core/dynamics/bounds/step_bound.h"
#include "core/dynamics/methods/chebyshev_damping.h"
#include "core/dynamics/methods/integrator.h"
#include "tests/support/nets.h"
#include "tests/support/one_mass.h"
#include "tests/support/physics.h"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

namespace esm::test {
namespace {

FastestMode boundOf(const SpringNet& net)
{
  System system(net, {});
  MotionState state = startOf(net);
  system.enter(state, true);
  StepBound bound;
  bound.prepare();
  return bound.compute(system, state.x, state.v);
}

double exactStiffness(const SpringNet& net)
{
  const Eigen::MatrixXd k = scaledMatrix(net, net.stiffness);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k).eigenvalues().maxCoeff();
}

/// The fastest real root of s^2 + s D + K over all modes, as a positive rate; 0 if all oscillate.
double exactDecay(const SpringNet& net)
{
  const Eigen::Index n = 3 * net.nodeCount();
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  companion.topRightCorner(n, n).setIdentity();
  companion.bottomLeftCorner(n, n) = -scaledMatrix(net, net.stiffness);
  companion.bottomRightCorner(n, n) = -scaledMatrix(net, net.viscosity);
  double fastest = 0.0;
  for (const std::complex<double>& root : companion.eigenvalues())
    if (std::abs(root.imag()) < 1e-6 * std::abs(root)) fastest = std::max(fastest, -root.real());
  return fastest;
}

/// The spectral radius of one leapfrog step with this damping, by the eigenvectors of the damping matrix.
/// @param inPhase  with Stoermer's second difference of the forces
double growthPerStep(const SpringNet& net, const ChebyshevDamping& damping, double h, bool inPhase)
{
  const Eigen::Index n = 3 * net.nodeCount();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> rates(scaledMatrix(net, net.viscosity));
  const Eigen::ArrayXd z = h * rates.eigenvalues().array().max(0.0);
  const Eigen::ArrayXd p = z.unaryExpr([&](double at) { return damping.value(at); });
  const Eigen::ArrayXd share = (z > 1e-9).select((1.0 - p) / z.max(1e-9), 1.0);
  const Eigen::MatrixXd& q = rates.eigenvectors();
  const Eigen::MatrixXd kept = q * p.matrix().asDiagonal() * q.transpose();
  const Eigen::MatrixXd filter = q * share.matrix().asDiagonal() * q.transpose();
  const Eigen::MatrixXd stiffness = h * h * scaledMatrix(net, net.stiffness);
  const Eigen::MatrixXd pull = filter * stiffness, one = Eigen::MatrixXd::Identity(n, n);
  if (!inPhase) {
    Eigen::MatrixXd step(2 * n, 2 * n); // of (x, h v)
    step << one - pull, kept, -pull, kept;
    return step.eigenvalues().cwiseAbs().maxCoeff();
  }
  const Eigen::MatrixXd drag = q * z.matrix().asDiagonal() * q.transpose(), zero = 0.0 * one;
  Eigen::MatrixXd force(n, 4 * n), kick(n, 4 * n); // of (x, h v, f, f before), f = h^2 M^-1 F
  force << -stiffness, -drag, zero, zero;
  kick << zero, one, -filter / 6.0, filter / 12.0;
  kick += 13.0 / 12.0 * filter * force;
  Eigen::MatrixXd step(4 * n, 4 * n);
  step << kick, kick, force, Eigen::MatrixXd::Zero(n, 4 * n);
  step.topLeftCorner(n, n) += one;
  step.block(3 * n, 2 * n, n, n) = one;
  return step.eigenvalues().cwiseAbs().maxCoeff();
}

/// A mass of 1 kg at 1000/s, damped so much [1/s].
FastestMode verletMode(double damping)
{
  FastestMode mode;
  mode.stiffness = 1e6;
  mode.damping = damping;
  return mode;
}

/// What is left of its displacement of 1 m along the spring after so many steps of velocity Verlet, or NaN.
double verletEnd(double damping, double h, int steps)
{
  OneMass mass("verlet", 1000.0, damping, verletMode(damping));
  return mass.run(h * steps, steps) == StepResult::Done ? mass.displacement() : std::nan("");
}

} // namespace

// The bound must not lie below the largest eigenvalue, which the dense solver knows, nor far above: Ritz
// values get a margin of 2 %, the step one of 5 % (10 % in the square).
TEST(Spectrum, BoundIsTheLargestEigenvalueOrALittleMore)
{
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const SpringNet net = relaxed(seed);
    const double exact = exactStiffness(net), bound = boundOf(net).stiffness;
    EXPECT_GE(bound, 0.999 * exact) << "seed " << seed;
    EXPECT_LE(bound, 1.03 * exact) << "seed " << seed;
  }
}

// Nothing decays faster than the bound, by the dense companion matrix; and where stiffness holds up the
// dampers, the bound is not the damping alone. It counts on nine tenths of the stiffness: at critical damping
// that alone makes 1 + sqrt(1/10) of the truth, and five rounds of a slow iteration a little more.
TEST(Spectrum, DecayIsBoundedByMoreThanTheDamping)
{
  for (std::uint32_t seed = 1; seed <= 8; ++seed)
    for (const double overdamped : {0.3, 1.0, 1.3, 3.0}) {
      SpringNet net = relaxed(seed);
      const double fastest = std::sqrt(exactStiffness(net));
      net.viscosity = net.stiffness * (2.0 * overdamped / fastest); // of the stiffest mode
      const FastestMode mode = boundOf(net);
      const double exact = exactDecay(net), slowest = std::max(exact, fastest);
      EXPECT_GE(std::max(mode.decay, fastest), 0.999 * exact) << "seed " << seed << ", " << overdamped;
      EXPECT_LE(mode.decay, 1.45 * slowest) << "seed " << seed << ", " << overdamped;
      EXPECT_LE(mode.decay, mode.damping);
    }
}

// A spring along a damper holds up what that brakes: r^2 - (c/m) r + k/m = 0. Turned across it, it does not,
// and the node decays with c/m, while no row sum has changed. A look or two later the bound must know.
TEST(Spectrum, DecayIsMeasuredAnewWhereSpringsTurn)
{
  const double mass = 1e-3, k = 100.0, c = 0.7;
  SpringNet net;
  const Index node = addNode(net, {0.0, 0.0, 0.0}), springEnd = addNode(net, {1.0, 0.0, 0.0}),
              damperEnd = addNode(net, {-1.0, 0.0, 0.0});
  net.mass << mass, 1e6, 1e6; // the ends stay where they are
  addSpring(net, node, springEnd, k);
  addSpring(net, node, damperEnd, 1e-6, c);
  System system(net, {});
  MotionState state = startOf(net);
  system.enter(state, true);
  StepBound bound;
  bound.prepare();
  const double along = bound.compute(system, state.x, state.v).decay;
  const double fast = (c / mass + std::sqrt(c * c / mass / mass - 4.0 * k / mass)) / 2.0;
  EXPECT_GE(along, fast);
  EXPECT_LE(along, 0.8 * c / mass);
  state.x[static_cast<std::size_t>(springEnd)] = Lanes{0.0, 1.0, 0.0, 0.0};
  double across = 0.0;
  for (int look = 0; look < 2; ++look) across = bound.compute(system, state.x, state.v).decay;
  EXPECT_GE(across, c / mass);
}

// What the dampers leave over: K <= undamped + D/leastDamping in every mode, by the dense solver, in nets of
// which every tenth spring has no damper; and the same for a share of what is owed. Not far above either, as
// sums over the springs at a node are: Ritz values get a margin of 2 %, and 0.4 % of the largest eigenvalue
// of D/leastDamping.
TEST(Spectrum, WhatDampersLeaveOverIsTheLargestEigenvalueOrALittleMore)
{
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    SpringNet net = relaxed(seed);
    const double least = 2.0 / std::sqrt(exactStiffness(net));
    net.viscosity = net.stiffness * least;
    for (Index s = 0; s < net.springCount(); ++s) net.viscosity[s] *= s % 10 == 0 ? 0.0 : 1.0 + s % 4;
    const FastestMode mode = boundOf(net);
    ASSERT_NEAR(mode.leastDamping, least, 1e-9 * least) << "seed " << seed;
    const Eigen::MatrixXd damping = scaledMatrix(net, net.viscosity) / least;
    const auto largest = [](const Eigen::MatrixXd& matrix) {
      return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues().maxCoeff();
    };
    ASSERT_LT(mode.owedShare, 1.0) << "seed " << seed;
    for (const auto& [share, undamped] :
         {std::pair{1.0, mode.undamped}, {mode.owedShare, mode.undampedByShare}}) {
      const double exact = largest(scaledMatrix(net, net.stiffness) - share * damping);
      EXPECT_GE(undamped, 0.999 * exact) << "seed " << seed << ", " << share;
      EXPECT_LE(undamped, 1.03 * exact + 0.005 * largest(damping)) << "seed " << seed << ", " << share;
    }
  }
}

// Masses that hang on springs with dampers in proportion, and one on a spring without, as tension is in
// tissue: staged steps are stable up to their limit and not a twentieth beyond, by the eigenvalues of the
// whole step. (Measured bounds are 2.4 % above the squares of the rates; means of the two bounds at the ends
// alone were 7 and 11 % below the limit.)
TEST(Spectrum, TheLimitOfStagedStepsIsSharpBesideTension)
{
  const double mass = 1e-3, stiffness = 1000.0, least = 0.5 / std::sqrt(stiffness / mass);
  for (const double tension : {0.13, 0.3}) {
    SpringNet net;
    const auto hang = [&](double k, double c) {
      const double row = net.nodeCount();
      const Index node = addNode(net, {0.0, row, 0.0}), end = addNode(net, {1.0, row, 0.0});
      net.mass.tail(2) << mass, 1e6; // the end stays where it is
      addSpring(net, node, end, k, c);
    };
    for (int i = 1; i <= 10; ++i) hang(0.1 * i * stiffness, 0.1 * i * stiffness * least);
    hang(tension * stiffness, 0.0);
    const FastestMode mode = boundOf(net);
    for (const bool inPhase : {false, true}) {
      const ChebyshevDamping damping(inPhase ? 2 : 3, 2, inPhase);
      const double limit = damping.stableStep(mode);
      EXPECT_LT(growthPerStep(net, damping, 0.99 * limit, inPhase), 1.0 + 1e-6) << tension << ", " << inPhase;
      EXPECT_GT(growthPerStep(net, damping, 1.05 * limit, inPhase), 1.001) << tension << ", " << inPhase;
    }
  }
}

// Three springs from a light node, each at 60 degrees to both others as lines: in a plane, all pull against
// one another and the largest eigenvalue is 1.5 k/m; as three edges of a tetrahedron they pull together, and
// it is 2 k/m (1 + 2 cos 60). Sums of absolute values are 2 k/m in both.
TEST(Spectrum, BoundIsMeasuredAnewWhereSpringsTurn)
{
  const double mass = 1e-3, k = 100.0, c = 0.2;
  SpringNet net;
  const Index node = addNode(net, {0.0, 0.0, 0.0});
  const double root = std::sqrt(3.0);
  const Index ends[] = {addNode(net, {1.0, 0.0, 0.0}), addNode(net, {0.5, root / 2.0, 0.0}),
                        addNode(net, {-0.5, root / 2.0, 0.0})};
  net.mass << mass, 1e6, 1e6, 1e6; // the ends stay where they are
  for (const Index end : ends) addSpring(net, node, end, k, c);
  System system(net, {});
  MotionState state = startOf(net);
  system.enter(state, true);
  StepBound bound;
  bound.prepare();
  const FastestMode flat = bound.compute(system, state.x, state.v);
  EXPECT_NEAR(flat.stiffness, 1.5 * k / mass, 0.05 * k / mass); // measured values are raised by 2 %
  EXPECT_NEAR(flat.damping, 1.5 * c / mass, 0.05 * c / mass);
  state.x[static_cast<std::size_t>(ends[2])] = Lanes{0.5, root / 6.0, std::sqrt(2.0 / 3.0), 0.0};
  FastestMode raised;
  for (int look = 0; look < 2; ++look) raised = bound.compute(system, state.x, state.v);
  EXPECT_GE(raised.stiffness, 1.999 * k / mass);
  EXPECT_GE(raised.damping, 1.999 * c / mass);
}

// A tridiagonal matrix with 2 on the diagonal and -1 beside it has the eigenvalues 2 - 2 cos(k pi/(n + 1)).
TEST(Spectrum, TridiagonalEigenvalueInClosedForm)
{
  const std::size_t n = 12;
  const double largest =
    largestTridiagonalEigenvalue(std::vector<double>(n, 2.0), std::vector<double>(n - 1, -1.0));
  EXPECT_NEAR(largest, 2.0 - 2.0 * std::cos(12.0 * std::numbers::pi / 13.0), 1e-11);
}

// P(z) = 1 - z + ... for order 1, 1 - z + z^2/2 + ... for order 2, and |P| < 1 up to its reach.
TEST(Spectrum, ChebyshevPolynomialsHaveTheirOrderAndStayBelowOne)
{
  for (const int order : {1, 2})
    for (int stages = order; stages <= ChebyshevDamping::kMostStages; ++stages) {
      const ChebyshevDamping damping(stages, order);
      const double h = 1e-4, slope = (damping.value(h) - damping.value(-h)) / (2 * h);
      EXPECT_NEAR(damping.value(0.0), 1.0, 1e-13);
      EXPECT_NEAR(slope, -1.0, 1e-7);
      const double curvature = (damping.value(h) - 2.0 * damping.value(0.0) + damping.value(-h)) / (h * h);
      if (order == 2) {
        EXPECT_NEAR(curvature, 1.0, 1e-5); // rounding 1e-16/h^2, and h^2 P''''
      }
      // The reach is that of a mode that is all damper: w2 -> 0.
      FastestMode mode;
      mode.damping = 1.0;
      const double reach = damping.stableStep(mode);
      EXPECT_GT(reach, (order == 1 ? 1.3 : 0.6) * (stages * stages - (order == 1 ? 0 : 1)));
      for (int i = 1; i < 200; ++i) EXPECT_LT(std::abs(damping.value(reach * i / 200.0)), 1.0);
    }
}

// The velocity of a mode that is all damper, taken through the stages one by one, is P(z) times what it was.
// The recurrence's terms are at most some thousands (8 stages at the end of their reach), rounded at 1e-16.
TEST(Spectrum, TheStagesMakeTheirPolynomial)
{
  for (const int order : {1, 2})
    for (int stages = 2; stages <= ChebyshevDamping::kMostStages; ++stages) {
      const ChebyshevDamping damping(stages, order);
      for (int i = 0; i <= 40; ++i) {
        const double z = damping.viscousLimit(1.0) * i / 40.0, a = -z; // h F/m of v = 1
        double before = 0.0, d = a;
        for (int j = 2; j <= stages; ++j) {
          const ChebyshevDamping::Stage& stage = damping.stage(j);
          const double next = stage.mu * d + stage.nu * before + stage.push * a - stage.kick * z * d;
          before = d;
          d = next;
        }
        EXPECT_NEAR(1.0 + d, damping.value(z), 1e-11) << stages << " stages of order " << order << ", " << z;
      }
    }
}

// Rates that overflowed somewhere allow no step, rather than any.
TEST(Spectrum, NoStepIsStableForWhatIsNoNumber)
{
  for (const int order : {1, 2}) {
    const ChebyshevDamping damping(3, order);
    FastestMode mode;
    mode.stiffness = 1e6;
    mode.damping = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(damping.stableStep(mode), 0.0);
  }
}

// One damped mass: at 0.99 of the stable step it stays, at 1.1 of it it does not. (The bound is exact for one
// mode, but for the bisection's 0.1 %.)
TEST(Spectrum, LeapfrogLimitIsSharpForOneMode)
{
  for (const double damping : {0.0, 100.0, 1500.0, 8000.0})
    for (const int stages : {1, 2, 3, 4}) {
      const ChebyshevDamping polynomial(stages, 1);
      FastestMode mode;
      mode.stiffness = 1e6;
      mode.damping = damping;
      mode.leastDamping = damping / mode.stiffness;
      const auto grows = [&](double h) {
        const double p = polynomial.value(h * damping),
                     share = damping > 0.0 ? (1.0 - p) / (h * damping) : 1.0;
        double x = 1.0, v = 0.0;
        for (int i = 0; i < 2000; ++i) {
          v = p * v - share * h * mode.stiffness * x;
          x += h * v;
        }
        return !(std::abs(x) < 1e6);
      };
      const double limit = polynomial.stableStep(mode);
      EXPECT_FALSE(grows(0.99 * limit)) << stages << " stages, damping " << damping;
      if (damping == 0.0) {
        EXPECT_TRUE(grows(1.01 * limit));
      }
    }
}

// One damped mass: velocity Verlet stays at every step up to its limit, whatever share of its prediction it
// carries over there, and not beyond. (The limit is exact for one mode.)
TEST(Spectrum, VerletStaysUpToItsLimitWhateverItCarries)
{
  for (const double damping : {0.0, 100.0, 1500.0, 8000.0}) {
    const FastestMode mode = verletMode(damping);
    const double limit = makeIntegrator("verlet")->stableStep(mode);
    for (const double part : {0.05, 0.3, 0.5, 0.6, 0.7, 0.8, 0.85, 0.88, 0.9, 0.95, 0.99})
      EXPECT_LT(std::abs(verletEnd(damping, part * limit, 3000)), 1.5) << part << ", damping " << damping;
    EXPECT_FALSE(std::abs(verletEnd(damping, 1.05 * limit, 150)) < 10.0) << "damping " << damping;
  }
}

// Steps far below the limit carry nothing over: they are those of the textbook, whose viscous force sees
// v + h a.
TEST(Spectrum, SmallStepsOfVerletPredictPlainly)
{
  for (const double damping : {100.0, 1500.0}) {
    const double h = 0.3 / std::max(damping, 1000.0), stiffness = 1e6;
    double x = 1.0, v = 0.0, a = -stiffness * x;
    for (int i = 0; i < 50; ++i) {
      const double half = v + 0.5 * h * a, predicted = v + h * a;
      x += h * half;
      a = -stiffness * x - damping * predicted;
      v = half + 0.5 * h * a;
    }
    EXPECT_NEAR(verletEnd(damping, h, 50), x, 1e-9); // rounding of a stretch of 1 m, 50 times
  }
}

// No step up to the limit lets anything grow in nets whose dampers and springs have other directions of their
// own, by the eigenvalues of the dense step matrix. (Rigid motion has a double eigenvalue 1, of which
// rounding makes 1 + sqrt(1e-16) and more.)
TEST(Spectrum, NoStepUpToTheLimitLetsANetGrow)
{
  for (std::uint32_t seed = 1; seed <= 6; ++seed)
    for (const double damped : {0.1, 1.0, 5.0}) {
      SpringNet net = relaxed(seed, 16);
      net.viscosity = net.stiffness * (2.0 * damped / std::sqrt(exactStiffness(net)));
      for (Index s = 0; s < net.springCount(); ++s) net.viscosity[s] *= 1.0 + s % 4;
      if (seed % 2 == 0)
        for (Index s = 0; s < net.springCount(); s += 10) net.viscosity[s] = 0.0;
      const FastestMode mode = boundOf(net);
      for (const int order : {1, 2})
        for (int stages = order; stages <= 4; ++stages)
          for (const bool inPhase : {false, true}) {
            if (inPhase && order == 1) continue;
            const ChebyshevDamping damping(stages, order, inPhase);
            const double limit = damping.stableStep(mode);
            for (const double part : {0.3, 0.6, 0.8, 1.0})
              EXPECT_LT(growthPerStep(net, damping, part * limit, inPhase), 1.0 + 1e-6)
                << "seed " << seed << ", damped " << damped << ", order " << order << ", " << stages
                << " stages, " << part << (inPhase ? ", in phase" : "");
          }
    }
}

// Where the stiffest modes are the best damped, staged steps may be longer than 2/w, the limit of all
// explicit methods without damping.
TEST(Spectrum, DampedNetsBearStepsBeyondTheElasticLimit)
{
  SpringNet net = relaxed(3);
  const double fastest = std::sqrt(exactStiffness(net));
  net.viscosity = net.stiffness * (4.0 / fastest);
  EXPECT_GT(ChebyshevDamping(4, 2).stableStep(boundOf(net)), 1.2 * 2.0 / fastest);
}

} // namespace esm::test
