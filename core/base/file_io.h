// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace esm {

/// The whole file as bytes. Errors: FileUnreadable (absent, a folder, no permission).
Result<std::string> readFile(const std::filesystem::path& path);

/// Writes all or nothing: a temporary file beside `path`, fsync, rename. Whatever fails, the old file
/// stays as it was. With `keepBackup` the previous version stays as `path` + ".bak".
/// Errors: FileUnwritable, with the system's reason.
Status writeFileAtomically(const std::filesystem::path& path, std::string_view bytes,
                           bool keepBackup = false);

} // namespace esm
