// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/colour_map.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

// Viridis by S. van der Walt, N. Smith and E. Firing (2015), released under CC0: every 15th of its 256
// entries. Linear interpolation between them stays within 1/255 of the full table.
constexpr std::array<Rgb, 18> kStops = {{
  {0.267004f, 0.004874f, 0.329415f},
  {0.281924f, 0.089666f, 0.412415f},
  {0.280255f, 0.165693f, 0.476498f},
  {0.263663f, 0.237631f, 0.518762f},
  {0.237441f, 0.305202f, 0.541921f},
  {0.208623f, 0.367752f, 0.552675f},
  {0.182256f, 0.426184f, 0.557120f},
  {0.159194f, 0.482237f, 0.558073f},
  {0.137770f, 0.537492f, 0.554906f},
  {0.121148f, 0.592739f, 0.544641f},
  {0.128087f, 0.647749f, 0.523491f},
  {0.180653f, 0.701402f, 0.488189f},
  {0.274149f, 0.751988f, 0.436601f},
  {0.395174f, 0.797475f, 0.367757f},
  {0.535621f, 0.835785f, 0.281908f},
  {0.688944f, 0.865448f, 0.182725f},
  {0.845561f, 0.887322f, 0.099702f},
  {0.993248f, 0.906157f, 0.143936f},
}};

} // namespace

Rgb viridis(double t)
{
  if (std::isnan(t)) return {0.62f, 0.62f, 0.62f};
  const double at = std::clamp(t, 0.0, 1.0) * (kStops.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const auto share = static_cast<float>(at - static_cast<double>(low));
  Rgb colour;
  for (std::size_t i = 0; i < 3; ++i)
    colour[i] = kStops[low][i] + share * (kStops[low + 1][i] - kStops[low][i]);
  return colour;
}

std::array<std::uint8_t, 4 * kColourMapSize> viridisTable()
{
  std::array<std::uint8_t, 4 * kColourMapSize> table{};
  for (std::size_t i = 0; i < kColourMapSize; ++i) {
    const Rgb colour = viridis(static_cast<double>(i) / (kColourMapSize - 1));
    for (std::size_t c = 0; c < 3; ++c)
      table[4 * i + c] = static_cast<std::uint8_t>(std::lround(255.0f * colour[c]));
    table[4 * i + 3] = 255;
  }
  return table;
}

} // namespace esm
