// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fuzzy/rule_base.h"

namespace esm::fuzzy {

/// The axis on which the terms of a variable live: its range, in log10 for a logarithmic variable.
struct Axis {
  double low = 0.0, high = 1.0;
};
Axis axisOf(const Variable& variable) noexcept;
/// A plain value as a place on the axis. Outside the range: the nearer end; not finite: the default.
double toAxis(const Variable& variable, double value) noexcept;
double fromAxis(const Variable& variable, double x) noexcept;

} // namespace esm::fuzzy
