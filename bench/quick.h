// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace esm::bench {

/// Fixed steps on small scenes, seconds in all, so that the bits depend on the arithmetic alone. With a file
/// of golden hashes, 1 if any state differs by a bit.
int runQuick(const std::string& goldenFile);

} // namespace esm::bench
