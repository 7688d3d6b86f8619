// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/shape.h"

#include "core/fuzzy/fis/dual.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace esm::fis {

namespace {

struct ShapeInfo {
  std::string_view name;
  int parameters;
  std::array<std::string_view, 4> parameterNames;
};
constexpr std::array<ShapeInfo, kShapeCount> kShapeInfos = {
  {{"Bell", 3, {"center", "width", "slope", ""}},
   {"Binary", 2, {"start", "direction", "", ""}},
   {"Concave", 2, {"inflection", "end", "", ""}},
   {"Constant", 1, {"value", "", "", ""}},
   {"Cosine", 2, {"center", "width", "", ""}},
   {"Discrete", -1, {}},
   {"Function", -1, {}},
   {"Gaussian", 2, {"mean", "deviation", "", ""}},
   {"GaussianProduct", 4, {"mean A", "deviation A", "mean B", "deviation B"}},
   {"Linear", -1, {}},
   {"PiShape", 4, {"bottom left", "top left", "top right", "bottom right"}},
   {"Ramp", 2, {"start", "end", "", ""}},
   {"Rectangle", 2, {"start", "end", "", ""}},
   {"SShape", 2, {"start", "end", "", ""}},
   {"Sigmoid", 2, {"inflection", "slope", "", ""}},
   {"SigmoidDifference", 4, {"left", "rising", "falling", "right"}},
   {"SigmoidProduct", 4, {"left", "rising", "falling", "right"}},
   {"Spike", 2, {"center", "width", "", ""}},
   {"Trapezoid", 4, {"a", "b", "c", "d"}},
   {"Triangle", 3, {"a", "b", "c", ""}},
   {"ZShape", 2, {"start", "end", "", ""}}}};

const ShapeInfo& infoOf(Shape shape)
{
  return kShapeInfos[static_cast<std::size_t>(shape)];
}

/// Height of a flank that is 0 at `zero` and 1 at `one`, for x beyond `one` on the side of `zero`.
template <class T>
T flank(const T& x, const T& zero, const T& one)
{
  if (std::isinf(valueOf(zero))) return T(1.0);
  if (valueOf(zero) == valueOf(one)) return T(0.0);
  const T height = (x - zero) / (one - zero);
  if (valueOf(height) > 1.0) return T(1.0);
  return valueOf(height) > 0.0 ? height : T(0.0); // also for NaN, from a half-typed term
}

template <class T>
T trapezoid(const T& x, const T& a, const T& b, const T& c, const T& d)
{
  if (valueOf(x) < valueOf(b)) return flank(x, a, b);
  if (valueOf(x) > valueOf(c)) return flank(x, d, c);
  return T(valueOf(x) >= valueOf(b) ? 1.0 : 0.0);
}

template <class T>
T square(const T& x)
{
  return x * x;
}

/// 0 up to `start`, 1 from `end` on.
template <class T>
T sShape(const T& x, const T& start, const T& end)
{
  if (valueOf(x) <= valueOf(start)) return T(0.0);
  if (valueOf(x) <= 0.5 * (valueOf(start) + valueOf(end)))
    return T(2.0) * square((x - start) / (end - start));
  if (valueOf(x) < valueOf(end)) return T(1.0) - T(2.0) * square((x - end) / (end - start));
  return T(1.0);
}
/// 1 up to `start`, 0 from `end` on.
template <class T>
T zShape(const T& x, const T& start, const T& end)
{
  if (valueOf(x) <= valueOf(start)) return T(1.0);
  if (valueOf(x) <= 0.5 * (valueOf(start) + valueOf(end)))
    return T(1.0) - T(2.0) * square((x - start) / (end - start));
  if (valueOf(x) < valueOf(end)) return T(2.0) * square((x - end) / (end - start));
  return T(0.0);
}

template <class T>
T bell(const T& x, const T& mean, const T& deviation)
{
  return exponential(-square((x - mean) / deviation) / T(2.0));
}
template <class T>
T sigmoid(const T& x, const T& inflection, const T& slope)
{
  const T exponent = slope * (x - inflection);
  if (valueOf(exponent) < 0.0) { // exp() of what is negative never overflows
    const T e = exponential(exponent);
    return e / (T(1.0) + e);
  }
  return T(1.0) / (T(1.0) + exponential(-exponent));
}

template <class T>
T concave(const T& x, const T& inflection, const T& end)
{
  if (valueOf(inflection) <= valueOf(end)) {
    if (valueOf(x) < valueOf(end)) return (end - inflection) / (T(2.0) * end - inflection - x);
  } else if (valueOf(x) > valueOf(end)) {
    return (inflection - end) / (inflection - T(2.0) * end + x);
  }
  return T(1.0);
}

template <class T>
T ramp(const T& x, const T& start, const T& end)
{
  if (valueOf(start) == valueOf(end)) return T(0.0);
  const bool rises = valueOf(start) < valueOf(end);
  if (rises ? valueOf(x) <= valueOf(start) : valueOf(x) >= valueOf(start)) return T(0.0);
  if (rises ? valueOf(x) >= valueOf(end) : valueOf(x) <= valueOf(end)) return T(1.0);
  return (x - start) / (end - start);
}

/// The curve of height 1 of every shape with a fixed number of parameters.
template <class T>
T unitCurve(Shape shape, const T* p, const T& x)
{
  const double v = valueOf(x);
  switch (shape) {
  case Shape::Bell:
    return T(1.0) / (T(1.0) + power(magnitude((x - p[0]) / p[1]), T(2.0) * p[2]));
  case Shape::Binary:
    return T((valueOf(p[1]) > valueOf(p[0]) && v >= valueOf(p[0])) ||
                 (valueOf(p[1]) < valueOf(p[0]) && v <= valueOf(p[0]))
               ? 1.0
               : 0.0);
  case Shape::Concave:
    return concave(x, p[0], p[1]);
  case Shape::Constant:
    return p[0];
  case Shape::Cosine:
    if (v < valueOf(p[0]) - 0.5 * valueOf(p[1]) || v > valueOf(p[0]) + 0.5 * valueOf(p[1])) return T(0.0);
    return T(0.5) * (T(1.0) + cosine(T(2.0) / p[1] * T(std::numbers::pi) * (x - p[0])));
  case Shape::Gaussian:
    return bell(x, p[0], p[1]);
  case Shape::GaussianProduct:
    return (v < valueOf(p[0]) ? bell(x, p[0], p[1]) : T(1.0)) *
           (v > valueOf(p[2]) ? bell(x, p[2], p[3]) : T(1.0));
  case Shape::PiShape:
    return sShape(x, p[0], p[1]) * zShape(x, p[2], p[3]);
  case Shape::Ramp:
    return ramp(x, p[0], p[1]);
  case Shape::Rectangle:
    return T(v >= valueOf(p[0]) && v <= valueOf(p[1]) ? 1.0 : 0.0);
  case Shape::SShape:
    return sShape(x, p[0], p[1]);
  case Shape::Sigmoid:
    return sigmoid(x, p[0], p[1]);
  case Shape::SigmoidDifference:
    return magnitude(sigmoid(x, p[0], p[1]) - sigmoid(x, p[3], p[2]));
  case Shape::SigmoidProduct:
    return sigmoid(x, p[0], p[1]) * sigmoid(x, p[3], p[2]);
  case Shape::Spike:
    return exponential(-magnitude(T(10.0) / p[1] * (x - p[0])));
  case Shape::Trapezoid:
    return trapezoid(x, p[0], p[1], p[2], p[3]);
  case Shape::Triangle:
    return trapezoid(x, p[0], p[1], p[1], p[2]);
  case Shape::ZShape:
    return zShape(x, p[0], p[1]);
  case Shape::Discrete:
  case Shape::Function:
  case Shape::Linear:
    break;
  }
  return T(0.0);
}

/// The points around x of a Discrete: both equal beyond the ends and on a point. Of points above one another
/// the highest one.
struct Bracket {
  std::size_t left = 0, right = 0; ///< places of x in the list
};
Bracket highestAbove(std::span<const double> xy, std::size_t point)
{
  std::size_t best = point;
  for (std::size_t i = point; i < xy.size() && xy[i] == xy[point]; i += 2)
    if (xy[i + 1] > xy[best + 1]) best = i;
  return {best, best};
}
Bracket bracketOf(std::span<const double> xy, double x)
{
  const std::size_t last = xy.size() - 2;
  if (x > xy[last]) return {last, last};
  if (!(x > xy[0])) return x == xy[0] ? highestAbove(xy, 0) : Bracket{0, 0};
  std::size_t low = 0, high = last / 2; // points, not places: x lies in (low, high]
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (xy[2 * middle] < x ? low : high) = middle;
  }
  return xy[2 * high] == x ? highestAbove(xy, 2 * high) : Bracket{2 * low, 2 * high};
}

