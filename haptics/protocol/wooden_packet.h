// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/protocol/byte_order.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

/// Reports of WoodenHaptics 1.5: eight bytes each way without report id, int16 in Intel order. To the host
/// the three encoders and a counter; to the device the motor currents [mA] and a spare word.
/// @note Pure; no allocation; any thread.
namespace esm::wooden {

constexpr std::size_t kReportSize = 8;
using Report = std::array<std::uint8_t, kReportSize>;
constexpr double kLargestCurrent = 3.0; ///< [A]; the firmware clamps there, axis by axis

inline Report encode(const std::array<std::int16_t, 4>& words) noexcept
{
  Report report{};
  for (std::size_t i = 0; i < 4; ++i) putLe16(&report[2 * i], static_cast<std::uint16_t>(words[i]));
  return report;
}

inline bool decode(std::span<const std::uint8_t> bytes, std::array<std::int16_t, 4>& words) noexcept
{
  if (bytes.size() != kReportSize) return false;
  for (std::size_t i = 0; i < 4; ++i) words[i] = static_cast<std::int16_t>(getLe16(&bytes[2 * i]));
  return true;
}

/// Current words [mA] for `currents` [A]; one factor for all keeps the direction of the force.
inline std::array<std::int16_t, 4> currentWords(const Eigen::Vector3d& currents) noexcept
{
  std::array<std::int16_t, 4> words{};
  const double largest = currents.cwiseAbs().maxCoeff();
  if (!currents.allFinite() || !(largest > 0.0)) return words;
  const double size = 1000.0 * std::min(largest, kLargestCurrent);
  for (std::size_t i = 0; i < 3; ++i)
    words[i] =
      static_cast<std::int16_t>(std::lround(currents[static_cast<Eigen::Index>(i)] / largest * size));
  return words;
}

} // namespace esm::wooden
