// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"
#include "meshimport/byte_order.h"
#include "meshimport/text_cursor.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace esm {

enum class Scalar { Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };

constexpr std::size_t scalarSize(Scalar type) noexcept
{
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

/// The value at `from`, of that type and byte order; to an integer only whole numbers in range, else -1.
template <class T>
T decodeScalar(Scalar type, std::endian order, const char* from)
{
  const auto as = [&]<class From>(From) -> T {
    const From value = order == std::endian::little ? load<From, std::endian::little>(from)
                                                    : load<From, std::endian::big>(from);
    if constexpr (std::is_integral_v<T> && std::is_floating_point_v<From>) {
      return std::abs(value) < From{1e15f} && value == std::floor(value) ? static_cast<T>(value) : T{-1};
    } else {
      return static_cast<T>(value);
    }
  };
  switch (type) {
  case Scalar::Int8:
    return as(std::int8_t{});
  case Scalar::UInt8:
    return as(std::uint8_t{});
  case Scalar::Int16:
    return as(std::int16_t{});
  case Scalar::UInt16:
    return as(std::uint16_t{});
  case Scalar::Int32:
    return as(std::int32_t{});
  case Scalar::UInt32:
    return as(std::uint32_t{});
  case Scalar::Int64:
    return as(std::int64_t{});
  case Scalar::UInt64:
    return as(std::uint64_t{});
  case Scalar::Float32:
    return as(float{});
  case Scalar::Float64:
    return as(double{});
  }
  return T{};
}

/// A file whose numbers are text or binary, between lines of text (VTK, Gmsh).
class NumberSource : public TextCursor {
public:
  explicit NumberSource(std::string_view bytes) : TextCursor(bytes) {}

  std::optional<std::endian> binary; ///< byte order; empty for text

  /// To the next word, over ends of lines; false at the end of the file.
  bool skipToWord()
  {
    while (atLineEnd()) {
      if (atEnd()) return false;
      nextLine();
    }
    return true;
  }

  /// One number of a text or binary body. T is double or an integer.
  template <class T>
  bool next(Scalar type, T& value)
  {
    if (binary) {
      const std::string_view bytes = rest();
      if (bytes.size() < scalarSize(type)) return false;
      value = decodeScalar<T>(type, *binary, bytes.data());
      skipBytes(scalarSize(type));
      return true;
    }
    if (!skipToWord()) return false;
    if constexpr (std::is_floating_point_v<T>) {
      return number(value);
    } else {
      long long whole = 0;
      if (!integer(whole)) return false;
      value = static_cast<T>(whole);
      return true;
    }
  }

  /// Whether so many numbers may still come; to be asked before room is made for them.
  bool hasRoomFor(std::uint64_t count, Scalar type) const
  {
    return count <= (binary ? rest().size() / scalarSize(type) : rest().size() / 2 + 1);
  }

  /// What to say where the next number is missing.
  std::string whyNoNumber() const
  {
    NumberSource look = *this;
    if (binary || !look.skipToWord()) return "it ends early; it is cut short, fetch it again";
    const bool isLast = look.inLastLine();
    return "'" + look.wordForMessage() + "' stands where a number should be" +
           (isLast ? "; it may be cut short" : "; is the file damaged?");
  }

  template <class T>
  bool numbers(Scalar type, std::uint64_t count, std::vector<T>& out, WorkControl* control = nullptr)
  {
    if (!hasRoomFor(count, type)) return false;
    out.resize(count);
    for (std::uint64_t i = 0; i < count; ++i)
      if ((i % 4096 == 0 && stopWanted(control)) || !next(type, out[i])) return false;
    return true;
  }
};

} // namespace esm
