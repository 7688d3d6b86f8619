// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/zip_archive.h"

#include "meshimport/byte_order.h"

#include <zlib.h>

#include <algorithm>

namespace esm {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view kLocal = "PK\3\4"sv, kDirectory = "PK\1\2"sv, kEnd = "PK\5\6"sv;
constexpr std::size_t kLocalSize = 30, kDirectorySize = 46, kEndSize = 22, kMostComment = 65535;
constexpr std::uint32_t kElsewhere = 0xFFFFFFFF; ///< the true number needs 64 bits

std::uint16_t two(std::string_view bytes, std::size_t at)
{
  return loadLittle<std::uint16_t>(bytes.data() + at);
}

std::uint32_t four(std::string_view bytes, std::size_t at)
{
  return loadLittle<std::uint32_t>(bytes.data() + at);
}

void appendTwo(std::string& bytes, std::size_t value)
{
  bytes += static_cast<char>(value & 0xFF);
  bytes += static_cast<char>(value >> 8 & 0xFF);
}

void appendFour(std::string& bytes, std::size_t value)
{
  appendTwo(bytes, value & 0xFFFF);
  appendTwo(bytes, value >> 16);
}

/// The entry whose record begins the directory; empty if it does not fit.
std::optional<ZipEntry> entryAt(std::string_view archive, std::string_view directory)
{
  if (directory.size() < kDirectorySize || directory.substr(0, 4) != kDirectory) return std::nullopt;
  const std::size_t nameSize = two(directory, 28);
  const std::size_t recordSize = kDirectorySize + nameSize + two(directory, 30) + two(directory, 32);
  const std::uint32_t packed = four(directory, 20), size = four(directory, 24), place = four(directory, 42);
  if (directory.size() < recordSize || packed == kElsewhere || size == kElsewhere || place == kElsewhere)
    return std::nullopt;
  if (archive.size() < kLocalSize + std::size_t{place} || archive.substr(place, 4) != kLocal)
    return std::nullopt;
  const std::string_view local = archive.substr(place);
  const std::size_t start = kLocalSize + two(local, 26) + two(local, 28);
  if (local.size() < start + packed) return std::nullopt;
  return ZipEntry{directory.substr(kDirectorySize, nameSize), local.substr(start, packed),
                  directory.substr(0, recordSize), two(directory, 10), size};
}

/// Hands the unpacked bytes on, piece by piece, until there are no more, they are damaged or `take` returns false.
template <class Take>
void unpackTo(const ZipEntry& entry, const Take& take)
{
  if (entry.method == 0) take(entry.packed);
  z_stream stream{};
  if (entry.method != Z_DEFLATED || inflateInit2(&stream, -MAX_WBITS) != Z_OK) return;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(entry.packed.data())); // it is only read
  stream.avail_in = static_cast<uInt>(entry.packed.size());
  std::string piece(1 << 16, '\0');
  for (int state = Z_OK; state == Z_OK;) {
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    state = inflate(&stream, Z_SYNC_FLUSH);
    const std::size_t made = piece.size() - stream.avail_out;
    if (made == 0 || !take(std::string_view(piece).substr(0, made))) break;
  }
  inflateEnd(&stream);
}

} // namespace

std::optional<std::vector<ZipEntry>> listZip(std::string_view archive)
{
  const std::size_t from = archive.size() - std::min(archive.size(), kEndSize + kMostComment);
  const std::size_t place = archive.substr(from).rfind(kEnd);
  if (place == archive.npos || archive.size() - from - place < kEndSize) return std::nullopt;
  const std::string_view end = archive.substr(from + place);
  if (four(end, 16) > archive.size()) return std::nullopt;
  std::string_view directory = archive.substr(four(end, 16));
  std::vector<ZipEntry> entries;
  for (int left = two(end, 10); left > 0; --left) {
    const std::optional<ZipEntry> entry = entryAt(archive, directory);
    if (!entry) return std::nullopt;
    directory.remove_prefix(entry->record.size());
    entries.push_back(*entry);
  }
  return entries;
}

bool canUnpack(const ZipEntry& entry) noexcept
{
  return entry.method == 0 || entry.method == Z_DEFLATED;
}

bool isWhole(const ZipEntry& entry)
{
  std::uint64_t size = 0;
  uLong sum = ::crc32_z(0, nullptr, 0);
  unpackTo(entry, [&](std::string_view piece) {
    size += piece.size();
    sum = ::crc32_z(sum, reinterpret_cast<const Bytef*>(piece.data()), piece.size());
    return size <= entry.size;
  });
  return size == entry.size && sum == four(entry.record, 16);
}

std::string unpack(const ZipEntry& entry, std::size_t most)
{
  std::string out;
  unpackTo(entry, [&](std::string_view piece) {
    out += piece.substr(0, most - out.size());
    return out.size() < most;
  });
  return out;
}

ZipEntry storedEntry(const ZipEntry& like, std::string_view bytes, std::string& record)
{
  record = like.record;
  std::string numbers;
  appendFour(numbers, ::crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
  appendFour(numbers, bytes.size());
  appendFour(numbers, bytes.size());
  record.replace(10, 2, 2, '\0'); // the method
  record.replace(16, numbers.size(), numbers);
  return {like.name, bytes, record, 0, static_cast<std::uint32_t>(bytes.size())};
}

std::string makeZip(const std::vector<ZipEntry>& entries)
{
  std::string archive, directory;
  for (const ZipEntry& entry : entries) {
    std::string record(entry.record.substr(0, kDirectorySize));
    record.replace(8, 2, 2, '\0');  // no sizes behind the data
    record.replace(30, 4, 4, '\0'); // neither extra field nor comment
    std::string place;
    appendFour(place, archive.size());
    record.replace(42, 4, place);
    archive += kLocal;
    archive.append(record, 6,
                   kLocalSize - 4); // version to the length of the extra field are the same in both
    archive += entry.name;
    archive += entry.packed;
    directory += record;
    directory += entry.name;
  }
  const std::size_t start = archive.size();
  archive += directory;
  archive += kEnd;
  appendFour(archive, 0);
  appendTwo(archive, entries.size());
  appendTwo(archive, entries.size());
  appendFour(archive, directory.size());
  appendFour(archive, start);
  appendTwo(archive, 0);
  return archive;
}

} // namespace esm
