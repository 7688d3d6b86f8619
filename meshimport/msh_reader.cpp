// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/msh_reader.h"

#include "core/base/ascii_case.h"
#include "core/base/text_encoding.h"
#include "meshimport/cells.h"
#include "meshimport/number_source.h"

#include <algorithm>
#include <array>

namespace esm {

namespace {

/// Tags of nodes, which may be any numbers in any order, to vertices in the order of the file.
class NodeTags {
public:
  void add(long long tag) { m_tags.push_back({tag, static_cast<Index>(m_tags.size())}); }
  void finish()
  {
    const auto byTag = [](const Entry& a, const Entry& b) { return a.tag < b.tag; };
    if (!std::is_sorted(m_tags.begin(), m_tags.end(), byTag))
      std::stable_sort(m_tags.begin(), m_tags.end(), byTag);
  }
  /// kNoIndex if no node has the tag.
  Index find(long long tag) const
  {
    if (m_tags.empty()) return kNoIndex;
    const auto guess =
      static_cast<std::uint64_t>(tag) - static_cast<std::uint64_t>(m_tags.front().tag); // tags without a gap
    if (tag >= m_tags.front().tag && guess < m_tags.size() && m_tags[guess].tag == tag)
      return m_tags[guess].vertex;
    const auto found =
      std::lower_bound(m_tags.begin(), m_tags.end(), tag,
                       [](const Entry& entry, long long wanted) { return entry.tag < wanted; });
    return found != m_tags.end() && found->tag == tag ? found->vertex : kNoIndex;
  }

private:
  struct Entry {
    long long tag;
    Index vertex;
  };
  std::vector<Entry> m_tags;
};

class MshParser {
  enum class Version { Unknown, One, Two, Four };

public:
  MshParser(std::string_view bytes, const std::string& origin, WorkControl* control)
    : m_source(bytes), m_origin(origin), m_control(control), m_cells(m_raw)
  {}

  Result<Mesh> run(std::string& format, std::vector<std::string>& notes)
  {
    while (m_source.skipToWord()) {
      const std::string section(m_source.word().substr(0, 40));
      if (section == "$NOD" || section == "$NOE") m_version = Version::One; // it has no line of its version
      Status status = section == "$MeshFormat"                                        ? meshFormat()
                      : section == "$Nodes" || section == "$NOD" || section == "$NOE" ? nodes()
                      : section == "$Elements" || section == "$ELM"                   ? elements()
                                                                                      : Status();
      if (stopWanted(m_control)) return cancelledError();
      if (!status) return status.error();
      if (section.substr(0, 1) == "$" && !equalIgnoringCase(section.substr(0, 4), "$End"))
        skipToEnd(section.substr(1));
      m_source.nextLine();
    }
    format = std::string("Gmsh ") +
             (m_version == Version::Four  ? "4.1"
              : m_version == Version::Two ? "2.2"
                                          : "1") +
             (m_source.binary ? " (binary)" : " (ASCII)");
    notes.insert(notes.end(), m_notes.begin(), m_notes.end());
    Result<Mesh> mesh = m_cells.finish(m_origin, notes, m_control);
    if (mesh || mesh.error().code != ErrorCode::EmptyResult) return mesh;
    return Error{mesh.error().code, mesh.error().detail + m_lostNodes + m_lostElements};
  }

private:
  Error wrong(const std::string& text) const
  {
    return fault(ErrorCode::BadFormat, m_origin, m_source.binary ? 0 : m_source.line(), text);
  }
  Error noNumber() const { return wrong(m_source.whyNoNumber()); }

  /// Sections end with "$End" and their name; those that are not read may hold anything.
  void skipToEnd(const std::string& name)
  {
    const std::string start = m_version == Version::One ? "$END" : "$End";
    const std::size_t size = m_source.rest().size(), end = std::min(size, m_source.rest().find(start + name));
    for (NumberSource line = m_source; !m_source.binary; m_source = line) { // lines are counted
      line.nextLine();
      if (line.atEnd() || line.rest().size() < size - end) break;
    }
    m_source.skipBytes(m_source.rest().size() - (size - end));
  }

