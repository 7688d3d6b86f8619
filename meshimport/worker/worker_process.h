// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"
#include "meshimport/worker/reply.h"

#include <chrono>
#include <filesystem>

namespace esm {

/// A file for the program esm-import-worker.
struct WorkerTask {
  const char* library = "";       ///< that shall read it, a name of the worker's own table
  std::string ending;             ///< of the format, without a point; the content may have betrayed it
  std::filesystem::path file;     ///< companions are looked for in its folder
  std::chrono::seconds wall{600}; ///< longest time; far above what the worker's own processor limit allows
};

/// Reads a file by a foreign library in a process of its own, so that whatever that library does with a
/// damaged file (crash, hang, eat the memory) ends as one sentence here. The worker limits itself by the size
/// of what it opens, writes no file, and dies with the calling thread.
/// @param control when cancelled, the worker is killed and reaped, and the answer is Cancelled
/// @note Threads: any; blocks. Errors: what the worker says of the file; BadFormat if it crashed, hung or
///       answered with garbage; Unsupported if it needed too much memory or time; Internal if it is not
///       there.
Result<WorkerReply> readInWorker(const WorkerTask& task, WorkControl* control);

} // namespace esm
