// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/child_process.h"

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

/// Runs a program of the PATH that fills bodies in a folder, as runChild() does. Errors: Unsupported (there is
/// no such program), Numerics (it failed or took more than `timeLimit` [s]), Internal, Cancelled.
Status runProgram(const std::vector<std::string>& command, const std::filesystem::path& folder,
                  double timeLimit, WorkControl* control);

} // namespace esm::support
