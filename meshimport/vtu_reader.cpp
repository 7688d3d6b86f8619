// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/vtu_reader.h"

#include "core/base/text_number.h"
#include "meshimport/cells.h"
#include "meshimport/stated_frame.h"
#include "meshimport/vtu_arrays.h"
#include "meshimport/xml_tags.h"

namespace esm {

namespace {

struct Piece {
  XmlTag tag;
  long long points = 0;
  std::vector<VtuArray> arrays;
};

bool isGeometry(std::string_view section)
{
  return section == "Points" || section == "Cells" || section == "Lines" || section == "Polys" ||
         section == "Strips" || section == "Verts";
}
bool isSection(std::string_view tag)
{
  return isGeometry(tag) || tag == "PointData" || tag == "CellData" || tag == "FieldData";
}

class VtuParser {
public:
  VtuParser(std::string_view bytes, const std::string& origin, WorkControl* control)
    : m_bytes(bytes), m_origin(origin), m_control(control), m_cells(m_raw)
  {}

  Result<Mesh> run(FileStory& story)
  {
    if (Status status = outline(); !status) return status.error();
    story.format = m_isGrid ? "VTU" : "VTP";
    readAxes(story);
    for (std::size_t i = 0; i < m_pieces.size(); ++i) {
      tellDone(m_control, static_cast<double>(i) / static_cast<double>(m_pieces.size()));
      if (Status status = piece(m_pieces[i]); !status) return status.error();
    }
    story.notes.insert(story.notes.end(), m_notes.begin(), m_notes.end());
    return m_cells.finish(m_origin, story.notes, m_control);
  }

private:
  Error wrong(const std::string& text) const { return fault(ErrorCode::BadFormat, m_origin, 0, text); }
  Error unsupported(const std::string& text) const
  {
    return fault(ErrorCode::Unsupported, m_origin, 0, text);
  }

  /// Where everything is; decodes nothing yet.
  Status outline()
  {
    XmlTags tags(m_bytes);
    XmlTag tag;
    std::string_view section;
    bool isWhole = false;
    while (tags.next(tag)) {
      if (tag.name == "VTKFile") {
        isWhole = isWhole || tag.isEnd;
        if (!tag.isEnd)
          if (Status status = fileTag(tag); !status) return status;
      } else if (tag.name == "Piece" && !tag.isEnd) {
        m_pieces.push_back({tag, parseInteger(tag.attribute("NumberOfPoints")).value_or(-1), {}});
      } else if ((tag.name == "Array" || tag.name == "DataArray") && section == "FieldData" && !tag.isEnd &&
                 tag.attribute("Name") == kAxesArray) {
        m_axes = arrayOf(tag, tags, section, vtuScalar(tag.attribute("type")).value_or(Scalar::UInt8));
      } else if (tag.name == "DataArray" && !tag.isEnd) {
        if (Status status = arrayTag(tag, section, tags); !status) return status;
      } else if (tag.name == "AppendedData") {
        m_storage.isAppendedBase64 = tag.attribute("encoding") == "base64";
        const std::size_t mark = m_bytes.find('_', tags.position());
        if (mark != std::string_view::npos) m_storage.appended = m_bytes.substr(mark + 1);
        isWhole = true; // raw bytes follow, which are no XML
        break;
      } else if (!tag.isEnd && isSection(tag.name)) { // others may stand within arrays
        section = tag.name;
      }
    }
    return isWhole ? Status()
                   : Status(wrong("it has no </VTKFile> at its end; it is cut short, fetch it again"));
  }

  Status fileTag(const XmlTag& tag)
  {
    const std::string type(tag.attribute("type").substr(0, 40));
    if (type != "UnstructuredGrid" && type != "PolyData")
      return unsupported("a VTK file of the type '" + type + "' is no mesh of cells; save it as VTU or VTP");
    m_isGrid = type == "UnstructuredGrid";
    if (tag.attribute("byte_order") == "BigEndian") m_storage.order = std::endian::big;
    if (tag.attribute("header_type") == "UInt64") m_storage.headerType = Scalar::UInt64;
    const std::string_view compressor = tag.attribute("compressor");
    m_storage.isZipped = compressor == "vtkZLibDataCompressor";
    if (!compressor.empty() && !m_storage.isZipped)
      return unsupported("its compressor " + std::string(compressor.substr(0, 40)) +
                         " is not read; save it with zlib or without compression");
    return {};
  }

