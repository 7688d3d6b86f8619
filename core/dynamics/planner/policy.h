// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/system/frame.h"

#include <cstdint>

namespace esm {

/// Every constant by which the planner judges. All of it is a number, so that a test, or a program that fits one,
/// may try another; what a run uses is a default. After each constant stand its unit, the range in which it makes
/// sense, and where it comes from: `rule` is a choice that no measurement asked for, `fit` was measured on scenes
/// (what moved with it is said), `bound` follows from the mathematics. scripts/check_policy.py holds the form, and
/// that no other file of the planner has constants of its own. The measurements are in docs/decisions.
struct Policy {
  /// Of the tolerance, who may spend what; see ErrorLedger, decisions 016 and 020.
  struct Shares {
    double steps = 0.8; ///< that they spend on purpose [1; 0..1; rule]
    /// What a net errs while it is held bent grows when it is let go: errors in its stiff patterns, which are small in
    /// length but not in energy, become such of soft ones. In tubes they grew up to twentyfold, and 12 of 200 runs of
    /// 40 tubes ended up to three times above the tolerance; with this share of it, none of 44 runs of 11.
    double beforeRelease = 0.15; ///< of what steps may [1; 0..1; fit]
    double sleepers = 0.5;       ///< what those miss who rest [1; 0..1; rule]
    /// Where a motion ends as a whole no step errs any more: what the steps have not spent of this, up to the second.
    double atEnd = 0.8, mostAtEnd = 0.64; ///< of the mean square [1; 0..1; rule]
  };
  Shares shares = {};

  /// How errors live, and how much of the motion is still to come; see ErrorGauge, decisions 016 to 020.
  struct Errors {
    double horizon =
      2.0; ///< motion that is reckoned with at least, if nobody knows its end [s; 0..100; rule]
    double shortestLife = 0.1;               ///< of an error; to count on less would be bold [s; 0..1; rule]
    double memory = 0.2, shortMemory = 0.03; ///< over which the net's damping is averaged [s; 0..1; rule]
    /// In which a displacement becomes what the motion makes of it. With 0.03 a struck organ ended 5 % above
    /// a tolerance of 1e-2, and with 0.017 more: a blow does not last.
    double unfolding = 0.01; ///< [s; 0..0.1; fit]
    /// Of that mean, where what was struck swings out: what the first waves err lives longer than they do. With all of
    /// it organs of 890 to 2,000 nodes ended at 0.97 to 1.13 times a tolerance of 1e-2, with this at 0.82 to 1.0; with
    /// half of it they took up to twice the passes.
    double afterBlow = 0.75;      ///< [1; 0..1; fit]
    double slowerThanFirst = 2.0; ///< what follows the first motion, which dampers brake most [1; 1..10; fit]
    /// Of what may be spent: an error for some time, where the end is known and the mean up to it counts. One
    /// that fades in time T leaves a mean of sqrt(T/2t) of it over the time t, so it may be the larger the sooner
    /// it is over; of that this share is believed, and the less the more of the mean square is spent, up to this
    /// part of it. With 2.5 for all, 6 of 64 runs of 16 tubes, which swing on, missed tolerances they had kept.
    double leastPeak = 1.4, mostPeak = 2.5, peakOfMean = 0.35, spentEarly = 0.5; ///< [1; 0..10; fit]
    double beyond = 0.9;  ///< of an even share, that goes on when all of the mean is spent [1; 0..1; rule]
    double faster = 1.5;  ///< what is over has faded faster than is counted on for what comes [1; 1..4; rule]
    double fresh = 0.015; ///< after an event, see ErrorGauge::growing() [s; 0..0.1; fit]
    double slowest = 0.08;     ///< motion that a difference of velocities is taken for [s; 0..1; rule]
    double manyNodes = 2500.0; ///< up to which the errors of a few waves count most [nodes; 100..1e5; fit]
    double halving = 3.0;      ///< doublings of those by which typical errors halve [1; 1..10; fit]
    double tight = 1e-3, tightPower = 0.15; ///< see ErrorGauge::lastingShare() [1; 0..1; fit]
    double mostShares = 2.0;                ///< of an even share, in nets of many nodes [1; 1..4; rule]
    double leastPower = 0.85, lessPerDoubling = 0.18,
           leastOfAll = 0.3; ///< see growing() [1; 0..1; fit]
    double floor = 1e-6;     ///< of the net's extent: a displacement that nobody sees [1; 1e-12..1e-2; rule]
  };
  Errors errors = {};

