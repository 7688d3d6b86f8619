// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/off_reader.h"

#include "core/base/ascii_case.h"
#include "meshimport/content.h"
#include "meshimport/raw_mesh.h"
#include "meshimport/text_cursor.h"

namespace esm {

namespace {

/// [ST][C][N]OFF; the variants with a fourth coordinate or n of them are other geometry.
bool isMagic(std::string_view word)
{
  const std::string letters = asciiLower(word.substr(0, 8));
  std::string_view rest = letters;
  if (rest.substr(0, 2) == "st") rest.remove_prefix(2);
  if (rest.substr(0, 1) == "c") rest.remove_prefix(1);
  if (rest.substr(0, 1) == "n") rest.remove_prefix(1);
  return rest == "off";
}

class OffParser {
public:
  OffParser(std::string_view bytes, const std::string& origin)
    : m_cursor(bytes, TextCursor::HashComments), m_origin(origin)
  {}

  Result<Mesh> run(std::vector<std::string>& notes, WorkControl* control)
  {
    if (Status status = header(); !status) return status.error();
    if (Status status = vertices(control); !status) return status.error();
    if (Status status = faces(control); !status) return status.error();
    const std::string more = linesBehind(m_cursor, std::to_string(m_faces) + " promised faces");
    if (m_raw.isEmpty())
      return fault(ErrorCode::EmptyResult, m_origin, 0,
                   "it holds " + std::to_string(m_vertices) + " vertices but no face" +
                     (more.empty() ? "" : "; " + more));
    if (!more.empty()) notes.push_back(more + ".");
    return finishMesh(std::move(m_raw), m_origin, notes, control);
  }

private:
  Error wrong(const std::string& text) const
  {
    return fault(ErrorCode::BadFormat, m_origin, m_cursor.line(), text);
  }
  /// For what is missing where the cursor is: in the last line the rest of the file may be missing, too.
  Error missing(const char* text) const
  {
    return wrong(text + std::string(m_cursor.inLastLine() ? "; the file is cut short, fetch it again" : ""));
  }

  void skipToWord()
  {
    while (!m_cursor.atEnd() && m_cursor.atLineEnd()) m_cursor.nextLine();
  }

  Status header()
  {
    skipToWord();
    TextCursor magic = m_cursor; // the counts may follow it on the same line; Geomview lets it be missing
    if (isMagic(magic.word())) m_cursor = magic;
    skipToWord();
    if (equalIgnoringCase(m_cursor.rest().substr(0, 6), "binary"))
      return fault(ErrorCode::Unsupported, m_origin, m_cursor.line(),
                   "binary OFF is not read; save it as text or as PLY");
    if (!m_cursor.integer(m_vertices) || !m_cursor.integer(m_faces) || m_vertices < 0 || m_faces < 0)
      return wrong("an OFF file begins with the counts of vertices and faces");
    m_cursor.nextLine(); // the count of edges is often 0 or missing
    // A vertex takes at least "0 0 0\n", a face "1 0\n".
    const auto left = static_cast<long long>(m_cursor.rest().size()) + 1;
    if (m_vertices > left / 6 || m_faces > (left - 6 * m_vertices) / 4)
      return wrong("the counts promise more than the file has room for; it is cut short, fetch it again");
    return {};
  }

  Status vertices(WorkControl* control)
  {
    m_raw.vertices.reserve(static_cast<Eigen::Index>(m_vertices));
    for (long long v = 0; v < m_vertices; ++v, m_cursor.nextLine()) {
      if (v % 4096 == 0 && m_cursor.stopWanted(control)) return cancelledError();
      skipToWord();
      double p[3];
      for (double& coordinate : p)
        if (!m_cursor.number(coordinate))
          return missing("a vertex needs three coordinates, written with a point");
      m_raw.addVertex(p[0], p[1], p[2], m_cursor.line());
      if (m_raw.isTooLarge()) return tooManyError(m_origin);
    }
    return {};
  }

  Status faces(WorkControl* control)
  {
    std::vector<Index> corners;
    for (long long f = 0; f < m_faces; ++f, m_cursor.nextLine()) {
      if (f % 4096 == 0 && m_cursor.stopWanted(control)) return cancelledError();
      skipToWord();
      long long count = 0;
      if (!m_cursor.integer(count) || count < 0)
        return missing("a face begins with the number of its corners");
      corners.clear();
      for (long long k = 0; k < count; ++k) {
        long long vertex = 0;
        if (!m_cursor.integer(vertex)) return missing("a face has fewer corners than it says");
        if (vertex < 0 || vertex >= m_vertices)
          return fault(ErrorCode::InvalidValue, m_origin, m_cursor.line(),
                       "there is no vertex " + std::to_string(vertex) + ", the file has vertices 0 to " +
                         std::to_string(m_vertices - 1));
        corners.push_back(static_cast<Index>(vertex));
      }
      m_raw.addFace(corners);
      if (m_raw.isTooLarge()) return tooManyError(m_origin);
    }
    return {};
  }

  TextCursor m_cursor;
  const std::string& m_origin;
  RawMesh m_raw;
  long long m_vertices = 0, m_faces = 0;
};

/// The magic, or three counts alone on the first line of a file that is an OFF by its name.
bool recognisesOff(std::string_view bytes, std::string_view ending)
{
  if (!looksLikeText(bytes)) return false;
  TextCursor cursor(bytes, TextCursor::HashComments);
  while (!cursor.atEnd() && cursor.atLineEnd()) cursor.nextLine();
  TextCursor counts = cursor;
  if (isMagic(cursor.word())) return true;
  long long count = 0;
  return ending == "off" && counts.integer(count) && counts.integer(count) && counts.integer(count) &&
         counts.atLineEnd();
}

Result<Mesh> readOff(std::string_view bytes, const std::string& origin, FileStory& story,
                     WorkControl* control)
{
  std::string& format = story.format;
  std::vector<std::string>& notes = story.notes;
  format = "OFF";
  return OffParser(bytes, origin).run(notes, control);
}

} // namespace

MeshReader offReader()
{
  return {"OFF", recognisesOff, readOff};
}

} // namespace esm
