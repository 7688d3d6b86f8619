// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/stl_reader.h"

#include "core/base/ascii_case.h"
#include "core/base/large_pages.h"
#include "meshimport/byte_order.h"
#include "meshimport/content.h"
#include "meshimport/raw_mesh.h"
#include "meshimport/text_cursor.h"

#include <cmath>

namespace esm {

namespace {

// Binary: 80 bytes of free text, the count of facets, then per facet a normal and three corners as twelve
// floats and two spare bytes; all little-endian.
constexpr std::size_t kHeader = 84, kFacet = 50, kFirstCorner = 12;

std::uint64_t facetCount(std::string_view bytes)
{
  return loadLittle<std::uint32_t>(bytes.data() + 80);
}

/// Exact size proves a binary STL; a text would need half a billion facets, for four letters are that many.
bool hasBinarySize(std::string_view bytes)
{
  return bytes.size() >= kHeader && bytes.size() == kHeader + kFacet * facetCount(bytes);
}

bool isAscii(std::string_view bytes)
{
  if (hasBinarySize(bytes) || !looksLikeText(bytes)) return false;
  TextCursor cursor(bytes);
  while (!cursor.atEnd() && cursor.atLineEnd()) cursor.nextLine();
  return equalIgnoringCase(cursor.word(), "solid");
}

bool recognisesStl(std::string_view bytes, std::string_view ending)
{
  if (hasBinarySize(bytes) || isAscii(bytes)) return true;
  // Cut short or too long, but by its name an STL and by its bytes nothing else.
  return ending == "stl" && !looksLikeText(bytes) && describeForeign(bytes).empty() &&
         betrayedEnding(bytes).empty();
}

Result<Mesh> readBinary(std::string_view bytes, const std::string& origin, std::vector<std::string>& notes,
                        WorkControl* control)
{
  if (bytes.size() < kHeader)
    return fault(ErrorCode::BadFormat, origin, 0,
                 "it has " + std::to_string(bytes.size()) +
                   " bytes, less than the 84 of a binary STL header; it is cut short");
  const std::uint64_t facets = facetCount(bytes), wanted = kHeader + kFacet * facets;
  if (bytes.size() < wanted)
    return fault(ErrorCode::BadFormat, origin, 0,
                 "its header promises " + std::to_string(facets) + " facets in " + std::to_string(wanted) +
                   " bytes, but it has " + std::to_string(bytes.size()) +
                   "; it is cut short or no STL, fetch it again");
  if (12 * facets > kMostItems) return tooManyError(origin);
  if (bytes.size() > wanted)
    notes.push_back(std::to_string(bytes.size() - wanted) + " bytes behind the last facet were passed over.");

  Mesh mesh;
  mesh.position.resize(3, static_cast<Eigen::Index>(3 * facets));
  mesh.triangles.resize(3, static_cast<Eigen::Index>(facets));
  useLargePages(mesh.position);
  useLargePages(mesh.triangles);
  double* coordinate = mesh.position.data();
  Index* corner = mesh.triangles.data();
  const char* facet = bytes.data() + kHeader;
  for (Index f = 0; f < mesh.triangleCount(); ++f, facet += kFacet) {
    if (stopWantedAt(static_cast<std::size_t>(f), facets, control)) return cancelledError();
    double sum = 0.0; // becomes NaN or infinite with any of the nine
    for (std::size_t k = 0; k < 9; ++k) {
      coordinate[k] = double{loadLittle<float>(facet + kFirstCorner + 4 * k)};
      sum += coordinate[k];
    }
    if (!std::isfinite(sum))
      return fault(ErrorCode::InvalidValue, origin, 0,
                   "facet " + std::to_string(f + 1) +
                     " has a coordinate that is not a finite number (NaN or infinite); mend the file in the "
                     "program that wrote it");
    for (Index k = 0; k < 3; ++k) corner[k] = 3 * f + k;
    coordinate += 9;
    corner += 3;
  }
  return mesh;
}

/// solid NAME / facet normal . . . / outer loop / vertex . . . (3 times) / endloop / endfacet / endsolid
class AsciiParser {
  static constexpr std::size_t kUsualFacet = 200; ///< bytes

public:
  AsciiParser(std::string_view bytes, const std::string& origin) : m_cursor(bytes), m_origin(origin) {}