  /// Steps, and stretches of them; see decisions 014 and 037.
  struct Steps {
    /// Of the bound, which is exact only for a frozen net: the rest is for what stiffens until the next look.
    double shareOfStable = 0.95;   ///< [1; 0.5..1; rule]
    double solveShare = 0.1;       ///< of the budget, for what implicit solvers leave [1; 0..1; rule]
    double mostSteps = 1e12;       ///< of one stretch [1; 1e6..1e15; rule]
    int mostAttempts = 24;         ///< of one stretch [1; 1..100; rule]
    double mostEffort = 3.0;       ///< for one frame, before descent takes over, in efforts [1; 1..10; rule]
    double leastShare = 1.0 / 8.0; ///< of that for a stretch, however short [1; 0..1; rule]
    double afterFailure = 1.0 / 4.0;   ///< of a step that failed: the next one [1; 0..1; rule]
    double mostShrinking = 1.0 / 64.0; ///< of a step at a time: beyond, errors tell of chaos [1; 0..1; rule]
    int attemptsUntilImplicit = 4;     ///< that may fail before implicit steps take over [1; 1..24; rule]
    double coarseSolve = 1e-4;   ///< of the extent: what implicit solvers leave unchecked [1; 0..1; rule]
    double exactSolve = 1e-13;   ///< the same where checks follow [1; 0..1; bound]
    double repeatedSolve = 1e-6; ///< the same where unchecked steps gained energy [1; 0..1; rule]
    double solveAlone = 1e-9;    ///< the same of a method that nobody controls [1; 0..1; rule]
    double solveFixed = 1e-12;   ///< the same at fixed steps [1; 0..1; rule]
    double fewSteps = 32.0;      ///< beyond, the energy of each stretch is looked at [1; 1..1000; rule]
  };
  Steps steps = {};

  /// What may not happen to energy.
  struct Energy {
    /// Growth in a stretch without cause: explicit steps stir up the fastest modes a little at their limit.
    double coarseGrowth = 0.05; ///< of what was there [1; 0..1; rule]
    double growth = 0.02;       ///< the same in steps whose error nobody measures [1; 0..1; rule]
    double rounding = 1e-12;    ///< of sums over all nodes [1; 0..1e-6; bound]
    double quickened = 2.0;     ///< kinetic energy over the start's that is worth a look [1; 1..10; rule]
    double lossLook = 250.0; ///< work between two looks at what a method loses [force passes; 1..1e4; rule]
    double lossPrecision = 0.01; ///< of the tolerance [1; 0..1; rule]
    double mostLossError = 0.5;  ///< the same, at most [1; 0..1; rule]
  };
  Energy energy = {};

  /// Looks at where the net is stiffest; see decision 010.
  struct Bound {
    double patienceImplicit = 32.0;   ///< between two looks [force passes; 1..1e4; rule]
    double patienceNonlinear = 384.0; ///< the same where springs stiffen [force passes; 1..1e4; fit]
    double patienceLinear = 768.0;    ///< the same where they do not [force passes; 1..1e4; fit]
  };
  Bound bound = {};

