// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/folder_files.h"

#include "core/base/ascii_case.h"
#include "core/base/file_io.h"
#include "meshimport/worker/scene_text.h"

#include <algorithm>
#include <cstring>

namespace esm {

namespace {

namespace fs = std::filesystem;

/// Bytes in memory, to be read only.
class MemoryStream : public Assimp::IOStream {
public:
  explicit MemoryStream(std::string_view bytes) : m_bytes(bytes) {}
  explicit MemoryStream(std::string&& owned) : m_owned(std::move(owned)), m_bytes(m_owned) {}

  size_t Read(void* buffer, size_t size, size_t count) override
  {
    if (size == 0) return 0;
    const size_t items = std::min(count, (m_bytes.size() - m_at) / size);
    std::memcpy(buffer, m_bytes.data() + m_at, items * size);
    m_at += items * size;
    return items;
  }
  size_t Write(const void*, size_t, size_t) override { return 0; }
  aiReturn Seek(size_t offset, aiOrigin origin) override
  {
    const size_t from = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? m_at : m_bytes.size();
    const size_t to = origin == aiOrigin_END ? from - offset : from + offset; // as assimp's own streams
    if (to > m_bytes.size()) return aiReturn_FAILURE;
    m_at = to;
    return aiReturn_SUCCESS;
  }
  size_t Tell() const override { return m_at; }
  size_t FileSize() const override { return m_bytes.size(); }
  void Flush() override {}

private:
  std::string m_owned;
  std::string_view m_bytes;
  size_t m_at = 0;
};

} // namespace

FolderFiles::FolderFiles(const fs::path& model, std::string_view bytes, std::string_view ending,
                         void (*announce)(std::uint64_t bytes))
  : m_folder(model), m_model(m_folder.path() / model.filename()), m_bytes(bytes), m_announce(announce)
{
  if (!ending.empty()) m_model.replace_extension(ending);
  if (ending == "x3d") m_plain = plainX3d(bytes, m_folder, false);
  if (ending == "dae") m_plain = plainCollada(bytes, m_folder);
  if (ending == "amf") m_plain = plainAmf(bytes);
  if (!m_plain.empty()) m_bytes = m_plain;
}

bool FolderFiles::isModel(const fs::path& file) const
{
  return file == m_model || file == m_model.filename();
}

bool FolderFiles::Exists(const char* file) const
{
  return isModel(file) || !m_folder.find(file).empty();
}

Assimp::IOStream* FolderFiles::Open(const char* file, const char* mode)
{
  if (std::strpbrk(mode, "wa+")) return nullptr;
  if (isModel(file)) return new MemoryStream(m_bytes);
  const fs::path whole = m_folder.find(file);
  if (whole.empty()) return nullptr;
  std::error_code code;
  if (const std::uintmax_t size = fs::file_size(whole, code); !code) m_announce(size);
  Result<std::string> bytes = readFile(whole);
  if (bytes && asciiLower(whole.extension().string()) == ".x3d")
    if (std::string plain = plainX3d(*bytes, m_folder, true); !plain.empty()) *bytes = std::move(plain);
  if (bytes) return new MemoryStream(std::move(*bytes));
  m_folder.lose(file, "it cannot be read");
  return nullptr;
}

} // namespace esm
