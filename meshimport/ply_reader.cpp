// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/ply_reader.h"

#include "core/base/large_pages.h"
#include "meshimport/byte_order.h"
#include "meshimport/ply_header.h"
#include "meshimport/raw_mesh.h"
#include "meshimport/text_cursor.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace esm {

namespace {

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

private:
  TextCursor m_cursor;
  long m_firstLine;
};

template <class Source>
class BodyParser {
public:
  BodyParser(const PlyHeader& header, Source source, const std::string& origin)
    : m_header(header), m_source(source), m_origin(origin)
  {}

  Result<Mesh> run(std::vector<std::string>& notes, WorkControl* control)
  {
    m_control = control;
    m_vertexTotal = vertexTotal();
    for (const PlyElement& element : m_header.elements) {
      if (element.properties.empty() || element.count == 0) continue;
      Status status = element.name == "vertex" ? vertices(element)
                      : element.name == "face" ? faces(element)
                      : element.name == "edge" ? edges(element)
                                               : passOver(element, notes);
      if (!status) return status.error();
    }
    if (m_raw.isEmpty())
      return fault(ErrorCode::EmptyResult, m_origin, 0,
                   "it holds " + std::to_string(m_raw.vertexCount()) +
                     " vertices but no face and no edge; a point cloud makes no net");
    if (const std::size_t left = m_source.bytesLeft(); left > 0)
      notes.push_back(std::to_string(left) + " bytes behind the last element were passed over.");
    if (m_thinFaces > 0)
      notes.push_back(std::to_string(m_thinFaces) +
                      " faces with fewer than three corners were read as lines.");
    return finishMesh(std::move(m_raw), m_origin, notes, control);
  }

private:
  Error wrong(ErrorCode code, const char* element, std::uint64_t row, const std::string& text) const
  {
    return fault(code, m_origin, m_source.line(),
                 std::string(element) + " " + std::to_string(row + 1) + ": " + text);
  }

