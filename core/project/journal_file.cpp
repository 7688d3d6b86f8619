// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/journal_file.h"

#include "core/base/file_io.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace esm {

namespace {

constexpr std::chrono::milliseconds kSyncPause{500}; // a line is on the disk within a second

} // namespace

std::int64_t secondsNow()
{
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::seconds>(since).count();
}

// === The lock

JournalLock::~JournalLock()
{
  if (m_file >= 0) ::close(m_file);
}

JournalLock JournalLock::take(const std::filesystem::path& folder)
{
  JournalLock lock;
  const std::filesystem::path path = folder / kJournalLock;
  lock.m_file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (lock.m_file < 0) return {};
  struct stat held = {}, named = {};
  // The former holder may have removed the folder between our two steps: then this is no lock of anything.
  const bool ours = ::flock(lock.m_file, LOCK_EX | LOCK_NB) == 0 && ::fstat(lock.m_file, &held) == 0 &&
                    ::stat(path.c_str(), &named) == 0 && held.st_ino == named.st_ino;
  if (!ours) return {};
  return lock;
}

// === The file

Result<std::unique_ptr<JournalFile>> JournalFile::create(const std::filesystem::path& parent)
{
  std::error_code code;
  std::filesystem::create_directories(parent, code);
  if (code) return fileUnwritable(parent, code.value());
  ::chmod(parent.c_str(), 0700); // what is unsaved is nobody else's
  // A hidden name until the lock is held, so that no other window takes the folder for a left one.
  std::string hidden = (parent / ".new-XXXXXX").string();
  if (::mkdtemp(hidden.data()) == nullptr) return fileUnwritable(parent, errno);
  JournalLock lock = JournalLock::take(hidden);
  const std::filesystem::path visible =
    parent / (std::to_string(secondsNow()) + hidden.substr(hidden.size() - 7));
  if (!lock || ::rename(hidden.c_str(), visible.c_str()) != 0) {
    const int reason = errno;
    std::filesystem::remove_all(hidden, code);
    return fileUnwritable(parent, reason);
  }
  auto file = adopt(visible, std::move(lock), 0);
  if (!file) std::filesystem::remove_all(visible, code);
  return file;
}

Result<std::unique_ptr<JournalFile>> JournalFile::adopt(const std::filesystem::path& folder, JournalLock lock,
                                                        std::uint64_t length)
{
  const std::filesystem::path path = folder / kJournalLines;
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (file < 0 || ::ftruncate(file, static_cast<off_t>(length)) != 0) {
    const int reason = errno;
    if (file >= 0) ::close(file);
    return fileUnwritable(path, reason);
  }
  return std::unique_ptr<JournalFile>(new JournalFile(folder, std::move(lock), file, length));
}

JournalFile::JournalFile(std::filesystem::path folder, JournalLock lock, int file, std::uint64_t length)
  : m_folder(std::move(folder)), m_lock(std::move(lock)), m_file(file), m_length(length), m_thread([this] {
      run();
    })
{}

JournalFile::~JournalFile()
{
  {
    const std::lock_guard guard(m_mutex);
    m_stop = true;
  }
  m_wake.notify_all();
  m_thread.join();
  ::close(m_file);
}

void JournalFile::append(std::string line)
{
  {
    const std::lock_guard guard(m_mutex);
    if (m_removed || m_failed) return;
    if (m_busy || !m_jobs.empty()) {
      m_jobs.push_back([text = std::move(line)](JournalFile& file) { return file.writeLine(text); });
      return;
    }
    m_busy = true; // the line is short: the page cache takes it in microseconds
  }
  const Status written = writeLine(line);
  {
    const std::lock_guard guard(m_mutex);
    m_busy = false;
  }
  if (!written) fail(written.error());
  m_wake.notify_all();
}

void JournalFile::post(Job job)
{
  {
    const std::lock_guard guard(m_mutex);
    if (m_removed || m_failed) return;
    m_jobs.push_back(std::move(job));
  }
  m_wake.notify_all();
}

bool JournalFile::waitWritten(std::chrono::milliseconds limit)
{
  std::unique_lock guard(m_mutex);
  return m_idle.wait_for(guard, limit, [&] { return m_jobs.empty() && !m_busy; });
}

