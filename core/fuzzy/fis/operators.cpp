// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/operators.h"

namespace esm::fis {

namespace {

constexpr std::array<std::string_view, kTNormCount> kTNormNames = {
  "Minimum",         "AlgebraicProduct", "BoundedDifference", "DrasticProduct",
  "EinsteinProduct", "HamacherProduct",  "NilpotentMinimum"};
constexpr std::array<std::string_view, kSNormCount> kSNormNames = {
  "Maximum",     "AlgebraicSum",     "BoundedSum",    "DrasticSum",  "EinsteinSum",
  "HamacherSum", "NilpotentMaximum", "NormalizedSum", "UnboundedSum"};
constexpr std::array<std::string_view, kHedgeCount> kHedgeNames = {"any",      "extremely", "not",  "seldom",
                                                                   "somewhat", "very",      "cubed"};

template <class Enum, std::size_t N>
std::optional<Enum> find(const std::array<std::string_view, N>& names, std::string_view name)
{
  for (std::size_t i = 0; i < N; ++i)
    if (names[i] == name) return static_cast<Enum>(i);
  return std::nullopt;
}

} // namespace

std::string_view nameOf(TNorm norm) noexcept
{
  return kTNormNames[static_cast<std::size_t>(norm)];
}
std::string_view nameOf(SNorm norm) noexcept
{
  return kSNormNames[static_cast<std::size_t>(norm)];
}
std::string_view nameOf(Hedge hedge) noexcept
{
  return kHedgeNames[static_cast<std::size_t>(hedge)];
}
std::optional<TNorm> tNormNamed(std::string_view name) noexcept
{
  return find<TNorm>(kTNormNames, name);
}
std::optional<SNorm> sNormNamed(std::string_view name) noexcept
{
  return find<SNorm>(kSNormNames, name);
}
std::optional<Hedge> hedgeNamed(std::string_view name) noexcept
{
  return find<Hedge>(kHedgeNames, name);
}

} // namespace esm::fis
