// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

// Internal to the readers and writers of core/fuzzy/fis: what things are called in their formats.
#include "core/fuzzy/fis/source_text.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace esm::fis {

/// The place of a word among the names, whatever the case; -1 if it is not there.
template <std::size_t N>
int indexIn(const std::array<std::string_view, N>& names, std::string_view word)
{
  for (std::size_t i = 0; i < N; ++i)
    if (equalIgnoringCase(names[i], word)) return static_cast<int>(i);
  return -1;
}

/// The name of a norm, or what stands for none.
template <class Norm, std::size_t N>
std::string_view nameIn(const std::array<std::string_view, N>& names, std::optional<Norm> norm,
                        std::string_view none)
{
  return norm ? names[static_cast<std::size_t>(*norm)] : none;
}

namespace fcl {

inline constexpr std::array<std::string_view, kTNormCount> kTNorms = {"MIN",   "PROD",  "BDIF", "DPROD",
                                                                      "EPROD", "HPROD", "NMIN"};
inline constexpr std::array<std::string_view, kSNormCount> kSNorms = {
  "MAX", "ASUM", "BSUM", "DSUM", "ESUM", "HSUM", "NMAX", "NSUM", "UnboundedSum"};
inline constexpr std::array<std::string_view, 8> kMethods = {"NONE", "COA", "COG",  "RM",
                                                             "MM",   "LM",  "COGS", "COGSS"};

/// What jFuzzyLogic calls otherwise.
inline constexpr std::array<std::pair<std::string_view, TNorm>, 3> kForeignTNorms = {
  {{"DMIN", TNorm::DrasticProduct},
   {"NIPMIN", TNorm::NilpotentMinimum},
   {"HAMACHER", TNorm::HamacherProduct}}};
inline constexpr std::array<std::pair<std::string_view, SNorm>, 5> kForeignSNorms = {
  {{"DMAX", SNorm::DrasticSum},
   {"NIPMAX", SNorm::NilpotentMaximum},
   {"EINSTEIN", SNorm::EinsteinSum},
   {"PROBOR", SNorm::AlgebraicSum},
   {"SUM", SNorm::UnboundedSum}}};

} // namespace fcl

namespace matlab {

inline constexpr std::array<std::string_view, kTNormCount> kTNorms = {"min",
                                                                      "prod",
                                                                      "bounded_difference",
                                                                      "drastic_product",
                                                                      "einstein_product",
                                                                      "hamacher_product",
                                                                      "nilpotent_minimum"};
inline constexpr std::array<std::string_view, kSNormCount> kSNorms = {
  "max",          "probor",       "bounded_sum",       "drastic_sum",
  "einstein_sum", "hamacher_sum", "nilpotent_maximum", "normalized_sum",
  "sum"};
inline constexpr std::array<std::string_view, 8> kMethods = {"none", "bisector", "centroid", "lom",
                                                             "mom",  "som",      "wtaver",   "wtsum"};

/// A shape's name in FIS and where its parameters stand there: ours[i] = theirs[order[i]].
struct FisShape {
  std::string_view name;
  Shape shape;
  std::array<std::size_t, 4> order = {0, 1, 2, 3};
  bool matlab = true; ///< else an addition of fuzzylite
};
inline constexpr std::array<FisShape, 23> kShapes = {{{"trimf", Shape::Triangle},
                                                      {"trapmf", Shape::Trapezoid},
                                                      {"gaussmf", Shape::Gaussian, {1, 0, 2, 3}},
                                                      {"gauss2mf", Shape::GaussianProduct, {1, 0, 3, 2}},
                                                      {"gbellmf", Shape::Bell, {2, 0, 1, 3}},
                                                      {"sigmf", Shape::Sigmoid, {1, 0, 2, 3}},
                                                      {"dsigmf", Shape::SigmoidDifference, {1, 0, 2, 3}},
                                                      {"psigmf", Shape::SigmoidProduct, {1, 0, 2, 3}},
                                                      {"pimf", Shape::PiShape},
                                                      {"smf", Shape::SShape},
                                                      {"zmf", Shape::ZShape},
                                                      {"constant", Shape::Constant},
                                                      {"linear", Shape::Linear},
                                                      {"rampmf", Shape::Ramp, {0, 1, 2, 3}, false},
                                                      {"linsmf", Shape::Ramp},
                                                      {"linzmf", Shape::Ramp, {1, 0, 2, 3}},
                                                      {"binarymf", Shape::Binary, {0, 1, 2, 3}, false},
                                                      {"concavemf", Shape::Concave, {0, 1, 2, 3}, false},
                                                      {"cosinemf", Shape::Cosine, {0, 1, 2, 3}, false},
                                                      {"discretemf", Shape::Discrete, {0, 1, 2, 3}, false},
                                                      {"function", Shape::Function, {0, 1, 2, 3}, false},
                                                      {"rectmf", Shape::Rectangle, {0, 1, 2, 3}, false},
                                                      {"spikemf", Shape::Spike, {0, 1, 2, 3}, false}}};

/// Hedges behind the point of a term's number, as fuzzylite writes them.
inline constexpr std::array<std::pair<int, Hedge>, 5> kHedgeCodes = {
  {{1, Hedge::Seldom}, {5, Hedge::Somewhat}, {20, Hedge::Very}, {30, Hedge::Extremely}, {99, Hedge::Any}}};

} // namespace matlab
} // namespace esm::fis
