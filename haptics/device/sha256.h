// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace esm {

/// SHA-256 (FIPS 180-4) in hexadecimal, so that users can compare firmware files.
std::string sha256Hex(std::span<const std::uint8_t> bytes);

} // namespace esm
