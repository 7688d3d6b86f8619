// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/series_files.h"

#include "core/base/file_io.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace esm {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kBufferSize = 1 << 20;

Error cannotWrite(const fs::path& path, int errorNumber)
{
  return {ErrorCode::FileUnwritable,
          path.string() + ": cannot be written (" + std::generic_category().message(errorNumber) + ")"};
}

mode_t usualMask()
{
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return mask;
}

} // namespace

// === TemporaryFile

TemporaryFile::TemporaryFile(fs::path path, std::string temporary, int descriptor)
  : m_path(std::move(path)), m_temporary(std::move(temporary)), m_descriptor(descriptor)
{}

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept
  : m_path(std::move(other.m_path)),
    m_temporary(std::move(other.m_temporary)),
    m_buffer(std::move(other.m_buffer)),
    m_descriptor(other.m_descriptor)
{
  other.m_descriptor = -1;
}

TemporaryFile::~TemporaryFile()
{
  if (m_descriptor < 0) return;
  ::close(m_descriptor);
  ::unlink(m_temporary.c_str());
}

Result<TemporaryFile> TemporaryFile::create(const fs::path& path)
{
  std::error_code code;
  if (fs::is_directory(path, code))
    return Error{ErrorCode::FileUnwritable, path.string() + ": cannot be written, it is a folder"};
  if (const std::string kind = specialFileKind(path); !kind.empty()) // a rename would replace it
    return Error{ErrorCode::FileUnwritable,
                 path.string() + ": cannot be written, it is " + kind + "; name a file"};
  std::string temporary = path.string() + ".XXXXXX";
  const int descriptor = ::mkostemp(temporary.data(), O_CLOEXEC);
  if (descriptor < 0) return cannotWrite(path, errno);
  return TemporaryFile(path, std::move(temporary), descriptor);
}

Error TemporaryFile::unwritable() const
{
  return cannotWrite(m_path, errno);
}

Status TemporaryFile::flush()
{
  std::string_view rest = m_buffer;
  while (!rest.empty()) {
    const ssize_t written = ::write(m_descriptor, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return unwritable();
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  m_buffer.clear();
  return {};
}

Status TemporaryFile::append(std::string_view bytes)
{
  m_buffer += bytes;
  return m_buffer.size() < kBufferSize ? Status{} : flush();
}

Status TemporaryFile::commit()
{
  if (const Status status = flush(); !status) return status;
  if (::fchmod(m_descriptor, 0666 & ~usualMask()) != 0 || ::fsync(m_descriptor) != 0) return unwritable();
  if (::rename(m_temporary.c_str(), m_path.c_str()) != 0) return unwritable();
  ::close(m_descriptor);
  m_descriptor = -1;
  return {};
}

// === TemporaryFolder

TemporaryFolder::TemporaryFolder(fs::path path, fs::path temporary)
  : m_path(std::move(path)), m_temporary(std::move(temporary))
{}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept
  : m_path(std::move(other.m_path)), m_temporary(std::move(other.m_temporary))
{
  other.m_temporary.clear();
}

TemporaryFolder::~TemporaryFolder()
{
  std::error_code code;
  if (!m_temporary.empty()) fs::remove_all(m_temporary, code);
}

Result<TemporaryFolder> TemporaryFolder::create(const fs::path& path, const std::string& ending)
{
  std::error_code code;
  if (fs::exists(path, code) && !fs::is_directory(path, code))
    return Error{ErrorCode::FileUnwritable,
                 path.string() + ": is in the way, a folder of this name is needed"};
  for (const auto& entry : fs::directory_iterator(path, code))
    if (!entry.is_regular_file(code) || entry.path().extension() != ending)
      return Error{ErrorCode::FileUnwritable, path.string() + ": would be replaced, but holds \"" +
                                                entry.path().filename().string() + "\"; move it away"};
  std::string temporary = path.string() + ".XXXXXX";
  if (!::mkdtemp(temporary.data())) return cannotWrite(path, errno);
  ::chmod(temporary.c_str(), 0777 & ~usualMask());
  return TemporaryFolder(path, temporary);
}

Status TemporaryFolder::write(const std::string& file, std::string_view bytes)
{
  std::ofstream out(m_temporary / file, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) return cannotWrite(m_path / file, errno);
  return {};
}

Status TemporaryFolder::commit()
{
  std::error_code code;
  fs::path former;
  if (fs::exists(m_path, code)) {
    former = m_temporary.string() + ".old";
    fs::rename(m_path, former, code);
    if (code) return cannotWrite(m_path, code.value());
  }
  fs::rename(m_temporary, m_path, code);
  if (code) {
    std::error_code ignored;
    if (!former.empty()) fs::rename(former, m_path, ignored);
    return cannotWrite(m_path, code.value());
  }
  m_temporary.clear();
  if (!former.empty()) fs::remove_all(former, code);
  return {};
}

} // namespace esm
