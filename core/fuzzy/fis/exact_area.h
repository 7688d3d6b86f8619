// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

// Internal to core/fuzzy/fis: the aggregated set of one output as pieces that can be integrated.
#include "core/fuzzy/fis/compiled.h"

namespace esm::fis {

/// The union of Scratch::sets over u in [0, 1], the place within the output's range. Cut at every corner of a
/// curve, every place where a degree cuts it and, under maximum, every change of the highest set. Between
/// two marks it is smooth:
///
///     all sets straight, maximum    upper envelope of lines, in closed form
///     else                          adaptive quadrature (parts are halved until their error is below 1e-14
///                                   of the whole)
///
/// Uses the memory of Scratch and allocates nothing.
class ExactArea {
public:
  ExactArea(const FlatOutput& output, Scratch& s);

  double area() const noexcept { return m_area; }
  double moment() const noexcept { return m_moment; } ///< about the low end
  double x(double u) const noexcept { return m_output.minimum + u * m_length; }
  double u(double x) const noexcept { return (x - m_output.minimum) / m_length; }
  double height(double u) const noexcept { return heightOfAll(m_output, m_s.sets, x(u)); }
  /// At a mark; at a corner to the bit, since the set may jump there.
  double heightAt(const Mark& mark) const noexcept
  {
    return heightOfAll(m_output, m_s.sets, mark.kind == Mark::Kind::Corner ? mark.corner.x : x(mark.u));
  }

  double centroid() const noexcept; ///< as u
  double bisector() const noexcept;
  /// The first plateau of the greatest height and the end of the last one, with the marks where they lie.
  static constexpr std::size_t kNoMark = static_cast<std::size_t>(-1); ///< somewhere between marks
  struct Plateau {
    double first = 0.0, firstEnd = 0.0, last = 0.0;
    std::size_t firstMark = 0, firstEndMark = 0, lastMark = 0;
    double height = 0.0;
  };
  Plateau highest() const noexcept;

private:
  void addMark(const Mark& mark) noexcept;
  void addMarksOf(int setIndex) noexcept;
  void addLevels(int setIndex, std::size_t firstMark) noexcept;
  void addLevel(int setIndex, double level, bool complement, double u0, double u1) noexcept;
  void addChanges() noexcept;
  void addSaturations() noexcept;
  int winner(double u) const noexcept;
  void sortMarks() noexcept;
  double riseBetween(std::size_t mark, double known, double& place) const noexcept;
  double plateauEdge(double from, double limit, double least) const noexcept;
  Segment integrate(double u0, double u1) const noexcept;
  Segment integrateLines(double u0, double u1) const noexcept;

  const FlatOutput& m_output;
  Scratch& m_s;
  double m_length;
  bool m_straight = true; ///< closed form
  double m_scale = 0.0;   ///< a rough area, for tolerances
  double m_area = 0.0, m_moment = 0.0;
};

} // namespace esm::fis
