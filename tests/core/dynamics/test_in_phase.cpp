// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// `stoermer3`: leapfrog and its viscous stages with Stoermer's second difference of the forces.
#include "tests/support/one_mass.h"
#include "tests/support/physics.h"

#include <numbers>

namespace esm::test {
namespace {

constexpr double kRate = 1000.0; ///< of the mass [1/s]

OneMass undamped(std::string_view name)
{
  FastestMode mode;
  mode.stiffness = kRate * kRate;
  return OneMass(name, kRate, 0.0, mode);
}

OneMass damped()
{
  FastestMode mode;
  mode.stiffness = kRate * kRate;
  mode.damping = 300.0;
  return OneMass("stoermer3", kRate, mode.damping, mode);
}

} // namespace

// What the rule leaves out, (nabla^3/12) a = h^3 a'''/12, is a damper: x'' = -w^2 x - (h^3 w^4/12) x', so
// that after t the amplitude is exp(-z^3 w t/24), z = h w. After whole periods its phase, off by O(z^4),
// shows in its square only: what is left of the difference is the start, and z^4. Leapfrog's waves have run
// off by z^2/24 of the time.
TEST(InPhase, LosesAmplitudeByTheThirdPowerOfTheStep)
{
  for (const int perPeriod : {80, 160}) {
    constexpr int kPeriods = 10;
    const double time = kPeriods * 2.0 * std::numbers::pi / kRate, z = 2.0 * std::numbers::pi / perPeriod;
    OneMass mass = undamped("stoermer3"), leapfrog = undamped("leapfrog");
    ASSERT_EQ(mass.run(time, kPeriods * perPeriod), StepResult::Done);
    ASSERT_EQ(leapfrog.run(time, kPeriods * perPeriod), StepResult::Done);
    const double lost = z * z * z * kRate * time / 24.0;
    EXPECT_NEAR(1.0 - mass.displacement(), lost, 0.1 * lost) << perPeriod;
    const double late = leapfrog.motion.v[1][0] / kRate, phase = z * z * kRate * time / 24.0;
    EXPECT_NEAR(std::abs(late), std::sin(phase), 0.05 * phase) << perPeriod;
    EXPECT_LT(std::abs(mass.motion.v[1][0] / kRate), 0.1 * std::abs(late)) << perPeriod;
  }
}

// Steps that change from run to run, up to fivefold: the past is interpolated. Equal steps of the longest
// kind lose lost = sum z^3 w t/24; the changes add as much at most.
TEST(InPhase, StepsMayChange)
{
  const double longest = 0.1 / kRate;
  OneMass mass = undamped("stoermer3");
  double time = 0.0;
  constexpr double kShare[] = {1.0, 0.67, 0.2, 0.3, 1.0, 0.55};
  for (int run = 0; run < 120; ++run) {
    const double step = longest * kShare[run % 6];
    time += 8.0 * step;
    ASSERT_EQ(mass.run(time, 8), StepResult::Done);
  }
  const double lost = std::pow(0.1, 3) * kRate * time / 24.0;
  EXPECT_NEAR(mass.displacement(), std::cos(kRate * time), lost);
  EXPECT_NEAR(mass.motion.v[1][0] / kRate, -std::sin(kRate * time), lost);
}

// A check runs a stretch and then, from where it began, once more with another step: the second run goes on
// as if the first had never been, bit by bit. Taken back to a time that has not been marked, the method
// starts anew.
TEST(InPhase, WhatWasMarkedIsKnownAgain)
{
  const double h = 2e-4;
  const auto detour = [&](double backTo) {
    OneMass mass = damped();
    mass.run(20 * h, 20);
    const MotionState before = mass.motion;
    mass.method->mark(before.time);
    mass.run(32 * h, 12);
    mass.motion = before;
    mass.method->rewind(backTo);
    mass.run(32 * h, 18);
    return mass.displacement();
  };
  OneMass straight = damped(), anew = damped();
  straight.run(20 * h, 20);
  straight.run(32 * h, 18);
  anew.run(20 * h, 20);
  anew.method->restart();
  anew.run(32 * h, 18);
  EXPECT_EQ(detour(20 * h), straight.displacement());
  EXPECT_EQ(detour(19 * h), anew.displacement());
  EXPECT_NE(straight.displacement(), anew.displacement());
}

// After a run that ended in infinity nothing of it is left: the next one is that of a fresh method.
TEST(InPhase, NothingIsLeftOfARunThatFailed)
{
  const double h = 2e-4;
  OneMass mass = damped(), fresh = damped();
  const MotionState start = mass.motion;
  ASSERT_EQ(mass.run(4000 * 20 * h, 4000), StepResult::NonFinite); // 4 ms each: far beyond 2/w
  EXPECT_EQ(mass.motion.x[1][0], start.x[1][0]);
  mass.run(20 * h, 20);
  fresh.run(20 * h, 20);
  EXPECT_EQ(mass.displacement(), fresh.displacement());
}

} // namespace esm::test
