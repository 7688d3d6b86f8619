// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace esm {

/// A file that grows under a temporary name beside its own and takes it with commit(). Without commit()
/// nothing stays behind, and an older file of the name is as it was. Errors: FileUnwritable.
class TemporaryFile {
public:
  static Result<TemporaryFile> create(const std::filesystem::path& path);
  TemporaryFile(TemporaryFile&& other) noexcept;
  TemporaryFile& operator=(TemporaryFile&&) = delete;
  ~TemporaryFile();

  Status append(std::string_view bytes); ///< kept in memory up to a megabyte, then written
  Status commit();                       ///< fsync and rename; once, at the end

private:
  TemporaryFile(std::filesystem::path path, std::string temporary, int descriptor);
  Status flush();
  Error unwritable() const;

  std::filesystem::path m_path;
  std::string m_temporary, m_buffer;
  int m_descriptor; ///< -1 once closed
};

/// The same for a folder of files. A folder of the name from an earlier run is replaced, but only if it
/// holds nothing but files of the given ending: what somebody else put there is not ours to remove.
class TemporaryFolder {
public:
  static Result<TemporaryFolder> create(const std::filesystem::path& path, const std::string& ending);
  TemporaryFolder(TemporaryFolder&& other) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();

  std::string name() const { return m_path.filename().string(); } ///< after commit()
  Status write(const std::string& file, std::string_view bytes);
  Status commit();

private:
  TemporaryFolder(std::filesystem::path path, std::filesystem::path temporary);

  std::filesystem::path m_path, m_temporary; ///< m_temporary is empty once committed
};

} // namespace esm
