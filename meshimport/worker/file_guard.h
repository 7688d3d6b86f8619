// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace esm {

/// From now on fopen() in this process, that of the libraries too, opens regular files beneath `folder` and
/// those of the system alone, for reading. Coin tries out names of pictures, shaders and sounds by opening
/// them, and on a pipe that waits for ever.
void guardFiles(const std::filesystem::path& folder);

} // namespace esm
