// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/file_guard.h"

#include "meshimport/worker/sandbox.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace esm {

namespace {

std::filesystem::path guardedFolder; ///< empty until there is a guard

bool isBeneath(const std::filesystem::path& file, const std::filesystem::path& folder)
{
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

bool mayBeOpened(const char* name)
{
  if (guardedFolder.empty()) return true;
  std::error_code code;
  const std::filesystem::path whole = std::filesystem::weakly_canonical(name, code);
  return !code && (isBeneath(whole, guardedFolder) ||
                   std::any_of(std::begin(kSystemFolders), std::end(kSystemFolders),
                               [&](const char* folder) { return isBeneath(whole, folder); }));
}

} // namespace

void guardFiles(const std::filesystem::path& folder)
{
  guardedFolder = folder;
}

} // namespace esm

/// Goes before the C library's own, since the program comes first where the loader looks for names.
extern "C" std::FILE* fopen(const char* name, const char* mode)
{
  errno = EACCES;
  if (std::strpbrk(mode, "wa+") || !esm::mayBeOpened(name)) return nullptr;
  const int file = ::open(name, O_RDONLY | O_NONBLOCK | O_CLOEXEC); // a pipe would wait for its writer
  if (file < 0) return nullptr;
  struct stat what {};
  if (::fstat(file, &what) == 0 && S_ISREG(what.st_mode))
    if (std::FILE* const stream = ::fdopen(file, mode)) return stream;
  ::close(file);
  errno = EACCES;
  return nullptr;
}