  Status meshFormat()
  {
    double version = 0.0;
    long long isBinary = 0, size = 0;
    if (!m_source.skipToWord() || !m_source.number(version) || !m_source.integer(isBinary) ||
        !m_source.integer(size))
      return wrong("$MeshFormat needs version, type and size");
    m_version = version >= 4.1 ? Version::Four : Version::Two;
    if (!(version >= 2.0 && version < 3.0) && !(version >= 4.1 && version < 5.0))
      return fault(ErrorCode::Unsupported, m_origin, 0,
                   "this version of the Gmsh format is not read; save it in format 4.1 or 2.2");
    if (isBinary == 0) return {};
    if (size != 8)
      return fault(
        ErrorCode::Unsupported, m_origin, 0,
        "a binary Gmsh file needs sizes of 8 bytes; save it as text, or as binary in format 4.1 or 2.2");
    m_source.nextLine();
    if (m_source.rest().size() < 4) return noNumber();
    m_source.binary = std::endian::little;
    long long one = 0;
    m_source.next(Scalar::Int32, one);
    if (one != 1) m_source.binary = std::endian::big;
    return {};
  }

  /// Behind the line of the section's name, where a binary body begins.
  Status begin()
  {
    if (m_version == Version::Unknown) return wrong("the section $MeshFormat must come first");
    m_source.nextLine();
    return {};
  }
  template <std::size_t n>
  bool numbers(Scalar type, std::array<long long, n>& values)
  {
    return std::all_of(values.begin(), values.end(),
                       [&](long long& value) { return m_source.next(type, value); });
  }
  bool mayCome(long long items, std::size_t binaryBytes, std::size_t textBytes) const
  {
    const std::size_t least = m_source.binary ? binaryBytes : textBytes;
    return items >= 0 && static_cast<std::uint64_t>(items) <= (m_source.rest().size() + 1) / least;
  }
  Error tooMany(long long items, const char* what) const
  {
    return wrong("it promises " + std::to_string(items) + " " + what +
                 ", but the file is too small for them; it is cut short, fetch it again");
  }

  /// Says what is left between the promised items and the end of their section.
  /// @return the same for an error; empty if nothing is left
  std::string tellBehind(long long promised, const std::string& item)
  {
    if (m_source.binary) {
      std::string_view left = m_source.rest();
      left = left.substr(0, left.find("$End"));
      while (!left.empty() && (left.back() == '\n' || left.back() == '\r')) left.remove_suffix(1);
      if (!left.empty())
        m_notes.push_back(std::to_string(left.size()) + " bytes behind the last " + item +
                          " were passed over.");
      return {};
    }
    const std::string more = linesBehind(m_source, std::to_string(promised) + " promised " + item + "s", "$");
    if (more.empty()) return {};
    m_notes.push_back(more + ".");
    return "; " + more;
  }
  /// Format 4.1 states the sum of its blocks, too.
  void tellTotal(long long promised, long long there, const std::string& items)
  {
    if (promised != there)
      m_notes.push_back("The section promises " + std::to_string(promised) + " " + items + ", but " +
                        std::to_string(there) + " are there; all of these were read.");
  }

  Status nodes()
  {
    if (Status status = begin(); !status) return status;
    Status status = m_version == Version::Four ? newNodes() : oldNodes();
    if (status) m_lostNodes = tellBehind(m_raw.vertexCount(), "node");
    m_tags.finish();
    return status;
  }
  bool addNode(double x, double y, double z)
  {
    m_raw.addVertex(x, y, z, m_source.binary ? 0 : m_source.line());
    return !m_raw.isTooLarge();
  }

