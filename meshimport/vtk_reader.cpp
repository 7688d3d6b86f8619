// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/vtk_reader.h"

#include "core/base/ascii_case.h"
#include "core/base/text_encoding.h"
#include "core/base/text_number.h"
#include "meshimport/cells.h"
#include "meshimport/number_source.h"
#include "meshimport/stated_frame.h"

#include <utility>

namespace esm {

namespace {

/// What VTK itself writes in its files; it has 4 bytes for a vtkIdType there, whatever it has in memory.
std::optional<Scalar> vtkScalar(std::string_view name)
{
  using enum Scalar;
  constexpr std::pair<std::string_view, Scalar> kScalars[] = {{"float", Float32},
                                                              {"double", Float64},
                                                              {"int", Int32},
                                                              {"unsigned_int", UInt32},
                                                              {"short", Int16},
                                                              {"unsigned_short", UInt16},
                                                              {"char", Int8},
                                                              {"unsigned_char", UInt8},
                                                              {"vtktypeint64", Int64},
                                                              {"vtkIdType", Int32},
                                                              {"long", Int64},
                                                              {"unsigned_long", UInt64},
                                                              {"vtktypeuint64", UInt64},
                                                              {"vtktypeint32", Int32},
                                                              {"signed_char", Int8},
                                                              {"vtktypeuint32", UInt32},
                                                              {"vtktypeint16", Int16},
                                                              {"vtktypeuint16", UInt16},
                                                              {"vtktypeint8", Int8},
                                                              {"vtktypeuint8", UInt8},
                                                              {"vtktypefloat32", Float32},
                                                              {"vtktypefloat64", Float64}};
  for (const auto& [known, type] : kScalars)
    if (equalIgnoringCase(name, known)) return type;
  return std::nullopt;
}

/// Cells one after the other: cell i has the nodes from end[i - 1] up to end[i] of `nodes`.
struct CellList {
  std::vector<long long> nodes;
  std::vector<std::size_t> end;
};

class VtkParser {
public:
  VtkParser(std::string_view bytes, const std::string& origin, WorkControl* control)
    : m_source(bytes), m_origin(origin), m_control(control), m_cells(m_raw)
  {}

  Result<Mesh> run(FileStory& story)
  {
    if (Status status = header(story.format); !status) return status.error();
    while (m_source.skipToWord()) {
      const std::string keyword(m_source.word().substr(0, 40));
      const auto is = [&keyword](std::string_view word) { return equalIgnoringCase(keyword, word); };
      if (is("POINT_DATA") || is("CELL_DATA")) break; // nothing of ours comes behind
      if (is("METADATA")) {
        metadata(m_components);
        continue;
      }
      Status status = is("POINTS")            ? points()
                      : is("VERTICES")        ? list(1)
                      : is("LINES")           ? list(4)
                      : is("POLYGONS")        ? list(7)
                      : is("TRIANGLE_STRIPS") ? list(6)
                      : is("CELLS")           ? cells()
                      : is("CELL_TYPES")      ? cellTypes()
                      : is("FIELD")           ? field()
                                              : unknown(keyword);
      if (stopWanted(m_control)) return cancelledError();
      if (!status) return status.error();
    }
    if (!m_list.end.empty() && !m_hasTypes)
      return wrong("its cells have no CELL_TYPES; it is cut short, fetch it again");
    if (!m_axes.empty()) stateAxes(story.stated, m_axes);
    if (m_hasUnreadAxes) story.notes.push_back(unreadAxes("they are no string"));
    return m_cells.finish(m_origin, story.notes, m_control);
  }

private:
  Error wrong(const std::string& text) const
  {
    return fault(ErrorCode::BadFormat, m_origin, m_source.binary ? 0 : m_source.line(), text);
  }
  Error noNumber() const { return wrong(m_source.whyNoNumber()); }

  Status header(std::string& format)
  {
    m_source.nextLine(); // the magic
    m_source.nextLine(); // a title
    m_source.skipToWord();
    const std::string_view encoding = m_source.word();
    if (equalIgnoringCase(encoding, "BINARY")) {
      m_source.binary = std::endian::big;
    } else if (!equalIgnoringCase(encoding, "ASCII")) {
      return wrong("the third line of a VTK file says ASCII or BINARY");
    }
    format = m_source.binary ? "VTK (binary)" : "VTK (ASCII)";
    m_source.skipToWord();
    if (!equalIgnoringCase(m_source.word(), "DATASET")) return wrong("a VTK file goes on with DATASET");
    const std::string kind(m_source.word().substr(0, 40));
    if (!equalIgnoringCase(kind, "POLYDATA") && !equalIgnoringCase(kind, "UNSTRUCTURED_GRID"))
      return fault(ErrorCode::Unsupported, m_origin, m_source.line(),
                   "a VTK data set '" + kind +
                     "' is no mesh of cells; extract its surface and save that as POLYDATA");
    m_source.nextLine();
    return {};
  }

