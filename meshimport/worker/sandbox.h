// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace esm {

/// Where libraries, fonts and their like lie.
inline constexpr const char* kSystemFolders[] = {
  "/usr", "/lib", "/lib64", "/etc/ld.so.cache", "/etc/fonts", "/var/cache/fontconfig"};

/// From now on this process opens no socket and starts no program, as far as the kernel offers seccomp.
/// @return whether it does
bool closeNetwork();

/// From now on this process opens files beneath `folder` and those of the system (libraries, fonts) alone, as
/// far as the kernel offers Landlock: a second wall behind ModelFolder, for what a library opens by itself.
/// @return whether it does
bool closeOtherFolders(const std::filesystem::path& folder);

} // namespace esm