  /// Checks: a stretch is done twice; see decisions 015, 018, 019, 024 and 025.
  struct Checks {
    double finer = 1.5; ///< steps of the second run, in those of the first [1; 1.1..4; rule]
    /// Of a stretch that is done twice, if that is many steps. Where the end is known a third of the frame saves
    /// 3 % of all passes; with a quarter errors of uteri and organs came out up to five times too large. Where it is
    /// not, a third was too short for a blow: a struck organ ended at 1.3 and 1.9 times a tolerance of 1e-2.
    double lengthToEnd = kFrame / 3.0; ///< [s; 1e-3..kFrame; fit]
    double length = kFrame / 2.0;      ///< [s; 1e-3..kFrame; fit]
    double manySteps = 8.0;            ///< in that length [1; 1..100; rule]
    /// Below fourth order errors at half of the limit are not yet of their order: with checks from above half of the
    /// tubes took 2 % more at 1e-2.
    double enoughOrder = 4.0; ///< for checks by a larger step [1; 2..5; fit]
    /// Of the step after one check: an error has its zeros, one of them must not decide for long.
    double mostGrowth = 3.0;            ///< of the step [1; 1..10; rule]
    double mostErrorGrowth = 30.0;      ///< of its error [1; 1..1000; rule]
    double mostImplicitShrinking = 0.1; ///< of an implicit step [1; 0..1; rule]
    /// The look at the two runs comes after about a quarter of the steps, if there are so many, and so many nodes.
    std::int64_t lookShare = 4;         ///< [1; 2..16; rule]
    std::int64_t leastStepsForLook = 8; ///< [1; 4..64; rule]
    double prepareSwingCost = 3.0;      ///< of ErrorGauge [spring evaluations per spring; 0..10; bound]
    double swingCost = 4.0;             ///< the same [spring evaluations per spring; 0..10; bound]
    /// A step whose error is near the budget stays: to follow every wave of the error would mean to check for ever.
    double leastShareKept = 0.6, mostShareKept = 1.2; ///< of the budget [1; 0..2; rule]
    /// An error that, grown with the power of the dampers since the last check, asks for the next.
    double suspicious = 1.5;  ///< of the budget [1; 1..10; rule]
    double twiceAsFast = 2.0; ///< speed over the largest so far that asks for one, too [1; 1..10; rule]
    /// A check that finds more than its share takes it from what no stretch has spent, and smaller steps from then
    /// on: to do the stretch again would cost more than such an error does.
    double once = 0.1;         ///< of what is unspent [1; 0..1; fit]
    double roughAtFloor = 0.1; ///< of all displacement: an answer at the smallest step [1; 0..1; rule]
    double lastAttempt = 3.0;  ///< further runs that must be payable, else this one counts [1; 1..10; rule]
    /// Room below the budget: errors of high order rise steeply with what the waves do until the next check.
    double roomOfHighOrder = 0.82, room = 0.9; ///< [1; 0..1; fit]
    double highOrder = 3.0;                    ///< beyond [1; 1..5; rule]
    double mostGain = 1e3;                     ///< that a check may promise [1; 1..1e6; rule]
    /// Work of a check's second run over the first, below which it was cheaper; how the largest cheap step grows back.
    double cheaper = 0.9, ease = 1.15; ///< [1; 0.5..2; rule]
    double mostTransfer = 1.5;  ///< power of what is learned for methods of lower order [1; 1..4; rule]
    double leastTransfer = 0.2; ///< of a step, by another method's check [1; 0..1; rule]
    int longestGap = 24;        ///< between checks [stretches; 1..100; rule]
    int longestRoughGap = 8; ///< while the error is beyond what the effort can mend [stretches; 1..100; rule]
    double held = 0.8; ///< of the last step: a larger one has not shrunk, a smaller not grown [1; 0..1; rule]
    double promisedTooMuch =
      0.7; ///< of a step on a guess, below which others may be chosen at once [1; 0..1; rule]
    /// A method that errs less than this share of the budget is not checked again if a known end is no further off
    /// than this many gaps: nothing that a check can still say would save what it costs.
    double sureShare = 0.5, gapsBeforeEnd = 2.0; ///< [1; 0..10; rule]
    /// A shorter stretch tells little of those to come: parts of an onset, and what an event cuts short.
    double leastProof = kFrame / 4.0; ///< [s; 0..kFrame; rule]
    double along = 0.4; ///< error along the motion from which on nothing of it is an offset [1; 0..1; fit]
    double freshGrowth = 2.0; ///< of a step that nobody could afford to check [1; 1..4; rule]
  };
  Checks checks = {};

