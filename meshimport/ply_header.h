// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

enum class PlyScalar { Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };
std::size_t plySize(PlyScalar type) noexcept; ///< bytes in a binary file

struct PlyProperty {
  std::string name;
  PlyScalar type = PlyScalar::Float32; ///< of the value or of a list's items
  bool isList = false;
  PlyScalar countType = PlyScalar::UInt8;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Place of the property in `properties`, in any case, or -1.
  int find(std::string_view property) const;
  /// The least number of bytes that all rows together take.
  std::uint64_t leastBytes(bool ascii) const;
};

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
  std::size_t bodyStart = 0;  ///< first byte behind end_header
  long bodyLine = 1;          ///< its line, from 1
  std::size_t strayLines = 0; ///< before the first element that are no words of PLY
  std::string firstStray;     ///< how the first of them begins
};

/// Errors: BadFormat with the line; among them counts that the file is too small for.
Result<PlyHeader> parsePlyHeader(std::string_view bytes, const std::string& origin);

} // namespace esm