  Result<Mesh> run(std::vector<std::string>& notes, WorkControl* control)
  {
    const auto facets = static_cast<Eigen::Index>(m_cursor.rest().size() / kUsualFacet);
    m_raw.vertices.reserve(3 * facets);
    m_raw.triangles.reserve(facets);
    for (std::size_t i = 0; skipToWord(); ++i) {
      if (i % 4096 == 0 && m_cursor.stopWanted(control)) return cancelledError();
      if (!usualFacet())
        if (Status status = statement(); !status) return status.error();
      if (m_raw.isTooLarge()) return tooManyError(m_origin);
    }
    if (m_inSolid)
      return fault(ErrorCode::BadFormat, m_origin, m_cursor.line(),
                   "the file ends without 'endsolid'; it is cut short, fetch it again");
    return finishMesh(std::move(m_raw), m_origin, notes, control);
  }

private:
  bool skipToWord()
  {
    while (m_cursor.atLineEnd()) {
      if (m_cursor.atEnd()) return false;
      m_cursor.nextLine();
    }
    return true;
  }

  /// A whole facet as nearly all programs write it; of any other the cursor stays before it.
  bool usualFacet()
  {
    const TextCursor before = m_cursor;
    const auto take = [this](const auto& keyword) { return skipToWord() && m_cursor.take(keyword); };
    double p[3][3];
    long line[3];
    const auto takeVertex = [&](int k) {
      if (!take("vertex")) return false;
      line[k] = m_cursor.line();
      return m_cursor.number(p[k][0]) && m_cursor.number(p[k][1]) && m_cursor.number(p[k][2]);
    };
    if (!m_cursor.take("facet")) return false;
    m_cursor.nextLine(); // the normal may be anything, see statement()
    if (!take("outer") || !take("loop") || !takeVertex(0) || !takeVertex(1) || !takeVertex(2) ||
        !take("endloop") || !take("endfacet")) {
      m_cursor = before;
      return false;
    }
    const Index first = m_raw.vertexCount();
    for (int k = 0; k < 3; ++k) m_raw.addVertex(p[k][0], p[k][1], p[k][2], line[k]);
    m_raw.addTriangle(first, first + 1, first + 2);
    m_corners.clear();
    return true;
  }

  Status statement()
  {
    const long line = m_cursor.line();
    TextCursor before = m_cursor;
    const std::string_view word = m_cursor.word();
    if (word == "vertex") return vertex(line);
    const auto is = [word](std::string_view keyword) {
      return word == keyword || equalIgnoringCase(word, keyword);
    };
    if (is("vertex")) return vertex(line);
    if (is("outer") || is("endfacet")) return {};
    if (is("loop")) {
      m_corners.clear();
    } else if (is("endloop")) {
      return endLoop(line);
    } else if (is("facet")) { // the normal may be anything, "nan" included: corners say it better
      m_cursor.nextLine();
    } else if (is("solid") || is("endsolid")) { // a name may hold any words
      m_inSolid = is("solid");
      m_cursor.nextLine();
    } else {
      return fault(ErrorCode::BadFormat, m_origin, line,
                   "'" + before.wordForMessage() + "' is no word of an ASCII STL; is the file cut short?");
    }
    return {};
  }

  Status vertex(long line)
  {
    double p[3];
    for (double& coordinate : p)
      if (!skipToWord() || !m_cursor.number(coordinate))
        return fault(ErrorCode::BadFormat, m_origin, line,
                     "a vertex needs three coordinates, written with a point" +
                       (m_cursor.atEnd() ? std::string("; the file is cut short")
                                         : ", not '" + m_cursor.wordForMessage() + "'"));
    m_corners.push_back(m_raw.vertexCount());
    m_raw.addVertex(p[0], p[1], p[2], line);
    return {};
  }

  Status endLoop(long line)
  {
    if (m_corners.size() < 3)
      return fault(ErrorCode::BadFormat, m_origin, line,
                   "a facet has " + std::to_string(m_corners.size()) + " vertices, it needs three");
    m_raw.addFace(m_corners);
    m_corners.clear();
    return {};
  }

  TextCursor m_cursor;
  const std::string& m_origin;
  RawMesh m_raw;
  std::vector<Index> m_corners; ///< of the current facet
  bool m_inSolid = false;
};

Result<Mesh> readStl(std::string_view bytes, const std::string& origin, std::string& format,
                     std::vector<std::string>& notes, WorkControl* control)
{
  const bool ascii = isAscii(bytes);
  format = ascii ? "STL (ASCII)" : "STL (binary)";
  Result<Mesh> mesh =
    ascii ? AsciiParser(bytes, origin).run(notes, control) : readBinary(bytes, origin, notes, control);
  if (mesh && mesh->triangleCount() == 0)
    return fault(ErrorCode::EmptyResult, origin, 0, "it is an STL without a single facet");
  return mesh;
}

} // namespace

MeshReader stlReader()
{
  return {"STL", recognisesStl, readStl};
}

} // namespace esm