template <class T>
T straight(const T& x, const T& x0, const T& y0, const T& x1, const T& y1)
{
  return (y1 - y0) / (x1 - x0) * (x - x0) + y0;
}

double discrete(std::span<const double> xy, double x)
{
  const auto [l, r] = bracketOf(xy, x);
  return l == r ? xy[l + 1] : straight(x, xy[l], xy[l + 1], xy[r], xy[r + 1]);
}

double linear(const Curve& curve)
{
  const std::size_t inputs = curve.variables.size(), count = curve.parameters.size();
  double sum = 0.0;
  for (std::size_t i = 0; i < std::min(inputs, count); ++i) sum += curve.parameters[i] * curve.variables[i];
  return count > inputs ? sum + curve.parameters.back() : sum;
}

} // namespace

std::string_view nameOf(Shape shape) noexcept
{
  return infoOf(shape).name;
}

std::optional<Shape> shapeNamed(std::string_view name) noexcept
{
  for (std::size_t i = 0; i < kShapeInfos.size(); ++i)
    if (kShapeInfos[i].name == name) return static_cast<Shape>(i);
  return std::nullopt;
}

int parameterCount(Shape shape) noexcept
{
  return infoOf(shape).parameters;
}

std::string_view parameterName(Shape shape, int index) noexcept
{
  return index >= 0 && index < 4 ? infoOf(shape).parameterNames[static_cast<std::size_t>(index)] : "";
}

