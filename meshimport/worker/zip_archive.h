// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// A file in an archive. Views into the archive.
struct ZipEntry {
  std::string_view name;
  std::string_view packed;
  std::string_view record;  ///< of the archive's directory: name, extra field and comment included
  std::uint16_t method = 0; ///< 0 stored, 8 deflated
  std::uint32_t size = 0;   ///< unpacked
};

/// What the directory at the end of a ZIP archive lists. Empty for what is none, is damaged, or is so large
/// that its sizes take more than 32 bits.
std::optional<std::vector<ZipEntry>> listZip(std::string_view archive);

/// Whether the entry is packed in a way that unpack() knows.
bool canUnpack(const ZipEntry& entry) noexcept;

/// Whether it unpacks to the size and the checksum that the directory states; takes little memory.
bool isWhole(const ZipEntry& entry);

/// At most the first `most` bytes of the file; shorter where the data are damaged.
std::string unpack(const ZipEntry& entry, std::size_t most);

/// An entry like this one with these bytes, not packed. Views into `bytes` and into `record`, which is made.
ZipEntry storedEntry(const ZipEntry& like, std::string_view bytes, std::string& record);

/// An archive of these files alone; nothing is unpacked for it.
std::string makeZip(const std::vector<ZipEntry>& entries);

} // namespace esm
