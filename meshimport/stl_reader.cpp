// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/stl_reader.h"

#include "core/base/ascii_case.h"
#include "core/base/large_pages.h"
#include "meshimport/byte_order.h"
#include "meshimport/content.h"
#include "meshimport/foreign_kinds.h"
#include "meshimport/raw_mesh.h"
#include "meshimport/text_cursor.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace esm {

namespace {

// Binary: 80 bytes of free text, the count of facets, then per facet a normal and three corners as twelve
// floats and two spare bytes; all little-endian.
constexpr std::size_t kHeader = 84, kFacet = 50, kFirstCorner = 12;
constexpr std::size_t kStlLook = 4096; ///< bytes of a text, for the signs of an STL

std::uint64_t facetCount(std::string_view bytes)
{
  return loadLittle<std::uint32_t>(bytes.data() + 80);
}

/// Exact size proves a binary STL; a text would need half a billion facets, for four letters are that many.
bool hasBinarySize(std::string_view bytes)
{
  return bytes.size() >= kHeader && bytes.size() == kHeader + kFacet * facetCount(bytes);
}

/// The first word, or "facet normal" further on in a file that is an STL by its name.
bool isAscii(std::string_view bytes, std::string_view ending)
{
  if (hasBinarySize(bytes) || !looksLikeText(bytes)) return false;
  TextCursor cursor(bytes);
  while (!cursor.atEnd() && cursor.atLineEnd()) cursor.nextLine();
  const std::string_view first = cursor.word();
  if (equalIgnoringCase(first, "solid")) return true;
  if (equalIgnoringCase(first, "facet") && equalIgnoringCase(cursor.word(), "normal")) return true;
  return ending == "stl" && asciiLower(bytes.substr(0, kStlLook)).find("facet normal") != std::string::npos;
}

bool recognisesStl(std::string_view bytes, std::string_view ending)
{
  if (hasBinarySize(bytes) || isAscii(bytes, ending)) return true;
  // Its count is wrong, but by its name it is an STL and by its bytes nothing else.
  return ending == "stl" && !looksLikeText(bytes) && !foreignKind(bytes) && betrayedEnding(bytes).empty();
}

/// Whether the facets from number `first` on could go on the body of those before: no text or table.
bool goOn(const char* facets, std::uint64_t first, std::uint64_t count)
{
  constexpr double kMostTimesLarger = 1000.0, kNothing = 1e-30;
  double largest = 0.0, largestBehind = 0.0;
  for (std::uint64_t f = 0; f < count; ++f)
    for (std::size_t k = 0; k < 9; ++k) {
      const double x = double{loadLittle<float>(facets + kFacet * f + kFirstCorner + 4 * k)};
      if (!std::isfinite(x)) return false;
      double& most = f < first ? largest : largestBehind;
      most = std::max(most, std::abs(x));
    }
  return largestBehind > kNothing && (first == 0 || largestBehind <= kMostTimesLarger * largest);
}

/// How many facets to read. The count of the header is often wrong: writers of streams leave it open, and
/// other readers go by the size of the file.
Result<std::uint64_t> facetsToRead(std::string_view bytes, const std::string& origin,
                                   std::vector<std::string>& notes)
{
  const std::uint64_t promised = facetCount(bytes), body = bytes.size() - kHeader, there = body / kFacet;
  const bool isWhole = body % kFacet == 0, isOpen = promised == 0 || promised == 0xFFFFFFFF;
  const std::string promise = "its header promises " + std::to_string(promised) + " facets in " +
                              std::to_string(kHeader + kFacet * promised) + " bytes, but it has " +
                              std::to_string(bytes.size());
  if (promised == there && isWhole) return promised;
  if (isWhole && there > 0 && (promised > there || goOn(bytes.data() + kHeader, promised, there))) {
    notes.push_back("The header promises " + std::to_string(promised) + " facets, but " +
                    std::to_string(there) + " are there; all of these were read." +
                    (promised > there && !isOpen ? " The file may be cut short." : ""));
    return there;
  }
  if (promised == 0xFFFFFFFF || (promised == 0 && there > 0))
    return fault(ErrorCode::BadFormat, origin, 0,
                 promise + "; nor do these hold a whole number of facets, so it is no STL or damaged");
  if (promised > there)
    return fault(ErrorCode::BadFormat, origin, 0, promise + "; it is cut short or no STL, fetch it again");
  notes.push_back(std::to_string(body - kFacet * promised) +
                  " bytes behind the last facet were passed over.");
  return promised;
}

Result<Mesh> readBinary(std::string_view bytes, const std::string& origin, std::vector<std::string>& notes,
                        WorkControl* control)
{
  if (bytes.size() < kHeader)
    return fault(ErrorCode::BadFormat, origin, 0,
                 "it has " + std::to_string(bytes.size()) +
                   " bytes, less than the 84 of a binary STL header; it is cut short");
  const Result<std::uint64_t> toRead = facetsToRead(bytes, origin, notes);
  if (!toRead) return toRead.error();
  const std::uint64_t facets = *toRead;
  if (12 * facets > kMostItems) return tooManyError(origin);

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
    if (m_inFacet)
      return fault(ErrorCode::BadFormat, m_origin, m_cursor.line(),
                   "the file ends within a facet; it is cut short, fetch it again");
    tellNotes(notes);
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
    std::string_view word = m_cursor.word();
    if (word == "vertex") return vertex(line);
    const auto is = [&word](std::string_view keyword) {
      return word == keyword || equalIgnoringCase(word, keyword);
    };
    std::string oneWord; // of "end" and "facet", for instance
    if (is("end")) {
      oneWord = "end" + asciiLower(m_cursor.word());
      word = oneWord;
    }
    if (is("vertex")) return vertex(line);
    if (is("outer")) return {};
    if (is("loop") || is("outerloop")) {
      m_corners.clear();
    } else if (is("endloop")) {
      if (Status status = endLoop(line); !status) return status;
    } else if (is("endfacet")) {
      if (Status status = endFacet(line); !status) return status;
    } else if (is("facet")) {
      if (Status status = endFacet(line); !status) return status;
      m_inFacet = true;
      skipNormal();
    } else if (is("solid") || is("endsolid")) { // a name may hold any words
      if (Status status = endFacet(line); !status) return status;
      m_inSolid = is("solid");
      m_cursor.nextLine();
    } else {
      return other(before, line);
    }
    if (!oneWord.empty()) m_splitWords.insert(oneWord);
    return {};
  }

