// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fuzzy_set.h"

#include "core/fuzzy/quadrature.h"

#include <cmath>

namespace esm::fuzzy {

namespace {

/// One smooth, monotone stretch of a membership curve, between two neighbouring corners. Unlike the term
/// itself it is continuous up to both ends, where an upright flank jumps.
struct Piece {
  enum class Kind { Constant, Line, Bell } kind = Kind::Constant;
  double p = 0.0, q = 1.0; ///< Constant: height p; Line: 0 at p, 1 at q; Bell: mean p, deviation q

  double at(double x) const noexcept
  {
    switch (kind) {
    case Kind::Constant:
      return p;
    case Kind::Line:
      return std::clamp((x - p) / (q - p), 0.0, 1.0);
    case Kind::Bell:
      return std::exp(-0.5 * ((x - p) / q) * ((x - p) / q));
    }
    return 0.0;
  }
};

/// a b c d of a polygonal term.
struct Corners {
  double a, b, c, d;
};
Corners cornersOf(const Term& term) noexcept
{
  const std::vector<double>& p = term.parameters;
  return term.shape == Shape::Triangle ? Corners{p[0], p[1], p[1], p[2]} : Corners{p[0], p[1], p[2], p[3]};
}

/// The piece of the term around a place that is no corner.
Piece pieceAround(const Term& term, double x) noexcept
{
  if (term.shape == Shape::Gaussian) return {Piece::Kind::Bell, term.parameters[0], term.parameters[1]};
  const auto [a, b, c, d] = cornersOf(term);
  if (x < a || x > d) return {Piece::Kind::Constant, 0.0, 0.0};
  if (x < b && std::isfinite(a)) return {Piece::Kind::Line, a, b};
  if (x > c && std::isfinite(d)) return {Piece::Kind::Line, d, c};
  return {Piece::Kind::Constant, 1.0, 0.0};
}

/// Adds the places within the axis where the term's curve has a corner or turns around.
void addCorners(const Term& term, const Axis& axis, std::vector<double>& places)
{
  const auto add = [&](double x) {
    if (x > axis.low && x < axis.high) places.push_back(x);
  };
  if (term.shape == Shape::Gaussian) {
    add(term.parameters[0]);
    return;
  }
  const auto [a, b, c, d] = cornersOf(term);
  for (const double x : {a, b, c, d}) add(x);
}

/// The unhedged height at which the hedged curve reaches `degree`. @pre no Hedge::Not
double unhedge(const std::vector<Hedge>& hedges, double degree) noexcept
{
  for (const Hedge hedge : hedges) switch (hedge) {
    case Hedge::Very:
      degree = std::sqrt(degree);
      break;
    case Hedge::Extremely:
      degree = std::cbrt(degree);
      break;
    case Hedge::Somewhat:
      degree = degree * degree;
      break;
    case Hedge::Not:
      break;
    }
  return degree;
}

/// Adds the places where clipping cuts the curve.
void addClipPlaces(const ClippedSet& clipped, const Axis& axis, std::vector<double>& places)
{
  const auto add = [&](double x) {
    if (x > axis.low && x < axis.high) places.push_back(x);
  };
  const double height = unhedge(*clipped.set.hedges, clipped.degree);
  const Term& term = *clipped.set.term;
  if (term.shape == Shape::Gaussian) {
    const double m = term.parameters[0], s = term.parameters[1];
    const double away = s * std::sqrt(std::max(0.0, -2.0 * std::log(height)));
    add(m - away);
    add(m + away);
    // Marks around the bell, lest quadrature on a wide axis steps over a narrow one.
    for (const double k : {1.0, 2.5, 5.0, 8.0}) {
      add(m - k * s);
      add(m + k * s);
    }
    return;
  }
  const auto [a, b, c, d] = cornersOf(term);
  if (std::isfinite(a)) add(a + height * (b - a));
  if (std::isfinite(d)) add(d - height * (d - c));
}

std::vector<double> sorted(std::vector<double> places)
{
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// min(f, g) where two curves cross between x0 and x1, the differences there having opposite signs.
template <class F, class G>
double heightOfCrossing(const F& f, const G& g, double x0, double x1)
{
  const bool startsAbove = f(x0) > g(x0);
  for (;;) { // halves the interval until no double lies inside
    const double middle = 0.5 * (x0 + x1);
    if (!(middle > x0 && middle < x1)) return std::max(std::min(f(x0), g(x0)), std::min(f(x1), g(x1)));
    ((f(middle) > g(middle)) == startsAbove ? x0 : x1) = middle;
  }
}

/// A straight stretch over t in [0, 1].
struct Line {
  double start, end;
  double at(double t) const noexcept { return start + t * (end - start); }
};

/// Area and first moment about the axis' low end, both in units of the axis' length.
struct Moments {
  double area = 0.0, moment = 0.0;
};

/// Adds a straight stretch from (u0, v0) to (u1, v1).
void addLine(Moments& sum, double u0, double v0, double u1, double v1) noexcept
{
  const double width = u1 - u0;
  sum.area += 0.5 * width * (v0 + v1);
  sum.moment += width / 6.0 * (u0 * (2.0 * v0 + v1) + u1 * (v0 + 2.0 * v1));
}

/// Adds the upper envelope of straight lines over [u0, u1], cut exactly where they cross.
void addEnvelope(Moments& sum, const std::vector<Line>& lines, double u0, double u1)
{
  std::vector<double> cuts = {0.0, 1.0};
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t j = i + 1; j < lines.size(); ++j) {
      const double before = lines[i].start - lines[j].start, after = lines[i].end - lines[j].end;
      if ((before < 0.0) != (after < 0.0) && before != after) cuts.push_back(before / (before - after));
    }
  cuts = sorted(std::move(cuts));
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const double t0 = cuts[k], t1 = cuts[k + 1], middle = 0.5 * (t0 + t1);
    const Line* highest = &lines.front();
    for (const Line& line : lines)
      if (line.at(middle) > highest->at(middle)) highest = &line;
    const double width = u1 - u0;
    addLine(sum, u0 + t0 * width, highest->at(t0), u0 + t1 * width, highest->at(t1));
  }
}

Moments exactMoments(std::span<const ClippedSet> sets, const Axis& axis, const std::vector<double>& places)
{
  Moments sum;
  std::vector<Line> lines;
  const double length = axis.high - axis.low;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    const double x0 = places[k], x1 = places[k + 1], middle = 0.5 * (x0 + x1);
    lines.clear();
    for (const ClippedSet& clipped : sets) {
      const Piece piece = pieceAround(*clipped.set.term, middle);
      if (piece.at(middle) >= clipped.degree)
        lines.push_back({clipped.degree, clipped.degree});
      else
        lines.push_back({std::min(piece.at(x0), clipped.degree), std::min(piece.at(x1), clipped.degree)});
    }
    addEnvelope(sum, lines, (x0 - axis.low) / length, (x1 - axis.low) / length);
  }
  return sum;
}