  Status unknown(const std::string& keyword)
  {
    return wrong(parseForeignDouble(keyword)
                   ? "'" + keyword + "' stands behind as many numbers as were promised; is a count too small?"
                   : "'" + keyword + "' is no part of a VTK mesh; is the file damaged?");
  }
  /// Annotations of the array before, up to an empty line; but components without a name have one, too.
  void metadata(std::uint64_t components)
  {
    for (m_source.nextLine(); !m_source.atEnd() && !m_source.atLineEnd(); m_source.nextLine()) {
      if (!equalIgnoringCase(m_source.word(), "COMPONENT_NAMES")) continue;
      for (std::uint64_t i = 0; i < components && !m_source.atEnd(); ++i) m_source.nextLine();
    }
  }

  /// FIELD name n, then n times: name, components, tuples, type and the values.
  Status field()
  {
    m_source.word();
    const Result<std::uint64_t> arrays = count();
    if (!arrays) return arrays.error();
    std::uint64_t componentsBefore = 0;
    for (std::uint64_t i = 0; i < *arrays;) {
      if (!m_source.skipToWord()) return noNumber();
      const std::string name(m_source.word().substr(0, 40));
      if (name == "METADATA" && i > 0) {
        metadata(componentsBefore);
        continue;
      }
      ++i;
      if (name == "NULL_ARRAY") continue;
      const Result<std::uint64_t> components = count();
      if (!components) return components.error();
      const Result<std::uint64_t> tuples = count();
      if (!tuples) return tuples.error();
      const std::string type(m_source.word().substr(0, 40));
      m_source.nextLine();
      if (*components > kMostItems || *tuples > kMostItems) return tooSmall(*tuples, "values of a field");
      const NumberSource values = m_source;
      if (Status status = passValues(type, *components * *tuples); !status) return status;
      if (name == kAxesArray && *components * *tuples > 0) readAxes(values, type, *components * *tuples);
      componentsBefore = *components;
    }
    // What comes behind the last array belongs to it.
    NumberSource look = m_source;
    if (look.skipToWord() && look.word() == "METADATA") {
      m_source = look;
      metadata(componentsBefore);
    }
    return {};
  }

  /// The axes that 3D Slicer names there: the first string, or letters as numbers.
  void readAxes(NumberSource values, const std::string& type, std::uint64_t count)
  {
    const auto is = [&type](std::string_view word) { return equalIgnoringCase(type, word); };
    const std::optional<Scalar> scalar = vtkScalar(type);
    if ((is("string") || is("utf8_string")) && values.binary) {
      m_axes = passString(values).value_or(std::string_view());
    } else if (is("string") || is("utf8_string")) {
      m_axes = values.word().substr(0, 4);
    } else if (scalar && scalarSize(*scalar) == 1) {
      long long letter = 0;
      while (count-- > 0 && m_axes.size() < 4 && values.next(*scalar, letter) && letter > 32 && letter < 127)
        m_axes += static_cast<char>(letter);
    } else {
      m_hasUnreadAxes = true;
    }
  }

