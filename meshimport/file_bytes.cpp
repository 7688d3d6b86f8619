// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/file_bytes.h"

#include "core/base/file_io.h"
#include "core/base/hash.h"
#include "core/base/large_pages.h"
#include "core/base/machine_memory.h"
#include "meshimport/raw_mesh.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace esm {

namespace {

/// Bytes; then they are hashed while they are in the cache, and somebody may wish to stop.
constexpr std::size_t kAtOnce = std::size_t{1} << 18;

Error unreadable(const std::filesystem::path& path, const std::string& why)
{
  return fault(ErrorCode::FileUnreadable, path.string(), 0, why);
}
Error unreadable(const std::filesystem::path& path, int errorNumber)
{
  return unreadable(path, "cannot be read (" + std::generic_category().message(errorNumber) + ")");
}

class OpenFile {
public:
  explicit OpenFile(const std::filesystem::path& path)
    : m_file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) // a pipe without a writer would block
  {}
  ~OpenFile()
  {
    if (m_file >= 0) ::close(m_file);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int get() const { return m_file; }

private:
  int m_file;
};

} // namespace

FileBytes::FileBytes(FileBytes&& other) noexcept
  : m_data(std::exchange(other.m_data, nullptr)),
    m_size(std::exchange(other.m_size, 0)),
    m_capacity(std::exchange(other.m_capacity, 0)),
    m_fingerprint(std::exchange(other.m_fingerprint, 0))
{}

FileBytes& FileBytes::operator=(FileBytes&& other) noexcept
{
  std::swap(m_data, other.m_data);
  std::swap(m_size, other.m_size);
  std::swap(m_capacity, other.m_capacity);
  std::swap(m_fingerprint, other.m_fingerprint);
  return *this;
}

FileBytes::~FileBytes()
{
  std::free(m_data);
}

/// Makes room for `capacity` bytes; keeps what is there.
bool FileBytes::hold(std::size_t capacity)
{
  void* const fresh = std::realloc(m_data, capacity);
  if (!fresh) return false;
  useLargePages(fresh, capacity);
  m_data = static_cast<char*>(fresh);
  m_capacity = capacity;
  return true;
}

Result<FileBytes> FileBytes::read(const std::filesystem::path& path, WorkControl* control)
{
  const auto noFile = [&](const std::string& kind) {
    return unreadable(path, "is " + (kind.empty() ? "a device" : kind) + ", not a file");
  };
  if (const std::string kind = specialFileKind(path); !kind.empty()) // opening a device may do something
    return noFile(kind);
  const OpenFile file(path);
  struct stat info = {};
  if (file.get() < 0 || ::fstat(file.get(), &info) != 0) return unreadable(path, errno);
  if (S_ISDIR(info.st_mode)) return unreadable(path, "is a folder, not a file");
  if (!S_ISREG(info.st_mode)) return noFile(specialFileKind(path));
  const auto promised = static_cast<std::size_t>(std::max<off_t>(info.st_size, 0));
  const Error tooLarge =
    fault(ErrorCode::Unsupported, path.string(), 0,
          "with " + std::to_string(promised) +
            " bytes it is larger than the memory of this machine; simplify the mesh first");
  FileBytes bytes;
  if (promised >= machineMemory() || !bytes.hold(promised + 1)) return tooLarge;
  Fingerprint fingerprint;
  for (;;) {
    if (stopWanted(control)) return cancelledError();
    if (bytes.m_size == bytes.m_capacity && !bytes.hold(2 * bytes.m_capacity + kAtOnce)) return tooLarge;
    const std::size_t room = std::min(kAtOnce, bytes.m_capacity - bytes.m_size);
    const ssize_t count = ::read(file.get(), bytes.m_data + bytes.m_size, room);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return unreadable(path, errno);
    if (count == 0) break;
    bytes.m_size += static_cast<std::size_t>(count);
    fingerprint.follow(bytes.view());
  }
  bytes.m_fingerprint = fingerprint.finish(bytes.view());
  return bytes;
}

} // namespace esm