  Status oldNodes()
  {
    std::array<long long, 1> count{};
    if (m_source.binary) { // the count is text all the same
      if (!m_source.integer(count[0])) return noNumber();
      m_source.nextLine();
    } else if (!numbers(Scalar::Int32, count)) {
      return noNumber();
    }
    if (!mayCome(count[0], 28, 8)) return tooMany(count[0], "nodes");
    for (long long i = 0; i < count[0]; ++i) {
      if (i % 4096 == 0 && m_source.stopWanted(m_control)) return cancelledError();
      long long tag = 0;
      double p[3];
      if (!m_source.next(Scalar::Int32, tag) || !m_source.next(Scalar::Float64, p[0]) ||
          !m_source.next(Scalar::Float64, p[1]) || !m_source.next(Scalar::Float64, p[2]))
        return noNumber();
      m_tags.add(tag);
      if (!addNode(p[0], p[1], p[2])) return tooManyError(m_origin);
    }
    return {};
  }

  Status newNodes()
  {
    std::array<long long, 4> head{}; // blocks, nodes, smallest and largest tag
    if (!numbers(Scalar::UInt64, head)) return noNumber();
    if (!mayCome(head[0], 20, 8)) return tooMany(head[0], "blocks of nodes");
    for (long long block = 0; block < head[0]; ++block) {
      std::array<long long, 3> kind{}; // dimension, tag, with parameters
      std::array<long long, 1> count{};
      if (!numbers(Scalar::Int32, kind) || !numbers(Scalar::UInt64, count)) return noNumber();
      if (!mayCome(count[0], 32, 8)) return tooMany(count[0], "nodes");
      for (long long i = 0; i < count[0]; ++i) {
        std::array<long long, 1> tag{};
        if (!numbers(Scalar::UInt64, tag)) return noNumber();
        m_tags.add(tag[0]);
      }
      const long long parameters = kind[2] != 0 ? std::clamp(kind[0], 0LL, 3LL) : 0;
      for (long long i = 0; i < count[0]; ++i) {
        if (i % 4096 == 0 && m_source.stopWanted(m_control)) return cancelledError();
        double p[6] = {};
        for (long long k = 0; k < 3 + parameters; ++k)
          if (!m_source.next(Scalar::Float64, p[k])) return noNumber();
        if (!addNode(p[0], p[1], p[2])) return tooManyError(m_origin);
      }
    }
    tellTotal(head[1], m_raw.vertexCount(), "nodes");
    return {};
  }

  Status elements()
  {
    if (Status status = begin(); !status) return status;
    Status status = m_version == Version::Four  ? newElements()
                    : m_version == Version::Two ? oldElements()
                                                : firstElements();
    if (status) m_lostElements = tellBehind(m_elements, "element");
    return status;
  }

  Status oldElements()
  {
    std::array<long long, 1> count{};
    if (m_source.binary ? !m_source.integer(count[0]) : !numbers(Scalar::Int32, count)) return noNumber();
    if (m_source.binary) m_source.nextLine();
    if (!mayCome(count[0], 8, 8)) return tooMany(count[0], "elements");
    for (long long done = 0; done < count[0];) {
      // Text: number, type, count of tags, tags, nodes. Binary: type, how many follow, count of tags; then
      // each number, tags, nodes.
      std::array<long long, 3> head{};
      if (!numbers(Scalar::Int32, head)) return noNumber();
      const long long type = m_source.binary ? head[0] : head[1];
      const long long follow = m_source.binary ? head[1] : 1, tags = head[2];
      if (follow < 1 || follow > count[0] - done || tags < 0 || !mayCome(tags, 4, 2))
        return wrong("an element has impossible counts; the file is damaged");
      for (long long i = 0; i < follow; ++i, ++done) {
        const long long ahead = tags + (m_source.binary ? 1 : 0);
        for (long long k = 0; k < ahead; ++k) {
          std::array<long long, 1> passed{};
          if (!numbers(Scalar::Int32, passed)) return noNumber();
        }
        if (Status status = element(type, Scalar::Int32, done); !status) return status;
      }
    }
    return {};
  }