bool isNumber(Shape shape) noexcept
{
  return shape == Shape::Constant || shape == Shape::Linear || shape == Shape::Function;
}

bool isPiecewiseLinear(Shape shape) noexcept
{
  switch (shape) {
  case Shape::Binary:
  case Shape::Constant:
  case Shape::Discrete:
  case Shape::Linear:
  case Shape::Ramp:
  case Shape::Rectangle:
  case Shape::Trapezoid:
  case Shape::Triangle:
    return true;
  default:
    return false;
  }
}

bool isMonotone(Shape shape) noexcept
{
  return shape == Shape::Concave || shape == Shape::Ramp || shape == Shape::SShape ||
         shape == Shape::Sigmoid || shape == Shape::ZShape;
}

double membership(const Curve& curve, double x) noexcept
{
  switch (curve.shape) {
  case Shape::Constant:
    return curve.parameters[0];
  case Shape::Linear:
    return linear(curve);
  case Shape::Function:
    return curve.formula ? curve.formula->evaluate(x, curve.variables) : 0.0;
  case Shape::Discrete:
    return std::isnan(x) ? x : curve.height * discrete(curve.parameters, x);
  default:
    return std::isnan(x) ? x : curve.height * unitCurve(curve.shape, curve.parameters.data(), x);
  }
}

CurveSlope membershipSlope(const Curve& curve, double x) noexcept
{
  CurveSlope slope;
  using D = Dual<5>; // x, then up to four parameters
  const auto take = [&](const D& unit) {
    slope.value = curve.height * unit.v;
    slope.byHeight = unit.v;
    slope.byX = curve.height * unit.d[0];
    for (int i = 0; i < slope.count; ++i)
      slope.byParameter[static_cast<std::size_t>(i)] = curve.height * unit.d[static_cast<std::size_t>(i) + 1];
  };
  const auto& p = curve.parameters;
  if (std::isnan(x) || curve.shape == Shape::Linear || curve.shape == Shape::Function) {
    slope.value = membership(curve, x);
    return slope;
  }
  if (curve.shape == Shape::Discrete) {
    const auto [l, r] = bracketOf(p, x);
    slope.count = l == r ? 1 : 4;
    slope.index = {static_cast<int>(l) + (l == r ? 1 : 0), static_cast<int>(l) + 1, static_cast<int>(r),
                   static_cast<int>(r) + 1};
    if (l == r)
      take(D::variable(p[l + 1], 1));
    else
      take(straight(D::variable(x, 0), D::variable(p[l], 1), D::variable(p[l + 1], 2), D::variable(p[r], 3),
                    D::variable(p[r + 1], 4)));
    return slope;
  }
  std::array<D, 4> dual;
  slope.count = static_cast<int>(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    slope.index[i] = static_cast<int>(i);
    dual[i] = std::isfinite(p[i]) ? D::variable(p[i], i + 1) : D(p[i]);
  }
  take(unitCurve(curve.shape, dual.data(), D::variable(x, 0)));
  if (curve.shape == Shape::Constant) slope.byHeight = 0.0;
  return slope;
}