Moments quadratureMoments(std::span<const ClippedSet> sets, const Axis& axis,
                          const std::vector<double>& places)
{
  const double length = axis.high - axis.low;
  const auto integrand = [&](double u) {
    const double x = axis.low + u * length;
    double height = 0.0;
    for (const ClippedSet& clipped : sets) height = std::max(height, clipped.at(x));
    return Eigen::Array2d(height, u * height);
  };
  std::vector<double> marks;
  for (const double x : places) marks.push_back((x - axis.low) / length);
  const Eigen::Array2d integral = integrateAdaptively(integrand, sorted(std::move(marks)), 1e-12);
  return {integral[0], integral[1]};
}

bool isStraight(const ClippedSet& clipped) noexcept
{
  return clipped.set.hedges->empty() && clipped.set.term->shape != Shape::Gaussian;
}

} // namespace

Axis axisOf(const Variable& variable) noexcept
{
  if (!variable.logarithmic) return {variable.minimum, variable.maximum};
  return {std::log10(variable.minimum), std::log10(variable.maximum)};
}

double toAxis(const Variable& variable, double value) noexcept
{
  if (!std::isfinite(value)) value = variable.defaultValue;
  value = std::max(variable.minimum, std::min(value, variable.maximum));
  return variable.logarithmic ? std::log10(value) : value;
}

double fromAxis(const Variable& variable, double x) noexcept
{
  const double value = variable.logarithmic ? std::pow(10.0, x) : x;
  return std::max(variable.minimum, std::min(value, variable.maximum)); // pow may round past an end
}

double heightOfIntersection(const HedgedTerm& a, const HedgedTerm& b, const Axis& axis)
{
  std::vector<double> places = {axis.low, axis.high};
  addCorners(*a.term, axis, places);
  addCorners(*b.term, axis, places);
  places = sorted(std::move(places));

  double height = 0.0;
  for (const double x : places) height = std::max(height, std::min(a.at(x), b.at(x)));
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    const double x0 = places[k], x1 = places[k + 1], middle = 0.5 * (x0 + x1);
    const Piece pieceA = pieceAround(*a.term, middle), pieceB = pieceAround(*b.term, middle);
    const auto f = [&](double x) { return applyHedges(*a.hedges, pieceA.at(x)); };
    const auto g = [&](double x) { return applyHedges(*b.hedges, pieceB.at(x)); };
    const double f0 = f(x0), f1 = f(x1), g0 = g(x0), g1 = g(x1);
    height = std::max({height, std::min(f0, g0), std::min(f1, g1)});
    // Both curves are monotone here, so inside the piece only their crossing can lie higher.
    if ((f0 < g0) != (f1 < g1)) height = std::max(height, heightOfCrossing(f, g, x0, x1));
  }
  return height;
}

std::optional<double> centroid(std::span<const ClippedSet> sets, const Axis& axis)
{
  if (sets.empty()) return std::nullopt;
  std::vector<double> places = {axis.low, axis.high};
  for (const ClippedSet& clipped : sets) {
    addCorners(*clipped.set.term, axis, places);
    addClipPlaces(clipped, axis, places);
  }
  places = sorted(std::move(places));
  const bool straight = std::all_of(sets.begin(), sets.end(), isStraight);
  const Moments sum = straight ? exactMoments(sets, axis, places) : quadratureMoments(sets, axis, places);
  if (!(sum.area > 0.0)) return std::nullopt;
  const double centre = sum.moment / sum.area;
  return axis.low + std::clamp(centre, 0.0, 1.0) * (axis.high - axis.low);
}

} // namespace esm::fuzzy
