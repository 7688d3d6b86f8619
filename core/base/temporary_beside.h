// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <sys/types.h>

namespace esm {

/// A new file or folder beside `target` (where that is a link: beside what it leads to), on the same file
/// system, to be filled and then to take the target's name. Its name is "<target>.esm-tmp-XXXXXX", and it is
/// locked (flock) as long as this object lives. So create() can tell what killed programs left in the folder,
/// whose lock is free, and removes it first.
class TemporaryBeside {
public:
  enum class Kind { File, Folder };

  /// Errors: FileUnwritable, with the system's reason.
  static Result<TemporaryBeside> create(const std::filesystem::path& target, Kind kind);
  TemporaryBeside(TemporaryBeside&& other) noexcept;
  TemporaryBeside& operator=(TemporaryBeside&&) = delete;
  ~TemporaryBeside(); ///< removes what did not take the name, or what it replaced

  const std::filesystem::path& target() const noexcept { return m_target; } ///< behind all links
  const std::filesystem::path& path() const noexcept { return m_path; }
  int descriptor() const noexcept { return m_descriptor; } ///< of a file: open for writing

  /// Becomes `target`, whatever file, or folder of files, stood there. Errors: FileUnwritable.
  Status takeName();

private:
  TemporaryBeside(std::filesystem::path target, std::filesystem::path path, int descriptor, Kind kind);

  std::filesystem::path m_target, m_path;
  int m_descriptor; ///< -1 once moved from
  Kind m_kind;
};

/// The mode in which this process creates files (0666) or folders (0777).
mode_t creationMode(mode_t wanted);

} // namespace esm
