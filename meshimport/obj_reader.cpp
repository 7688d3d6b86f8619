// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/obj_reader.h"

#include "core/base/large_pages.h"
#include "meshimport/content.h"
#include "meshimport/foreign_kinds.h"
#include "meshimport/raw_mesh.h"
#include "meshimport/text_cursor.h"

#include <algorithm>
#include <array>

namespace esm {

namespace {

constexpr unsigned kRules = TextCursor::HashComments | TextCursor::BackslashJoins;

/// Statements without geometry of ours.
bool isOrdinaryKeyword(std::string_view word)
{
  constexpr std::array<std::string_view, 17> kWords{
    "vt",     "vn",  "vp",     "o",        "g",        "s",     "mg",         "mtllib",   "usemtl",
    "maplib", "lod", "usemap", "c_interp", "d_interp", "bevel", "shadow_obj", "trace_obj"};
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

/// Points, curves and surfaces: geometry that a net cannot take.
bool isPassedOverGeometry(std::string_view word)
{
  constexpr std::array<std::string_view, 15> kWords{"p",    "cstype", "deg",  "bmat", "step",
                                                    "curv", "curv2",  "surf", "parm", "trim",
                                                    "hole", "scrv",   "sp",   "end",  "con"};
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

class ObjParser {
public:
  ObjParser(std::string_view bytes, const std::string& origin)
    : m_cursor(bytes, kRules),
      m_origin(origin),
      m_doubt(bytes.find_last_of("\r\n") + 1 == bytes.size() ? "" : "; it may be cut short")
  {}

  Result<Mesh> run(std::vector<std::string>& notes, WorkControl* control)
  {
    const std::size_t bytes =
      m_cursor.rest().size(); // half of them vertices and half of them faces, as a rule
    m_raw.vertices.reserve(static_cast<Eigen::Index>(bytes / 60));
    m_raw.triangles.reserve(static_cast<Eigen::Index>(bytes / 36));
    for (std::size_t i = 0; !m_cursor.atEnd(); ++i) {
      if (i % 4096 == 0 && m_cursor.stopWanted(control)) return cancelledError();
      if (!m_cursor.atLineEnd())
        if (Status status = statement(); !status) return status.error();
      m_cursor.nextLine();
      if (m_raw.isTooLarge()) return tooManyError(m_origin);
    }
    for (const Forward& forward : m_forward)
      if (forward.vertex >= m_raw.vertexCount()) return outOfRange(forward.vertex + 1, forward.line);
    if (m_raw.isEmpty())
      return fault(ErrorCode::EmptyResult, m_origin, 0,
                   "it holds " + std::to_string(m_raw.vertexCount()) +
                     " vertices but no face (f) and no line (l), points alone make no net" + m_doubt);
    tellNotes(notes);
    return finishMesh(std::move(m_raw), m_origin, notes, control);
  }

private:
  struct Forward {
    long long vertex;
    long line;
  };

  Status statement()
  {
    const long line = m_cursor.line();
    if (m_cursor.take("v")) return vertex(line);
    if (m_cursor.take("f")) return usualTriangle() ? Status() : element(line, true);
    const std::string_view word = m_cursor.word();
    if (word == "fo" || word == "l") return element(line, word != "l");
    if (isOrdinaryKeyword(word)) return {};
    if (isPassedOverGeometry(word)) {
      ++m_passedOver;
    } else if (word == "call") { // the statements of another file, which would stand here
      if (m_called++ == 0) m_firstCalled = m_cursor.word();
    } else if (m_unknown++ == 0) {
      m_firstUnknown = line;
    }
    return {};
  }

  Status vertex(long line)
  {
    double p[3];
    for (double& coordinate : p) {
      if (m_cursor.number(coordinate)) continue;
      if (m_cursor.atLineEnd())
        return fault(ErrorCode::BadFormat, m_origin, line,
                     std::string("a vertex needs three coordinates") +
                       (m_cursor.inLastLine() ? "; the file is cut short" : ""));
      return fault(ErrorCode::BadFormat, m_origin, line,
                   "'" + m_cursor.wordForMessage() + "' is no coordinate (numbers are written with a point)");
    }
    m_raw.addVertex(p[0], p[1], p[2], line);
    return {};
  }

  /// A face as nearly all are: three vertices that have come already. Before any other the cursor stays.
  bool usualTriangle()
  {
    const TextCursor before = m_cursor;
    long long a = 0, b = 0, c = 0;
    const auto take = [this](long long& number) {
      return m_cursor.corner(number) && number >= 1 && number <= m_raw.vertexCount();
    };
    if (!take(a) || !take(b) || !take(c) || !m_cursor.atLineEnd()) {
      m_cursor = before;
      return false;
    }
    m_raw.addTriangle(static_cast<Index>(a - 1), static_cast<Index>(b - 1), static_cast<Index>(c - 1));
    return true;
  }

  /// A face or a polyline.
  Status element(long line, bool isFace)
  {
    m_corners.clear();
    while (!m_cursor.atLineEnd()) {
      long long number = 0;
      if (!m_cursor.corner(number))
        return fault(ErrorCode::BadFormat, m_origin, line,
                     "'" + m_cursor.wordForMessage() + "' is no corner (as 7, 7/1, 7//3 or 7/1/3)");
      const long long vertex = number > 0 ? number - 1 : m_raw.vertexCount() + number;
      if (number == 0 || vertex < 0 || vertex >= static_cast<long long>(kMostItems))
        return outOfRange(number, line);
      if (vertex >= m_raw.vertexCount()) m_forward.push_back({vertex, line});
      m_corners.push_back(static_cast<Index>(vertex));
    }
    const std::size_t wanted = isFace ? 3 : 2;
    if (m_corners.size() < wanted && m_cursor.inLastLine())
      return fault(ErrorCode::BadFormat, m_origin, line, "the file ends in the middle of a statement");
    if (!isFace) {
      m_raw.addPolyline(m_corners);
    } else if (!m_raw.addFace(m_corners)) {
      ++m_thinFaces;
    }
    return {};
  }

  Error outOfRange(long long number, long line) const
  {
    return fault(ErrorCode::InvalidValue, m_origin, line,
                 "there is no vertex " + std::to_string(number) + ", the file has " +
                   std::to_string(m_raw.vertexCount()) + " of them up to here" + m_doubt);
  }

  void tellNotes(std::vector<std::string>& notes) const
  {
    if (m_thinFaces > 0)
      notes.push_back(std::to_string(m_thinFaces) +
                      " faces with fewer than three corners were read as lines.");
    if (m_passedOver > 0)
      notes.push_back(std::to_string(m_passedOver) +
                      " statements for points, curves or free-form surfaces were passed over.");
    if (m_called > 0)
      notes.push_back("Its part '" + std::string(m_firstCalled.substr(0, 160)) + "' is missing here" +
                      (m_called > 1 ? " (and " + std::to_string(m_called - 1) + " more)" : "") +
                      ": files that an OBJ calls are not read.");
    if (m_unknown > 0)
      notes.push_back(std::to_string(m_unknown) +
                      " lines with unknown keywords were passed over, the first is line " +
                      std::to_string(m_firstUnknown) + ".");
  }

  TextCursor m_cursor;
  const std::string& m_origin;
  RawMesh m_raw;
  std::vector<Index> m_corners; ///< of the current statement
  std::vector<Forward> m_forward;
  const char* m_doubt; ///< for messages about a file that ends within a line
  std::size_t m_thinFaces = 0, m_passedOver = 0, m_unknown = 0, m_called = 0;
  std::string_view m_firstCalled;
  long m_firstUnknown = 0;
};

/// A vertex statement with three numbers near the start; or text that calls itself OBJ.
bool recognisesObj(std::string_view bytes, std::string_view ending)
{
  if (!looksLikeText(bytes)) return false;
  if (ending == "obj") return !foreignKind(bytes) && betrayedEnding(bytes).empty();
  TextCursor cursor(bytes.substr(0, 1 << 16), kRules);
  for (; !cursor.atEnd(); cursor.nextLine()) {
    if (cursor.word() != "v") continue;
    double x;
    if (cursor.number(x) && cursor.number(x) && cursor.number(x)) return true;
  }
  return false;
}

Result<Mesh> readObj(std::string_view bytes, const std::string& origin, FileStory& story,
                     WorkControl* control)
{
  std::string& format = story.format;
  std::vector<std::string>& notes = story.notes;
  format = "OBJ";
  return ObjParser(bytes, origin).run(notes, control);
}

} // namespace

MeshReader objReader()
{
  return {"OBJ", recognisesObj, readObj};
}

} // namespace esm
