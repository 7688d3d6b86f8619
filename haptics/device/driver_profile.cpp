// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/device/driver_profile.h"

#include "core/base/file_io.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <system_error>

namespace esm {

namespace {

using Json = nlohmann::json;

/// Reads known keys within their ranges; the first fault stays.
class ProfileReader {
public:
  explicit ProfileReader(const std::string& origin) : m_origin(origin) {}

  void number(const Json& where, const char* key, double least, double most, double& out)
  {
    if (!where.contains(key)) return;
    const Json& value = where[key];
    const double x = value.is_number() ? value.get<double>() : std::nan("");
    if (!(x >= least && x <= most))
      return fail(std::string(key) + " is " + value.dump() + "; it must be a number from " + trim(least) +
                  " to " + trim(most));
    out = x;
  }

  template <class Vector>
  void vector(const Json& where, const char* key, double most, Vector& out)
  {
    if (!where.contains(key)) return;
    const Json& value = where[key];
    Vector read;
    bool good = value.is_array() && value.size() == static_cast<std::size_t>(read.size());
    for (Eigen::Index i = 0; good && i < read.size(); ++i) {
      const Json& entry = value[static_cast<std::size_t>(i)];
      good = entry.is_number() && std::abs(entry.get<double>()) <= most;
      if (good) read[i] = entry.get<double>();
    }
    if (!good)
      return fail(std::string(key) + " is " + value.dump() + "; it must be " + std::to_string(read.size()) +
                  " numbers of at most " + trim(most));
    out = read;
  }

  void flag(const Json& where, const char* key, bool& out)
  {
    if (!where.contains(key)) return;
    if (!where[key].is_boolean()) return fail(std::string(key) + " must be true or false");
    out = where[key].get<bool>();
  }

  void text(const Json& where, const char* key, std::string& out)
  {
    if (!where.contains(key)) return;
    if (!where[key].is_string()) return fail(std::string(key) + " must be a text");
    out = where[key].get<std::string>();
  }

  void onlyKnown(const Json& where, const char* what, std::initializer_list<std::string_view> known)
  {
    if (!where.is_object()) return fail(std::string(what) + " must be an object");
    for (const auto& [key, value] : where.items()) {
      bool found = false;
      for (const std::string_view name : known) found = found || name == key;
      if (!found) return fail("there is no key " + key + " in " + what);
    }
  }

  void fail(const std::string& what)
  {
    if (!m_error) m_error = Error{ErrorCode::InvalidValue, m_origin + ": " + what};
  }
  const std::optional<Error>& error() const { return m_error; }

private:
  static std::string trim(double value) { return Json(value).dump(); }

