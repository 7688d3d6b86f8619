// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace esm::fis {

/// The 15-point Kronrod rule with its embedded 7-point Gauss rule. Source: QUADPACK (Piessens et al. 1983).
namespace kronrod {
inline constexpr std::array<double, 8> kNode = {
  0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
  0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
  0.586087235467691130294144691693013, 0.405845151377397166906606412076961,
  0.207784955007898467600689403773245, 0.0};
inline constexpr std::array<double, 8> kWeight = {
  0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
  0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
  0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
  0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
inline constexpr std::array<double, 4> kGauss = {
  0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
  0.381830050505118944950369775488975, 0.417959183673469387755102040816327};

/// Calls visit(x, weight, gaussWeight) for the 15 nodes of [x0, x1]; gaussWeight is 0 off the Gauss rule.
template <class Visit>
void forEachNode(double x0, double x1, const Visit& visit)
{
  const double centre = 0.5 * (x0 + x1), half = 0.5 * (x1 - x0);
  visit(centre, half * kWeight[7], half * kGauss[3]);
  for (std::size_t i = 0; i < 7; ++i) {
    const double gauss = i % 2 == 1 ? half * kGauss[i / 2] : 0.0; // every second node is a Gauss node
    visit(centre - half * kNode[i], half * kWeight[i], gauss);
    visit(centre + half * kNode[i], half * kWeight[i], gauss);
  }
}
} // namespace kronrod

/// Halves [x0, x1] until accept(x0, x1, depth) takes each part, from left to right, without recursion. Parts
/// below 2^-50 of the whole are offered with `last` set and must be taken. Kinks need no mark: halving closes
/// in on them.
template <class Accept>
void halve(double x0, double x1, const Accept& accept)
{
  struct Part {
    double x0, x1;
    int depth;
  };
  constexpr int kMaximumDepth = 50;
  std::array<Part, kMaximumDepth + 2> parts{};
  std::size_t count = 1;
  parts[0] = {x0, x1, 0};
  while (count > 0) {
    const Part part = parts[--count];
    if (accept(part.x0, part.x1, part.depth >= kMaximumDepth)) continue;
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
