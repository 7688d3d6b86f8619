// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace esm {

using Rgb = std::array<float, 3>; ///< sRGB, [0, 1]

/// The map "viridis": equal steps of value look like equal steps of colour, lightness rises all the way, so
/// it also reads in greyscale print and with the common colour vision deficiencies.
/// @param t clamped to [0, 1]; NaN ("no value here") gives a neutral grey that the map does not contain.
Rgb viridis(double t);

inline constexpr int kColourMapSize = 256;
/// The same as a table for the GPU: RGBA bytes, dark end first.
std::array<std::uint8_t, 4 * kColourMapSize> viridisTable();

} // namespace esm
