// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fuzzy/fis/evaluator.h"
#include "core/fuzzy/fis/shape_corners.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace esm::fis {

/// Where in input space rules speak, for checkRules().
///
/// Each output is tried at places of the inputs that its rules hang on, the others in the middle: at all
/// combinations of the ends, corners and tops of their terms where these are few (so that a hole at the very
/// peak of a term is found), else at places spread evenly (Halton), every other one moved to the nearest
/// corners.

/// A finite stretch of a variable's axis: its range, or where its terms bend.
struct Stretch {
  double low = 0.0, high = 1.0;
};

inline Curve curveOf(const Term& term)
{
  return {term.shape, term.parameters, term.height, nullptr, {}};
}

template <class Variable>
Stretch stretchOf(const Variable& variable)
{
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Term& term : variable.terms)
    forEachCorner(curveOf(term), [&](const Corner& corner) {
      low = std::min(low, corner.x), high = std::max(high, corner.x);
    });
  if (!(low < high)) low = low < HUGE_VAL ? low - 1.0 : 0.0, high = low + 2.0;
  return {std::isfinite(variable.minimum) ? variable.minimum : low,
          std::isfinite(variable.maximum) ? variable.maximum : high};
}

std::vector<double> middlesOf(const System& system); ///< one per input

/// A stretch of input space where no rule sets an output.
struct Hole {
  int output = -1;
  std::vector<double> place; ///< in its middle, one value per input; no rule sets the output here
  std::vector<int> inputs;   ///< those that it hangs on: whatever the others are, the hole stays
  double share = 0.0;        ///< of the places tried
};

struct Coverage {
  std::vector<Hole> holes;  ///< a few per output at most, none for outputs that no rule concludes on
  std::vector<bool> silent; ///< one per rule, blocks one after another: it fired at no place, nor at those
                            ///< that suit each of its conditions best
};

/// @param places how many are tried for one output, about.
Coverage tryPlaces(const Evaluator& evaluator, int places);

} // namespace esm::fis
