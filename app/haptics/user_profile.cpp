// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/haptics/user_profile.h"

#include "core/base/file_io.h"
#include "haptics/device/driver_profile.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <filesystem>
#include <system_error>

namespace esm {

Result<double> newtonsAtFull(const std::string& kind)
{
  const Result<DriverProfile> profile = loadProfile(kind, {});
  if (!profile) return profile.error();
  return profile->newtonsAtFull;
}

Status setNewtonsAtFull(const std::string& kind, double newtons)
{
  const std::filesystem::path file = userProfilePath(kind);
  if (file.empty()) return Error{ErrorCode::FileUnwritable, "There is no home folder for the profile"};
  QJsonObject profile;
  std::error_code fault;
  if (std::filesystem::exists(file, fault)) {
    const Result<std::string> text = readFile(file);
    if (!text) return text.error();
    const QJsonDocument read = QJsonDocument::fromJson(QByteArray::fromStdString(*text));
    if (!read.isObject())
      return Error{ErrorCode::BadFormat, file.string() + ": this is no JSON object; correct or remove it"};
    profile = read.object();
  }
  profile["newtons_at_full"] = newtons;
  std::filesystem::create_directories(file.parent_path(), fault); // writing says what is wrong with it
  return writeFileAtomically(file, QJsonDocument(profile).toJson().toStdString());
}

} // namespace esm