  Status arrayTag(const XmlTag& tag, std::string_view section, const XmlTags& tags)
  {
    if (m_pieces.empty()) return {}; // data of the field, such as the time
    if (!isGeometry(section)) return {};
    const std::optional<Scalar> type = vtuScalar(tag.attribute("type"));
    if (!type) return wrong("an array has a type that VTK does not know");
    const std::optional<VtuArray> array = arrayOf(tag, tags, section, *type);
    if (!array) return wrong("an array begins before the data");
    m_pieces.back().arrays.push_back(*array);
    return {};
  }

  /// None if it begins before the data.
  static std::optional<VtuArray> arrayOf(const XmlTag& tag, const XmlTags& tags, std::string_view section,
                                         Scalar type)
  {
    VtuArray array;
    array.section = section;
    array.name = tag.attribute("Name");
    array.type = type;
    const std::string_view format = tag.attribute("format");
    array.format = format == "appended" ? VtuArray::Format::Appended
                   : format == "binary" ? VtuArray::Format::Binary
                                        : VtuArray::Format::Ascii;
    const long long offset = parseInteger(tag.attribute("offset")).value_or(0);
    if (offset < 0) return std::nullopt;
    array.offset = static_cast<std::uint64_t>(offset);
    if (!tag.isEmpty) array.content = tags.content();
    return array;
  }

  /// The axes in the field data: letters up to a 0, an array of bytes if its type is String.
  void readAxes(FileStory& story) const
  {
    if (!m_axes) return;
    const Result<std::vector<long long>> letters = vtuIntegers(*m_axes, m_storage);
    if (!letters) {
      story.notes.push_back(unreadAxes(letters.error().detail));
      return;
    }
    std::string name;
    for (const long long letter : *letters) {
      if (letter <= 32 || letter >= 127 || name.size() > 3) break;
      name += static_cast<char>(letter);
    }
    stateAxes(story.stated, name);
  }

  static const VtuArray* find(const Piece& piece, std::string_view section, std::string_view name)
  {
    for (const VtuArray& array : piece.arrays)
      if (array.section == section && (name.empty() || array.name == name)) return &array;
    return nullptr;
  }
  Error named(const Error& error) const { return fault(error.code, m_origin, 0, error.detail); }

  Status piece(const Piece& piece)
  {
    if (stopWanted(m_control)) return cancelledError();
    m_first = m_raw.vertexCount();
    const VtuArray* points = find(piece, "Points", "");
    if (piece.points != 0 && !points) return wrong("it has no Points");
    if (points) {
      const Result<std::vector<double>> values = vtuNumbers(*points, m_storage);
      if (!values) return named(values.error());
      if (piece.points < 0 || values->size() != 3 * static_cast<std::uint64_t>(piece.points))
        return wrong("it promises " + std::to_string(piece.points) + " points, but it has " +
                     std::to_string(values->size() / 3) + "; the file is damaged");
      if (3 * static_cast<std::size_t>(m_raw.vertexCount()) + values->size() > kMostItems)
        return tooManyError(m_origin);
      for (std::size_t i = 0; i < values->size(); i += 3)
        m_raw.addVertex((*values)[i], (*values)[i + 1], (*values)[i + 2], 0);
    }
    if (m_isGrid) return cells(piece, "Cells", 0);
    constexpr std::pair<const char*, int> kLists[] = {
      {"Verts", 2}, {"Lines", 4}, {"Polys", 7}, {"Strips", 6}};
    for (const auto& [section, type] : kLists)
      if (Status status = cells(piece, section, type); !status) return status;
    return {};
  }

  /// A count that the piece states, as many leave it out, and that its arrays do not keep.
  void tellCount(const Piece& piece, std::string_view section, std::size_t there)
  {
    const std::string attribute = "NumberOf" + std::string(section);
    const std::optional<long long> promised = parseInteger(piece.tag.attribute(attribute));
    if (promised && *promised != static_cast<long long>(there))
      m_notes.push_back("The attribute " + attribute + " promises " + std::to_string(*promised) +
                        " cells, but " + std::to_string(there) + " are there; all of these were read.");
  }

