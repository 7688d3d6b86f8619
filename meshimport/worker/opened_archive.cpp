// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/opened_archive.h"

#include "core/base/ascii_case.h"
#include "meshimport/worker/joined_model.h"
#include "meshimport/worker/limits.h"
#include "meshimport/worker/zip_archive.h"

#include <algorithm>

namespace esm {

namespace {

constexpr std::size_t kMostPartText = 1 << 16; ///< bytes of the scene that are looked at
constexpr std::size_t kMostUnpacked = 1032;    ///< bytes that deflate makes of one

bool hasEnding(const ZipEntry& entry, std::string_view ending)
{
  const std::string name = asciiLower(entry.name);
  return name.size() >= ending.size() && name.substr(name.size() - ending.size()) == ending;
}

/// The root model with what it takes from other files of the archive; empty if it is one file as it is.
std::string oneModel(const ZipEntry& root, const std::vector<ZipEntry>& entries,
                     std::vector<std::string>& lost)
{
  const auto whole = [](const ZipEntry& entry) {
    std::string text = unpack(entry, kMostUnpacked * (entry.packed.size() + 1));
    allowFor(text.size() / 8); // for the joined text beside what the library makes of it
    return text;
  };
  if (std::none_of(
        entries.begin(), entries.end(),
        [&](const ZipEntry& entry) { return hasEnding(entry, ".model") && entry.name != root.name; }) &&
      unpack(root, kMostPartText).find(":path=") == std::string::npos)
    return {};
  return joinedModel(
    whole(root),
    [&](std::string_view path) {
      if (path.substr(0, 1) == "/") path.remove_prefix(1);
      for (const ZipEntry& entry : entries)
        if (entry.name == path) return whole(entry);
      return std::string();
    },
    lost);
}

} // namespace

OpenedArchive openArchive(std::string_view bytes, std::string_view ending)
{
  OpenedArchive opened;
  if (ending != "3mf" && ending != "zae") return opened;
  std::optional<std::vector<ZipEntry>> entries = listZip(bytes);
  if (!entries) return opened;
  const char* const sceneEnding = ending == "3mf" ? ".model" : ".dae";
  auto scene = std::find_if(entries->begin(), entries->end(),
                            [](const ZipEntry& entry) { return hasEnding(entry, "3d/3dmodel.model"); });
  if (scene == entries->end())
    scene = std::find_if(entries->begin(), entries->end(),
                         [&](const ZipEntry& entry) { return hasEnding(entry, sceneEnding); });
  if (scene != entries->end()) opened.text = unpack(*scene, kMostPartText);
  if (ending != "3mf" || scene == entries->end()) return opened;
  std::string record;
  const std::string model = oneModel(*scene, *entries, opened.lost);
  if (!model.empty()) *scene = storedEntry(*scene, model, record);
  const auto isNeeded = [](const ZipEntry& entry) {
    return hasEnding(entry, ".model") || hasEnding(entry, ".rels") || hasEnding(entry, "[content_types].xml");
  };
  const std::size_t dropped =
    std::erase_if(*entries, [&](const ZipEntry& entry) { return !isNeeded(entry); });
  if (dropped > 0 || !model.empty()) opened.plain = makeZip(*entries);
  return opened;
}

} // namespace esm
