// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <vector>

namespace esm::fuzzy {

/// Integral and its estimated error, for two integrands at once.
struct IntervalIntegral {
  Eigen::Array2d value, error;
};

/// The 15-point Kronrod rule with its embedded 7-point Gauss rule. Source: QUADPACK (Piessens et al. 1983).
template <class F>
IntervalIntegral gaussKronrod(const F& f, double x0, double x1)
{
  static constexpr std::array<double, 8> kNode = {
    0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
    0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
    0.586087235467691130294144691693013, 0.405845151377397166906606412076961,
    0.207784955007898467600689403773245, 0.0};
  static constexpr std::array<double, 8> kKronrod = {
    0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
    0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
    0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
    0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
  static constexpr std::array<double, 4> kGauss = {
    0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
    0.381830050505118944950369775488975, 0.417959183673469387755102040816327};

  const double centre = 0.5 * (x0 + x1), half = 0.5 * (x1 - x0);
  const Eigen::Array2d middle = f(centre);
  Eigen::Array2d kronrod = kKronrod[7] * middle, gauss = kGauss[3] * middle;
  for (std::size_t i = 0; i < 7; ++i) {
    const Eigen::Array2d pair = f(centre - half * kNode[i]) + f(centre + half * kNode[i]);
    kronrod += kKronrod[i] * pair;
    if (i % 2 == 1) gauss += kGauss[i / 2] * pair; // every second node is a Gauss node
  }
  return {half * kronrod, (half * (kronrod - gauss)).abs()};
}

/// Integrates over the intervals between sorted marks, halving each until its error is below `tolerance`
/// times the whole integral. Kinks need no mark: halving closes in on them (at most 40 times).
template <class F>
Eigen::Array2d integrateAdaptively(const F& f, const std::vector<double>& marks, double tolerance)
{
  struct Task {
    double x0, x1;
    int depth;
    IntervalIntegral integral;
  };
  std::vector<Task> tasks;
  Eigen::Array2d rough = Eigen::Array2d::Zero(), sum = Eigen::Array2d::Zero();
  for (std::size_t k = 0; k + 1 < marks.size(); ++k) {
    tasks.push_back({marks[k], marks[k + 1], 0, gaussKronrod(f, marks[k], marks[k + 1])});
    rough += tasks.back().integral.value.abs();
  }
  while (!tasks.empty()) {
    const Task task = tasks.back();
    tasks.pop_back();
    if (task.depth >= 40 || (task.integral.error <= tolerance * rough).all()) {
      sum += task.integral.value;
      continue;
    }
    const double middle = 0.5 * (task.x0 + task.x1);
    tasks.push_back({task.x0, middle, task.depth + 1, gaussKronrod(f, task.x0, middle)});
    tasks.push_back({middle, task.x1, task.depth + 1, gaussKronrod(f, middle, task.x1)});
  }
  return sum;
}

} // namespace esm::fuzzy