  /// Reads one row: scalars into `m_scalars` by place, the list at `listPlace` into `m_list`.
  Status row(const PlyElement& element, std::uint64_t number, int listPlace)
  {
    if (stopWantedAt(number, element.count, m_control)) return cancelledError();
    const char* name = element.name.c_str();
    if (!m_source.beginRow()) return wrong(ErrorCode::BadFormat, name, number, kCutShort);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      double first = 0.0;
      if (!m_source.value(property.isList ? property.countType : property.type, first))
        return wrong(ErrorCode::BadFormat, name, number, kCutShort);
      m_scalars[i] = first;
      if (!property.isList) continue;
      const double most = static_cast<double>(m_source.mostItems(property.type));
      if (!(first >= 0.0 && first <= most && first == std::floor(first)))
        return wrong(ErrorCode::BadFormat, name, number,
                     "a list of impossible length; the file is damaged or cut short");
      m_list.resize(static_cast<std::size_t>(first));
      for (double& item : m_list)
        if (!m_source.value(property.type, item)) return wrong(ErrorCode::BadFormat, name, number, kCutShort);
      if (static_cast<int>(i) == listPlace) m_wantedList.swap(m_list);
    }
    m_source.endRow();
    return {};
  }

  Status vertices(const PlyElement& element)
  {
    int place[3];
    constexpr const char* kNames[3] = {"x", "y", "z"};
    for (int k = 0; k < 3; ++k) {
      place[k] = element.find(kNames[k]);
      if (place[k] < 0 || element.properties[static_cast<std::size_t>(place[k])].isList)
        return fault(ErrorCode::BadFormat, m_origin, 0, "its vertices have no x, y and z");
    }
    m_scalars.resize(element.properties.size());
    m_raw.vertices.reserve(static_cast<Eigen::Index>(element.count));
    if constexpr (Source::isBinary)
      if (const std::optional<PlainRow> plain = plainRow(element))
        return plainVertices(element, *plain, place);
    for (std::uint64_t r = 0; r < element.count; ++r) {
      const long line = m_source.line();
      if (Status status = row(element, r, -1); !status) return status;
      const auto at = [&](int k) { return m_scalars[static_cast<std::size_t>(place[k])]; };
      m_raw.addVertex(at(0), at(1), at(2), line);
    }
    return {};
  }

  Status faces(const PlyElement& element)
  {
    int place = element.find("vertex_indices");
    if (place < 0) place = element.find("vertex_index");
    if (place < 0 || !element.properties[static_cast<std::size_t>(place)].isList)
      return fault(ErrorCode::BadFormat, m_origin, 0, "its faces have no list vertex_indices");
    m_scalars.resize(element.properties.size());
    m_raw.triangles.reserve(
      static_cast<Eigen::Index>(std::min<std::uint64_t>(element.count, m_source.bytesLeft())));
    if constexpr (Source::isBinary)
      if (isPlainList(element)) return plainFaces(element.count);
    for (std::uint64_t r = 0; r < element.count; ++r) {
      if (Status status = row(element, r, place); !status) return status;
      m_corners.clear();
      for (const double vertex : m_wantedList)
        if (Status status = addCorner("face", r, vertex); !status) return status;
      if (!m_raw.addFace(m_corners)) ++m_thinFaces;
      if (m_raw.isTooLarge()) return tooManyError(m_origin);
    }
    return {};
  }

  /// Rows of one length: where each property begins, and the length.
  struct PlainRow {
    std::vector<std::size_t> offset;
    std::size_t size = 0;
  };
  static std::optional<PlainRow> plainRow(const PlyElement& element)
  {
    PlainRow row;
    for (const PlyProperty& property : element.properties) {
      if (property.isList) return std::nullopt;
      row.offset.push_back(row.size);
      row.size += plySize(property.type);
    }
    return row;
  }
  Status plainVertices(const PlyElement& element, const PlainRow& plain, const int (&place)[3])
  {
    std::size_t offset[3];
    bool isFloat = true;
    PlyScalar type[3];
    for (int k = 0; k < 3; ++k) {
      offset[k] = plain.offset[static_cast<std::size_t>(place[k])];
      type[k] = element.properties[static_cast<std::size_t>(place[k])].type;
      isFloat = isFloat && type[k] == PlyScalar::Float32;
    }
    for (std::uint64_t r = 0; r < element.count; ++r) {
      if (stopWantedAt(r, element.count, m_control)) return cancelledError();
      const char* from = m_source.take(plain.size);
      if (!from) return wrong(ErrorCode::BadFormat, "vertex", r, kCutShort);
      const auto at = [&](int k) {
        return isFloat ? double{Source::template item<float>(from + offset[k])}
                       : Source::decode(type[k], from + offset[k]);
      };
      m_raw.addVertex(at(0), at(1), at(2), 0);
    }
    return {};
  }

  /// Nothing but the list that nearly all writers use.
  static bool isPlainList(const PlyElement& element)
  {
    const PlyProperty& property = element.properties[0];
    return element.properties.size() == 1 && property.countType == PlyScalar::UInt8 &&
           (property.type == PlyScalar::Int32 || property.type == PlyScalar::UInt32);
  }
  Status plainFaces(std::uint64_t rows)
  {
    for (std::uint64_t first = 0; first < rows; first += kItemsPerLook) {
      if (stopWantedAt(first, rows, m_control)) return cancelledError();
      const std::uint64_t end = std::min<std::uint64_t>(first + kItemsPerLook, rows);
      for (std::uint64_t row = first; row < end; ++row) {
        row += plainTriangles(end - row);
        if (row == end) break;
        if (Status status = otherPlainFace(row); !status) return status;
      }
    }
    return {};
  }
  /// Takes the triangles that come next, up to the first row that is anything else.
  /// @return how many
  std::uint64_t plainTriangles(std::uint64_t most)
  {
    constexpr std::size_t kCorner = sizeof(std::uint32_t), kRow = 1 + 3 * kCorner;
    most = std::min<std::uint64_t>(most, m_source.bytesLeft() / kRow);
    const char* from = m_source.take(0);
    std::uint64_t taken = 0;
    for (; taken < most; ++taken, from += kRow) {
      const std::uint32_t a = Source::template item<std::uint32_t>(from + 1);
      const std::uint32_t b = Source::template item<std::uint32_t>(from + 1 + kCorner);
      const std::uint32_t c = Source::template item<std::uint32_t>(from + 1 + 2 * kCorner);
      if (*from != 3 || std::max(std::max(a, b), c) >= m_vertexTotal) break;
      m_raw.addTriangle(static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c));
    }
    m_source.take(taken * kRow);
    return taken;
  }
  /// Than a triangle over vertices that are there.
  Status otherPlainFace(std::uint64_t row)
  {
    const char* const count = m_source.take(1);
    const std::size_t corners = count ? static_cast<std::uint8_t>(*count) : 0;
    const char* const from = m_source.take(4 * corners);
    if (!count || !from) return wrong(ErrorCode::BadFormat, "face", row, kCutShort);
    const auto corner = [from](std::size_t k) { return Source::template item<std::uint32_t>(from + 4 * k); };
    m_corners.resize(corners);
    for (std::size_t k = 0; k < corners; ++k) {
      if (corner(k) >= m_vertexTotal) return noVertex("face", row, static_cast<double>(corner(k)));
      m_corners[k] = static_cast<Index>(corner(k));
    }
    if (!m_raw.addFace(m_corners)) ++m_thinFaces;
    return m_raw.isTooLarge() ? Status(tooManyError(m_origin)) : Status();
  }

  Status edges(const PlyElement& element)
  {
    const int a = element.find("vertex1"), b = element.find("vertex2");
    if (a < 0 || b < 0)
      return fault(ErrorCode::BadFormat, m_origin, 0, "its edges have no vertex1 and vertex2");
    m_scalars.resize(element.properties.size());
    for (std::uint64_t r = 0; r < element.count; ++r) {
      if (Status status = row(element, r, -1); !status) return status;
      m_corners.clear();
      for (const int place : {a, b})
        if (Status status = addCorner("edge", r, m_scalars[static_cast<std::size_t>(place)]); !status)
          return status;
      m_raw.addPolyline(m_corners);
    }
    return {};
  }

  Status passOver(const PlyElement& element, std::vector<std::string>& notes)
  {
    m_scalars.resize(element.properties.size());
    for (std::uint64_t r = 0; r < element.count; ++r)
      if (Status status = row(element, r, -1); !status) return status;
    notes.push_back(std::to_string(element.count) + " of the element '" + element.name.substr(0, 30) +
                    "' were passed over.");
    return {};
  }

  /// The vertex count comes from the header, so faces may stand before their vertices.
  Status addCorner(const char* what, std::uint64_t row, double vertex)
  {
    if (!(vertex >= 0.0 && vertex < static_cast<double>(m_vertexTotal) && vertex == std::floor(vertex)))
      return noVertex(what, row, vertex);
    m_corners.push_back(static_cast<Index>(vertex));
    return {};
  }
  Error noVertex(const char* what, std::uint64_t row, double vertex) const
  {
    const double named = std::isfinite(vertex) && std::abs(vertex) < 1e15 ? vertex : -1.0;
    return wrong(ErrorCode::InvalidValue, what, row,
                 "there is no vertex " + std::to_string(static_cast<long long>(named)) +
                   ", the file has vertices 0 to " +
                   std::to_string(static_cast<long long>(m_vertexTotal) - 1));
  }

  std::uint64_t vertexTotal() const
  {
    for (const PlyElement& element : m_header.elements)
      if (element.name == "vertex" && !element.properties.empty()) return element.count;
    return 0;
  }

  static constexpr const char* kCutShort =
    "it ends early or holds something that is no number; is the file cut short?";

  const PlyHeader& m_header;
  Source m_source;
  const std::string& m_origin;
  RawMesh m_raw;
  std::vector<double> m_scalars, m_list, m_wantedList;
  std::vector<Index> m_corners;
  std::size_t m_thinFaces = 0;
  std::uint64_t m_vertexTotal = 0;
  WorkControl* m_control = nullptr;
};

