// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/ply_header.h"

#include "core/base/ascii_case.h"
#include "meshimport/raw_mesh.h"
#include "meshimport/text_cursor.h"

#include <algorithm>
#include <optional>

namespace esm {

namespace {

std::optional<PlyScalar> scalarNamed(std::string_view name)
{
  using enum PlyScalar;
  constexpr std::pair<std::string_view, PlyScalar> kNames[] = {
    {"char", Int8},       {"int8", Int8},      {"uchar", UInt8},    {"uint8", UInt8},   {"short", Int16},
    {"int16", Int16},     {"ushort", UInt16},  {"uint16", UInt16},  {"int", Int32},     {"int32", Int32},
    {"uint", UInt32},     {"uint32", UInt32},  {"int64", Int64},    {"uint64", UInt64}, {"float", Float32},
    {"float32", Float32}, {"double", Float64}, {"float64", Float64}};
  for (const auto& [known, type] : kNames)
    if (known == name) return type;
  return std::nullopt;
}

class HeaderParser {
public:
  HeaderParser(std::string_view bytes, const std::string& origin)
    : m_bytes(bytes), m_cursor(bytes), m_origin(origin)
  {}

  Result<PlyHeader> run()
  {
    m_cursor.nextLine(); // "ply"
    for (; !m_cursor.atEnd(); m_cursor.nextLine()) {
      if (m_cursor.atLineEnd()) continue;
      m_line = m_cursor.line();
      const std::string_view word = m_cursor.word();
      if (word == "end_header") return end();
      if (Status status = statement(word); !status) return status.error();
    }
    return fault(ErrorCode::BadFormat, m_origin, m_cursor.line(),
                 "the header has no 'end_header'; the file is cut short");
  }

private:
  Error wrong(const std::string& text) const { return fault(ErrorCode::BadFormat, m_origin, m_line, text); }

  Status statement(std::string_view word)
  {
    if (equalIgnoringCase(word.substr(0, 7), "comment") || word == "obj_info" || word[0] == '#') return {};
    if (word == "format") return format();
    if (word == "element") return element();
    if (word == "property") return property();
    return stray(word);
  }

  /// Some writers put remarks there without the word comment; further on it may be half of a property.
  Status stray(std::string_view word)
  {
    std::string start(word.substr(0, 30));
    if (!m_header.elements.empty())
      return wrong("a PLY header line begins with '" + start + "'" +
                   (m_cursor.inLastLine()
                      ? "; the file is cut short"
                      : ", which is no word of PLY; remarks begin with the word comment"));
    if (m_header.strayLines++ == 0) m_header.firstStray = std::move(start);
    return {};
  }

  Status format()
  {
    const std::string_view name = m_cursor.word();
    m_hasFormat = true;
    if (name == "ascii") {
      m_header.encoding = PlyEncoding::Ascii;
    } else if (name == "binary_little_endian") {
      m_header.encoding = PlyEncoding::LittleEndian;
    } else if (name == "binary_big_endian") {
      m_header.encoding = PlyEncoding::BigEndian;
    } else {
      return wrong("the PLY format must be ascii, binary_little_endian or binary_big_endian");
    }
    return {};
  }

  Status element()
  {
    PlyElement element;
    element.name = m_cursor.word();
    long long count = 0;
    if (element.name.empty() || !m_cursor.integer(count) || count < 0)
      return wrong("an element needs a name and a count from 0");
    for (const PlyElement& other : m_header.elements)
      if (other.name == element.name)
        return wrong("the element '" + element.name.substr(0, 30) + "' comes twice");
    element.count = static_cast<std::uint64_t>(count);
    m_header.elements.push_back(std::move(element));
    return {};
  }

  Status property()
  {
    if (m_header.elements.empty()) return wrong("a property comes before the first element");
    PlyProperty property;
    std::string_view type = m_cursor.word();
    if (type == "list") {
      property.isList = true;
      const std::optional<PlyScalar> count = scalarNamed(m_cursor.word());
      if (!count) return wrong("a list property needs a count type that PLY knows");
      property.countType = *count;
      type = m_cursor.word();
    }
    const std::optional<PlyScalar> scalar = scalarNamed(type);
    if (!scalar) return wrong("a property has a type that PLY does not know");
    property.type = *scalar;
    property.name = m_cursor.word();
    if (property.name.empty()) return wrong("a property has no name");
    m_header.elements.back().properties.push_back(std::move(property));
    return {};
  }

  Result<PlyHeader> end()
  {
    if (!m_hasFormat) return wrong("the PLY header has no 'format' line");
    m_cursor.nextLine();
    m_header.bodyStart = m_bytes.size() - m_cursor.rest().size();
    m_header.bodyLine = m_cursor.line();
    // Where lines end with CR alone, a binary body may begin with the byte of LF.
    const std::size_t firstEnd = m_bytes.find_first_of("\r\n");
    const bool loneReturn = m_bytes.substr(firstEnd, 1) == "\r" && m_bytes.substr(firstEnd + 1, 1) != "\n";
    if (loneReturn && m_bytes[m_header.bodyStart - 1] == '\n') --m_header.bodyStart;
    return sizeChecked();
  }

  Result<PlyHeader> sizeChecked()
  {
    std::uint64_t left = m_bytes.size() - m_header.bodyStart;
    const bool ascii = m_header.encoding == PlyEncoding::Ascii;
    if (ascii) ++left; // the last line may lack its end
    for (const PlyElement& element : m_header.elements) {
      const std::uint64_t least = element.leastBytes(ascii);
      if (element.count > kMostItems && least > 0 && least <= left) return tooManyError(m_origin);
      if (least > left)
        return fault(ErrorCode::BadFormat, m_origin, 0,
                     "its header promises " + std::to_string(element.count) + " of '" +
                       element.name.substr(0, 30) + "', but the file is too small for them (" +
                       std::to_string(m_bytes.size()) + " bytes); it is cut short, fetch it again");
      left -= least;
    }
    return std::move(m_header);
  }

  std::string_view m_bytes;
  TextCursor m_cursor;
  const std::string& m_origin;
  PlyHeader m_header;
  long m_line = 1;
  bool m_hasFormat = false;
};

} // namespace

std::size_t plySize(PlyScalar type) noexcept
{
  static constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

int PlyElement::find(std::string_view property) const
{
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (equalIgnoringCase(properties[i].name, property)) return static_cast<int>(i);
  return -1;
}

std::uint64_t PlyElement::leastBytes(bool ascii) const
{
  std::uint64_t row = 0;
  for (const PlyProperty& property : properties)
    row += ascii ? 2 : plySize(property.isList ? property.countType : property.type); // a digit and a blank
  constexpr std::uint64_t kEnough = std::uint64_t{1} << 62; // more than any file, and no overflow
  return row > 0 && count > kEnough / row ? kEnough : row * count;
}

Result<PlyHeader> parsePlyHeader(std::string_view bytes, const std::string& origin)
{
  return HeaderParser(bytes, origin).run();
}

} // namespace esm