  /// Which method; see decisions 022, 023, 025, 026, 029, 037 and 039.
  struct Choice {
    /// Implicit steps per frame to begin with. Nets with stiffness over six decades take 25 and more; with 4 tubes
    /// and uteri of a hundred and a thousand times their stiffness went implicit where explicit steps cost a third.
    double implicitGuess = 16.0; ///< [1/frame; 1..100; fit]
    double boundedGuess = 4.0;   ///< the same where they only have to stay bounded [1/frame; 1..100; rule]
    /// Of what plain steps cost: local ones must be that cheap. They err as much as they may, plain ones at their
    /// limit a hundred times less: for a twentieth saved a stiff net ended at fourteen times a tolerance of 1e-3.
    double localGain = 0.6; ///< [1; 0..1; fit]
    double onsetOfImplicit =
      1.9 * kFrame; ///< after an event, in which implicit steps cost more [s; 0..1; rule]
    /// Of what explicit steps cost at their limit: implicit ones are left where they cost more, within that time and
    /// after it. Without the first a tube of a thousand times its stiffness took 1.8 million passes in a frame.
    double mostInOnset = 8.0, mostAfterOnset = 1.5; ///< [1; 1..100; fit]
    double manySteps = 500.0; ///< explicit ones per frame that hold a net up [1; 10..1e4; rule]
    double mostFloorSteps =
      64.0; ///< implicit ones per frame while the tolerance is given up [1; 1..1000; rule]
    double looseTolerance = 1e-2;  ///< see Weighing::caution() and isPayable() [1; 1e-4..1; fit]
    double cautionPower = 0.6;     ///< with 0.4 two of twelve stiff nets at 1e-3 went implicit [1; 0..1; fit]
    double sparingTolerance = 0.1; ///< below, implicit steps spend less than their budget [1; 1e-3..1; fit]
    double sparingPower = 0.3;     ///< see Weighing::spendable() [1; 0..1; fit]
    double patience = 0.9; ///< of the present cost, below which another method must be [1; 0..1; rule]
    double latestOnset = 0.9 * kFrame; ///< after an event, in which an onset may begin [s; 0..kFrame; rule]
    double implicitBeyond =
      4.0; ///< accurate steps over the explicit limit, to weigh implicit ones [1; 1..100; rule]
    double implicitCheaper = 3.0;        ///< explicit over implicit costs, to change [1; 1..10; rule]
    double implicitCheaperAtFirst = 2.0; ///< the same at the start [1; 1..10; rule]
    double tooDear = 1.5; ///< work of the tolerance over the least of a frame, to give it up [1; 1..10; rule]
    int settling = 2;     ///< checks before a method that has just been chosen may be left [1; 0..10; rule]
    int settlingAfterRetreat = 64; ///< the same of implicit steps after failures [1; 0..1000; rule]
    int settlingAfterFallBack = 4; ///< the same of plain steps [1; 0..1000; rule]
  };
  Choice choice = {};

  /// Other methods take the stretch once, after a check; see decision 022.
  struct Probes {
    double gain = 0.7;      ///< of the present cost, below which a probe is worth it [1; 0..1; rule]
    double twinGain = 0.85; ///< the same for longer steps of its twin, at coarse tolerances [1; 0..1; fit]
    double hope = 20.0;     ///< of the budget: guesses are that far off [1; 1..1000; rule]
    double chance = 0.3;    ///< that a probe succeeds [1; 0..1; fit]
    double shareToCompare = 0.5; ///< of the budget, that the end may be off [1; 0..1; rule]
    int most = 2;                ///< after one check [1; 0..10; rule]
    int longestGap = 4;          ///< [checks; 1..100; rule]
    /// Stretches that count as one more check to a method that waits: where checks are rare a probe costs little.
    double waitedPerCheck = 6.0; ///< [stretches; 1..100; rule]
    double farTooGood = 0.2;     ///< of the budget: who errs less need not settle first [1; 0..1; rule]
    int gapAfterProof = 2;       ///< stretches until a method that was proven is checked [1; 1..24; rule]
  };
  Probes probes = {};

  /// The first moments after an event; see decision 021.
  struct Onset {
    double error = 20.0; ///< of the budget: tells of waves that die out soon [1; 1..1000; rule]
    double parts = 16.0; ///< of the stretch, and the steps that make cutting worth while [1; 2..100; rule]
    double share = 1.0 / 16.0; ///< of a frame: what each part may err as much as [1; 0..1; rule]
    double growth = 2.0;       ///< of each part over the last [1; 1..10; rule]
  };
  Onset onset = {};

