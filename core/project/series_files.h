// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/temporary_beside.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace esm {

/// A file that grows under a temporary name beside its own and takes it with commit(). Without commit()
/// nothing stays behind, and an older file of the name is as it was. Errors: FileUnwritable.
class TemporaryFile {
public:
  static Result<TemporaryFile> create(const std::filesystem::path& path);

  Status append(std::string_view bytes); ///< kept in memory up to a megabyte, then written
  Status commit();                       ///< fsync and rename; once, at the end

private:
  TemporaryFile(std::filesystem::path path, TemporaryBeside temporary);
  Status flush();

  std::filesystem::path m_path;
  TemporaryBeside m_temporary;
  std::string m_buffer;
};

/// The same for a folder of files. A folder of the name from an earlier run is replaced, but only if it
/// holds nothing but files of the given ending: what somebody else put there is not ours to remove.
class TemporaryFolder {
public:
  static Result<TemporaryFolder> create(const std::filesystem::path& path, const std::string& ending);

  std::string name() const { return m_path.filename().string(); } ///< after commit()
  Status write(const std::string& file, std::string_view bytes);
  Status commit();

private:
  TemporaryFolder(std::filesystem::path path, TemporaryBeside temporary);

  std::filesystem::path m_path;
  TemporaryBeside m_temporary;
};

} // namespace esm
