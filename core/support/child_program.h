// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/base/work_control.h"

#include <filesystem>
#include <string>
#include <vector>

namespace esm::support {

/// A folder of our own for the files that go to and fro; removed with the object.
class ScratchFolder {
public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const noexcept { return m_path; } ///< empty if none could be made

private:
  std::filesystem::path m_path;
};

/// Whether the PATH has a program of that name.
bool isInPath(const std::string& program);

/// Runs a program of the PATH in a folder and waits for it; its words are thrown away. It is killed when the
/// time is up or the work is cancelled, within 20 ms. Errors: Unsupported (there is no such program),
/// Numerics (it failed or was too slow), Cancelled.
Status runProgram(const std::vector<std::string>& command, const std::filesystem::path& folder,
                  double timeLimit, WorkControl* control);

} // namespace esm::support