  Status passValues(const std::string& type, std::uint64_t values)
  {
    const auto is = [&type](std::string_view word) { return equalIgnoringCase(type, word); };
    const bool isString = is("string") || is("utf8_string");
    const std::optional<Scalar> scalar = vtkScalar(type);
    if (is("variant") || (isString && !m_source.binary)) {
      for (std::uint64_t i = 0; i < values; ++i, m_source.nextLine())
        if (m_source.atEnd()) return noNumber();
    } else if (isString) {
      for (std::uint64_t i = 0; i < values; ++i)
        if (!passString(m_source)) return noNumber();
    } else if (is("bit") && m_source.binary) {
      if (!passBytes(m_source, (values + 7) / 8)) return noNumber();
    } else if (scalar || is("bit")) {
      if (!m_source.hasRoomFor(values, scalar.value_or(Scalar::UInt8)))
        return tooSmall(values, "values of a field");
      double value = 0.0;
      for (std::uint64_t k = values; k > 0; --k)
        if (!m_source.next(scalar.value_or(Scalar::UInt8), value)) return noNumber();
    } else {
      return fault(ErrorCode::Unsupported, m_origin, m_source.line(),
                   "field data of the type '" + type +
                     "' before the points is not read; save the file without it");
    }
    return {};
  }
  static bool passBytes(NumberSource& source, std::uint64_t bytes)
  {
    if (bytes > source.rest().size()) return false;
    source.skipBytes(bytes);
    return true;
  }
  /// In binary files a string begins with its length, in as many bytes as the two highest bits say.
  static std::optional<std::string_view> passString(NumberSource& source)
  {
    const std::string_view bytes = source.rest();
    if (bytes.empty()) return std::nullopt;
    const std::size_t size = std::size_t{1} << (3 - (static_cast<unsigned char>(bytes[0]) >> 6));
    if (bytes.size() < size) return std::nullopt;
    std::uint64_t length = static_cast<unsigned char>(bytes[0]) & 0x3Fu;
    for (std::size_t i = 1; i < size; ++i) length = length << 8 | static_cast<unsigned char>(bytes[i]);
    source.skipBytes(size);
    return passBytes(source, length) ? std::optional(bytes.substr(size, length)) : std::nullopt;
  }

  Result<std::uint64_t> count()
  {
    long long count = 0;
    if (!m_source.integer(count) || count < 0) return wrong("a count from 0 is missing");
    return static_cast<std::uint64_t>(count);
  }
  Error tooSmall(std::uint64_t count, const char* what) const
  {
    return wrong("it promises " + std::to_string(count) + " " + what +
                 ", but the file is too small for them; it is cut short, fetch it again");
  }

  Status points()
  {
    const Result<std::uint64_t> points = count();
    if (!points) return points.error();
    const std::optional<Scalar> type = vtkScalar(m_source.word());
    if (!type) return wrong("the points have a type that VTK does not know");
    m_source.nextLine();
    if (*points > kMostItems / 3 || !m_source.hasRoomFor(3 * *points, *type))
      return tooSmall(*points, "points");
    m_raw.vertices.reserve(static_cast<Eigen::Index>(*points));
    for (std::uint64_t i = 0; i < *points; ++i) {
      if (i % 4096 == 0 && m_source.stopWanted(m_control)) return cancelledError();
      double p[3];
      for (double& coordinate : p)
        if (!m_source.next(*type, coordinate)) return noNumber();
      m_raw.addVertex(p[0], p[1], p[2], m_source.binary ? 0 : m_source.line());
    }
    m_components = 3;
    return {};
  }

  /// CELLS n size, then as version 1 to 4 "count, nodes" n times, or as version 5 offsets and nodes apart.
  Status readList(CellList& list)
  {
    m_components = 1;
    const Result<std::uint64_t> cells = count();
    if (!cells) return cells.error();
    const Result<std::uint64_t> size = count();
    if (!size) return size.error();
    m_source.nextLine();
    NumberSource look = m_source;
    if (look.skipToWord() && equalIgnoringCase(look.word(), "OFFSETS"))
      return offsetList(*cells, *size, list);
    if (*size > kMostItems || !m_source.hasRoomFor(*size, Scalar::Int32)) return tooSmall(*size, "numbers");
    std::vector<long long> numbers;
    if (!m_source.numbers(Scalar::Int32, *size, numbers, m_control)) return noNumber();
    for (std::size_t at = 0; at < numbers.size();) {
      const long long corners = numbers[at++];
      if (corners < 0 || static_cast<std::uint64_t>(corners) > numbers.size() - at)
        return wrong("a cell has an impossible number of nodes; the file is damaged");
      list.nodes.insert(list.nodes.end(), numbers.begin() + static_cast<std::ptrdiff_t>(at),
                        numbers.begin() + static_cast<std::ptrdiff_t>(at) + corners);
      list.end.push_back(list.nodes.size());
      at += static_cast<std::size_t>(corners);
    }
    if (list.end.size() != *cells)
      return wrong("it promises " + std::to_string(*cells) + " cells, but it has " +
                   std::to_string(list.end.size()) + "; the file is damaged");
    return {};
  }

