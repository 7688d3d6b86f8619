// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker_place.h"

#include <atomic>
#include <cstdlib>
#include <dlfcn.h>
#include <mutex>
#include <system_error>

namespace esm {

namespace fs = std::filesystem;

namespace {

constexpr const char* kProgram = "esm-import-worker";
constexpr int kFoldersAbove = 2; ///< from lib/x86_64-linux-gnu up to the tree's root

std::atomic<const char*> toldFile{nullptr};

struct Chosen {
  std::mutex mutex;
  fs::path program;
};

Chosen& chosen()
{
  static Chosen only;
  return only;
}

/// The file that holds this code; empty where the loader knows only a relative name, which would lead into
/// whatever folder is the working one.
fs::path library()
{
  Dl_info info;
  if (::dladdr(reinterpret_cast<const void*>(&toldFile), &info) == 0 || !info.dli_fname) return {};
  const fs::path file(info.dli_fname);
  if (!file.is_absolute()) return {};
  std::error_code code;
  const fs::path real = fs::canonical(file, code);
  return code ? file : real;
}

fs::path runningProgram()
{
  std::error_code code;
  return fs::read_symlink("/proc/self/exe", code);
}

} // namespace

namespace detail {
bool tellOfImportWorker(const char* file) noexcept
{
  toldFile = file;
  return true;
}
} // namespace detail

void setImportWorker(const fs::path& program)
{
  const std::lock_guard lock(chosen().mutex);
  chosen().program = program;
}

std::vector<fs::path> importWorkerPlaces()
{
  std::vector<fs::path> places;
  fs::path last;
  for (const fs::path& file : {library(), runningProgram()}) {
    if (file.empty() || file == last) continue;
    last = file;
    fs::path folder = file.parent_path();
    places.push_back(folder / kProgram);
    for (int above = 0; above < kFoldersAbove && folder.has_relative_path(); ++above) {
      folder = folder.parent_path();
      places.push_back(folder / ESM_WORKER_FOLDER / kProgram);
    }
  }
  if (const char* told = toldFile) places.emplace_back(told);
  return places;
}

fs::path importWorker()
{
  {
    const std::lock_guard lock(chosen().mutex);
    if (!chosen().program.empty()) return chosen().program;
  }
  if (const char* program = std::getenv("ESM_IMPORT_WORKER"); program && *program) return program;
  const std::vector<fs::path> places = importWorkerPlaces();
  std::error_code code;
  for (const fs::path& place : places)
    if (fs::is_regular_file(place, code)) return place;
  return places.empty() ? fs::path() : places.front();
}

} // namespace esm
