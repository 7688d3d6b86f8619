// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/ply_reader.h"

#include "core/base/large_pages.h"
#include "core/base/text_encoding.h"
#include "meshimport/ply_header.h"
#include "meshimport/ply_roles.h"
#include "meshimport/ply_source.h"
#include "meshimport/raw_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace esm {

namespace {

using namespace ply;

template <class Source>
class BodyParser {
public:
  BodyParser(const PlyHeader& header, Source source, const std::string& origin)
    : m_header(header), m_source(source), m_origin(origin)
  {}

  Result<Mesh> run(std::vector<std::string>& notes, WorkControl* control)
  {
    m_control = control;
    m_vertexElement = plyVertices(m_header);
    m_vertexTotal = m_vertexElement ? m_vertexElement->count : 0;
    for (const PlyElement& element : m_header.elements) {
      if (element.properties.empty() || element.count == 0) continue;
      if (Status status = read(element, notes); !status) return status.error();
    }
    if (m_raw.isEmpty()) return nothingIn();
    if (const std::size_t left = m_source.bytesLeft(); left > 0)
      notes.push_back(std::to_string(left) + " bytes behind the last element were passed over.");
    if (m_thinFaces > 0)
      notes.push_back(std::to_string(m_thinFaces) +
                      " faces with fewer than three corners were read as lines.");
    if (m_otherCells > 0)
      notes.push_back(std::to_string(m_otherCells) + " cells that are no tetrahedra were passed over.");
    return finishMesh(std::move(m_raw), m_origin, notes, control);
  }

private:
  Status read(const PlyElement& element, std::vector<std::string>& notes)
  {
    if (&element == m_vertexElement) return vertices(element);
    const PlyRole role = plyRole(element);
    if (role.note)
      notes.push_back(std::to_string(element.count) + " of the element '" + shortName(element) +
                      "' were read as " + role.note + ".");
    switch (role.shape) {
    case PlyShape::Face:
      return faces(element, role.list);
    case PlyShape::Strip:
    case PlyShape::Fan:
    case PlyShape::Polyline:
    case PlyShape::Tetrahedron:
      return lists(element, role);
    case PlyShape::Edge:
      return edges(element, role.ends);
    case PlyShape::None:
      return passOver(element, notes);
    }
    return {};
  }

  /// Why no net comes of it, and what would help.
  Error nothingIn() const
  {
    std::string text =
      "it holds " + std::to_string(m_raw.vertexCount()) + " vertices but no face and no edge";
    for (const PlyElement& element : m_header.elements) {
      if (element.count == 0 || &element == m_vertexElement) continue;
      const auto isList = [](const PlyProperty& property) { return property.isList; };
      const bool holdsLists = std::any_of(element.properties.begin(), element.properties.end(), isList);
      if (isPlyGrid(element))
        return empty(text + "; a range grid is a scan that must be triangulated first, as MeshLab does");
      if (holdsLists)
        return empty(text + "; it has lists in the element '" + shortName(element) +
                     "', which is none of those that are known; save it with faces");
    }
    return empty(text + "; a point cloud makes no net, make a surface of it first");
  }
  Error empty(const std::string& text) const { return fault(ErrorCode::EmptyResult, m_origin, 0, text); }
  static std::string shortName(const PlyElement& element) { return element.name.substr(0, 30); }

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
    if (!m_source.beginRow()) return wrong(ErrorCode::BadFormat, name, number, kEndsEarly);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      double first = 0.0;
      if (!m_source.value(property.isList ? property.countType : property.type, first))
        return wrong(ErrorCode::BadFormat, name, number, m_source.fault());
      m_scalars[i] = first;
      if (!property.isList) continue;
      const double most = static_cast<double>(m_source.mostItems(property.type));
      if (!(first >= 0.0 && first <= most && first == std::floor(first)))
        return wrong(ErrorCode::BadFormat, name, number,
                     first > most ? "a list of impossible length; the file is damaged or cut short"
                                  : "a list of impossible length; the file is damaged");
      m_list.resize(static_cast<std::size_t>(first));
      for (double& item : m_list)
        if (!m_source.value(property.type, item))
          return wrong(ErrorCode::BadFormat, name, number, m_source.fault());
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

