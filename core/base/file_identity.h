// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace esm {

/// What tells one version of a regular file from another: where it lies, when it was touched, what it holds.
struct FileIdentity {
  std::uint64_t device = 0, inode = 0, size = 0;
  std::int64_t modified = 0, changed = 0; ///< of the bytes, and of anything about the file [ns]
  std::uint64_t fingerprint = 0;          ///< fingerprintOf() the bytes; 0: not known
  bool operator==(const FileIdentity&) const = default;
};

/// All that costs no reading: the fingerprint stays unknown. Nothing: there is no regular file.
std::optional<FileIdentity> statusOf(const std::filesystem::path& path);

/// Reads the file for its fingerprint. Nothing: there is no regular file, or it cannot be read.
std::optional<FileIdentity> identityOf(const std::filesystem::path& path);

/// Whether a regular file stands at `path` that may hold other bytes than `known` did. A file that was only
/// touched, copied back or moved holds the same. Nothing known: any file is another one.
bool isOtherFile(const std::filesystem::path& path, const std::optional<FileIdentity>& known);

} // namespace esm
