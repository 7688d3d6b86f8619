// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/implicit_guess.h"

namespace esm {
namespace {

using GuessWeights = std::array<double, 4>;

/// What a guess weighs.
struct GuessSources {
  const Lanes *v0, *a0, *v1, *a1;

  ESM_INLINE void weigh(const GuessWeights& w, std::size_t i, Lanes& sum) const noexcept
  {
    sum = v0[i] * w[0] + a0[i] * w[1] + v1[i] * w[2] + a1[i] * w[3];
  }
};

ESM_CPU_CLONES void makeGuess(const GuessSources& sources, const GuessWeights& given, std::size_t count,
                              Lanes* v) noexcept
{
  const GuessWeights weights = given; // as ESM_CPU_CLONES says
  for (std::size_t i = 0; i < count; ++i) sources.weigh(weights, i, v[i]);
}

/// @return sum over the nodes of the guess's squared distance from v
ESM_CPU_CLONES double guessMissed(const GuessSources& sources, const GuessWeights& weights, std::size_t count,
                                  const Lanes* v) noexcept
{
  Lanes sum = {0, 0, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    Lanes guess;
    sources.weigh(weights, i, guess);
    const Lanes away = guess - v[i];
    sum += away * away;
  }
  return sumLanes(sum);
}

} // namespace

void StageGuess::make(const NodeArray& v0, const NodeArray& a0, const NodeArray& v1, const NodeArray& a1,
                      NodeArray& v) const noexcept
{
  makeGuess({v0.data(), a0.data(), v1.data(), a1.data()}, m_weights[m_best], v.size(), v.data());
}

void StageGuess::judge(const NodeArray& v0, const NodeArray& a0, const NodeArray& v1, const NodeArray& a1,
                       const NodeArray& v) noexcept
{
  const GuessSources sources{v0.data(), a0.data(), v1.data(), a1.data()};
  double least = 0.0;
  for (std::size_t g = 0; g < m_known; ++g) {
    const double missed = guessMissed(sources, m_weights[g], v.size(), v.data());
    if (g > 0 && !(missed < least)) continue;
    least = missed;
    m_best = g;
  }
}

} // namespace esm
