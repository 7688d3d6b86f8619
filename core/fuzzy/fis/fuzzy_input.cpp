// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/compiled.h"
#include "core/fuzzy/fis/quadrature.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace esm::fis {

namespace {

/// A set under hedges (in the order of application), as a curve over x.
struct Hedged {
  Curve curve;
  std::span<const Hedge> hedges;
  bool written = false; ///< hedges in the order written: the last is applied first

  double bend(double degree) const
  {
    if (!written) return applyHedges(hedges, degree);
    for (auto hedge = hedges.rbegin(); hedge != hedges.rend(); ++hedge) degree = apply(*hedge, degree);
    return degree;
  }
  double at(double x) const { return bend(membership(curve, x)); }
  /// The limits at the ends of a piece without corners: at a corner the curve may jump.
  std::array<double, 2> limits(double x0, double x1) const
  {
    if (!isPiecewiseLinear(curve.shape)) return {at(x0), at(x1)};
    const double low = membership(curve, 0.75 * x0 + 0.25 * x1),
                 high = membership(curve, 0.25 * x0 + 0.75 * x1);
    return {
      bend(std::clamp(1.5 * low - 0.5 * high, std::min(0.0, curve.height), std::max(0.0, curve.height))),
      bend(std::clamp(1.5 * high - 0.5 * low, std::min(0.0, curve.height), std::max(0.0, curve.height)))};
  }
};

/// Places where either curve bends, sorted, within [low, high]. On the stack: room for two Discrete of the
/// greatest length that checkTerm() allows.
class Places {
public:
  Places(const Hedged& a, const Hedged& b, double low, double high)
  {
    add(low);
    add(high);
    for (const Hedged* set : {&a, &b}) {
      const auto within = [&](double x) {
        if (x > low && x < high) add(x);
      };
      forEachCorner(set->curve, [&](const Corner& corner) { within(corner.x); });
      forEachGuide(set->curve, within);
    }
    std::sort(m_x.begin(), m_x.begin() + static_cast<std::ptrdiff_t>(m_count));
  }
  std::size_t count() const { return m_count; }
  double operator[](std::size_t i) const { return m_x[i]; }

private:
  void add(double x)
  {
    if (m_count < m_x.size()) m_x[m_count++] = x;
  }
  std::array<double, 2 * kMaximumPoints + 100> m_x;
  std::size_t m_count = 0;
};

/// Where the minimum of both sets is highest, and how high.
struct Best {
  double x = 0.0, height = 0.0;
  bool crossing = false; ///< both curves pass each other there
};

Best bestOf(const Hedged& a, const Hedged& b, double low, double high)
{
  Best best{low, 0.0, false};
  const auto offer = [&](double x, double height, bool crossing) {
    if (height > best.height) best = {x, height, crossing};
  };
  const Places places(a, b, low, high);
  for (std::size_t i = 0; i < places.count(); ++i)
    offer(places[i], std::min(a.at(places[i]), b.at(places[i])), false);
  for (std::size_t i = 0; i + 1 < places.count(); ++i) {
    const double x0 = places[i], x1 = places[i + 1];
    if (!(x1 > x0)) continue;
    const auto [a0, a1] = a.limits(x0, x1);
    const auto [b0, b1] = b.limits(x0, x1);
    offer(x0, std::min(a0, b0), false);
    offer(x1, std::min(a1, b1), false);
    if (!((a0 - b0) * (a1 - b1) < 0.0)) continue;
    // Both are monotone here, so inside the piece only their crossing can lie higher.
    const double x = root([&](double place) { return a.at(place) - b.at(place); }, x0, x1, a0 - b0, a1 - b1);
    offer(x, std::min(a.at(x), b.at(x)), true);
  }
  return best;
}

/// A stand-in for an interval: 1 everywhere within it.
constexpr std::array<double, 1> kOne = {1.0};
Hedged everywhere()
{
  return {{Shape::Constant, kOne, 1.0, nullptr, {}}, {}, false};
}

Curve curveOf(const Term& term)
{
  return {term.shape, term.parameters, term.height, nullptr, {}};
}

/// The bounds within which to look: of the variable, or around both sets where it has none.
void bound(double& low, double& high, const Hedged& a, const Hedged& b)
{
  if (std::isfinite(low) && std::isfinite(high)) return;
  double least = HUGE_VAL, most = -HUGE_VAL;
  const auto add = [&](double x) {
    if (std::isfinite(x)) least = std::min(least, x), most = std::max(most, x);
  };
  for (const Hedged* set : {&a, &b}) {
    forEachCorner(set->curve, [&](const Corner& corner) { add(corner.x); });
    forEachGuide(set->curve, add);
  }
  if (!(least <= most)) least = most = 0.0;
  if (!std::isfinite(low)) low = least - 1.0 - (most - least);
  if (!std::isfinite(high)) high = most + 1.0 + (most - least);
}

struct Meeting {
  Hedged given, term;
  double low, high;
  Best best;
};

Meeting meet(const Curve& term, const Input& input, double low, double high)
{
  Meeting m{input.set ? Hedged{curveOf(*input.set), input.hedges, true} : everywhere(),
            {term, {}, false},
            low,
            high,
            {}};
  if (!input.set) m.low = input.low, m.high = input.high;
  bound(m.low, m.high, m.given, m.term);
  m.best = bestOf(m.given, m.term, m.low, m.high);
  return m;
}

} // namespace

double fuzzyDegree(const Curve& term, const Input& input, double low, double high) noexcept
{
  return meet(term, input, low, high).best.height;
}

/// Where both curves cross the height follows both; else only the lower one, whose summit it is.
void addFuzzyDegreeSlopes(const Compiled& c, int termIndex, const Curve& term, const Input& input, double low,
                          double high, double factor, const Slopes& slopes) noexcept
{
  const Meeting m = meet(term, input, low, high);
  const double x = m.best.x;
  if (m.best.crossing) {
    const double plain = membership(m.given.curve, x);
    Dual<1> bent = Dual<1>::variable(plain, 0);
    for (auto hedge = input.hedges.rbegin(); hedge != input.hedges.rend(); ++hedge)
      bent = apply(*hedge, bent);
    const double given = bent.d[0] * membershipSlope(m.given.curve, x).byX,
                 own = membershipSlope(term, x).byX;
    if (given == own) return;
    addCurveSlopes(c, termIndex, term, x, factor * given / (given - own), slopes);
    return;
  }
  if (membership(term, x) <= m.given.at(x)) addCurveSlopes(c, termIndex, term, x, factor, slopes);
}

double standIn(const Input& input, double low, double high) noexcept
{
  if (!input.set) return input.low < input.high ? 0.5 * (input.low + input.high) : input.low;
  const Hedged given{curveOf(*input.set), input.hedges, true}, all = everywhere();
  bound(low, high, given, all);
  return bestOf(given, all, low, high).x;
}

double heightOfIntersection(const Term& a, std::span<const Hedge> hedgesA, const Term& b,
                            std::span<const Hedge> hedgesB, double low, double high) noexcept
{
  return bestOf({curveOf(a), hedgesA, true}, {curveOf(b), hedgesB, true}, low, high).height;
}

} // namespace esm::fis
