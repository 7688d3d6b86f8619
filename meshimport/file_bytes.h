// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/base/work_control.h"

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace esm {

/// A whole file in memory. It is read, not mapped: a mapped file that another program cuts short meanwhile
/// ends this one with SIGBUS, and nothing could be checked once for all. Large pages make the copy about as
/// cheap as a mapping.
/// @note Threads: any.
class FileBytes {
public:
  /// Errors: FileUnreadable (absent, a folder, a device, no permission), Unsupported (larger than the memory
  /// of the machine), Cancelled.
  static Result<FileBytes> read(const std::filesystem::path& path, WorkControl* control = nullptr);

  FileBytes(FileBytes&& other) noexcept;
  FileBytes& operator=(FileBytes&& other) noexcept;
  ~FileBytes();

  std::string_view view() const noexcept { return {m_data, m_size}; }
  std::uint64_t fingerprint() const noexcept { return m_fingerprint; } ///< fingerprintOf() the bytes

private:
  FileBytes() = default;
  bool hold(std::size_t capacity);

  char* m_data = nullptr;
  std::size_t m_size = 0, m_capacity = 0;
  std::uint64_t m_fingerprint = 0;
};

} // namespace esm
