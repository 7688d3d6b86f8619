// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace esm {

/// Names inside a journal's folder.
inline constexpr const char* kJournalLines = "journal.jsonl";
inline constexpr const char* kJournalLock = "lock";
inline constexpr const char* kJournalPicture = "picture.png";
inline constexpr const char* kJournalPostponed = "later"; ///< exists: the user wants not to be asked again

std::int64_t secondsNow(); ///< since 1970

/// Holds the lock of a journal's folder. The kernel lets it go with the process, however that ends, so what
/// can be locked belongs to nobody who lives.
class JournalLock {
public:
  JournalLock() = default;
  JournalLock(JournalLock&& other) noexcept : m_file(std::exchange(other.m_file, -1)) {}
  JournalLock& operator=(JournalLock&& other) noexcept
  {
    std::swap(m_file, other.m_file);
    return *this;
  }
  ~JournalLock();
  static JournalLock take(const std::filesystem::path& folder); ///< holds nothing if another has it
  explicit operator bool() const noexcept { return m_file >= 0; }

private:
  int m_file = -1;
};

/// The folder of one journal on disk: lines that are appended and files beside them. A line is in the hands
/// of the kernel when append() returns, unless something bigger is still being written, and on the disk
/// within a second; what takes longer is done by a thread of its own, in the order of the calls.
///
/// After a failure the file ends with its last whole line and takes nothing more; failure() says why.
/// append(), post() and remove() on one thread, the owner's.
class JournalFile {
public:
  using Job = std::function<Status(JournalFile&)>;

  /// A folder of its own under `parent`, which is made if need be. Errors: FileUnwritable.
  static Result<std::unique_ptr<JournalFile>> create(const std::filesystem::path& parent);
  /// Goes on with a journal of which the first `length` bytes are good; what follows is cut off.
  static Result<std::unique_ptr<JournalFile>> adopt(const std::filesystem::path& folder, JournalLock lock,
                                                    std::uint64_t length);
  ~JournalFile(); ///< writes what waits; the folder stays

  const std::filesystem::path& folder() const noexcept { return m_folder; }
  void append(std::string line); ///< without its end
  void post(Job job);            ///< runs on the thread of the file, after what came before
  /// Whether all is written, after waiting for it at most so long.
  bool waitWritten(std::chrono::milliseconds limit);
  void remove(); ///< nothing is left to be recovered; takes nothing more
  bool hasFailed() const noexcept { return m_failed; }
  /// Called once, on either thread, at the first failure. Set it before the first line.
  void onFailure(std::function<void(const Error&)> handler) { m_handler = std::move(handler); }

  // === For jobs
  Status writeLine(std::string_view line);
  Status writeBeside(const std::string& name, std::string_view bytes); ///< all or nothing
  Status copyBeside(const std::filesystem::path& from, const std::string& name);

private:
  JournalFile(std::filesystem::path folder, JournalLock lock, int file, std::uint64_t length);
  void run();
  void fail(const Error& error);
  void noteUnsynced(const std::string& name);
  void sync(std::vector<std::string> names);

  std::filesystem::path m_folder;
  JournalLock m_lock;
  int m_file;
  std::uint64_t m_length; ///< of the whole lines [byte]
  std::function<void(const Error&)> m_handler;
  std::atomic<bool> m_failed = false;

  std::mutex m_mutex; ///< guards what follows
  std::condition_variable m_wake, m_idle;
  std::deque<Job> m_jobs;
  bool m_busy = false, m_stop = false, m_removed = false;
  std::vector<std::string> m_unsynced; ///< names of files that the disk may not have yet
  std::chrono::steady_clock::time_point m_unsyncedSince;
  std::thread m_thread; ///< last: sees the rest built
};

} // namespace esm
