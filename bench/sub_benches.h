// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace esm::bench {

// The other subcommands. All print CSV on stdout; --quick does less. @return exit code.

/// Nanoseconds per spring of the force pass, beside what the machine allows.
int runKernel(const std::vector<std::string>& words);
/// Bounded or not at one step per frame, over stiffness x mass spread and stiffness x viscosity.
int runStability(const std::vector<std::string>& words);
/// Seconds per frame of auto and per force pass, 100 to 1,000,000 nodes.
int runGrowth(const std::vector<std::string>& words);
/// The uterus pulled and let go: the share of the frame time used, and the largest net that keeps up.
int runRealTime(const std::vector<std::string>& words);
/// Projects as the window's simulation runs them, a node pulled and held: the time until a picture has moved,
/// between two pictures, and the share of real time. Words: "--thread" for the window's thread and the wall clock; project files.
int runHand(const std::vector<std::string>& words);
/// The same pull, led as a prescribed motion, beside XPBD and fast mass springs at the same error.
int runHandBeside(const std::vector<std::string>& words);
/// Tolerances that are missed: how many of them finer runs see and mend. Words: scenes and tolerances.
int runVerify(const std::vector<std::string>& words);
/// What each constant of the planner's policy is worth on the scenes by which it was tuned, and on others. Words: names
/// of constants; none: all.
int runFit(const std::vector<std::string>& words);
int runHoldout(const std::vector<std::string>& words);
/// Whether a motion multiplies errors: what the watch says of scenes that it was not made with, against two
/// exact runs. With names of scenes: what it costs there.
int runWatch(const std::vector<std::string>& words);
/// Steps and spring evaluations of `auto`, which no machine changes. Words: scenes, none: those of
/// docs/BENCHMARKS.md; and constants of the policy that are left out.
int runCounts(const std::vector<std::string>& words);
/// Evaluations per second of fuzzy rule bases, beside fuzzylite.
int runFuzzy(const std::vector<std::string>& words);
/// Milliseconds from a moved slider to new springs, 100,000 of them, beside the full derivation; and from there to an
/// engine that has them, by a patch and by the whole net.
int runTissueEdit(const std::vector<std::string>& words);

/// Displacements of nets as the import makes them against those of finite elements. Words: a body or a net of those
/// that it knows, --cases for each case, --data=FOLDER.
int runFem(const std::vector<std::string>& words);
/// Nanoseconds per triangle from a mesh file to a net, beside the assimp library.
int runImport(const std::vector<std::string>& words);
/// Simplifying and remeshing a bumpy sphere of a million triangles, beside meshoptimizer.
int runRemesh(const std::vector<std::string>& words);

bool isQuick(const std::vector<std::string>& words);

} // namespace esm::bench