namespace {

/// The inverse of a monotone curve; `h` is its height. May be infinite.
template <class T>
T inverse(Shape shape, const T* p, const T& h, const T& w)
{
  const T y = w / h;
  switch (shape) {
  case Shape::Concave:
    return valueOf(y) >= 1.0 ? p[1] : (p[0] - p[1]) / y + T(2.0) * p[1] - p[0];
  case Shape::Ramp:
    return p[0] + y * (p[1] - p[0]);
  case Shape::Sigmoid:
    return p[0] - logarithm(T(1.0) / y - T(1.0)) / p[1];
  case Shape::SShape:
    if (valueOf(y) <= 0.5) return p[0] + (p[1] - p[0]) * squareRoot(T(0.5) * y);
    return valueOf(y) >= 1.0 ? p[1] : p[1] - (p[1] - p[0]) * squareRoot(T(0.5) * (T(1.0) - y));
  default: // ZShape
    if (valueOf(y) >= 1.0) return p[0];
    if (valueOf(y) > 0.5) return p[0] + (p[1] - p[0]) * squareRoot(T(0.5) * (T(1.0) - y));
    return p[1] - (p[1] - p[0]) * squareRoot(T(0.5) * y);
  }
}

/// What fuzzylite 6.0 computes in its place.
template <class T>
T fuzzyliteInverse(Shape shape, const T* p, const T& h, const T& w)
{
  const auto at = [&](const T& x) { return h * unitCurve(shape, p, x); };
  const auto nearer = [&](const T& a, const T& b) {
    const bool first = std::abs(valueOf(w) - valueOf(at(a))) < std::abs(valueOf(w) - valueOf(at(b)));
    return first ? a : b;
  };
  const T length = magnitude(p[1] - p[0]);
  const T low = length * squareRoot(T(0.5) * w), high = length * squareRoot(T(0.5) * (T(1.0) - w));
  switch (shape) {
  case Shape::Concave:
    return (p[0] - p[1]) / at(w) + T(2.0) * p[1] - p[0];
  case Shape::Ramp:
    return (p[1] - p[0]) * w + p[0];
  case Shape::Sigmoid:
    return p[0] + logarithm(T(1.0) / w - T(1.0)) / -p[1];
  case Shape::SShape:
    return nearer(p[0] + low, p[1] + high);
  default:
    return nearer(p[0] + high, p[1] + low);
  }
}

template <class T>
T tsukamotoValue(const Curve& curve, const T* p, const T& h, const T& w, double minimum, double maximum,
                 bool asFuzzylite)
{
  if (curve.shape == Shape::Sigmoid) { // reaches 0 and its height at infinity only
    const bool rises = valueOf(p[1]) >= 0.0;
    const double y = asFuzzylite ? valueOf(w) : valueOf(w) / valueOf(h);
    if (y >= 1.0) return T(rises ? maximum : minimum);
    if (y <= 0.0) return T(rises ? minimum : maximum);
    if (valueOf(p[1]) == 0.0) return p[0];
  }
  if (asFuzzylite) return fuzzyliteInverse(curve.shape, p, h, w);
  const T x = inverse(curve.shape, p, h, w);
  const bool endless = curve.shape == Shape::Sigmoid || curve.shape == Shape::Concave;
  return endless && valueOf(x) < minimum ? T(minimum) : endless && valueOf(x) > maximum ? T(maximum) : x;
}

} // namespace

double tsukamoto(const Curve& curve, double w, double minimum, double maximum, bool asFuzzylite) noexcept
{
  if (!isMonotone(curve.shape)) return membership(curve, w);
  return tsukamotoValue(curve, curve.parameters.data(), curve.height, w, minimum, maximum, asFuzzylite);
}

CurveSlope tsukamotoSlope(const Curve& curve, double w, double minimum, double maximum,
                          bool asFuzzylite) noexcept
{
  if (!isMonotone(curve.shape)) return membershipSlope(curve, w);
  using D = Dual<4>; // w, two parameters, height
  const std::array<D, 2> p = {D::variable(curve.parameters[0], 1), D::variable(curve.parameters[1], 2)};
  const D z = tsukamotoValue(curve, p.data(), D::variable(curve.height, 3), D::variable(w, 0), minimum,
                             maximum, asFuzzylite);
  CurveSlope slope;
  slope.value = z.v;
  slope.byX = z.d[0];
  slope.byHeight = z.d[3];
  slope.count = 2;
  slope.index = {0, 1, 0, 0};
  slope.byParameter = {z.d[1], z.d[2], 0.0, 0.0};
  return slope;
}

int cornerBound(const Curve& curve) noexcept
{
  return curve.shape == Shape::Discrete ? static_cast<int>(curve.parameters.size() / 2) : 32;
}

} // namespace esm::fis
