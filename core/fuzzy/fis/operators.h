// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fuzzy/fis/dual.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace esm::fis {

/// The operators on degrees: norms that join two of them, hedges that bend one. Written for double and Dual.
/// Any thread.
///
/// A NaN (an input nobody gave) is passed over by minimum and maximum and kept by all other operators, as in
/// fuzzylite; a rule whose degree is NaN does not fire.

enum class TNorm : std::uint8_t {
  Minimum,
  AlgebraicProduct,
  BoundedDifference, ///< max(0, a + b - 1)
  DrasticProduct,    ///< min(a, b) if one of them is 1, else 0
  EinsteinProduct,   ///< ab / (2 - (a + b - ab))
  HamacherProduct,   ///< ab / (a + b - ab)
  NilpotentMinimum   ///< min(a, b) if a + b > 1, else 0
};
enum class SNorm : std::uint8_t {
  Maximum,
  AlgebraicSum,     ///< a + b - ab
  BoundedSum,       ///< min(1, a + b)
  DrasticSum,       ///< max(a, b) if one of them is 0, else 1
  EinsteinSum,      ///< (a + b) / (1 + ab)
  HamacherSum,      ///< (a + b - 2ab) / (1 - ab)
  NilpotentMaximum, ///< max(a, b) if a + b < 1, else 1
  NormalizedSum,    ///< (a + b) / max(1, a + b)
  UnboundedSum      ///< a + b
};

/// Cubed is the mu^3 that some texts call "extremely"; Extremely is Zadeh's contrast intensification
/// (2 mu^2 below 1/2), as in fuzzylite. Seldom is its opposite. Any is 1 whatever mu.
enum class Hedge : std::uint8_t { Any, Extremely, Not, Seldom, Somewhat, Very, Cubed };

inline constexpr int kTNormCount = 7, kSNormCount = 9, kHedgeCount = 7;

/// The names of FLL: "AlgebraicProduct", "very".
std::string_view nameOf(TNorm norm) noexcept;
std::string_view nameOf(SNorm norm) noexcept;
std::string_view nameOf(Hedge hedge) noexcept;
std::optional<TNorm> tNormNamed(std::string_view name) noexcept;
std::optional<SNorm> sNormNamed(std::string_view name) noexcept;
std::optional<Hedge> hedgeNamed(std::string_view name) noexcept;

template <class T>
T lesser(const T& a, const T& b)
{
  return valueOf(a) < valueOf(b) || valueOf(b) != valueOf(b) ? a : b;
}
template <class T>
T greater(const T& a, const T& b)
{
  return valueOf(a) > valueOf(b) || valueOf(b) != valueOf(b) ? a : b;
}

/// Whether two numbers count as equal: `width` is 0, or that of fuzzylite where its answers are wanted.
inline bool near(double a, double b, double width)
{
  return a == b || std::abs(a - b) < width;
}

/// @param width see near(): drastic and nilpotent norms jump, and fuzzylite blurs the place.
template <class T>
T apply(TNorm norm, const T& a, const T& b, double width = 0.0)
{
  switch (norm) {
  case TNorm::Minimum:
    return lesser(a, b);
  case TNorm::AlgebraicProduct:
    return a * b;
  case TNorm::BoundedDifference:
    return greater(T(0.0), a + b - T(1.0));
  case TNorm::DrasticProduct:
    return near(valueOf(greater(a, b)), 1.0, width) ? lesser(a, b) : T(0.0);
  case TNorm::EinsteinProduct:
    return (a * b) / (T(2.0) - (a + b - a * b));
  case TNorm::HamacherProduct:
    return near(valueOf(a) + valueOf(b), 0.0, width) ? T(0.0) : (a * b) / (a + b - a * b);
  case TNorm::NilpotentMinimum:
    return valueOf(a) + valueOf(b) > 1.0 && !near(valueOf(a) + valueOf(b), 1.0, width) ? lesser(a, b)
                                                                                       : T(0.0);
  }
  return T(0.0);
}

template <class T>
T apply(SNorm norm, const T& a, const T& b, double width = 0.0)
{
  switch (norm) {
  case SNorm::Maximum:
    return greater(a, b);
  case SNorm::AlgebraicSum:
    return a + b - a * b;
  case SNorm::BoundedSum:
    return lesser(T(1.0), a + b);
  case SNorm::DrasticSum:
    return near(valueOf(lesser(a, b)), 0.0, width) ? greater(a, b) : T(1.0);
  case SNorm::EinsteinSum:
    return (a + b) / (T(1.0) + a * b);
  case SNorm::HamacherSum:
    if (near(valueOf(a) * valueOf(b), 1.0, width)) return T(1.0);
    return (a + b - T(2.0) * a * b) / (T(1.0) - a * b);
  case SNorm::NilpotentMaximum:
    return valueOf(a) + valueOf(b) < 1.0 && !near(valueOf(a) + valueOf(b), 1.0, width) ? greater(a, b)
                                                                                       : T(1.0);
  case SNorm::NormalizedSum:
    return (a + b) / greater(T(1.0), a + b);
  case SNorm::UnboundedSum:
    return a + b;
  }
  return T(0.0);
}

template <class T>
T apply(Hedge hedge, const T& x)
{
  switch (hedge) {
  case Hedge::Any:
    return T(1.0);
  case Hedge::Extremely:
    return valueOf(x) <= 0.5 ? T(2.0) * x * x : T(1.0) - T(2.0) * (T(1.0) - x) * (T(1.0) - x);
  case Hedge::Not:
    return T(1.0) - x;
  case Hedge::Seldom: // outside [0, 1], where a term is higher than 1, its end counts
    if (valueOf(x) <= 0.5) return squareRoot(T(0.5) * greater(T(0.0), x));
    return valueOf(x) >= 1.0 ? T(1.0) : T(1.0) - squareRoot(T(0.5) * (T(1.0) - x));
  case Hedge::Somewhat:
    return valueOf(x) < 0.0 ? T(0.0) : squareRoot(x);
  case Hedge::Very:
    return x * x;
  case Hedge::Cubed:
    return x * x * x;
  }
  return x;
}

} // namespace esm::fis
