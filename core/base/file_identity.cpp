// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_identity.h"

#include "core/base/file_io.h"
#include "core/base/hash.h"

#include <sys/stat.h>

namespace esm {

namespace {

std::int64_t nanoseconds(const timespec& time)
{
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

} // namespace

std::optional<FileIdentity> statusOf(const std::filesystem::path& path)
{
  struct stat info = {};
  if (::stat(path.c_str(), &info) != 0 || !S_ISREG(info.st_mode)) return std::nullopt;
  FileIdentity identity;
  identity.device = info.st_dev;
  identity.inode = info.st_ino;
  identity.size = static_cast<std::uint64_t>(info.st_size);
  identity.modified = nanoseconds(info.st_mtim);
  identity.changed = nanoseconds(info.st_ctim);
  return identity;
}

std::optional<FileIdentity> identityOf(const std::filesystem::path& path)
{
  std::optional<FileIdentity> identity = statusOf(path); // first: a change meanwhile is then seen later
  if (!identity) return std::nullopt;
  const auto bytes = readFile(path);
  if (!bytes) return std::nullopt;
  identity->fingerprint = fingerprintOf(*bytes);
  return identity;
}

bool isOtherFile(const std::filesystem::path& path, const std::optional<FileIdentity>& known)
{
  const std::optional<FileIdentity> now = statusOf(path);
  if (!now) return false;
  if (!known) return true;
  FileIdentity same = *now;
  same.fingerprint = known->fingerprint;
  if (same == *known) return false;
  if (known->fingerprint == 0 || now->size != known->size) return true;
  const auto bytes = readFile(path);
  return !bytes || fingerprintOf(*bytes) != known->fingerprint;
}

} // namespace esm