void JournalFile::remove()
{
  {
    std::unique_lock guard(m_mutex);
    if (m_removed) return;
    m_removed = true;
    m_jobs.clear();
    m_unsynced.clear();
    m_idle.wait(guard, [&] { return !m_busy; });
  }
  // Out of sight in one step: a removal that is cut short leaves nothing to be offered.
  std::error_code code;
  const std::filesystem::path gone = m_folder.parent_path() / (".gone-" + m_folder.filename().string());
  std::filesystem::rename(m_folder, gone, code);
  std::filesystem::remove_all(code ? m_folder : gone, code);
}

/// Jobs in their order; between them, now and then, what was written goes to the disk.
void JournalFile::run()
{
  std::unique_lock guard(m_mutex);
  for (;;) {
    const auto due = m_unsyncedSince + kSyncPause;
    if (!m_jobs.empty() && !m_busy) {
      const Job job = std::move(m_jobs.front());
      m_jobs.pop_front();
      m_busy = true;
      guard.unlock();
      const Status done = m_failed ? Status{} : job(*this);
      if (!done) fail(done.error());
      guard.lock();
      m_busy = false;
      m_idle.notify_all();
    } else if (!m_unsynced.empty() && (m_stop || std::chrono::steady_clock::now() >= due)) {
      const std::vector<std::string> names = std::exchange(m_unsynced, {});
      guard.unlock();
      sync(names);
      guard.lock();
    } else if (m_stop && !m_busy) {
      return;
    } else {
      m_idle.notify_all();
      if (m_unsynced.empty())
        m_wake.wait(guard);
      else
        m_wake.wait_until(guard, due);
    }
  }
}

void JournalFile::fail(const Error& error)
{
  if (m_failed.exchange(true)) return;
  if (m_handler) m_handler(error);
}

void JournalFile::noteUnsynced(const std::string& name)
{
  const std::lock_guard guard(m_mutex);
  if (m_unsynced.empty()) m_unsyncedSince = std::chrono::steady_clock::now();
  if (std::find(m_unsynced.begin(), m_unsynced.end(), name) == m_unsynced.end()) m_unsynced.push_back(name);
}

void JournalFile::sync(std::vector<std::string> names)
{
  names.emplace_back("."); // the folder's own entries
  for (const std::string& name : names) {
    const int file = ::open((m_folder / name).c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) continue; // removed meanwhile
    const bool kept = ::fdatasync(file) == 0 || errno == EINVAL;
    const int reason = errno;
    ::close(file);
    if (!kept) return fail(fileUnwritable(m_folder / name, reason));
  }
}

// === For jobs

Status JournalFile::writeLine(std::string_view line)
{
  std::string whole(line);
  whole += '\n';
  if (!writeAll(m_file, whole)) {
    const Error error = fileUnwritable(m_folder / kJournalLines, errno);
    if (::ftruncate(m_file, static_cast<off_t>(m_length)) != 0) return error; // a torn end is no harm either
    return error;
  }
  m_length += whole.size();
  noteUnsynced(kJournalLines);
  return {};
}

Status JournalFile::writeBeside(const std::string& name, std::string_view bytes)
{
  const std::filesystem::path path = m_folder / name, temporary = m_folder / (name + ".part");
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (file < 0) return fileUnwritable(path, errno);
  const bool written = writeAll(file, bytes);
  const int reason = errno;
  const bool closed = ::close(file) == 0;
  if (!written || !closed) {
    ::unlink(temporary.c_str());
    return fileUnwritable(path, written ? errno : reason);
  }
  if (::rename(temporary.c_str(), path.c_str()) != 0) return fileUnwritable(path, errno);
  noteUnsynced(name);
  return {};
}

Status JournalFile::copyBeside(const std::filesystem::path& from, const std::string& name)
{
  std::error_code code;
  std::filesystem::copy_file(from, m_folder / name, std::filesystem::copy_options::overwrite_existing, code);
  if (code) return fileUnwritable(m_folder / name, code.value());
  ::chmod((m_folder / name).c_str(), 0600);
  noteUnsynced(name);
  return {};
}

} // namespace esm
