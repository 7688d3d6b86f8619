// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#if __cplusplus < 202002L
#error "the headers of ESM need C++20: compile with -std=c++20 (CMake: link esm::core, which hands it on)"
#endif

// Of these headers; the build reads the project's version from here.
#define ESM_VERSION_MAJOR 0
#define ESM_VERSION_MINOR 1
#define ESM_VERSION_PATCH 0

namespace esm {

/// Of the library that runs, "0.1.0"; a shared one may be another than that of the headers. Thread: any.
const char* version() noexcept;

} // namespace esm
