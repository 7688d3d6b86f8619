// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/trace_log.h"

#include "core/base/file_io.h"
#include "core/base/text_number.h"

#include <cerrno>
#include <fcntl.h>
#include <string_view>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace esm {

namespace {

using namespace std::chrono_literals;

constexpr auto kWriteEvery = 200ms, kSyncEvery = 500ms;
constexpr std::string_view kAllHeader =
  "t [s],x [m],y [m],z [m],vx [m/s],vy [m/s],vz [m/s],fx [N],fy [N],fz [N],work [J],lateness [s]\n";
constexpr std::string_view kPathHeader = "t,x,y,z\n";

void appendVector(std::string& text, const Eigen::Vector3d& vector)
{
  for (const double value : vector) {
    text += ',';
    appendDouble(text, value);
  }
}

void appendTick(std::string& text, const TraceSample& tick)
{
  appendDouble(text, tick.time);
  for (const Eigen::Vector3d* part : {&tick.position, &tick.velocity, &tick.force}) appendVector(text, *part);
  for (const double value : {tick.work, tick.lateness}) {
    text += ',';
    appendDouble(text, value);
  }
  text += '\n';
}

} // namespace

TraceLog::Descriptor::~Descriptor()
{
  ::close(number);
}

TraceLog::TraceLog(std::filesystem::path path, int descriptor, Columns columns)
  : m_path(std::move(path)),
    m_descriptor(std::make_unique<Descriptor>(descriptor)),
    m_columns(columns),
    m_text(columns == Columns::All ? kAllHeader : kPathHeader),
    m_written(Clock::now()),
    m_synced(m_written)
{}

Result<TraceLog> TraceLog::create(const std::filesystem::path& file, Columns columns)
{
  struct stat info = {};
  if (::stat(file.c_str(), &info) == 0 && (S_ISBLK(info.st_mode) || S_ISSOCK(info.st_mode)))
    return Error{ErrorCode::FileUnwritable, file.string() + ": cannot be written, it is " +
                                              (S_ISBLK(info.st_mode) ? "a device" : "a socket") +
                                              "; name a file"};
  // Without waiting for a pipe that nobody reads; emptied with the first tick only.
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_NOCTTY | O_NONBLOCK | O_CLOEXEC, 0666);
  if (descriptor < 0) return fileUnwritable(file, errno);
  ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
  return TraceLog(file, descriptor, columns);
}

void TraceLog::add(std::span<const TraceSample> ticks)
{
  if (ticks.empty() || m_fault != 0) return;
  if (!m_hasStart) {
    m_hasStart = true;
    m_start = ticks.front().time;
    if (::ftruncate(m_descriptor->number, 0) != 0 && errno != EINVAL) m_fault = errno; // EINVAL: no file
  }
  for (const TraceSample& tick : ticks) addLine(tick);
  const Clock::time_point now = Clock::now();
  if (now - m_written < kWriteEvery) return;
  m_written = now;
  write();
  if (now - m_synced < kSyncEvery) return;
  m_synced = now;
  ::fdatasync(m_descriptor->number); // where it cannot be, the line is with the reader already
}

void TraceLog::addLine(const TraceSample& tick)
{
  if (m_columns == Columns::All) return appendTick(m_text, tick);
  appendDouble(m_text, tick.time - m_start);
  appendVector(m_text, tick.position);
  m_text += '\n';
}

void TraceLog::write()
{
  std::string_view left = m_text;
  while (!left.empty() && m_fault == 0) {
    const ssize_t count = ::write(m_descriptor->number, left.data(), left.size());
    if (count >= 0)
      left.remove_prefix(static_cast<std::size_t>(count));
    else if (errno != EINTR)
      m_fault = errno;
  }
  m_text.clear();
}

Status TraceLog::finish()
{
  if (m_hasStart && m_fault == 0) {
    write();
    if (::fdatasync(m_descriptor->number) != 0 && errno != EINVAL && errno != EROFS && m_fault == 0)
      m_fault = errno;
  }
  return m_fault == 0 ? Status{} : fileUnwritable(m_path, m_fault);
}

std::string traceCsv(std::span<const TraceSample> ticks)
{
  std::string text(kAllHeader);
  for (const TraceSample& tick : ticks) appendTick(text, tick);
  return text;
}

} // namespace esm
