// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fuzzy/inference.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace esm::fuzzy {

/// Which output over which two inputs, and on how fine a grid. Both ends of the ranges are grid places, and
/// places are even on the inputs' axes (log10 for a logarithmic input).
struct SurfaceQuestion {
  int output = 0, x = 0, y = 1; ///< indices into RuleBase::outputs and inputs; x != y
  int columns = 41, rows = 41;  ///< >= 2
  bool operator==(const SurfaceQuestion&) const = default;
};

/// What the rules make of two inputs while the others stay: the control surface.
struct ControlSurface {
  std::vector<double> x, y;  ///< plain values of the inputs, rising; one per column, one per row
  std::vector<double> value; ///< rows x columns, plain; row r, column c at [r * columns + c]
  std::vector<char> fired;   ///< likewise: 1 where a rule fired, else value is the output's default

  std::size_t columns() const noexcept { return x.size(); }
  std::size_t rows() const noexcept { return y.size(); }
  double at(std::size_t row, std::size_t column) const noexcept { return value[row * columns() + column]; }
  bool firedAt(std::size_t row, std::size_t column) const noexcept
  {
    return fired[row * columns() + column] != 0;
  }
};

/// Computes a surface row by row, so that a window can spread the work. Only rules about the one output are
/// compiled; every value equals that of Engine::evaluate() with all of them, bit by bit.
class SurfaceSweep {
public:
  /// @param inputs one per RuleBase::inputs: what the others are. Errors: those of Engine::create(), indices
  ///        that are out of range or the same.
  static Result<SurfaceSweep> create(const RuleBase& ruleBase, const SurfaceQuestion& question,
                                     std::vector<InputValue> inputs);

  /// Computes the next row. @return false once all are there.
  bool nextRow();
  std::size_t rowsDone() const noexcept { return m_row; }
  /// Rows that are not computed yet hold the default, as where no rule fires.
  const ControlSurface& surface() const noexcept { return m_surface; }

private:
  SurfaceSweep(Engine engine, const SurfaceQuestion& question, std::vector<InputValue> inputs);
  Engine m_engine;
  SurfaceQuestion m_question;
  std::vector<InputValue> m_inputs;
  ControlSurface m_surface;
  std::size_t m_row = 0;
};

/// The whole surface at once.
Result<ControlSurface> controlSurface(const RuleBase& ruleBase, const SurfaceQuestion& question,
                                      std::vector<InputValue> inputs);

/// A line of equal value in grid units: x from 0 to columns - 1, y from 0 to rows - 1. First and last point
/// of a closed line are the same.
using ContourLine = std::vector<std::array<double, 2>>;
/// Marching squares on the output's axis (log10 where it is logarithmic), straight within a grid cell,
/// saddles decided by the mean of their corners. Cells with a corner where no rule fired have no lines.
/// Source: Lorensen & Cline 1987, in two dimensions.
std::vector<ContourLine> contourLines(const ControlSurface& surface, const Variable& output, double level);

/// Round plain values strictly between the least and the greatest: 1, 2, 5 times powers of ten, evenly spaced
/// unless the output is logarithmic. At most `most`, the roundest ones.
std::vector<double> contourLevels(double least, double greatest, bool logarithmic, int most);

} // namespace esm::fuzzy
