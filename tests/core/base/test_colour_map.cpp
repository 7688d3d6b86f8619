// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/colour_map.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace esm;

namespace {

/// CIE lightness L* [0, 100] of an sRGB colour.
double lightness(const Rgb& colour)
{
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  const double y = 0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2]);
  return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

} // namespace

// The published ends and middle of viridis; the middle is interpolated here, within half a byte step.
TEST(ColourMap, IsViridis)
{
  const auto near = [](const Rgb& a, const Rgb& b) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 0.5 / 255.0);
  };
  near(viridis(0.0), {0.267004f, 0.004874f, 0.329415f});
  near(viridis(128.0 / 255.0), {0.127568f, 0.566949f, 0.550556f});
  near(viridis(1.0), {0.993248f, 0.906157f, 0.143936f});
}

// Perceptually uniform: lightness rises all the way, in nearly equal steps (the map's own design goal; 15 %
// covers the rounding of its published table).
TEST(ColourMap, LightnessRisesEvenly)
{
  const double whole = lightness(viridis(1.0)) - lightness(viridis(0.0));
  for (int i = 0; i < 16; ++i) {
    const double step = lightness(viridis((i + 1) / 16.0)) - lightness(viridis(i / 16.0));
    EXPECT_NEAR(step, whole / 16.0, 0.15 * whole / 16.0) << "step " << i;
  }
}

TEST(ColourMap, ClampsAndGreysOut)
{
  EXPECT_EQ(viridis(-3.0), viridis(0.0));
  EXPECT_EQ(viridis(7.0), viridis(1.0));
  const Rgb none = viridis(NAN);
  EXPECT_EQ(none[0], none[1]);
  EXPECT_EQ(none[1], none[2]);
}

TEST(ColourMap, TableRunsFromTheDarkEndToTheLightOne)
{
  const auto table = viridisTable();
  EXPECT_EQ(table[0], 68);
  EXPECT_EQ(table[2], 84);
  EXPECT_EQ(table[table.size() - 4], 253);
  EXPECT_EQ(table[table.size() - 1], 255);
}
