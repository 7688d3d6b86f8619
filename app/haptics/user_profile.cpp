// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/haptics/user_profile.h"

#include "core/base/file_io.h"
#include "haptics/device/driver_profile.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <filesystem>
#include <system_error>

namespace esm {

Result<StickCalibration> stickCalibration(const std::string& kind)
{
  const Result<DriverProfile> profile = loadProfile(kind, {});
  if (!profile) return profile.error();
  const Eigen::Vector2d standard = pid::Quirks{}.polarity, &polarity = profile->quirks.polarity;
  return StickCalibration{profile->newtonsAtFull, polarity.x() != standard.x(), polarity.y() != standard.y(),
                          profile->origin};
}

Status setStickCalibration(const std::string& kind, const StickCalibration& calibration)
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
  const Eigen::Vector2d standard = pid::Quirks{}.polarity;
  profile["newtons_at_full"] = calibration.newtonsAtFull;
  profile["polarity"] = QJsonArray{calibration.reversedAcross ? -standard.x() : standard.x(),
                                   calibration.reversedAlong ? -standard.y() : standard.y()};
  profile["origin_m"] = QJsonArray{calibration.origin.x(), calibration.origin.y(), calibration.origin.z()};
  std::filesystem::create_directories(file.parent_path(), fault); // writing says what is wrong with it
  return writeFileAtomically(file, QJsonDocument(profile).toJson().toStdString());
}

} // namespace esm
