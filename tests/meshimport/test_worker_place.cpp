// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker_place.h"

#include <gmock/gmock.h>

#include <cstdlib>

namespace {

using namespace esm;
namespace fs = std::filesystem;
using ::testing::ElementsAre;

// The tests' own worker lies beside them (it is built so), and no file of these names is anywhere.
TEST(WorkerPlace, whatIsNamedNearestToTheReaderCounts)
{
  const fs::path beside = fs::read_symlink("/proc/self/exe").replace_filename("esm-import-worker");
  EXPECT_EQ(importWorker(), beside);
  ::setenv("ESM_IMPORT_WORKER", "/of/the/environment", 1);
  EXPECT_EQ(importWorker(), "/of/the/environment");
  setImportWorker("/of/the/program");
  EXPECT_EQ(importWorker(), "/of/the/program");
  setImportWorker({});
  EXPECT_EQ(importWorker(), "/of/the/environment");
  ::unsetenv("ESM_IMPORT_WORKER");
  EXPECT_EQ(importWorker(), beside);
}

// bin/host and lib/x86_64-linux-gnu/libesm.so lie one and two folders below the root of their tree; further up
// belongs to others.
TEST(WorkerPlace, isLookedForInTheTreeOfTheProgramAndNotAboveIt)
{
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path inTree = fs::path("libexec") / "esm" / "esm-import-worker";
  EXPECT_THAT(importWorkerPlaces(), ElementsAre(folder / "esm-import-worker", folder.parent_path() / inTree,
                                                folder.parent_path().parent_path() / inTree));
  detail::tellOfImportWorker("/of/the/package");
  EXPECT_EQ(importWorkerPlaces().back(), "/of/the/package");
  detail::tellOfImportWorker(nullptr);
}

} // namespace