  /// Where no step is both good and affordable, or a clock is kept; see decisions 002, 004 and 037.
  struct Rough {
    int longestDescent = 64;        ///< stretches before something else is tried again [1; 1..1000; rule]
    double mostDescentSteps = 16.0; ///< of one stretch [1; 1..100; rule]
    double mostBlocks = 4.0;        ///< the same of steps by blocks [1; 1..100; rule]
    double effortOfRun = 0.5;       ///< of what is affordable, that steps are counted by [1; 0..1; rule]
    double leastPasses = 12.0;      ///< a matrix, two looks and some sweeps [force passes; 1..100; rule]
    double guessedError = 0.1;      ///< of a step's own error, before the first check [1; 0..1; fit]
    int secondBlock = 2; ///< until the first check: the first has a hand just come [stretches; 1..16; rule]
    int checkGap = 16, leastCheckGap = 6, mostCheckGap = 256; ///< [stretches; 1..1000; rule]
    double blocksErr = 2.0;     ///< distance of two runs that tells the first one's error [1; 1..4; bound]
    std::size_t fewNodes = 500; ///< a smaller net's factor costs less than a frame [nodes; 1..1e4; rule]
    double back = 0.7;          ///< of the effort, below which plain steps return [1; 0..1; rule]
    /// Of the effort: what plain steps cost where no look at the bound is worth it, a net that has to be stretched until
    /// its stiffness is sixteenfold.
    double farBeyond = 4.0; ///< [1; 1..100; rule]
  };
  Rough rough = {};

  /// The watch over growing errors, see GrowthWatch and decision 003.
  struct Growth {
    double firstLookCost = 12.0; ///< a guess [force passes; 1..100; rule]
    double preparation = 2.0;    ///< of a look [force passes; 0..100; bound]
    double share = 0.015;        ///< of the motion's work, for looks [1; 0..1; rule]
    double shareUndamped = 0.05; ///< the same where no damper lets errors fade [1; 0..1; rule]
    double debtShare = 0.03;     ///< of the motion's work, that pays for following [1; 0..1; rule]
    int often = 2; ///< what gives way once, as a poked organ, seldom does for long [looks; 1..10; fit]
    int burst = 6; ///< [frames; 1..60; rule]
    /// Logarithm of what a difference must grow by in each frame, but for so much: what only wobbles does not pay.
    double leastRate = 0.1, slack = 0.2; ///< [1; 0..10; fit]
    double grows = 1.4;  ///< logarithm of what it must grow by to be followed further [1; 0..10; fit]
    double small = 1e-7; ///< of the extent: the difference that is followed [1; 1e-12..1e-3; rule]
    double grownEnough =
      8.0; ///< logarithm of a growth beyond which nobody needs to know more [1; 1..30; rule]
    double shareOfStable = 0.9; ///< of the stable step, as stiffness may rise in the frame [1; 0.5..1; rule]
    /// Of that, where no damper is: steps at their limit turn the waves by other angles than the motion has done, and
    /// a frame after the other of that multiplies what the motion does not. With 0.9 a free pair seemed to.
    double fineness = 0.25; ///< [1; 0..1; fit]
    /// Of what the motion's own frame took, that following it may: explicit steps take a few times that. Where the
    /// motion goes by implicit steps they may take a million.
    double mostOfFrame = 12.0; ///< [1; 1..100; rule]
    double anyFrame = 2e5;     ///< besides, of any motion [spring evaluations; 0..1e8; rule]
    double driftPower = 2.0;   ///< of time, by which what only drifts grows [1; 1..4; bound]
  };
  Growth growth = {};

  /// Who rests, see RegionDriver, RestWatch and decision 035.
  struct Rest {
    int smallestDivisible = 2000; ///< nets below sleep as a whole or not at all [nodes; 1..1e6; fit]
    double largestPart = 0.6;     ///< of the nodes; above it the whole net is as cheap [1; 0..1; fit]
    double leastDecay = 0.5,
           mostDecay = 8.0; ///< of what goes on behind the edge, see missedMotion() [1; 0..8; bound]
    double balanced =
      1e-3; ///< of what pulls at a node, that may be left while it rests at the start [1; 0..1; rule]
    /// Share of a frame after which to glance at nodes that seem to rest: no simple fraction.
    double glance = 0.381966011250105; ///< [1; 0..1; rule]
    double lookGap = 0.9 * kFrame;     ///< between two looks [s; 0..1; rule]
    double growsAt = 0.25;   ///< of what sleepers may miss, from which on a part grows [1; 0..1; rule]
    double slowShare = 0.25; ///< of the same, what slow nodes may miss [1; 0..1; rule]
    double restlessShare =
      4.0; ///< of the edge's mean, over which a node of it wakes others, its inverse [1; 1..100; rule]
    double someFrames = 4.0;       ///< a slow node does not get far in them [1; 1..60; rule]
    double horizon = 8.0 * kFrame; ///< over which an acceleration is followed [s; 0..1; rule]
    double longestSeries =
      600.0; ///< what does not die out goes on for so many looks, ten seconds [1; 1..1e5; rule]
    std::uint8_t looks = 4; ///< in a row [1; 1..100; rule]
    /// Of the motion so far, what a free body may miss by its momentum; of that and the tolerance, by its turning.
    double missedMomentum = 1e-9, missedTurn = 0.1; ///< [1; 0..1; rule]
    double longWhile = 600.0; ///< that a motion may go on whose end nobody knows [s; 1..1e5; rule]
  };
  Rest rest = {};

