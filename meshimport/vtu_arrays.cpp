// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/vtu_arrays.h"

#include <algorithm>
#include <utility>
#include <zlib.h>

namespace esm {

namespace {

Error damaged(const VtuArray& array, const char* what)
{
  return {ErrorCode::BadFormat,
          "the array '" + std::string(array.name.substr(0, 40)) + "' " + what +
            (array.format == VtuArray::Format::Appended ? "; the file is damaged or cut short"
                                                        : "; the file is damaged")};
}

int base64Value(char c)
{
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Up to `most` bytes. Sizes and data may be two texts one behind the other, so padding is allowed within.
std::string fromBase64(std::string_view text, std::uint64_t most)
{
  std::string bytes;
  unsigned bits = 0;
  int held = 0;
  for (const char c : text) {
    if (bytes.size() >= most) break;
    if (c == '=') {
      held = 0;
      continue;
    }
    const int value = base64Value(c);
    if (value < 0) {
      if (c == ' ' || (c >= '\t' && c <= '\r')) continue;
      break;
    }
    bits = (bits << 6 | static_cast<unsigned>(value)) & 0xFFFFFF;
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += static_cast<char>(bits >> held & 0xFF);
  }
  return bytes;
}

/// The bytes of an array with the sizes before them.
class Stored {
public:
  Stored(const VtuArray& array, const VtuStorage& storage)
    : m_isBase64(array.format == VtuArray::Format::Binary || storage.isAppendedBase64)
  {
    m_text = array.content;
    if (array.format == VtuArray::Format::Appended)
      m_text =
        array.offset <= storage.appended.size() ? storage.appended.substr(array.offset) : std::string_view();
  }
  /// The first `count` bytes; fewer if there are no more. Good until the next call.
  std::string_view first(std::uint64_t count)
  {
    if (!m_isBase64) return m_text.substr(0, count);
    m_decoded = fromBase64(m_text, count);
    return std::string_view(m_decoded).substr(0, count);
  }
  std::uint64_t most() const { return m_text.size(); }

private:
  std::string_view m_text;
  bool m_isBase64;
  std::string m_decoded;
};

std::uint64_t sizeAt(std::string_view bytes, std::size_t number, const VtuStorage& storage)
{
  const char* from = bytes.data() + number * scalarSize(storage.headerType);
  return static_cast<std::uint64_t>(decodeScalar<long long>(storage.headerType, storage.order, from));
}

Result<std::string> plainBytes(const VtuArray& array, const VtuStorage& storage)
{
  Stored stored(array, storage);
  const std::size_t head = scalarSize(storage.headerType);
  const std::string_view start = stored.first(head);
  if (start.size() < head) return damaged(array, "has no size");
  const std::uint64_t size = sizeAt(start, 0, storage);
  if (size > stored.most()) return damaged(array, "promises more than the file holds");
  const std::string_view all = stored.first(head + size);
  if (all.size() < head + size) return damaged(array, "ends early");
  return std::string(all.substr(head));
}

/// Blocks, size of a block, size of the last one if it is smaller, packed size of each; then the blocks.
Result<std::string> unzippedBytes(const VtuArray& array, const VtuStorage& storage)
{
  constexpr std::uint64_t kMostRatio = 1100; // deflate packs at most 1032 to 1
  Stored stored(array, storage);
  const std::size_t word = scalarSize(storage.headerType);
  std::string_view head = stored.first(3 * word);
  if (head.size() < 3 * word) return damaged(array, "has no sizes");
  const std::uint64_t blocks = sizeAt(head, 0, storage), size = sizeAt(head, 1, storage),
                      last = sizeAt(head, 2, storage);
  if (blocks == 0) return std::string();
  if (blocks > stored.most() / word || size == 0 || size > kMostRatio * stored.most() || last > size)
    return damaged(array, "promises more than the file holds");
  const std::uint64_t total = (blocks - 1) * size + (last > 0 ? last : size);
  if (total > kMostRatio * stored.most()) return damaged(array, "promises more than the file holds");
  head = stored.first((3 + blocks) * word);
  if (head.size() < (3 + blocks) * word) return damaged(array, "ends early");
  std::vector<std::uint64_t> packed;
  std::uint64_t sum = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    packed.push_back(sizeAt(head, 3 + b, storage));
    if (packed.back() > stored.most()) return damaged(array, "promises more than the file holds");
    sum += packed.back();
    if (sum > stored.most()) return damaged(array, "promises more than the file holds");
  }
  const std::size_t begin = (3 + blocks) * word;
  const std::string_view all = stored.first(begin + sum);
  if (all.size() < begin + sum) return damaged(array, "ends early");

  std::string bytes(total, '\0');
  std::uint64_t from = begin, to = 0;
  for (std::size_t b = 0; b < blocks; from += packed[b++]) {
    const std::uint64_t wanted = b + 1 < blocks || last == 0 ? size : last;
    uLongf got = wanted;
    const int code = ::uncompress(reinterpret_cast<Bytef*>(bytes.data() + to), &got,
                                  reinterpret_cast<const Bytef*>(all.data() + from), packed[b]);
    if (code != Z_OK || got != wanted) return damaged(array, "cannot be unpacked");
    to += wanted;
  }
  return bytes;
}

template <class T>
Result<std::vector<T>> valuesOf(const VtuArray& array, const VtuStorage& storage)
{
  std::vector<T> values;
  if (array.format == VtuArray::Format::Ascii) {
    NumberSource source(array.content);
    T value{};
    while (source.skipToWord()) {
      if (!source.next(array.type, value)) return damaged(array, "holds something that is no number");
      values.push_back(value);
    }
    return values;
  }
  const Result<std::string> bytes =
    storage.isZipped ? unzippedBytes(array, storage) : plainBytes(array, storage);
  if (!bytes) return bytes.error();
  const std::size_t size = scalarSize(array.type);
  values.resize(bytes->size() / size);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = decodeScalar<T>(array.type, storage.order, bytes->data() + i * size);
  return values;
}

} // namespace

std::optional<Scalar> vtuScalar(std::string_view name) noexcept
{
  using enum Scalar;
  constexpr std::pair<std::string_view, Scalar> kNames[] = {
    {"Int8", Int8},     {"UInt8", UInt8}, {"Int16", Int16},   {"UInt16", UInt16},   {"Int32", Int32},
    {"UInt32", UInt32}, {"Int64", Int64}, {"UInt64", UInt64}, {"Float32", Float32}, {"Float64", Float64}};
  for (const auto& [known, type] : kNames)
    if (known == name) return type;
  return std::nullopt;
}

Result<std::vector<double>> vtuNumbers(const VtuArray& array, const VtuStorage& storage)
{
  return valuesOf<double>(array, storage);
}

Result<std::vector<long long>> vtuIntegers(const VtuArray& array, const VtuStorage& storage)
{
  return valuesOf<long long>(array, storage);
}

} // namespace esm
