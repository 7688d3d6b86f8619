// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fuzzy/fis/system.h"

#include <cstdint>
#include <random>
#include <vector>

namespace esm::fis {

/// Throws of dice; the same seed gives the same throws everywhere (no std distributions).
class Dice {
public:
  explicit Dice(std::uint64_t seed) : m_engine(seed * 0x9E3779B97F4A7C15ULL + 1) {}
  double unit() { return static_cast<double>(m_engine() >> 11) * 0x1.0p-53; }
  double number(double low, double high) { return low + unit() * (high - low); }
  int below(int count) { return static_cast<int>(m_engine() % static_cast<std::uint64_t>(count)); }
  bool chance(double probability) { return unit() < probability; }

private:
  std::mt19937_64 m_engine;
};

/// A term of the shape that lies well within [low, high].
Term randomTerm(Dice& dice, Shape shape, const std::string& name, double low, double high);

/// What a random system may hold.
struct Recipe {
  std::vector<Shape> inputShapes, outputShapes; ///< to choose from
  std::vector<Hedge> hedges;                    ///< in conditions
  std::vector<Defuzzifier> defuzzifiers = {Defuzzifier::Centroid};
  std::vector<TNorm> conjunctions = {TNorm::Minimum}, implications = {TNorm::Minimum};
  std::vector<SNorm> disjunctions = {SNorm::Maximum}, aggregations = {SNorm::Maximum};
  std::vector<Activation> activations = {{}};
  std::vector<int> resolutions = {100};
  bool weights = false, heights = false, severalBlocks = false, chained = false, options = false,
       conclusionHedges = false;
  WeightedType weightedType = WeightedType::Automatic;
};
std::vector<Shape> curveShapes();    ///< all membership curves
std::vector<Shape> monotoneShapes(); ///< for Tsukamoto
Recipe everything();                 ///< a recipe of all that there is
System randomSystem(Dice& dice, const Recipe& recipe);
/// Inputs over the ranges and a little beyond.
std::vector<double> randomRow(Dice& dice, const System& system);

} // namespace esm::fis
