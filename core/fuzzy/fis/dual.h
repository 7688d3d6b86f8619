// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace esm::fis {

/// A number with its derivatives by N variables (forward differentiation). The curves, norms and hedges of
/// the engine are written once for any number type: with double they give values, with Dual also the exact
/// partial derivatives. At a kink the derivative is that of the branch taken; where a root or a power has an
/// infinite slope (at zero) the slope counts as 0, so that no NaN arises.
template <std::size_t N>
struct Dual {
  double v = 0.0;
  std::array<double, N> d{};

  Dual() = default;
  Dual(double value) : v(value) {}
  static Dual variable(double value, std::size_t index)
  {
    Dual result(value);
    result.d[index] = 1.0;
    return result;
  }

  /// f(v) with slope f'(v): the chain rule.
  Dual chain(double value, double slope) const
  {
    Dual result(value);
    for (std::size_t i = 0; i < N; ++i) result.d[i] = slope * d[i];
    return result;
  }

  friend Dual operator+(const Dual& a, const Dual& b)
  {
    Dual result(a.v + b.v);
    for (std::size_t i = 0; i < N; ++i) result.d[i] = a.d[i] + b.d[i];
    return result;
  }
  friend Dual operator-(const Dual& a, const Dual& b)
  {
    Dual result(a.v - b.v);
    for (std::size_t i = 0; i < N; ++i) result.d[i] = a.d[i] - b.d[i];
    return result;
  }
  friend Dual operator-(const Dual& a) { return a.chain(-a.v, -1.0); }
  friend Dual operator*(const Dual& a, const Dual& b)
  {
    Dual result(a.v * b.v);
    for (std::size_t i = 0; i < N; ++i) result.d[i] = a.d[i] * b.v + a.v * b.d[i];
    return result;
  }
  friend Dual operator/(const Dual& a, const Dual& b)
  {
    Dual result(a.v / b.v);
    for (std::size_t i = 0; i < N; ++i) result.d[i] = (a.d[i] - result.v * b.d[i]) / b.v;
    return result;
  }
};

inline double valueOf(double x)
{
  return x;
}
template <std::size_t N>
double valueOf(const Dual<N>& x)
{
  return x.v;
}

inline double exponential(double x)
{
  return std::exp(x);
}
template <std::size_t N>
Dual<N> exponential(const Dual<N>& x)
{
  const double value = std::exp(x.v);
  return x.chain(value, value);
}
inline double logarithm(double x)
{
  return std::log(x);
}
template <std::size_t N>
Dual<N> logarithm(const Dual<N>& x)
{
  return x.chain(std::log(x.v), 1.0 / x.v);
}
inline double squareRoot(double x)
{
  return std::sqrt(x);
}
template <std::size_t N>
Dual<N> squareRoot(const Dual<N>& x)
{
  const double value = std::sqrt(x.v);
  return x.chain(value, value > 0.0 ? 0.5 / value : 0.0);
}
inline double cosine(double x)
{
  return std::cos(x);
}
template <std::size_t N>
Dual<N> cosine(const Dual<N>& x)
{
  return x.chain(std::cos(x.v), -std::sin(x.v));
}
inline double magnitude(double x)
{
  return std::abs(x);
}
template <std::size_t N>
Dual<N> magnitude(const Dual<N>& x)
{
  return x.v < 0.0 ? -x : x;
}
/// base^exponent for base >= 0.
inline double power(double base, double exponent)
{
  return std::pow(base, exponent);
}
template <std::size_t N>
Dual<N> power(const Dual<N>& base, const Dual<N>& exponent)
{
  Dual<N> result(std::pow(base.v, exponent.v));
  if (!(base.v > 0.0)) return result;
  const double byBase = exponent.v * std::pow(base.v, exponent.v - 1.0);
  const double byExponent = result.v * std::log(base.v);
  for (std::size_t i = 0; i < N; ++i) result.d[i] = byBase * base.d[i] + byExponent * exponent.d[i];
  return result;
}

} // namespace esm::fis
