// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/hand_path.h"

#include "core/base/ascii_case.h"
#include "core/base/csv_reader.h"
#include "core/base/file_io.h"
#include "core/base/text_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace esm {

namespace {

bool isHeader(const CsvRow& row)
{
  constexpr std::array<std::string_view, 4> kColumns = {"t", "x", "y", "z"};
  return std::equal(row.cells.begin(), row.cells.end(), kColumns.begin(), kColumns.end(), equalIgnoringCase);
}

Result<std::array<double, 4>> numbersOf(CsvReader& table, const CsvRow& row)
{
  std::array<double, 4> numbers{};
  for (std::size_t i = 0; i < 4; ++i) {
    const CsvNumber number = table.number(row.cells[i]);
    if (number.kind == CsvNumber::Kind::Unclear) return table.error(row, i, number.why);
    if (number.kind == CsvNumber::Kind::Text || !std::isfinite(number.value))
      return table.error(row, i, "four finite numbers are expected: time [s] and x, y, z [m]");
    numbers[i] = number.value;
  }
  return numbers;
}

} // namespace

Eigen::Vector3d HandPath::at(double t) const noexcept
{
  const auto next = std::upper_bound(time.begin(), time.end(), t);
  if (next == time.begin()) return position.col(0);
  if (next == time.end()) return position.col(position.cols() - 1);
  const Eigen::Index i = next - time.begin();
  const double before = time[static_cast<std::size_t>(i - 1)];
  const double share = (t - before) / (*next - before);
  return position.col(i - 1) + share * (position.col(i) - position.col(i - 1));
}

Result<HandPath> readHandPath(const std::filesystem::path& file)
{
  const Result<std::string> bytes = readFile(file);
  if (!bytes) return bytes.error();
  Result<CsvReader> table = CsvReader::open(*bytes, file.string());
  if (!table) return table.error();
  if (!isHeader(table->header()))
    return table->error(table->header(), "a hand path begins with the columns \"t,x,y,z\"");
  HandPath path;
  std::vector<std::array<double, 4>> rows;
  CsvRow row;
  for (;;) {
    const Result<bool> more = table->next(row);
    if (!more) return more.error();
    if (!*more) break;
    const auto numbers = numbersOf(*table, row);
    if (!numbers) return numbers.error();
    if (!rows.empty() && (*numbers)[0] <= rows.back()[0])
      return table->error(row, 0, "the times must rise from line to line");
    rows.push_back(*numbers);
  }
  if (rows.empty()) return Error{ErrorCode::EmptyResult, file.string() + ": the path has no points"};
  path.position.resize(3, static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    path.time.push_back(rows[i][0]);
    path.position.col(static_cast<Eigen::Index>(i)) << rows[i][1], rows[i][2], rows[i][3];
  }
  return path;
}

Status writeHandPath(const std::filesystem::path& file, const HandPath& path)
{
  std::string text = "t,x,y,z\n";
  for (std::size_t i = 0; i < path.time.size(); ++i) {
    appendDouble(text, path.time[i]);
    for (int axis = 0; axis < 3; ++axis) {
      text += ',';
      appendDouble(text, path.position(axis, static_cast<Eigen::Index>(i)));
    }
    text += '\n';
  }
  return writeFileAtomically(file, text);
}

HandPath handPathOf(std::span<const TraceSample> trace)
{
  HandPath path;
  path.position.resize(3, static_cast<Eigen::Index>(trace.size()));
  for (std::size_t i = 0; i < trace.size(); ++i) {
    path.time.push_back(trace[i].time - trace.front().time);
    path.position.col(static_cast<Eigen::Index>(i)) = trace[i].position;
  }
  return path;
}

HandPose WaitingHand::pose(double time) noexcept
{
  const std::uint32_t starts = m_starts.load(std::memory_order_relaxed);
  if (starts != m_seen) m_start = time;
  m_seen = starts;
  const Eigen::Vector3d first = m_path.position.col(0);
  if (starts == 0) return {first, first, 1};
  return {m_path.at(m_path.time.front() + time - m_start), first, 1 + starts};
}

HandPose RecordedHand::pose(double time) noexcept
{
  if (!m_started) m_start = time;
  m_started = true;
  const Eigen::Vector3d first = m_path.position.col(0);
  return {m_path.at(m_path.time.front() + time - m_start), first, 1};
}

} // namespace esm
