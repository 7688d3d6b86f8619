// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/byte_order.h"
#include "meshimport/ply_header.h"
#include "meshimport/text_cursor.h"

#include <string>
#include <string_view>

namespace esm::ply {

/// Said where a row is missing or has no end.
inline constexpr const char* kEndsEarly = "it ends early; the file is cut short, fetch it again";

/// Values of a binary body, one after the other.
template <std::endian order>
class BinarySource {
public:
  static constexpr bool isBinary = true;
  BinarySource(std::string_view bytes, const PlyHeader& header) : m_left(bytes.substr(header.bodyStart)) {}

  bool beginRow() { return true; }
  void endRow() {}
  long line() const { return 0; }
  std::size_t mostItems(PlyScalar type) const { return m_left.size() / plySize(type); }
  std::size_t bytesLeft() const { return m_left.size(); }

  /// The next `count` bytes, or null if there are fewer.
  const char* take(std::uint64_t count)
  {
    if (m_left.size() < count) return nullptr;
    const char* from = m_left.data();
    m_left.remove_prefix(count);
    return from;
  }
  /// Of the usual list of corners: the count as one byte, then so many Ts.
  template <class T>
  static T item(const char* from)
  {
    return load<T, order>(from);
  }

  /// Why value() found none.
  std::string fault() { return kEndsEarly; }
  bool value(PlyScalar type, double& value)
  {
    if (m_left.size() < plySize(type)) return false;
    value = decode(type, m_left.data());
    m_left.remove_prefix(plySize(type));
    return true;
  }

  template <class T>
  static double as(const char* from)
  {
    return static_cast<double>(load<T, order>(from));
  }
  static double decode(PlyScalar type, const char* from)
  {
    switch (type) {
    case PlyScalar::Int8:
      return as<std::int8_t>(from);
    case PlyScalar::UInt8:
      return as<std::uint8_t>(from);
    case PlyScalar::Int16:
      return as<std::int16_t>(from);
    case PlyScalar::UInt16:
      return as<std::uint16_t>(from);
    case PlyScalar::Int32:
      return as<std::int32_t>(from);
    case PlyScalar::UInt32:
      return as<std::uint32_t>(from);
    case PlyScalar::Int64:
      return as<std::int64_t>(from);
    case PlyScalar::UInt64:
      return as<std::uint64_t>(from);
    case PlyScalar::Float32:
      return as<float>(from);
    case PlyScalar::Float64:
      return as<double>(from);
    }
    return 0.0;
  }

private:
  std::string_view m_left;
};

/// Values of an ASCII body: one row of an element per line, blank lines between rows do not matter.
class AsciiSource {
public:
  static constexpr bool isBinary = false;
  AsciiSource(std::string_view bytes, const PlyHeader& header)
    : m_cursor(bytes.substr(header.bodyStart)), m_firstLine(header.bodyLine)
  {}

  bool beginRow()
  {
    while (!m_cursor.atEnd() && m_cursor.atLineEnd()) m_cursor.nextLine();
    return !m_cursor.atEnd();
  }
  void endRow() { m_cursor.nextLine(); }
  long line() const { return m_firstLine + m_cursor.line() - 1; }
  std::size_t mostItems(PlyScalar) const { return m_cursor.rest().size() / 2 + 1; }
  std::size_t bytesLeft()
  {
    beginRow();
    return m_cursor.rest().size();
  }
  bool value(PlyScalar, double& value) { return m_cursor.number(value); }
  std::string fault()
  {
    if (m_cursor.atEnd()) return kEndsEarly;
    if (m_cursor.atLineEnd()) return "its line has fewer numbers than the header says";
    const bool isLast = m_cursor.inLastLine();
    return "'" + m_cursor.wordForMessage() + "' is no number" + (isLast ? "; the file may be cut short" : "");
  }

private:
  TextCursor m_cursor;
  long m_firstLine;
};

} // namespace esm::ply
