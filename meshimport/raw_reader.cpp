// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/raw_reader.h"

#include "meshimport/content.h"
#include "meshimport/foreign_kinds.h"
#include "meshimport/raw_mesh.h"
#include "meshimport/text_cursor.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <set>

namespace esm {

namespace {

constexpr int kTriangle = 9, kMore = 12;

struct Row {
  std::array<double, kMore> numbers{};
  int count = 0;
  long line = 0;
  Eigen::Vector3d point(std::size_t corner) const { return Eigen::Vector3d::Map(&numbers[3 * corner]); }
};

/// The numbers at the start of a line; one more than fit is counted, too.
Row takeRow(TextCursor& cursor)
{
  Row row;
  row.line = cursor.line();
  double number = 0.0;
  while (row.count <= kMore && cursor.number(number)) {
    if (row.count < kMore) row.numbers[static_cast<std::size_t>(row.count)] = number;
    ++row.count;
  }
  return row;
}

/// Whether the word at the cursor could have been meant as a number.
bool beginsLikeNumber(TextCursor cursor)
{
  constexpr std::string_view kStarts = "0123456789+-.";
  return kStarts.find(cursor.word().substr(0, 1)) != std::string_view::npos;
}

bool isFlatConvexQuad(const Row& row)
{
  std::array<Eigen::Vector3d, 4> turn;
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector3d a = row.point(k), b = row.point((k + 1) % 4), c = row.point((k + 2) % 4);
    turn[k] = (b - a).cross(c - b).normalized();
  }
  return std::all_of(turn.begin(), turn.end(),
                     [&](const Eigen::Vector3d& n) { return n.dot(turn[0]) > 1.0 - 1e-8; }); // to six digits
}

class RawParser {
public:
  RawParser(std::string_view bytes, const std::string& origin) : m_cursor(bytes), m_origin(origin) {}

  Result<Mesh> run(std::vector<std::string>& notes, WorkControl* control)
  {
    for (std::size_t i = 0; !m_cursor.atEnd(); ++i, m_cursor.nextLine()) {
      if (i % 4096 == 0 && m_cursor.stopWanted(control)) return cancelledError();
      if (m_cursor.atLineEnd()) continue;
      if (Status status = line(); !status) return status.error();
      if (m_rows.size() > kMostItems / 24) return tooManyError(m_origin);
    }
    const bool hasColours = m_more > 0 && areColours();
    for (const Row& row : m_rows) add(row, hasColours);
    if (m_raw.isEmpty()) return fault(ErrorCode::EmptyResult, m_origin, 0, "it holds no triangle");
    if (m_more > 0)
      notes.push_back(std::to_string(m_more) + (hasColours
                                                  ? " lines begin with a colour, which was passed over."
                                                  : " lines with twelve numbers were read as quads."));
    return finishMesh(std::move(m_raw), m_origin, notes, control);
  }

private:
  /// A name of an object or the numbers of a face; what stands behind them is the name of a texture.
  Status line()
  {
    if (!beginsLikeNumber(m_cursor)) return {};
    const Row row = takeRow(m_cursor);
    if (row.count == kTriangle || row.count == kMore) {
      if (!m_cursor.atLineEnd() && beginsLikeNumber(m_cursor)) return noNumber(row.line);
      if (row.count == kMore) ++m_more;
      m_rows.push_back(row);
      return {};
    }
    if (!m_cursor.atLineEnd() && row.count < kMore) return noNumber(row.line);
    return fault(ErrorCode::BadFormat, m_origin, row.line,
                 "a line of a RAW file has 9 or 12 numbers, this one has " +
                   (row.count > kMore ? std::string("more") : std::to_string(row.count)) +
                   (m_cursor.inLastLine() && row.count < kTriangle ? "; the file is cut short" : ""));
  }
  Error noNumber(long line)
  {
    return fault(ErrorCode::BadFormat, m_origin, line,
                 "'" + m_cursor.wordForMessage() + "' is no coordinate (numbers are written with a point)");
  }

  /// Whether the first three of twelve numbers are red, green and blue: all between 0 and 1, and either the
  /// same in more faces than meet in a corner, or as a rule no corner of other faces nor the fourth of a flat
  /// quad.
  bool areColours() const
  {
    const auto isColour = [](const Row& row) {
      return std::all_of(row.numbers.begin(), row.numbers.begin() + 3,
                         [](double x) { return x >= 0.0 && x <= 1.0; });
    };
    const auto isMore = [](const Row& row) { return row.count == kMore; };
    if (!std::all_of(m_rows.begin(), m_rows.end(),
                     [&](const Row& row) { return !isMore(row) || isColour(row); }))
      return false;
    constexpr std::size_t kMostAtCorner = 6; // faces, that begin there
    using Corner = std::array<double, 3>;
    const auto corner = [](const Row& row, std::size_t k) {
      return Corner{row.numbers[3 * k], row.numbers[3 * k + 1], row.numbers[3 * k + 2]};
    };
    std::set<Corner> corners, firsts;
    for (const Row& row : m_rows)
      if (isMore(row)) firsts.insert(corner(row, 0));
    if (m_more > kMostAtCorner * firsts.size()) return true;
    for (const Row& row : m_rows)
      for (std::size_t k = isMore(row) ? 1 : 0; k < static_cast<std::size_t>(row.count) / 3; ++k)
        corners.insert(corner(row, k));
    const auto quads = std::count_if(m_rows.begin(), m_rows.end(), [&](const Row& row) {
      return isMore(row) && (corners.contains(corner(row, 0)) || isFlatConvexQuad(row));
    });
    return 2 * static_cast<std::size_t>(quads) < m_more;
  }

  void add(const Row& row, bool hasColours)
  {
    const std::size_t first = row.count == kMore && hasColours ? 1 : 0,
                      end = static_cast<std::size_t>(row.count) / 3;
    m_corners.clear();
    for (std::size_t k = first; k < end; ++k) {
      m_corners.push_back(m_raw.vertexCount());
      m_raw.addVertex(row.numbers[3 * k], row.numbers[3 * k + 1], row.numbers[3 * k + 2], row.line);
    }
    m_raw.addFace(m_corners);
  }

  TextCursor m_cursor;
  const std::string& m_origin;
  std::vector<Row> m_rows;
  std::size_t m_more = 0; ///< rows of twelve numbers
  RawMesh m_raw;
  std::vector<Index> m_corners; ///< of the current face
};

/// By its name, for nothing else tells it from a table; and by the first line with numbers.
bool recognisesRaw(std::string_view bytes, std::string_view ending)
{
  if (ending != "raw" || !looksLikeText(bytes) || foreignKind(bytes)) return false;
  for (TextCursor cursor(bytes.substr(0, 1 << 16)); !cursor.atEnd(); cursor.nextLine()) {
    if (cursor.atLineEnd() || !beginsLikeNumber(cursor)) continue;
    const Row row = takeRow(cursor);
    return row.count == kTriangle || row.count == kMore;
  }
  return false;
}

Result<Mesh> readRaw(std::string_view bytes, const std::string& origin, FileStory& story,
                     WorkControl* control)
{
  std::vector<std::string>& notes = story.notes;
  story.format = "RAW triangles";
  return RawParser(bytes, origin).run(notes, control);
}

} // namespace

MeshReader rawReader()
{
  return {"RAW", recognisesRaw, readRaw};
}

} // namespace esm