  Status faces(const PlyElement& element, int place)
  {
    if (place < 0) return fault(ErrorCode::BadFormat, m_origin, 0, "its faces have no list vertex_indices");
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
      if (!from) return wrong(ErrorCode::BadFormat, "vertex", r, kEndsEarly);
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
    if (!count || !from) return wrong(ErrorCode::BadFormat, "face", row, kEndsEarly);
    const auto corner = [from](std::size_t k) { return Source::template item<std::uint32_t>(from + 4 * k); };
    m_corners.resize(corners);
    for (std::size_t k = 0; k < corners; ++k) {
      if (corner(k) >= m_vertexTotal) return noVertex("face", row, static_cast<double>(corner(k)));
      m_corners[k] = static_cast<Index>(corner(k));
    }
    if (!m_raw.addFace(m_corners)) ++m_thinFaces;
    return m_raw.isTooLarge() ? Status(tooManyError(m_origin)) : Status();
  }

  Status edges(const PlyElement& element, const std::array<int, 2>& ends)
  {
    if (ends[0] < 0) return fault(ErrorCode::BadFormat, m_origin, 0, "its edges have no vertex1 and vertex2");
    m_scalars.resize(element.properties.size());
    for (std::uint64_t r = 0; r < element.count; ++r) {
      if (Status status = row(element, r, -1); !status) return status;
      m_corners.clear();
      for (const int place : ends)
        if (Status status = addCorner("edge", r, m_scalars[static_cast<std::size_t>(place)]); !status)
          return status;
      m_raw.addPolyline(m_corners);
    }
    return {};
  }

  /// Strips, fans and lines of any length, in which -1 begins a new one; tetrahedra.
  Status lists(const PlyElement& element, const PlyRole& role)
  {
    const char* const name = element.name.c_str();
    const PlyScalar type = element.properties[static_cast<std::size_t>(role.list)].type;
    const double unsignedRestart = type == PlyScalar::UInt32 ? 4294967295.0 : -1.0; // -1 all the same
    m_scalars.resize(element.properties.size());
    for (std::uint64_t r = 0; r < element.count; ++r) {
      if (Status status = row(element, r, role.list); !status) return status;
      m_corners.clear();
      for (const double vertex : m_wantedList) {
        if (vertex == -1.0 || vertex == unsignedRestart)
          addShape(role.shape);
        else if (Status status = addCorner(name, r, vertex); !status)
          return status;
      }
      addShape(role.shape);
      if (m_raw.isTooLarge()) return tooManyError(m_origin);
    }
    return {};
  }

  /// Makes what it says of the corners, and forgets these.
  void addShape(PlyShape shape)
  {
    const std::vector<Index>& c = m_corners;
    for (std::size_t i = 2; i < c.size() && (shape == PlyShape::Strip || shape == PlyShape::Fan); ++i) {
      const Index a = shape == PlyShape::Fan ? c[0] : c[i - 2], b = c[i - 1];
      if (a == b || b == c[i] || c[i] == a) continue; // a stitch between two parts of the strip
      if (shape == PlyShape::Strip && i % 2 == 1)     // every other triangle is turned round
        m_raw.addTriangle(b, a, c[i]);
      else
        m_raw.addTriangle(a, b, c[i]);
    }
    if (shape == PlyShape::Polyline) m_raw.addPolyline(c);
    if (shape == PlyShape::Tetrahedron && c.size() == 4)
      m_raw.tetrahedra.insert(m_raw.tetrahedra.end(), c.begin(), c.end());
    else if (shape == PlyShape::Tetrahedron && !c.empty())
      ++m_otherCells;
    m_corners.clear();
  }

  Status passOver(const PlyElement& element, std::vector<std::string>& notes)
  {
    m_scalars.resize(element.properties.size());
    for (std::uint64_t r = 0; r < element.count; ++r)
      if (Status status = row(element, r, -1); !status) return status;
    notes.push_back(std::to_string(element.count) + " of the element '" + shortName(element) +
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

  const PlyHeader& m_header;
  Source m_source;
  const std::string& m_origin;
  RawMesh m_raw;
  std::vector<double> m_scalars, m_list, m_wantedList;
  std::vector<Index> m_corners;
  const PlyElement* m_vertexElement = nullptr; ///< of the header
  std::size_t m_thinFaces = 0, m_otherCells = 0;
  std::uint64_t m_vertexTotal = 0;
  WorkControl* m_control = nullptr;
};

bool recognisesPly(std::string_view bytes, std::string_view)
{
  bytes = withoutByteOrderMark(bytes);
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

Result<Mesh> readPly(std::string_view bytes, const std::string& origin, FileStory& story,
                     WorkControl* control)
{
  std::string& format = story.format;
  std::vector<std::string>& notes = story.notes;
  format = "PLY";
  const Result<PlyHeader> header = parsePlyHeader(bytes, origin);
  if (!header) return header.error();
  if (header->strayLines > 0)
    notes.push_back(std::to_string(header->strayLines) +
                    " header lines without the word comment were passed over (the first begins with '" +
                    header->firstStray + "').");
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
