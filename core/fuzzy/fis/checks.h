// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fuzzy/fis/system.h"

#include <string>
#include <string_view>
#include <vector>

namespace esm::fis {

/// What is odd about a rule base that can be evaluated all the same. As data, for a list in which a double
/// click puts the sliders on the spot.
enum class FindingKind : std::uint8_t {
  Uncovered,     ///< at the witness no rule sets the output
  Contradiction, ///< two rules of one condition conclude different terms of one output
  Duplicate,     ///< two rules say the same
  Shadowed,      ///< another rule with a weaker condition concludes the same at least as strongly
  NeverFires,    ///< no place was found where the rule has a degree
  Overlap,       ///< two terms of a variable are nearly the same set
  Gap,           ///< at the witness no term of the input holds
  OutputNeverSet ///< no rule concludes on it
};
std::string_view nameOf(FindingKind kind) noexcept; ///< "uncovered", "never-fires", ...

/// A rule's place.
struct RulePlace {
  int block = -1, rule = -1;
};

struct Finding {
  FindingKind kind{};
  std::string message; ///< English sentence without full stop
  RulePlace rule, otherRule;
  bool onOutput = false; ///< whose variable it is
  int variable = -1, term = -1, otherTerm = -1;
  double overlap = 0.0;        ///< of two terms: area of the intersection by area of the union
  std::vector<double> witness; ///< one value per input, or empty
  std::vector<int> inputs;     ///< those that the witness hangs on: the others may be anywhere
};

struct CheckOptions {
  double overlapLimit = 0.6; ///< area of the intersection by area of the union (Jaccard)
  double gapLimit = 0.05;    ///< the highest membership in a gap
  int places = 20000;        ///< of input space that are tried for one output, about
};

/// All findings, the same for the same system. Which places are tried: coverage.h. An output has up to four
/// uncovered findings, one for each stretch of input space.
/// @pre checkSystem(system)
std::vector<Finding> checkRules(const System& system, const CheckOptions& options = {});

} // namespace esm::fis