  /// The end of a motion in one go, see Settling, decisions 033 and 035.
  struct Settling {
    double forGood =
      0.1; ///< of what may be missed for good: what the goal is off does not fade [1; 0..1; rule]
    /// Of the mean square over the nodes, that a single one may miss: nobody shall see one spot stop at a blow.
    double mostLocal = 25.0; ///< [1; 1..1000; rule]
    double near =
      12.0; ///< frames' ways within which nets of usual frequencies are near enough [1; 1..100; fit]
    int fewIterations = 48;  ///< of gradients where a factor might cost less [1; 1..1000; rule]
    double longestTry = 4.0; ///< [frames; 1..60; rule]
    double patience = 3.0;   ///< work since the last attempt over that of the next [1; 1..100; rule]
    /// Of the work since the last attempt, that a search may cost beyond its first step. With all of it organs of
    /// 2,000 nodes, whose factors are dear, took a fifth longer at 1e-1.
    double search = 0.25; ///< [1; 0..1; fit]
    int longestWait = 32; ///< [looks; 1..1000; rule]
    int waitUnknown =
      3; ///< after an attempt that told no distance: the net bends too much [looks; 1..1000; rule]
    /// Of the time in which amplitudes fade to what may be missed: no attempt before. They are not known to fade
    /// faster than that, and a swing that is slow where it turns is no nearer to its end.
    double leastWait = 0.4; ///< [1; 0..1; rule]
    double slower = 0.9;    ///< of the speed that the last attempt asks for [1; 0..1; rule]
    /// Of the amplitude that may be missed: from there on each attempt only waits for what has to fade, and may cost
    /// more, as it may save the next frame. Where waves meet on their way about an organ its speed rises once more.
    double nearlyThere = 1.5; ///< [1; 1..10; rule]
    /// Of the time in which a mode with all the energy would fade: slow ones take longer, as in fadingTime().
    double slowestFade = 2.0;  ///< [1; 1..10; rule]
    int glances = 16;          ///< iterations of each bound [1; 1..100; rule]
    double glanceCost = 40.0;  ///< with all of them [force passes; 1..1000; bound]
    double farEnough = 16.0;   ///< of what may be missed, that a bound need not go beyond [1; 1..100; rule]
    double mostSquares = 16.0; ///< see SettlingBudget [1; 1..100; rule]
  };
  Settling settling = {};

  /// The search for a balance, see Equilibrium and decision 034.
  struct Balance {
    double inertia = 1e-2; ///< share of the mass in K, 1/(10 s)^2 [1/s^2; 0..1; rule]
    int iterations = 400;  ///< of gradients, for each solution [1; 1..1e4; rule]
    /// Of the first forces, that may be left where they tell that the place is reached: the net is nearly linear on its
    /// way there, or it is not near.
    double left = 0.5;     ///< [1; 0..1; rule]
    double shorter = 0.75; ///< of a step, that the next by the same stiffness must be [1; 0..1; rule]
    /// Of a step, that the next by the stiffness after it may be. More of hanging chains are found the larger it
    /// is (39 of 45 with this, all with any length), but not more of tubes: one of the benches' took 40 % more time.
    double longer = 2.0;           ///< [1; 1..10; fit]
    double leastPart = 0.1;        ///< of a step [1; 0..1; rule]
    int mostSteps = 24;            ///< [1; 1..1000; rule]
    std::size_t mostNodes = 10000; ///< a factor of 150 MB in a solid [nodes; 1..1e6; rule]
    double layoutCost = 1500.0;    ///< [spring evaluations per node; 1..1e5; fit]
    double gradientsCost = 40.0;   ///< of a solution [force passes; 1..1000; fit]
    double gradientsLayout = 10.0; ///< the same before the first one at a place [force passes; 1..1000; fit]
  };
  Balance balance = {};
};

/// What a run uses.
inline constexpr Policy kPolicy{};

} // namespace esm
