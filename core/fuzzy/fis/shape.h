// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/fuzzy/fis/formula.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace esm::fis {

/// The forms of a term, with their parameters in the order of FLL. All but Constant, Linear and Function are
/// membership curves and are multiplied by the term's height.
///
///     Bell               center width slope          1 / (1 + |(x - center) / width|^(2 slope))
///     Binary             start direction             1 from start on, to the side of direction (often +-inf)
///     Concave            inflection end              (end - i) / (2 end - i - x) up to end, then 1
///     Constant           value                       a number whatever x (Takagi-Sugeno, singleton)
///     Cosine             center width                one wave of (1 + cos) / 2
///     Discrete           x1 y1 x2 y2 ...             straight between the points, level beyond them; of
///     points
///                                                    above one another (an upright edge) the highest
///     Function           (a formula over x and the names of variables)
///     Gaussian           mean deviation
///     GaussianProduct    meanA deviationA meanB deviationB    left flank A, right flank B
///     Linear             c1 ... cn c0                c1 in1 + ... + cn inn + c0
///     PiShape            bottomLeft topLeft topRight bottomRight
///     Ramp               start end                   rises from start to end; falls if end < start
///     Rectangle          start end                   -infinite start or infinite end: open on that side
///     SShape, ZShape     start end                   two parabolas
///     Sigmoid            inflection slope
///     SigmoidDifference  left rising falling right   |sigmoid(left, rising) - sigmoid(right, falling)|
///     SigmoidProduct     left rising falling right
///     Spike              center width                exp(-|10 (x - center) / width|)
///     Trapezoid          a b c d                     infinite a, a and b, d, c and d: a shoulder
///     Triangle           a b c                       infinite a or c: a shoulder
enum class Shape : std::uint8_t {
  Bell,
  Binary,
  Concave,
  Constant,
  Cosine,
  Discrete,
  Function,
  Gaussian,
  GaussianProduct,
  Linear,
  PiShape,
  Ramp,
  Rectangle,
  SShape,
  Sigmoid,
  SigmoidDifference,
  SigmoidProduct,
  Spike,
  Trapezoid,
  Triangle,
  ZShape
};
inline constexpr int kShapeCount = 21;
inline constexpr std::size_t kMaximumPoints = 1000; ///< of a Discrete

std::string_view nameOf(Shape shape) noexcept;
std::optional<Shape> shapeNamed(std::string_view name) noexcept;
/// How many parameters; -1 for Discrete, Linear and Function, which take any number.
int parameterCount(Shape shape) noexcept;
/// "center", "width", ... of fixed shapes; empty beyond them.
std::string_view parameterName(Shape shape, int index) noexcept;
/// Constant, Linear and Function: a number, not a membership; they have no height.
bool isNumber(Shape shape) noexcept;
/// Straight between its corners.
bool isPiecewiseLinear(Shape shape) noexcept;

/// A linguistic term: a name and a fuzzy set.
struct Term {
  std::string name;
  Shape shape = Shape::Triangle;
  std::vector<double> parameters;
  double height = 1.0;
  std::string formula; ///< of Shape::Function
  bool operator==(const Term&) const = default;
};

/// Parameters as many as the shape needs, finite where they must be, in order. The error names what is wrong
/// and begins in lower case: "needs 3 parameters, it has 2".
Status checkTerm(const Term& term);

/// What a curve is made of, without strings: a view of a term's numbers, as the compiled engine keeps them.
struct Curve {
  Shape shape = Shape::Triangle;
  std::span<const double> parameters;
  double height = 1.0;
  const Formula* formula = nullptr;    ///< of Function, compiled
  std::span<const double> variables{}; ///< what a formula or Linear sees: the inputs' values first
};

/// The value at x; NaN for NaN.
double membership(const Curve& curve, double x) noexcept;

/// The value with its derivatives by x, by the height and by those parameters it depends on there (4 at most,
/// given by index). Of Linear and Function the value only.
struct CurveSlope {
  double value = 0.0, byX = 0.0, byHeight = 0.0;
  int count = 0;
  std::array<int, 4> index{};
  std::array<double, 4> byParameter{};
};
CurveSlope membershipSlope(const Curve& curve, double x) noexcept;

/// The x at which a monotone curve (Concave, Ramp, SShape, Sigmoid, ZShape) has the value w: Tsukamoto's
/// inference. For other shapes the value at w, as fuzzylite does. `asFuzzylite` repeats the formulas of
/// fuzzylite 6.0, which are no inverse for Concave, for the upper half of SShape, the lower of ZShape and for
/// heights other than 1. Sigmoid and Concave reach their ends at infinity: the result is held within
/// [minimum, maximum], with `asFuzzylite` only where it is infinite. In the slope, byX is the derivative by
/// w.
double tsukamoto(const Curve& curve, double w, double minimum, double maximum, bool asFuzzylite) noexcept;
CurveSlope tsukamotoSlope(const Curve& curve, double w, double minimum, double maximum,
                          bool asFuzzylite) noexcept;
bool isMonotone(Shape shape) noexcept;

/// A place where the curve has a corner, a jump or an extremum, and how it moves with the parameters.
struct Corner {
  double x = 0.0;
  std::array<int, 2> index{{-1, -1}}; ///< parameters it depends on, -1: none
  std::array<double, 2> slope{};
};
/// Calls visit(Corner) for each, unsorted; between two neighbours the curve is smooth and, but for formulas,
/// monotone. How the turns of SigmoidProduct and SigmoidDifference move is not told.
template <class Visit>
void forEachCorner(const Curve& curve, const Visit& visit);
/// Calls visit(x) for places around narrow features, lest quadrature on a wide axis steps over them.
template <class Visit>
void forEachGuide(const Curve& curve, const Visit& visit);
/// An upper bound of the calls of both together.
int cornerBound(const Curve& curve) noexcept;

} // namespace esm::fis

#include "core/fuzzy/fis/shape_corners.h"