  const std::string& m_origin;
  std::optional<Error> m_error;
};

std::optional<UsbId> parseUsbId(const std::string& text)
{
  UsbId id;
  const char* end = text.data() + text.size();
  if (text.size() != 9 || text[4] != ':') return {};
  const auto vendor = std::from_chars(text.data(), text.data() + 4, id.vendor, 16);
  const auto product = std::from_chars(text.data() + 5, end, id.product, 16);
  if (vendor.ec != std::errc() || vendor.ptr != text.data() + 4) return {};
  if (product.ec != std::errc() || product.ptr != end) return {};
  return id;
}

const Json& part(const Json& all, const char* key)
{
  static const Json kEmpty = Json::object();
  return all.contains(key) ? all[key] : kEmpty;
}

void readUsb(ProfileReader& reader, const Json& all, std::vector<UsbId>& usb)
{
  if (!all.contains("usb")) return;
  if (!all["usb"].is_array()) return reader.fail("usb must be a list such as [\"0403:cb48\"]");
  for (const Json& entry : all["usb"]) {
    const auto id = parseUsbId(entry.is_string() ? entry.get<std::string>() : "");
    if (!id) return reader.fail("usb holds " + entry.dump() + "; it must look like \"0403:cb48\"");
    usb.push_back(*id);
  }
}

void readAll(ProfileReader& reader, const Json& all, DriverProfile& profile)
{
  DeviceProfile& device = profile.device;
  reader.onlyKnown(all, "the profile",
                   {"format", "name", "usb", "opt_in", "firmware", "limits", "mechanism", "arm_time_s",
                    "workspace_m", "origin_m", "newtons_at_full", "stroke_m", "update_rate_Hz", "polarity",
                    "quirks"});
  if (reader.error()) return;
  const Json &limits = part(all, "limits"), &mechanism = part(all, "mechanism");
  const Json &workspace = part(all, "workspace_m"), &quirks = part(all, "quirks");
  reader.onlyKnown(limits, "limits", {"force_N", "stiffness_N_per_m", "damping_Ns_per_m"});
  reader.onlyKnown(mechanism, "mechanism", {"damping_Ns_per_m", "delay_s", "period_s"});
  reader.onlyKnown(workspace, "workspace_m", {"min", "max"});
  reader.onlyKnown(quirks, "quirks", {"control_from_one", "no_block_load_answer", "endless_effects"});
  if (reader.error()) return;
  std::string format, firmware;
  reader.text(all, "format", format);
  if (format != "esm-haptic-profile") reader.fail("format is not \"esm-haptic-profile\"");
  reader.text(all, "name", device.name);
  reader.text(all, "firmware", firmware);
  profile.firmware = firmware;
  readUsb(reader, all, profile.usb);
  reader.flag(all, "opt_in", profile.needsOptIn);
  reader.number(limits, "force_N", 0.0, 50.0, device.maxForce);
  reader.number(limits, "stiffness_N_per_m", 0.0, 20000.0, device.maxStiffness);
  reader.number(limits, "damping_Ns_per_m", 0.0, 100.0, device.maxDamping);
  reader.number(mechanism, "damping_Ns_per_m", 0.0, 100.0, device.ownDamping);
  reader.number(mechanism, "delay_s", 0.0, 0.1, device.delay);
  reader.number(mechanism, "period_s", 0.00025, 0.02, device.period);
  reader.number(all, "arm_time_s", 0.1, 60.0, device.armTime);
  reader.vector(workspace, "min", 1.0, device.workspaceMin);
  reader.vector(workspace, "max", 1.0, device.workspaceMax);
  if ((device.workspaceMin.array() > device.workspaceMax.array()).any())
    reader.fail("workspace_m has a min above its max");
  reader.vector(all, "origin_m", 1.0, profile.origin);
  reader.number(all, "newtons_at_full", 0.01, 50.0, profile.newtonsAtFull);
  reader.vector(all, "stroke_m", 2.0, profile.stroke);
  if (profile.stroke.minCoeff() < 0.0) reader.fail("stroke_m must not be negative");
  reader.number(all, "update_rate_Hz", 10.0, 1000.0, profile.quirks.updateRate);
  reader.vector(all, "polarity", 1.0, profile.quirks.polarity);
  if ((profile.quirks.polarity.array().abs() != 1.0).any())
    reader.fail("polarity must be two numbers, each 1 or -1");
  reader.flag(quirks, "control_from_one", profile.quirks.controlFromOne);
  reader.flag(quirks, "no_block_load_answer", profile.quirks.noBlockLoadAnswer);
  reader.flag(quirks, "endless_effects", profile.quirks.endlessEffects);
}

} // namespace

Result<DriverProfile> parseProfile(std::string_view builtIn, std::string_view patch,
                                   const std::string& origin)
{
  Json all = Json::parse(builtIn, nullptr, false);
  if (!patch.empty()) {
    const Json own = Json::parse(patch, nullptr, false);
    if (!own.is_object()) return Error{ErrorCode::BadFormat, origin + " is not a JSON object"};
    all.merge_patch(own);
  }
  if (!all.is_object()) return Error{ErrorCode::BadFormat, origin + " is not a JSON object"};
  DriverProfile profile;
  ProfileReader reader(origin);
  readAll(reader, all, profile);
  if (reader.error()) return *reader.error();
  return profile;
}

std::filesystem::path userProfilePath(std::string_view kind)
{
  const char* config = std::getenv("XDG_CONFIG_HOME");
  const char* home = std::getenv("HOME");
  std::filesystem::path folder;
  if (config && *config)
    folder = config;
  else if (home && *home)
    folder = std::filesystem::path(home) / ".config";
  else
    return {};
  return folder / "esm" / "haptics" / (std::string(kind) + ".json");
}

Result<DriverProfile> loadProfile(std::string_view kind, const DeviceOptions& options)
{
  std::filesystem::path path = options.profile;
  std::error_code ignored;
  if (path.empty()) {
    path = userProfilePath(kind);
    if (!std::filesystem::exists(path, ignored)) path.clear();
  }
  std::string patch;
  if (!path.empty()) {
    Result<std::string> text = readFile(path);
    if (!text) return text.error();
    patch = std::move(*text);
    if (patch.empty()) patch = " "; // an empty file is a mistake, not an absent one
  }
  Result<DriverProfile> profile =
    parseProfile(builtInProfile(kind), patch, path.empty() ? "profile " + std::string(kind) : path.string());
  if (!profile) return profile;
  if (!options.firmware.empty()) profile->firmware = options.firmware;
  profile->optIn = options.optIn;
  return profile;
}

} // namespace esm