  /// Whether or not the words for it are there.
  Status endFacet(long line)
  {
    m_inFacet = false;
    return m_corners.empty() ? Status() : endLoop(line);
  }

  /// It may be anything, "nan" included: corners say it better.
  void skipNormal()
  {
    for (TextCursor look = m_cursor; !m_cursor.atLineEnd(); m_cursor = look)
      if (equalIgnoringCase(look.word(), "outer")) return;
    m_cursor.nextLine();
  }

  /// Colours and remarks of some writers stand between facets.
  Status other(TextCursor& at, long line)
  {
    if (m_inFacet) {
      const bool isLast = at.inLastLine();
      return fault(ErrorCode::BadFormat, m_origin, line,
                   "'" + at.wordForMessage() + "' is no word of an ASCII STL" +
                     (isLast ? "; the file is cut short" : ""));
    }
    if (m_otherLines++ == 0) m_firstOther = at.wordForMessage();
    m_cursor.nextLine();
    return {};
  }

  void tellNotes(std::vector<std::string>& notes) const
  {
    for (const std::string& word : m_splitWords)
      notes.push_back("The word '" + word + "' is written in two; it was read all the same.");
    if (m_otherLines > 0)
      notes.push_back(std::to_string(m_otherLines) +
                      " lines between facets were passed over (the first begins with '" + m_firstOther +
                      "').");
    if (m_inSolid) notes.push_back("The file ends without 'endsolid'; it may be cut short.");
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
  std::vector<Index> m_corners;       ///< of the current facet
  std::set<std::string> m_splitWords; ///< "endsolid" and others, written in two words
  std::string m_firstOther;
  std::size_t m_otherLines = 0;
  bool m_inSolid = false, m_inFacet = false;
};

Result<Mesh> readStl(std::string_view bytes, const std::string& origin, FileStory& story,
                     WorkControl* control)
{
  std::string& format = story.format;
  std::vector<std::string>& notes = story.notes;
  const bool ascii = isAscii(bytes, "stl");
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
