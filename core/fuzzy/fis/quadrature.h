// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace esm::fis {

/// The Clenshaw-Curtis rule of 17 points with the embedded one of 9. Unlike Gauss rules it looks at the ends
/// of a part, so that a kink close to an end cannot hide in its blind margin. Source: Clenshaw and Curtis
/// 1960.
class ClenshawCurtis {
public:
  /// Calls visit(x, weight, coarseWeight) for the nodes of [x0, x1]; coarseWeight is 0 off the coarse rule.
  /// The end nodes lie a trifle inside: at the end itself the function may jump.
  template <class Visit>
  static void forEachNode(double x0, double x1, const Visit& visit)
  {
    const Table& table = tableOf();
    const double centre = 0.5 * (x0 + x1), half = 0.5 * (x1 - x0);
    for (std::size_t k = 0; k <= kSteps; ++k)
      visit(centre + half * table.node[k], half * table.weight[k], half * table.coarse[k]);
  }

private:
  static constexpr std::size_t kSteps = 16;
  struct Table {
    std::array<double, kSteps + 1> node{}, weight{}, coarse{};
  };

  /// The weight of node k of n + 1.
  static double weightOf(std::size_t k, std::size_t n)
  {
    double sum = 1.0;
    for (std::size_t j = 1; j <= n / 2; ++j) {
      const double b = j == n / 2 ? 1.0 : 2.0, twice = 2.0 * static_cast<double>(j);
      sum -= b / (twice * twice - 1.0) *
             std::cos(twice * static_cast<double>(k) * std::numbers::pi / static_cast<double>(n));
    }
    return (k == 0 || k == n ? 1.0 : 2.0) / static_cast<double>(n) * sum;
  }

  static const Table& tableOf()
  {
    static const Table table = [] {
      Table t;
      for (std::size_t k = 0; k <= kSteps; ++k) {
        t.node[k] = -std::cos(static_cast<double>(k) * std::numbers::pi / kSteps);
        t.weight[k] = weightOf(k, kSteps);
        if (k % 2 == 0) t.coarse[k] = weightOf(k / 2, kSteps / 2);
      }
      t.node[0] = -(1.0 - 1e-12);
      t.node[kSteps / 2] = 0.0;
      t.node[kSteps] = 1.0 - 1e-12;
      return t;
    }();
    return table;
  }
};

/// Halves [x0, x1] until accept(x0, x1, last) takes each part, from left to right, without recursion. Kinks
/// need no mark: halving closes in on them. Parts below 2^-50 of the whole, and all parts once there are very
/// many (what is integrated is noise: a norm divides by nearly nothing), come with `last` and must be taken.
template <class Accept>
void halve(double x0, double x1, const Accept& accept)
{
  struct Part {
    double x0, x1;
    int depth;
  };
  constexpr int kMaximumDepth = 50, kMaximumParts = 3000;
  std::array<Part, kMaximumDepth + 2> parts{};
  std::size_t count = 1;
  parts[0] = {x0, x1, 0};
  for (int offered = 0; count > 0; ++offered) {
    const Part part = parts[--count];
    if (accept(part.x0, part.x1, part.depth >= kMaximumDepth || offered >= kMaximumParts)) continue;
    const double middle = 0.5 * (part.x0 + part.x1);
    parts[count++] = {middle, part.x1, part.depth + 1};
    parts[count++] = {part.x0, middle, part.depth + 1};
  }
}

/// The place in (x0, x1) where f changes its sign, f0 and f1 being its values (or limits) at the ends and of
/// opposite signs. To the last bits; f need not be smooth.
template <class F>
double root(const F& f, double x0, double x1, double f0, double f1)
{
  int side = 0;
  for (int i = 0; i < 200; ++i) {
    // Illinois steps, with a plain halving every third time lest a flat side stalls them.
    double x = i % 3 == 2 ? 0.5 * (x0 + x1) : (f1 * x0 - f0 * x1) / (f1 - f0);
    if (!(x > x0 && x < x1)) x = 0.5 * (x0 + x1);
    if (!(x > x0 && x < x1)) break;
    const double value = f(x);
    if (value == 0.0) return x;
    if ((value > 0.0) == (f1 > 0.0)) {
      x1 = x, f1 = value;
      if (side == 1) f0 *= 0.5;
      side = 1;
    } else {
      x0 = x, f0 = value;
      if (side == -1) f1 *= 0.5;
      side = -1;
    }
  }
  return 0.5 * (x0 + x1);
}

} // namespace esm::fis
