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

} // namespace

// === TemporaryFile

TemporaryFile::TemporaryFile(fs::path path, TemporaryBeside temporary)
  : m_path(std::move(path)), m_temporary(std::move(temporary))
{}

Result<TemporaryFile> TemporaryFile::create(const fs::path& path)
{
  std::error_code code;
  if (fs::is_directory(path, code))
    return Error{ErrorCode::FileUnwritable, path.string() + ": cannot be written, it is a folder"};
  if (const std::string kind = specialFileKind(path); !kind.empty()) // a rename would replace it
    return Error{ErrorCode::FileUnwritable,
                 path.string() + ": cannot be written, it is " + kind + "; name a file"};
  Result<TemporaryBeside> temporary = TemporaryBeside::create(path, TemporaryBeside::Kind::File);
  if (!temporary) return temporary.error();
  return TemporaryFile(path, std::move(*temporary));
}

Status TemporaryFile::flush()
{
  if (!writeAll(m_temporary.descriptor(), m_buffer)) return fileUnwritable(m_path, errno);
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
  const int file = m_temporary.descriptor();
  if (::fchmod(file, creationMode(0666)) != 0 || ::fsync(file) != 0) return fileUnwritable(m_path, errno);
  return m_temporary.takeName();
}

// === TemporaryFolder

TemporaryFolder::TemporaryFolder(fs::path path, TemporaryBeside temporary)
  : m_path(std::move(path)), m_temporary(std::move(temporary))
{}

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
  Result<TemporaryBeside> temporary = TemporaryBeside::create(path, TemporaryBeside::Kind::Folder);
  if (!temporary) return temporary.error();
  ::fchmod(temporary->descriptor(), creationMode(0777));
  return TemporaryFolder(path, std::move(*temporary));
}

Status TemporaryFolder::write(const std::string& file, std::string_view bytes)
{
  std::ofstream out(m_temporary.path() / file, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) return fileUnwritable(m_path / file, errno);
  return {};
}

Status TemporaryFolder::commit()
{
  return m_temporary.takeName();
}

} // namespace esm