bool recognisesPly(std::string_view bytes, std::string_view)
{
  if (bytes.substr(0, 3) == "\xEF\xBB\xBF") bytes.remove_prefix(3);
  const std::size_t end = bytes.substr(0, 16).find_first_of("\r\n");
  return end != std::string_view::npos && bytes.substr(0, 3) == "ply" &&
         bytes.substr(3, end - 3).find_first_not_of(" \t") == std::string_view::npos;
}

template <class Source>
Result<Mesh> readBody(std::string_view bytes, const PlyHeader& header, const std::string& origin,
                      std::vector<std::string>& notes, WorkControl* control)
{
  return BodyParser<Source>(header, Source(bytes, header), origin).run(notes, control);
}

Result<Mesh> readPly(std::string_view bytes, const std::string& origin, std::string& format,
                     std::vector<std::string>& notes, WorkControl* control)
{
  format = "PLY";
  const Result<PlyHeader> header = parsePlyHeader(bytes, origin);
  if (!header) return header.error();
  switch (header->encoding) {
  case PlyEncoding::Ascii:
    format = "PLY (ASCII)";
    return readBody<AsciiSource>(bytes, *header, origin, notes, control);
  case PlyEncoding::LittleEndian:
    format = "PLY (binary, little-endian)";
    return readBody<BinarySource<std::endian::little>>(bytes, *header, origin, notes, control);
  case PlyEncoding::BigEndian:
    format = "PLY (binary, big-endian)";
    return readBody<BinarySource<std::endian::big>>(bytes, *header, origin, notes, control);
  }
  return fault(ErrorCode::Internal, origin, 0, "unknown PLY encoding");
}

} // namespace

MeshReader plyReader()
{
  return {"PLY", recognisesPly, readPly};
}

} // namespace esm
