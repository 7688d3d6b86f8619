// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

namespace esm {

/// The program esm-import-worker, in which foreign libraries read their formats, away from ours.

/// Takes this one from now on, whatever else there is; an empty path takes that back. Thread: any.
void setImportWorker(const std::filesystem::path& program);

/// The first of these: the one of setImportWorker(); $ESM_IMPORT_WORKER; the first that is there of
/// importWorkerPlaces(). If none is there, the first of these places. Thread: any.
std::filesystem::path importWorker();

/// Beside this library, or in the folder libexec/esm of the tree that it is installed in; the same of the
/// running program; where the build or the package of the library has told that it is (a static library in a
/// program elsewhere has no other way to know).
std::vector<std::filesystem::path> importWorkerPlaces();

namespace detail {
/// @param file outlives the program
bool tellOfImportWorker(const char* file) noexcept;
} // namespace detail

#ifdef ESM_IMPORT_WORKER_FILE // by esm::meshimport and esm-meshimport.pc
[[maybe_unused]] static const bool importWorkerIsTold = detail::tellOfImportWorker(ESM_IMPORT_WORKER_FILE);
#endif

} // namespace esm
