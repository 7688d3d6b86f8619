// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fuzzy/term_editing.h"

#include <cmath>
#include <span>

/// What the parts of term_editing share.
namespace esm::fuzzy::editing {

/// Where a term is 1 (a Gaussian: its mean). An end under an infinite foot is where the shoulder begins.
struct Core {
  double left = 0.0, right = 0.0;
};

inline bool hasCorners(const Term& term) noexcept
{
  return term.shape != Shape::Gaussian;
}
inline double leftFoot(const Term& term) noexcept
{
  return term.parameters.front();
}
inline double rightFoot(const Term& term) noexcept
{
  return term.parameters.back();
}
inline bool endsLeft(const Term& term) noexcept
{
  return !hasCorners(term) || std::isfinite(leftFoot(term));
}
inline bool endsRight(const Term& term) noexcept
{
  return !hasCorners(term) || std::isfinite(rightFoot(term));
}
Core coreOf(const Term& term) noexcept;
double middleOf(const Term& term) noexcept; ///< of the core; where it begins or ends, for a shoulder
double spanOf(const Axis& axis) noexcept;

/// Gives the terms these cores and lets flanks fit: feet are the neighbours' cores, outer feet follow as
/// moveHandle() says. @param order of the terms; cores in that order.
void putCores(std::vector<Term>& terms, const std::vector<int>& order, const std::vector<Core>& cores,
              const Axis& axis);

} // namespace esm::fuzzy::editing