  /// Number, type, two regions, count of nodes, nodes.
  Status firstElements()
  {
    std::array<long long, 1> count{};
    if (!numbers(Scalar::Int32, count)) return noNumber();
    if (!mayCome(count[0], 12, 12)) return tooMany(count[0], "elements");
    for (long long i = 0; i < count[0]; ++i) {
      std::array<long long, 5> head{};
      if (!numbers(Scalar::Int32, head)) return noNumber();
      const std::optional<CellKind> kind = kindOf(head[1]);
      if (kind && kind->nodes != head[4])
        return wrong("element " + std::to_string(head[0]) + " has " + std::to_string(head[4]) +
                     " nodes, its type wants " + std::to_string(kind->nodes));
      if (Status status = element(head[1], Scalar::Int32, i); !status) return status;
    }
    return {};
  }

  Status newElements()
  {
    std::array<long long, 4> head{};
    if (!numbers(Scalar::UInt64, head)) return noNumber();
    if (!mayCome(head[0], 20, 8)) return tooMany(head[0], "blocks of elements");
    for (long long block = 0; block < head[0]; ++block) {
      std::array<long long, 3> kind{}; // dimension, tag, type
      std::array<long long, 1> count{}, tag{};
      if (!numbers(Scalar::Int32, kind) || !numbers(Scalar::UInt64, count)) return noNumber();
      if (!mayCome(count[0], 16, 4)) return tooMany(count[0], "elements");
      for (long long i = 0; i < count[0]; ++i) {
        if (!numbers(Scalar::UInt64, tag)) return noNumber();
        if (Status status = element(kind[2], Scalar::UInt64, i); !status) return status;
      }
    }
    tellTotal(head[1], m_elements, "elements");
    return {};
  }

  static std::optional<CellKind> kindOf(long long type)
  {
    return type > 0 && type < 1000 ? gmshElement(static_cast<int>(type)) : std::nullopt;
  }
  Status element(long long type, Scalar nodeType, long long number)
  {
    if (number % 4096 == 0 && m_source.stopWanted(m_control)) return cancelledError();
    const std::optional<CellKind> kind = kindOf(type);
    if (!kind)
      return fault(ErrorCode::Unsupported, m_origin, m_source.binary ? 0 : m_source.line(),
                   "elements of type " + std::to_string(type) +
                     " are not read; save the mesh with simpler ones");
    m_nodes.clear();
    for (int k = 0; k < kind->nodes; ++k) {
      long long tag = 0;
      if (!m_source.next(nodeType, tag)) return noNumber();
      const Index vertex = m_tags.find(tag);
      if (vertex == kNoIndex)
        return fault(ErrorCode::InvalidValue, m_origin, m_source.binary ? 0 : m_source.line(),
                     "there is no node " + std::to_string(tag) + ", but an element uses it" + m_lostNodes);
      m_nodes.push_back(vertex);
    }
    m_cells.add(*kind, m_nodes);
    ++m_elements;
    return m_raw.isTooLarge() ? Status(tooManyError(m_origin)) : Status();
  }

  NumberSource m_source;
  const std::string& m_origin;
  WorkControl* m_control;
  RawMesh m_raw;
  CellCollector m_cells;
  NodeTags m_tags;
  std::vector<Index> m_nodes;              ///< of the current element
  long long m_elements = 0;                ///< that were read
  std::string m_lostNodes, m_lostElements; ///< what stood behind the promised ones
  std::vector<std::string> m_notes;        ///< for the user, if the file can be read
  Version m_version = Version::Unknown;
};

bool recognisesMsh(std::string_view bytes, std::string_view)
{
  bytes = withoutByteOrderMark(bytes);
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return false;
  const std::string_view start = bytes.substr(first, 20);
  return start.substr(0, 11) == "$MeshFormat" || start.substr(0, 4) == "$NOD" ||
         start.substr(0, 4) == "$NOE" || start.substr(0, 9) == "$Comments";
}

Result<Mesh> readMsh(std::string_view bytes, const std::string& origin, FileStory& story,
                     WorkControl* control)
{
  std::string& format = story.format;
  std::vector<std::string>& notes = story.notes;
  format = "Gmsh";
  return MshParser(bytes, origin, control).run(format, notes);
}

} // namespace

MeshReader mshReader()
{
  return {"Gmsh", recognisesMsh, readMsh};
}

} // namespace esm
