// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fuzzy/rule_base.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace esm::fuzzy {

/// The geometry of fuzzy sets, apart from rules: terms under hedges as curves over a variable's axis, the
/// height at which two of them intersect, and the centre of area of a union of clipped ones.
///
/// A term's curve consists of few smooth monotone pieces between its corners. On a piece everything asked
/// here has a closed form (straight pieces) or a safe numerical one (bisection, adaptive quadrature), so
/// nothing is sampled and no answer depends on a resolution. Any thread.

/// The axis on which the terms of a variable live: its range, in log10 for a logarithmic variable.
struct Axis {
  double low = 0.0, high = 1.0;
};
Axis axisOf(const Variable& variable) noexcept;
/// A plain value as a place on the axis. Outside the range: the nearer end; not finite: the default.
double toAxis(const Variable& variable, double value) noexcept;
double fromAxis(const Variable& variable, double x) noexcept;

/// "very hard": a term under hedges. Refers to both, which must outlive it.
struct HedgedTerm {
  const Term* term = nullptr;
  const std::vector<Hedge>* hedges = nullptr;
  double at(double x) const noexcept { return applyHedges(*hedges, membership(*term, x)); }
};

/// sup over the axis of min(a, b): how well two words agree, 1 if they share a fully valid place.
double heightOfIntersection(const HedgedTerm& a, const HedgedTerm& b, const Axis& axis);

/// min(set, degree): what a rule of that degree concludes.
struct ClippedSet {
  HedgedTerm set;
  double degree = 0.0;
  double at(double x) const noexcept { return std::min(set.at(x), degree); }
};

/// The centre of area of the maximum of clipped sets; nothing if their area is zero. Closed form if every
/// set is an unhedged triangle or trapezoid, else adaptive quadrature between the corners (relative 1e-10).
std::optional<double> centroid(std::span<const ClippedSet> sets, const Axis& axis);

} // namespace esm::fuzzy