  /// @param vtkType of all cells; 0 to read them from the array "types"
  Status cells(const Piece& piece, std::string_view section, int vtkType)
  {
    const VtuArray* const arrays[] = {find(piece, section, "connectivity"), find(piece, section, "offsets"),
                                      find(piece, section, "types")};
    if (!arrays[0] && !arrays[1]) tellCount(piece, section, 0);
    if (!arrays[0] && !arrays[1])
      return vtkType > 0 || piece.points == 0 ? Status() : Status(wrong("it has no Cells"));
    if (!arrays[0] || !arrays[1] || (vtkType == 0 && !arrays[2]))
      return wrong("its cells lack connectivity, offsets or types");
    std::vector<long long> lists[3];
    for (int i = 0; i < (vtkType == 0 ? 3 : 2); ++i) {
      Result<std::vector<long long>> values = vtuIntegers(*arrays[i], m_storage);
      if (!values) return named(values.error());
      lists[i] = std::move(*values);
    }
    const auto& [nodes, ends, types] = lists;
    tellCount(piece, section, ends.size());
    if (vtkType == 0 && types.size() != ends.size())
      return wrong("it has " + std::to_string(types.size()) + " types for " + std::to_string(ends.size()) +
                   " offsets of its cells; the file is damaged");
    long long begin = 0;
    for (std::size_t i = 0; i < ends.size(); begin = ends[i++]) {
      if (stopWantedAt(i, ends.size(), m_control)) return cancelledError();
      if (ends[i] < begin || static_cast<std::uint64_t>(ends[i]) > nodes.size())
        return wrong("the offsets of its cells are impossible; the file is damaged");
      const long long type = vtkType > 0 ? vtkType : types[i];
      if (Status status = cell(type, nodes, begin, ends[i]); !status) return status;
    }
    return {};
  }

  Status cell(long long type, const std::vector<long long>& nodes, long long begin, long long end)
  {
    const std::optional<CellKind> kind =
      type > 0 && type < 256 ? vtkCell(static_cast<int>(type)) : std::nullopt;
    if (!kind)
      return unsupported("cells of the VTK type " + std::to_string(type) +
                         " are not read; triangulate them first");
    if (kind->nodes > 0 && end - begin != kind->nodes)
      return wrong("a cell has " + std::to_string(end - begin) + " nodes, its type wants " +
                   std::to_string(kind->nodes));
    const Index points = m_raw.vertexCount() - m_first;
    m_nodes.clear();
    for (long long k = begin; k < end; ++k) {
      const long long node = nodes[static_cast<std::size_t>(k)];
      if (node < 0 || node >= points)
        return fault(ErrorCode::InvalidValue, m_origin, 0,
                     "there is no point " + std::to_string(node) + ", its piece has points 0 to " +
                       std::to_string(points - 1));
      m_nodes.push_back(m_first + static_cast<Index>(node));
    }
    m_cells.add(*kind, m_nodes);
    return m_raw.isTooLarge() ? Status(tooManyError(m_origin)) : Status();
  }

  std::string_view m_bytes;
  const std::string& m_origin;
  WorkControl* m_control;
  VtuStorage m_storage;
  std::optional<VtuArray> m_axes; ///< of a patient, as 3D Slicer writes them
  std::vector<Piece> m_pieces;
  bool m_isGrid = true;
  RawMesh m_raw;
  CellCollector m_cells;
  Index m_first = 0; ///< vertex of the current piece
  std::vector<Index> m_nodes;
  std::vector<std::string> m_notes; ///< for the user, if the file can be read
};

bool recognisesVtu(std::string_view bytes, std::string_view)
{
  XmlTags tags(bytes.substr(0, 4096));
  XmlTag tag;
  return bytes.substr(0, 64).find('<') != std::string_view::npos && tags.next(tag) && tag.name == "VTKFile";
}

Result<Mesh> readVtu(std::string_view bytes, const std::string& origin, FileStory& story,
                     WorkControl* control)
{
  story.format = "VTU";
  return VtuParser(bytes, origin, control).run(story);
}

} // namespace

MeshReader vtuReader()
{
  return {"VTU", recognisesVtu, readVtu};
}

} // namespace esm
