// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/policy_table.h"

#include <array>

namespace esm::bench {
namespace {

constexpr double kNever = 1e300;

#define ESM_CONSTANT(name, value)                                                                            \
  Constant                                                                                                   \
  {                                                                                                          \
#name, [](Policy & policy) { policy.name = value; }                                                      \
  }

constexpr std::array kConstants = {
  ESM_CONSTANT(shares.beforeRelease, 1.0),
  ESM_CONSTANT(errors.unfolding, 0.0),
  ESM_CONSTANT(errors.afterBlow, 1.0),
  ESM_CONSTANT(errors.slowerThanFirst, 1.0),
  ESM_CONSTANT(errors.spentEarly, 1e6),
  ESM_CONSTANT(errors.leastPeak, 1.0),
  ESM_CONSTANT(errors.mostPeak, 1.4), // the least one
  ESM_CONSTANT(errors.peakOfMean, 0.0),
  ESM_CONSTANT(errors.faster, 1.0),
  ESM_CONSTANT(errors.fresh, 0.0),
  ESM_CONSTANT(errors.halving, kNever),
  ESM_CONSTANT(errors.tightPower, 0.0),
  ESM_CONSTANT(errors.mostShares, 1.0),
  ESM_CONSTANT(errors.leastPower, 1.0),
  ESM_CONSTANT(errors.lessPerDoubling, 0.0),
  ESM_CONSTANT(errors.leastOfAll, 0.0),
  ESM_CONSTANT(bound.patienceNonlinear, 768.0), // as where springs do not stiffen
  ESM_CONSTANT(bound.patienceLinear, 384.0),
  ESM_CONSTANT(checks.lengthToEnd, kFrame / 2.0), // as where no end is known
  ESM_CONSTANT(checks.length, kFrame),
  ESM_CONSTANT(checks.enoughOrder, kNever), // no checks from above
  ESM_CONSTANT(checks.mostErrorGrowth, kNever),
  ESM_CONSTANT(checks.suspicious, kNever),
  ESM_CONSTANT(checks.twiceAsFast, kNever),
  ESM_CONSTANT(checks.once, 0.0),
  ESM_CONSTANT(checks.roomOfHighOrder, 0.9), // as of low order
  ESM_CONSTANT(checks.cheaper, 0.0),
  ESM_CONSTANT(checks.mostTransfer, 1.0),
  ESM_CONSTANT(checks.promisedTooMuch, 0.0),
  ESM_CONSTANT(checks.sureShare, 0.0),
  ESM_CONSTANT(checks.leastProof, 0.0),
  ESM_CONSTANT(checks.along, 1e-300), // all is along the motion
  ESM_CONSTANT(choice.implicitGuess, 4.0),
  ESM_CONSTANT(choice.localGain, 1.0),
  ESM_CONSTANT(choice.onsetOfImplicit, 0.0),
  ESM_CONSTANT(choice.mostInOnset, 1.5), // as later
  ESM_CONSTANT(choice.looseTolerance, 1.0),
  ESM_CONSTANT(choice.cautionPower, 0.0),
  ESM_CONSTANT(choice.sparingTolerance, 1e-300),
  ESM_CONSTANT(choice.sparingPower, 0.0),
  ESM_CONSTANT(choice.patience, 1.0),
  ESM_CONSTANT(choice.settling, 0),
  ESM_CONSTANT(probes.twinGain, 0.7), // as of others
  ESM_CONSTANT(probes.chance, 0.0),   // no probes
  ESM_CONSTANT(probes.hope, kNever),
  ESM_CONSTANT(probes.shareToCompare, kNever),
  ESM_CONSTANT(probes.most, 0),
  ESM_CONSTANT(probes.waitedPerCheck, kNever),
  ESM_CONSTANT(probes.farTooGood, 0.0),
  ESM_CONSTANT(onset.error, kNever), // no onsets
  ESM_CONSTANT(onset.share, 0.0),
  ESM_CONSTANT(rough.guessedError, 1.0),
  ESM_CONSTANT(growth.often, 1),
  ESM_CONSTANT(growth.leastRate, 0.0),
  ESM_CONSTANT(growth.slack, 0.0),
  ESM_CONSTANT(growth.grows, 0.0),
  ESM_CONSTANT(growth.fineness, 1.0),
  ESM_CONSTANT(rest.smallestDivisible, 0),
  ESM_CONSTANT(rest.largestPart, 1.0),
  ESM_CONSTANT(rest.glance, 1.0),
  ESM_CONSTANT(rest.someFrames, 1.0),
  ESM_CONSTANT(settling.forGood, 1.0),
  ESM_CONSTANT(settling.mostLocal, kNever),
  ESM_CONSTANT(settling.near, kNever),
  ESM_CONSTANT(settling.patience, 1.0),
  ESM_CONSTANT(settling.search, 1.0),
  ESM_CONSTANT(settling.leastWait, 0.0),
  ESM_CONSTANT(settling.nearlyThere, 1.0),
  ESM_CONSTANT(settling.slowestFade, 0.0),
  ESM_CONSTANT(balance.longer, 1e-300),
  ESM_CONSTANT(balance.layoutCost, 0.0),
  ESM_CONSTANT(balance.gradientsCost, 0.0),
  ESM_CONSTANT(balance.gradientsLayout, 0.0),
};

#undef ESM_CONSTANT

} // namespace

std::span<const Constant> constants()
{
  return kConstants;
}

} // namespace esm::bench
