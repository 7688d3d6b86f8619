// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/temporary_beside.h"

#include "core/base/file_io.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace esm {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kMark = ".esm-tmp-";
constexpr std::string_view kPlaces = "XXXXXX"; // mkostemp() puts letters and digits here

bool isTemporaryName(std::string_view name)
{
  if (name.size() <= kMark.size() + kPlaces.size()) return false;
  const std::string_view end = name.substr(name.size() - kMark.size() - kPlaces.size());
  const auto isLetterOrDigit = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  };
  return end.starts_with(kMark) &&
         std::all_of(end.begin() + static_cast<std::ptrdiff_t>(kMark.size()), end.end(), isLetterOrDigit);
}

/// A file, or a folder of files. A folder in a folder is not ours and stays.
void removeShallow(const fs::path& path)
{
  if (::unlink(path.c_str()) == 0 || errno != EISDIR) return;
  std::error_code code;
  for (fs::directory_iterator entry(path, code), end; !code && entry != end; entry.increment(code))
    ::unlink(entry->path().c_str());
  ::rmdir(path.c_str());
}

/// Removes it if its writer is gone. Without locks on this file system nobody can know, and it stays.
void removeIfOrphaned(const fs::path& path)
{
  const int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return;
  struct stat info = {};
  const bool ours = ::fstat(file, &info) == 0 && (S_ISREG(info.st_mode) || S_ISDIR(info.st_mode));
  if (ours && ::flock(file, LOCK_EX | LOCK_NB) == 0) removeShallow(path);
  ::close(file);
}

void sweep(const fs::path& folder)
{
  std::error_code code;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code))
    if (isTemporaryName(entry->path().filename().native())) removeIfOrphaned(entry->path());
}

/// A descriptor of a new file or folder; `name` then holds its name. -1 with errno if that fails.
int createOnce(std::string& name, TemporaryBeside::Kind kind)
{
  if (kind == TemporaryBeside::Kind::File) return ::mkostemp(name.data(), O_CLOEXEC);
  return ::mkdtemp(name.data()) ? ::open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC) : -1;
}

} // namespace

Result<TemporaryBeside> TemporaryBeside::create(const fs::path& wanted, Kind kind)
{
  const Result<fs::path> file = behindLinks(wanted);
  if (!file) return file.error();
  const fs::path& target = *file;
  sweep(target.has_parent_path() ? target.parent_path() : fs::path("."));
  for (;;) {
    std::string name = target.string().append(kMark).append(kPlaces);
    const int descriptor = createOnce(name, kind);
    if (descriptor < 0) return fileUnwritable(wanted, errno);
    struct stat info = {};
    ::flock(descriptor, LOCK_EX);
    if (::fstat(descriptor, &info) == 0 && info.st_nlink > 0)
      return TemporaryBeside(target, name, descriptor, kind);
    ::close(descriptor); // another program swept it before it was locked
  }
}

TemporaryBeside::TemporaryBeside(fs::path target, fs::path path, int descriptor, Kind kind)
  : m_target(std::move(target)), m_path(std::move(path)), m_descriptor(descriptor), m_kind(kind)
{}

TemporaryBeside::TemporaryBeside(TemporaryBeside&& other) noexcept
  : m_target(std::move(other.m_target)),
    m_path(std::move(other.m_path)),
    m_descriptor(other.m_descriptor),
    m_kind(other.m_kind)
{
  other.m_descriptor = -1;
}

TemporaryBeside::~TemporaryBeside()
{
  if (m_descriptor < 0) return;
  removeShallow(m_path);
  ::close(m_descriptor);
}

Status TemporaryBeside::takeName()
{
  const char* from = m_path.c_str();
  const char* to = m_target.c_str();
  if (m_kind == Kind::File) return ::rename(from, to) == 0 ? Status{} : fileUnwritable(m_target, errno);
  // A folder cannot replace one that holds files: they change places, and the former goes with this object.
  if (::renameat2(AT_FDCWD, from, AT_FDCWD, to, RENAME_EXCHANGE) == 0 || ::rename(from, to) == 0) return {};
  // This file system cannot exchange, as it seems: in two steps.
  const std::string former = m_path.string() + ".old";
  if (::rename(to, former.c_str()) != 0) return fileUnwritable(m_target, errno);
  if (::rename(from, to) != 0) {
    const int reason = errno;
    ::rename(former.c_str(), to);
    return fileUnwritable(m_target, reason);
  }
  removeShallow(former);
  return {};
}

mode_t creationMode(mode_t wanted)
{
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return wanted & ~mask;
}

} // namespace esm
