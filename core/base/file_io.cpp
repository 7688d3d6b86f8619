// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"

#include "core/base/temporary_beside.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace esm {

namespace {

/// What stands at a path and is no regular file; empty for files, folders and what does not exist.
std::string specialKind(mode_t mode)
{
  if (S_ISCHR(mode) || S_ISBLK(mode)) return "a device";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return {};
}

/// A pipe or a terminal takes the bytes as they come. Never waits for a pipe that nobody reads.
Status writeInto(const std::filesystem::path& path, std::string_view bytes)
{
  const int file = ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0 && errno == ENXIO)
    return Error{ErrorCode::FileUnwritable,
                 path.string() + ": cannot be written, it is a pipe that nobody reads"};
  if (file < 0) return fileUnwritable(path, errno);
  ::fcntl(file, F_SETFL, ::fcntl(file, F_GETFL) & ~O_NONBLOCK);
  const bool written = writeAll(file, bytes);
  const int reason = errno;
  if (::close(file) != 0 && written) return fileUnwritable(path, errno);
  return written ? Status{} : fileUnwritable(path, reason);
}

/// Makes a rename in this folder survive a power cut; a file system that refuses it loses only that.
void syncFolder(const std::filesystem::path& folder)
{
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

/// Gives `file` a second name in place of whatever file has it, by way of a third: there is no moment without
/// one of both. The lock says that the third is in use (TemporaryBeside).
bool linkAs(const std::filesystem::path& file, const std::string& name, const std::string& between)
{
  const int locked = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (locked >= 0) ::flock(locked, LOCK_EX | LOCK_NB);
  const bool linked = ::link(file.c_str(), between.c_str()) == 0;
  const bool named = linked && ::rename(between.c_str(), name.c_str()) == 0;
  if (linked) ::unlink(between.c_str()); // rename() leaves it where both were names of one file already
  if (locked >= 0) ::close(locked);
  return named;
}

/// The same on a file system without hard links.
Status copyAs(const std::filesystem::path& file, const std::string& name)
{
  const Result<std::string> bytes = readFile(file);
  if (!bytes) return bytes.error();
  std::error_code code;
  if (std::filesystem::is_symlink(name, code)) std::filesystem::remove(name, code); // what it leads to stays
  Result<TemporaryBeside> copy = TemporaryBeside::create(name, TemporaryBeside::Kind::File);
  if (!copy) return copy.error();
  struct stat info = {}; // who may not read the file may not read its backup
  if (!writeAll(copy->descriptor(), *bytes) || ::stat(file.c_str(), &info) != 0 ||
      ::fchmod(copy->descriptor(), info.st_mode & 07777) != 0 || ::fsync(copy->descriptor()) != 0)
    return fileUnwritable(name, errno);
  return copy->takeName();
}

} // namespace

Error fileUnwritable(const std::filesystem::path& path, int errorNumber)
{
  return {ErrorCode::FileUnwritable,
          path.string() + ": cannot be written (" + std::generic_category().message(errorNumber) + ")"};
}

bool writeAll(int file, std::string_view bytes)
{
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      return false;
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::string specialFileKind(const std::filesystem::path& path)
{
  struct stat info = {};
  return ::stat(path.c_str(), &info) == 0 ? specialKind(info.st_mode) : std::string();
}

Result<std::filesystem::path> behindLinks(const std::filesystem::path& path)
{
  constexpr int kMostLinks = 40; // as the kernel follows
  std::filesystem::path file = path;
  for (int links = 0; links < kMostLinks; ++links) {
    std::error_code code;
    const std::filesystem::path next = std::filesystem::read_symlink(file, code);
    if (code) return file; // no link
    file = file.parent_path() / next;
  }
  return fileUnwritable(path, ELOOP);
}

Result<std::string> readFile(const std::filesystem::path& path)
{
  std::error_code code;
  if (std::filesystem::is_directory(path, code))
    return Error{ErrorCode::FileUnreadable, path.string() + ": is a folder, not a file"};
  const auto noFile = [&](const std::string& kind) {
    return Error{ErrorCode::FileUnreadable, path.string() + ": is " + kind + ", not a file"};
  };
  if (const std::string kind = specialFileKind(path); !kind.empty()) // opening a device may do something
    return noFile(kind);
  // What has come there since is not waited for, nor read without an end.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  if (file < 0)
    return Error{ErrorCode::FileUnreadable,
                 path.string() + ": cannot be read (" + std::generic_category().message(errno) + ")"};
  const struct Closing {
    int file;
    ~Closing() { ::close(file); }
  } closing{file};
  std::string bytes;
  struct stat info = {};
  const bool isKnown = ::fstat(file, &info) == 0;
  if (const std::string kind = isKnown ? specialKind(info.st_mode) : std::string(); !kind.empty()) {
    ::close(file);
    return noFile(kind);
  }
  if (isKnown && info.st_size > 0) bytes.reserve(static_cast<std::size_t>(info.st_size));
  char buffer[1 << 16];
  for (;;) {
    const ssize_t count = ::read(file, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      return Error{ErrorCode::FileUnreadable,
                   path.string() + ": cannot be read (" + std::generic_category().message(errno) + ")"};
    if (count == 0) break;
    bytes.append(buffer, static_cast<std::size_t>(count));
  }
  return bytes;
}

Status writeFileAtomically(const std::filesystem::path& path, std::string_view bytes, bool keepBackup)
{
  struct stat special = {};
  if (::stat(path.c_str(), &special) == 0) {
    if (S_ISCHR(special.st_mode) || S_ISFIFO(special.st_mode)) return writeInto(path, bytes);
    if (const std::string kind = specialKind(special.st_mode); !kind.empty())
      return Error{ErrorCode::FileUnwritable,
                   path.string() + ": cannot be written, it is " + kind + "; name a file"};
  }
  Result<TemporaryBeside> temporary = TemporaryBeside::create(path, TemporaryBeside::Kind::File);
  if (!temporary) return temporary.error();
  const std::filesystem::path& target = temporary->target();

  struct stat old = {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  const int file = temporary->descriptor();
  if (!writeAll(file, bytes) || ::fchmod(file, exists ? old.st_mode & 07777 : creationMode(0666)) != 0 ||
      ::fsync(file) != 0)
    return fileUnwritable(path, errno);

  if (exists && keepBackup) {
    const std::string backup = target.string() + ".bak";
    if (const std::string kind = specialFileKind(backup); !kind.empty())
      return Error{ErrorCode::FileUnwritable,
                   backup + ": cannot be written, it is " + kind + "; move it away"};
    const std::string mark = temporary->path().string().substr(target.string().size());
    if (!linkAs(target, backup, backup + mark))
      if (const Status copied = copyAs(target, backup); !copied) return copied;
  }
  if (const Status status = temporary->takeName(); !status) return status;
  syncFolder(target.has_parent_path() ? target.parent_path() : std::filesystem::path("."));
  return {};
}

Status canBeWritten(const std::filesystem::path& path)
{
  if (!specialFileKind(path).empty()) return {}; // to open one may do something
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) return fileUnwritable(path, EISDIR);
  const auto temporary = TemporaryBeside::create(path, TemporaryBeside::Kind::File);
  return temporary ? Status{} : Status{temporary.error()};
}

} // namespace esm