  Status offsetList(std::uint64_t offsets, std::uint64_t size, CellList& list)
  {
    std::vector<long long> end;
    for (const bool isOffsets : {true, false}) {
      m_source.skipToWord();
      if (!equalIgnoringCase(m_source.word(), isOffsets ? "OFFSETS" : "CONNECTIVITY"))
        return wrong(
          m_source.atEnd()
            ? "it ends before OFFSETS and CONNECTIVITY of the cells; it is cut short, fetch it again"
            : "OFFSETS and CONNECTIVITY of the cells are missing; is the file damaged?");
      const std::optional<Scalar> type = vtkScalar(m_source.word());
      if (!type) return wrong("the cells have a type that VTK does not know");
      m_source.nextLine();
      const std::uint64_t count = isOffsets ? offsets : size;
      if (count > kMostItems || !m_source.hasRoomFor(count, *type)) return tooSmall(count, "numbers");
      if (!m_source.numbers(*type, count, isOffsets ? end : list.nodes, m_control)) return noNumber();
    }
    for (std::size_t i = 0; i < end.size(); ++i) {
      const long long before = i > 0 ? end[i - 1] : 0;
      if (end[i] < before || static_cast<std::uint64_t>(end[i]) > size || (i == 0 && end[i] != 0))
        return wrong("the offsets of its cells are impossible; the file is damaged");
      if (i > 0) list.end.push_back(static_cast<std::size_t>(end[i]));
    }
    return {};
  }

  Status list(int vtkType)
  {
    CellList list;
    if (Status status = readList(list); !status) return status;
    return addCells(list, [vtkType](std::size_t) { return vtkType; });
  }

  Status cells()
  {
    m_list = {};
    return readList(m_list);
  }

  Status cellTypes()
  {
    const Result<std::uint64_t> cells = count();
    if (!cells) return cells.error();
    m_source.nextLine();
    std::vector<int> types;
    if (*cells != m_list.end.size())
      return wrong("it has " + std::to_string(*cells) + " CELL_TYPES for " +
                   std::to_string(m_list.end.size()) + " CELLS; the file is damaged");
    if (!m_source.numbers(Scalar::Int32, *cells, types, m_control)) return noNumber();
    m_hasTypes = true;
    return addCells(m_list, [&types](std::size_t i) { return types[i]; });
  }

  template <class TypeOf>
  Status addCells(const CellList& list, const TypeOf& typeOf)
  {
    std::size_t begin = 0;
    std::vector<Index> nodes;
    for (std::size_t i = 0; i < list.end.size(); begin = list.end[i++]) {
      if (stopWantedAt(i, list.end.size(), m_control)) return cancelledError();
      const std::optional<CellKind> kind = vtkCell(typeOf(i));
      if (!kind)
        return fault(ErrorCode::Unsupported, m_origin, 0,
                     "cells of the VTK type " + std::to_string(typeOf(i)) +
                       " are not read; triangulate them first");
      const std::size_t count = list.end[i] - begin;
      if (kind->nodes > 0 && count != static_cast<std::size_t>(kind->nodes))
        return wrong("cell " + std::to_string(i) + " has " + std::to_string(count) +
                     " nodes, its type wants " + std::to_string(kind->nodes));
      nodes.clear();
      for (std::size_t k = begin; k < list.end[i]; ++k) {
        if (list.nodes[k] < 0 || list.nodes[k] >= m_raw.vertexCount())
          return fault(ErrorCode::InvalidValue, m_origin, 0,
                       "there is no point " + std::to_string(list.nodes[k]) + ", the file has points 0 to " +
                         std::to_string(m_raw.vertexCount() - 1));
        nodes.push_back(static_cast<Index>(list.nodes[k]));
      }
      m_cells.add(*kind, nodes);
    }
    return {};
  }

  NumberSource m_source;
  const std::string& m_origin;
  WorkControl* m_control;
  RawMesh m_raw;
  CellCollector m_cells;
  CellList m_list;                ///< of an unstructured grid, until its types come
  std::uint64_t m_components = 1; ///< of the array that was read last
  bool m_hasTypes = false;
  std::string m_axes; ///< of a patient, by the field data
  bool m_hasUnreadAxes = false;
};

bool recognisesVtk(std::string_view bytes, std::string_view)
{
  bytes = withoutByteOrderMark(bytes);
  return equalIgnoringCase(bytes.substr(0, 14), "# vtk DataFile");
}

Result<Mesh> readVtk(std::string_view bytes, const std::string& origin, FileStory& story,
                     WorkControl* control)
{
  story.format = "VTK";
  return VtkParser(bytes, origin, control).run(story);
}

} // namespace

MeshReader vtkReader()
{
  return {"VTK", recognisesVtk, readVtk};
}

} // namespace esm
