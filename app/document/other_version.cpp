// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/other_version.h"

#include "core/base/file_io.h"

#include <cerrno>
#include <unistd.h>

namespace esm {

static std::filesystem::path fileOf(const QString& project)
{
  const auto behind = behindLinks(project.toStdString());
  return behind ? *behind : std::filesystem::path(project.toStdString());
}

QString nameForOtherVersion(const QString& project)
{
  const std::string start = fileOf(project).string() + ".other";
  std::string name = start + ".bak";
  std::error_code code;
  for (int number = 2; std::filesystem::exists(std::filesystem::symlink_status(name, code)); ++number)
    name = start + std::to_string(number) + ".bak";
  return QString::fromStdString(name);
}

Status keepOtherVersion(const QString& project, const QString& name)
{
  const std::filesystem::path file = fileOf(project);
  const std::string kept = name.toStdString();
  if (::link(file.c_str(), kept.c_str()) == 0 || errno == ENOENT) return {};
  if (errno == EEXIST) return fileUnwritable(kept, EEXIST);
  const auto bytes = readFile(file); // a file system without hard links
  return bytes ? writeFileAtomically(kept, *bytes) : Status{bytes.error()};
}

} // namespace esm
