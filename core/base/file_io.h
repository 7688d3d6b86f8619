// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace esm {

/// "a device", "a pipe" or "a socket" if that is what stands at `path` (links are followed), else empty.
std::string specialFileKind(const std::filesystem::path& path);

/// The file that writing to `path` changes: links are followed, also one whose file does not exist yet.
/// Errors: FileUnwritable (links that lead in a circle).
Result<std::filesystem::path> behindLinks(const std::filesystem::path& path);

/// The whole file as bytes. Errors: FileUnreadable (absent, a folder, a device, pipe or socket, no
/// permission).
Result<std::string> readFile(const std::filesystem::path& path);

/// `path` cannot be written, and why: a value of errno.
Error fileUnwritable(const std::filesystem::path& path, int errorNumber);

/// Writes to a descriptor, however many calls that takes. False: errno tells why.
bool writeAll(int file, std::string_view bytes);

/// Writes all or nothing: a temporary file beside `path`, fsync, rename. Whatever fails, the old file
/// stays as it was. A character device or a pipe that is read is written into and never replaced; block
/// devices and sockets are refused. With `keepBackup` the previous version stays as `path` + ".bak".
/// Errors: FileUnwritable, with the system's reason.
Status writeFileAtomically(const std::filesystem::path& path, std::string_view bytes,
                           bool keepBackup = false);

/// Whether writeFileAtomically() can begin, so that a bad path is told before the work whose result goes there.
/// Errors: as there.
Status canBeWritten(const std::filesystem::path& path);

} // namespace esm
