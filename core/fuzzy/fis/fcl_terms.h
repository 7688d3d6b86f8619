// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

// Internal to the reader of FCL.
#include "core/fuzzy/fis/fcl_scanner.h"

#include <vector>

namespace esm::fis {

/// "name := ...", behind TERM: points, a number, or a shape by the name of jFuzzyLogic (TRIAN, SIGM,
/// FUNCTION, in any case and with its order of parameters) or of fuzzylite ("Triangle", "Function", as
/// written here). Throws Fault.
///
/// One term, but for SINGLETONS of an output: these become one number each, called name, name_2, ...; their
/// heights stand in `heights`.
struct FclTerm {
  std::vector<Term> terms;
  std::vector<double> heights{};
};
/// @param onOutput a number concludes that value; of an input it is the set that holds only it
FclTerm readFclTerm(FclScanner& scan, const System& system, bool onOutput);

} // namespace esm::fis
